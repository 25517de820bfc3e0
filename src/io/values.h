// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/color.h>
#include <kushi/vec.h>

#include <cmath>

namespace kushi {

// Files are in centimetres, the library in metres. The factor is applied in double: a float that
// goes there and back comes back within 1e-7 of itself, and unchanged from the second time on.

inline float toMeters(double centimeters) {
    return static_cast<float>(centimeters / 100);
}
inline double toCentimeters(float meters) {
    return static_cast<double>(meters) * 100;
}

// What a strand file may hold, the same for readers and writers.

/// Whether a coordinate [cm] is finite and stays so in `float`, in either unit.
inline bool isCoordinate(double centimeters) {
    return std::abs(centimeters) <= 3e38;
}
inline bool isDiameter(double centimeters) {
    return isCoordinate(centimeters) && centimeters >= 0;
}
inline bool isTransparency(double value) {
    return value >= 0 && value <= 1;
}
inline bool isColor(Rgb color) {
    return std::isfinite(color.r) && std::isfinite(color.g) && std::isfinite(color.b);
}

inline bool isPosition(Vec3d centimeters) {
    return isCoordinate(centimeters.x) && isCoordinate(centimeters.y) &&
           isCoordinate(centimeters.z);
}
inline Vec3f toMeters(Vec3d centimeters) {
    return {toMeters(centimeters.x), toMeters(centimeters.y), toMeters(centimeters.z)};
}
inline Vec3d toCentimeters(Vec3f meters) {
    return {toCentimeters(meters.x), toCentimeters(meters.y), toCentimeters(meters.z)};
}

}  // namespace kushi
