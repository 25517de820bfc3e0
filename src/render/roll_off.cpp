// SPDX-License-Identifier: Apache-2.0
#include <kushi/image.h>

#include <cmath>
#include <utility>

namespace kushi {

namespace {

float rolledOff(float x) {
    constexpr float knee = 0.5F;
    constexpr float room = 1 - knee;
    return x > knee ? 1 - room * std::exp((knee - x) / room) : x;
}

}  // namespace

Image rolledOff(Image image) {
    for (Rgb& pixel : image.pixels)
        pixel = {rolledOff(pixel.r), rolledOff(pixel.g), rolledOff(pixel.b)};
    return image;
}

}  // namespace kushi
