// SPDX-License-Identifier: Apache-2.0
#include "render/projection.h"

#include <algorithm>
#include <cmath>

namespace kushi {

namespace {

/// Some unit vector normal to the unit vector `v`.
Vec3d anyNormal(Vec3d v) {
    const Vec3d other = std::abs(v.y) < 0.9 ? Vec3d{0, 1, 0} : Vec3d{-1, 0, 0};
    return normalized(cross(v, other));
}

}  // namespace

bool canBeDrawn(ScreenPoint point) {
    return std::abs(point.x) <= 0x1p30 && std::abs(point.y) <= 0x1p30 && point.q > 1e-30;
}

Projection::Projection(const Camera& camera, int width, int height)
    : eye_(camera.eye.as<double>()), centerX_(0.5 * width), centerY_(0.5 * height) {
    const Vec3d view = camera.target.as<double>() - eye_;
    const double distance = length(view);
    const double tangent = std::tan(0.5 * camera.verticalFieldOfView);
    valid_ = std::isfinite(distance) && distance > 0 && std::isfinite(tangent) && tangent > 0;
    if (!valid_) return;

    forward_ = view / distance;
    const Vec3d side = cross(forward_, camera.up.as<double>());
    const double size = length(side);
    right_ = std::isfinite(size) && size > 1e-9 ? side / size : anyNormal(forward_);
    down_ = cross(forward_, right_);
    focal_ = centerY_ / tangent;
    near_ = 1e-3 * distance;
}

Vec3d Projection::toView(Vec3f world) const {
    const Vec3d offset = world.as<double>() - eye_;
    return {dot(offset, right_), dot(offset, down_), dot(offset, forward_)};
}

ScreenPoint Projection::toScreen(Vec3d view) const {
    const double q = 1 / view.z;
    return {centerX_ + focal_ * q * view.x, centerY_ + focal_ * q * view.y, q};
}

StoredPoint Projection::store(Vec3f world) const {
    constexpr StoredPoint never = {.q = -1};
    const Vec3d view = toView(world);
    if (!isFinite(view)) return never;
    if (view.z < near_) return {};
    const ScreenPoint point = toScreen(view);
    if (!canBeDrawn(point)) return never;
    return {.x = static_cast<float>(point.x),
            .y = static_cast<float>(point.y),
            .q = static_cast<float>(point.q)};
}

Vec3d Projection::through(double x, double y) const {
    return forward_ + ((x - centerX_) * right_ + (y - centerY_) * down_) / focal_;
}

}  // namespace kushi
