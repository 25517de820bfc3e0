// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/mesh.h>
#include <kushi/shade.h>
#include <kushi/strands.h>

#include <memory>
#include <span>

namespace kushi {

/// How much light comes to a place past the head and through hair.
struct Passage {
    float free = 1;       ///< share of the light that the head leaves, in [0, 1]
    float crossings = 0;  ///< fibres that the rest passes through on its way, on average
};

/// What of some lights comes where: a head of hair in its own shadow, that of what it grows on, and
/// what that gets of the hair's.
///
/// Hair is a cloud of fibres in cubes of 3 mm or more, that knows which way they run; the head is a
/// map of depths for each light. Neither depends on the eye, so they hold for all pictures.
class Shadows {
public:
    /// hair     with diameters, or as if 75 micrometres thick
    /// head     may have no triangles
    /// threads  0: as many as the machine has; the same shadows from any number
    Shadows(const Strands& hair, const Mesh& head, const Lights& lights, int threads = 0);
    ~Shadows();
    Shadows(Shadows&&) noexcept;
    Shadows& operator=(Shadows&&) noexcept;

    /// The light from everywhere, from the half of all directions about some side and from the
    /// other half.
    struct Sky {
        Passage here, beyond;
    };
    /// What comes to a place. Farther than two cubes from any hair the sky counts as open.
    ///
    /// side     unit
    /// distant  one for each of the distant lights; overwritten
    Sky at(Vec3f place, Vec3f side, std::span<Passage> distant) const;

    /// How much light comes to skin, in [0, 1]; edges of shadows are as soft as those of lamps.
    ///
    /// normal   unit
    /// blocked  share of the light that each fibre on its way takes, in [0, 1]
    /// distant  one for each of the distant lights; overwritten
    /// returns  of the light from everywhere
    float onSkin(Vec3f place, Vec3f normal, float blocked, std::span<float> distant) const;

private:
    struct Fields;
    std::unique_ptr<const Fields> fields_;
};

}  // namespace kushi
