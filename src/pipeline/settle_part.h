// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/follicles.h>

#include <cstddef>
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

    std::span<const Vec3f> strand(std::size_t i) const {
        return std::span(nodes).subspan(stretches[i].first, stretches[i].count);
    }
};

/// Settles a part's strands by either method, and cuts them in the order of the cuts: what a hide
/// cut leaves is all that later ones see; a settle cut shortens the strands it meets, and they are
/// settled anew.
///
/// Refuses, by equilibrium, segments in which the natural shape turns by more than 2.2 rad.
Result<SettledPart> settlePart(const Style& style, const Part& part, const Follicles& follicles,
                               Method method, int segments, int threads);

}  // namespace kushi
