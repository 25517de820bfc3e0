// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rod/polyline_frames.h"

#include <kushi/rods.h>

#include <cstdint>
#include <vector>

namespace kushi {

/// Of what is laid over the head, over its surface [m].
inline constexpr double overHead = 0.003;

/// Where hair falls to; down where there is no gravity.
inline Vec3d fallOf(Vec3d gravity) {
    return length(gravity) > 0 ? normalized(gravity) : Vec3d{0, -1, 0};
}

/// Where strand i begins: its segments go as `directionAt` says for the way walked to the end of
/// each [m]. To be called for every strand in turn.
void startAlong(Rods& rods, std::uint32_t i, const auto& directionAt) {
    std::vector<Vec3d> tangents = {directionOf(rods.clamps[i])};
    double walked = 0;
    for (std::uint32_t j = 0; j < rods.segments(i); ++j) {
        walked += rods.segmentLength(i, j);
        tangents.push_back(directionAt(walked));
    }
    const auto frames = framesAlong(tangents, rotationOf(rods.clamps[i]));
    for (std::size_t j = 1; j < tangents.size(); ++j)
        rods.starts.push_back(frameOf(frames[j]));
}

}  // namespace kushi
