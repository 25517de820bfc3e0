// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/color.h>
#include <kushi/result.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace kushi {

/// A picture in linear light, rows from the top, pixels from the left.
struct Image {
    int width = 0, height = 0;
    std::vector<Rgb> pixels;

    Rgb& at(int x, int y) {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
    const Rgb& at(int x, int y) const { return const_cast<Image*>(this)->at(x, y); }
};

/// As film answers light: what is darker than 0.5 stays, what is brighter comes ever nearer to 1,
/// each channel by itself, so that highlights keep their shape.
Image rolledOff(Image image);

/// Writes an 8-bit sRGB PNG; values are clamped to [0, 1], what is not a number becomes 0. The file
/// appears whole or not at all.
///
/// image  of 1 to 1,000,000 pixels each way, as many pixels as width x height; else a problem
Status writePng(const Image& image, const std::string& path);

/// How bright a picture is, by the numbers that its file stores: 0 is black, 65535 white. Rows from
/// the top.
struct GreyImage {
    int width = 0, height = 0;
    std::vector<std::uint16_t> pixels;
};

/// Reads a PNG of any kind: colours become their luminance, and what is transparent is so much
/// darker. A file that is missing, damaged or no PNG, or has more than 8192 x 8192 pixels is a
/// problem.
Result<GreyImage> readGreyPng(const std::string& path);

}  // namespace kushi
