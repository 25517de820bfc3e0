// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/palette.h"
#include "render/tile.h"

#include <kushi/image.h>

namespace kushi {

/// Averages each pixel's samples into the image; pixels that show nothing (id 0) stay as they are.
///
/// palette  of the ids in the tile
void resolve(const SampleTile& tile, Palette& palette, int supersample, Image& image);

}  // namespace kushi
