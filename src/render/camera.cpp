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
    const double radius = bounds.radius() > 0 ? bounds.radius() : 0.1;

    Camera camera;
    const double halfHeight = std::tan(0.5 * camera.verticalFieldOfView);
    const double halfAngle = std::atan(halfHeight * std::min(1.0, aspect));
    const double distance = radius / std::sin(halfAngle);

    // The direction of the view as a point on the unit sphere, and its derivative by pitch, which
    // is a useful upward direction at the poles too.
    const double cosPitch = std::cos(view.pitch);
    const double sinPitch = std::sin(view.pitch);
    const Vec3d level = {std::cos(view.yaw), 0, std::sin(view.yaw)};
    const Vec3d direction = cosPitch * level + Vec3d{0, sinPitch, 0};

    camera.eye = (center + distance * direction).as<float>();
    camera.target = center.as<float>();
    camera.up = (Vec3d{0, cosPitch, 0} - sinPitch * level).as<float>();
    return camera;
}

}  // namespace kushi
