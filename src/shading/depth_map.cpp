// SPDX-License-Identifier: Apache-2.0
#include "shading/depth_map.h"

#include "geometry/axes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kushi {

namespace {

constexpr float nothing = std::numeric_limits<float>::lowest();
constexpr int largest = 2048;

}  // namespace

DepthMap::DepthMap(const Mesh& mesh, Vec3f towardsLight, float texel)
    : towards_(towardsLight), texel_(texel) {
    right_ = -anyNormal(towards_);
    up_ = cross(towards_, right_);
    float right = nothing;
    float top = nothing;
    left_ = bottom_ = std::numeric_limits<float>::max();
    for (const Vec3f vertex : mesh.vertices) {
        left_ = std::min(left_, dot(vertex, right_));
        right = std::max(right, dot(vertex, right_));
        bottom_ = std::min(bottom_, dot(vertex, up_));
        top = std::max(top, dot(vertex, up_));
    }
    if (mesh.triangles.empty() || !(right >= left_)) return;
    texel_ = std::max({texel_, (right - left_) / (largest - 4), (top - bottom_) / (largest - 4)});
    left_ -= texel_;
    bottom_ -= texel_;
    width_ = 3 + static_cast<int>((right - left_) / texel_);
    height_ = 3 + static_cast<int>((top - bottom_) / texel_);
    nearest_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), nothing);
    for (const auto& [a, b, c] : mesh.triangles)
        cover(project(mesh.vertices[a]), project(mesh.vertices[b]), project(mesh.vertices[c]));
}

void DepthMap::cover(const Place& a, const Place& b, const Place& c) {
    const float area = (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
    if (area == 0) return;
    const int first = static_cast<int>(std::ceil(std::min({a.u, b.u, c.u})));
    const int last = static_cast<int>(std::max({a.u, b.u, c.u}));
    const int low = static_cast<int>(std::ceil(std::min({a.v, b.v, c.v})));
    const int high = static_cast<int>(std::max({a.v, b.v, c.v}));
    for (int v = low; v <= high; ++v) {
        for (int u = first; u <= last; ++u) {
            const float x = static_cast<float>(u) - a.u;
            const float y = static_cast<float>(v) - a.v;
            const float ofB = (x * (c.v - a.v) - y * (c.u - a.u)) / area;
            const float ofC = (y * (b.u - a.u) - x * (b.v - a.v)) / area;
            if (ofB < 0 || ofC < 0 || ofB + ofC > 1) continue;
            const float depth = a.depth + ofB * (b.depth - a.depth) + ofC * (c.depth - a.depth);
            float& nearest =
                nearest_[static_cast<std::size_t>(v) * static_cast<std::size_t>(width_) +
                         static_cast<std::size_t>(u)];
            nearest = std::max(nearest, depth);
        }
    }
}

float DepthMap::lit(Vec3f place, float slack) const {
    if (nearest_.empty()) return 1;
    const Place found = project(place);
    const float u = found.u;
    const float v = found.v;
    const float depth = found.depth;
    // Also false for what is not a number.
    if (!(u >= 0 && v >= 0 && u < static_cast<float>(width_ - 1) &&
          v < static_cast<float>(height_ - 1)))
        return 1;
    const auto column = static_cast<std::size_t>(u);
    const auto row = static_cast<std::size_t>(v);
    const float* const at = &nearest_[row * static_cast<std::size_t>(width_) + column];
    const auto passes = [&](float nearest) {
        const float behind = (nearest - depth - slack) / (2 * slack);
        return 1 - std::clamp(behind, 0.0F, 1.0F);
    };
    const float shareU = u - static_cast<float>(column);
    const float shareV = v - static_cast<float>(row);
    const float one = passes(at[0]) * (1 - shareU) + passes(at[1]) * shareU;
    const float two = passes(at[width_]) * (1 - shareU) + passes(at[width_ + 1]) * shareU;
    return one * (1 - shareV) + two * shareV;
}

}  // namespace kushi
