// SPDX-License-Identifier: Apache-2.0
#include "zoom.h"

#include <array>
#include <charconv>
#include <cmath>

namespace kushi {

Result<Zoom> parseZoom(const std::string& text) {
    std::array<double, 3> numbers = {1, 0.5, 0.5};
    const char* at = text.data();
    const char* const end = at + text.size();
    std::size_t count = 0;
    bool good = true;
    while (good && count < 3) {
        const auto [next, error] = std::from_chars(at, end, numbers[count]);
        good = error == std::errc{} && (next == end || *next == ',');
        ++count;
        if (next == end) break;
        at = next + 1;
        good = good && count < 3;
    }
    const auto [times, x, y] = numbers;
    const auto isShare = [](double value) { return value >= 0 && value <= 1; };
    if (!good || count == 2 || !(times >= 1 && times <= 1000) || !isShare(x) || !isShare(y)) {
        return Problem{
            "--zoom is TIMES or TIMES,X,Y: 1 to 1000 times as large about a place of "
            "the picture, 0 to 1 from its left and top, such as 8,0.5,0.3; got '" +
            text + "'"};
    }
    return Zoom{times, x, y};
}

Camera zoomed(Camera camera, const Zoom& zoom, double aspect) {
    const Vec3d eye = camera.eye.as<double>();
    const Vec3d towards = camera.target.as<double>() - eye;
    const Vec3d right = normalized(cross(towards, camera.up.as<double>()));
    const Vec3d up = normalized(cross(right, towards));
    const double slope = std::tan(0.5 * static_cast<double>(camera.verticalFieldOfView));
    const double high = 2 * slope * length(towards);
    const Vec3d target =
        eye + towards + (zoom.x - 0.5) * high * aspect * right + (0.5 - zoom.y) * high * up;
    camera.target = target.as<float>();
    camera.verticalFieldOfView = static_cast<float>(2 * std::atan(slope / zoom.times));
    return camera;
}

}  // namespace kushi
