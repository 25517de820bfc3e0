// SPDX-License-Identifier: Apache-2.0
#include <kushi/camera.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace kushi {

namespace {

// Share of the picture's height and width that frame() fills.
constexpr double margin = 0.94;

struct NamedView {
    std::string_view name;
    double yaw, pitch;  // degrees
};

constexpr std::array<NamedView, 6> namedViews = {{{"front", 0, 0},
                                                  {"back", 180, 0},
                                                  {"left", -90, 0},
                                                  {"right", 90, 0},
                                                  {"top", 0, 90},
                                                  {"three-quarter", 45, 10}}};

std::optional<double> parseNumber(std::string_view text) {
    while (text.starts_with(' '))
        text.remove_prefix(1);
    while (text.ends_with(' '))
        text.remove_suffix(1);
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
    return value;
}

Problem problem(std::string message) {
    return {.message = std::move(message)};
}

}  // namespace

Result<View> parseView(const std::string& text) {
    for (const NamedView& named : namedViews) {
        if (text == named.name) return View{radians(named.yaw), radians(named.pitch)};
    }
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos) {
        return problem("unknown view '" + text +
                       "', expected front, back, left, right, top, three-quarter or YAW,PITCH in "
                       "degrees");
    }
    const std::optional<double> yaw = parseNumber(std::string_view(text).substr(0, comma));
    const std::optional<double> pitch = parseNumber(std::string_view(text).substr(comma + 1));
    if (!yaw || !pitch) {
        return problem("view '" + text + "' is not two numbers, expected YAW,PITCH in degrees, " +
                       "such as 30,10");
    }
    if (std::abs(*yaw) > 360) return problem("yaw of view '" + text + "' is not in [-360, 360]");
    if (std::abs(*pitch) > 90) return problem("pitch of view '" + text + "' is not in [-90, 90]");
    return View{radians(*yaw), radians(*pitch)};
}

Camera frame(const Bounds& bounds, View view, double aspect) {
    const Vec3d center = bounds.empty() ? Vec3d{} : bounds.center().as<double>();
    const Vec3d half = bounds.radius() > 0 ? (0.5F * (bounds.high - bounds.low)).as<double>()
                                           : Vec3d{0.1, 0.1, 0.1};

    // The direction of the view as a point on the unit sphere, and its derivative by pitch, which
    // is a useful upward direction at the poles too.
    const double cosPitch = std::cos(view.pitch);
    const double sinPitch = std::sin(view.pitch);
    const Vec3d level = {std::cos(view.yaw), 0, std::sin(view.yaw)};
    const Vec3d direction = cosPitch * level + Vec3d{0, sinPitch, 0};
    const Vec3d up = Vec3d{0, cosPitch, 0} - sinPitch * level;
    const Vec3d side = cross(up, direction);

    // Far enough for every corner of the box to lie inside the picture's margin.
    Camera camera;
    const double slope = margin * std::tan(0.5 * camera.verticalFieldOfView);
    double distance = 0;
    for (const double x : {-half.x, half.x}) {
        for (const double y : {-half.y, half.y}) {
            for (const double z : {-half.z, half.z}) {
                const Vec3d corner = {x, y, z};
                const double reach =
                    std::max(std::abs(dot(corner, up)), std::abs(dot(corner, side)) / aspect);
                distance = std::max(distance, dot(corner, direction) + reach / slope);
            }
        }
    }

    camera.eye = (center + distance * direction).as<float>();
    camera.target = center.as<float>();
    camera.up = up.as<float>();
    return camera;
}

}  // namespace kushi
