// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/spreading.h"
#include "pipeline/layers.h"

#include <kushi/distance_field.h>
#include <kushi/follicles.h>

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace kushi {

/// A part's strands after its cuts.
struct SettledPart {
    /// Where a strand's visible nodes lie; nowhere if it has none.
    struct Stretch {
        std::size_t first = 0, count = 0;
    };
    std::vector<Vec3f> nodes;        ///< m; some may be no strand's any more
    std::vector<Stretch> stretches;  ///< of each follicle's strand
    double maxResidual = 0;          ///< of equilibrium: moments over EI/L + w L^2/2
    std::size_t unsettled = 0;       ///< of equilibrium
    std::size_t pushedOut = 0;       ///< turned out of solids at the end
    std::size_t stuck = 0;           ///< and still too near to them

    std::span<const Vec3f> strand(std::size_t i) const {
        return std::span(nodes).subspan(stretches[i].first, stretches[i].count);
    }
};

/// How to settle a part.
struct PartSettling {
    Method method = Method::Equilibrium;
    int segments = 24;                      ///< of strands that are not cut
    const DistanceField* solids = nullptr;  ///< kept outside of; none if null
    std::span<const float> frictions = {};  ///< of the solids
    LayerMap layers = {};                   ///< what hair lies on; equilibrium only
    bool again = false;                     ///< settleAgain() is to follow
    int threads = 0;
};

/// A part's strands on their way to rest. Style, part and follicles must outlive it.
class PartHair {
public:
    PartHair(const Style& style, const Part& part, const Follicles& follicles,
             const PartSettling& how);
    ~PartHair();
    PartHair(PartHair&&) noexcept;
    PartHair& operator=(PartHair&&) = delete;

    /// By either method, and cut in the order of the cuts: what a hide cut leaves is all that later
    /// ones see; a settle cut shortens the strands it meets, and they are settled anew.
    ///
    /// Refuses, by equilibrium, segments in which the natural shape turns by more than 2.2 rad.
    Status settle();

    /// What is left of the strands, root first.
    std::vector<std::span<const Vec3f>> strands() const;

    /// Out of where hair is too close: strands() are moved to about where they will come to rest,
    /// and what leads them there acts from then on. By equilibrium only.
    void lead(const Spreading& spreading);

    /// Anew from where they last were at rest, under what leads them.
    Status settleAgain();

    /// At the end. No place of a strand is in the solids, but for the way that its root needs to
    /// come out of them.
    SettledPart take();

private:
    class Progress;
    std::unique_ptr<Progress> progress_;
};

}  // namespace kushi
