// SPDX-License-Identifier: Apache-2.0
#include "pipeline/hair_color.h"

#include "core/random.h"

#include <algorithm>

namespace kushi {

namespace {

constexpr std::uint64_t lightnessSalt = 0x6c69676874;
constexpr float rootDarkness = 0.35F;
constexpr float rootLength = 0.03F;  // m

}  // namespace

void appendHairColors(const Hair& hair, std::uint64_t key, std::span<const Vec3f> nodes,
                      std::vector<Rgb>& colors) {
    const double lightness = 1 + hair.variation * uniformSigned(mixKey(key, lightnessSalt));
    const Rgb own = static_cast<float>(lightness) * hair.color;
    float walked = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (i > 0) walked += length(nodes[i] - nodes[i - 1]);
        const float nearRoot = 1 - std::min(1.0F, walked / rootLength);
        colors.push_back((1 - rootDarkness * nearRoot * nearRoot) * own);
    }
}

}  // namespace kushi
