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
    /// Hair with diameters, or as if 75 micrometres thick.
    ///
    /// threads  0: as many as the machine has; the same shadows from any number
    Shadows(const Strands& hair, const Mesh& head, const Lights& lights, int threads = 0);
    ~Shadows();
    Shadows(Shadows&&) noexcept;
    Shadows& operator=(Shadows&&) noexcept;

    /// What comes of each of the distant lights; as many passages.
    void at(Vec3f place, std::span<Passage> distant) const;

    /// What comes of the light from everywhere, from the half of all directions about a unit
    /// `side`, and from the other half.
    struct Sky {
        Passage here, beyond;
    };
    Sky skyAt(Vec3f place, Vec3f side) const;

private:
    struct Fields;
    std::unique_ptr<const Fields> fields_;
};

}  // namespace kushi
