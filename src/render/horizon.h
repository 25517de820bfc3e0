// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/scene.h"
#include "render/tile.h"

#include <array>

namespace kushi {

/// How far one sees into a tile at most, in 8 x 8 blocks of samples. With the head drawn, most of
/// the hair behind it is known to be hidden without a look at its samples.
class Horizon {
public:
    /// Takes in what the tile shows.
    void look(const SampleTile& tile);

    /// Whether it is certain that the tile's samples would stay as they are if the segment were
    /// drawn.
    bool hides(const ScreenSegment& segment, const Projection& projection) const;

private:
    static constexpr int blocks = 8;  // along each side

    int x_ = 0, y_ = 0, blockSize_ = 1;
    std::array<std::array<SampleTile::Key, blocks>, blocks> farthest_{};
};

}  // namespace kushi
