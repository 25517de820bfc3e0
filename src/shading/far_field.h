// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/float4.h"

#include <kushi/fibre.h>

#include <array>
#include <cstddef>
#include <vector>

namespace kushi {

/// A fibre too thin to be seen: what it scatters in all of its width, in tables. Of the near-field
/// model (kushi/fibre.h) the mean over h is taken; the rest of TRRT and beyond is left with TRT.
class FarField {
public:
    explicit FarField(const Fibre& fibre);

    /// What a clear fibre sends around itself [1/rad], and how far through it light has gone
    /// [radii].
    struct Around {
        float r, tt, trt;
        float pathTt, pathTrt;
        /// The same where light comes from all of the half circle about phi (Zinke et al. 2008).
        float rHalf, ttHalf, trtHalf;
    };
    /// sinHalf  of half the difference between the angles to the normal plane, in [0, 1]
    /// phi      between the two directions around the fibre, in [0, pi]
    Around around(float sinHalf, float phi) const;

    /// What a fibre does to light on average over all that comes square to it or slanting.
    struct Albedo {
        float forward = 0, backward = 0;  ///< shares sent on and back
        float local = 0;  ///< what a deep pile of such fibres sends back beyond the first
    };
    /// absorption  per radius, >= 0
    Albedo albedo(float absorption) const;

private:
    static constexpr std::size_t rows = 24;      // of sinHalf in [0, 1]
    static constexpr std::size_t columns = 64;   // of phi
    static constexpr std::size_t pigments = 64;  // of absorption / (absorption + 0.5)

    using Entry = std::array<Float4, 2>;  // in the order of Around
    std::vector<Entry> entries_;
    std::vector<Albedo> albedos_;
};

}  // namespace kushi
