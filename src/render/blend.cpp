// SPDX-License-Identifier: Apache-2.0
#include "render/blend.h"

namespace kushi {

bool Blend::anyOpen(double left, double top, double right, double bottom) const {
    const auto blockOf = [&](double x) {
        return static_cast<int>(std::clamp<double>(x, 0, size_ - 1)) / block;
    };
    for (int y = blockOf(top); y <= blockOf(bottom); ++y) {
        for (int x = blockOf(left); x <= blockOf(right); ++x) {
            if (open_[index(x, y)] > 0) return true;
        }
    }
    return false;
}

void Blend::add(int x, int y, std::uint32_t node, float share, Float4 color) {
    Pixel& pixel = at(x, y);
    // Neighbours by number are neighbours on a strand: strands are a node apart.
    const bool same = node + 1 == pixel.node || node == pixel.node + 1;
    if (!same) {
        pixel.before = pixel.left;
        pixel.share = 0;
    }
    pixel.node = node;
    const float added = std::min(share, 1 - pixel.share);
    pixel.share += added;
    pixel.light += pixel.before * added * color;
    const bool wasOpen = pixel.left > opaque;
    pixel.left = pixel.before * (1 - pixel.share);
    if (wasOpen && pixel.left <= opaque) {
        --open_[index(x / block, y / block)];
    }
}

}  // namespace kushi
