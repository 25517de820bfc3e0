// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/camera.h>
#include <kushi/vec.h>

#include <cstdint>

namespace kushi {

/// A point on the picture's grid of samples; sample (i, j) has its centre at (i + 0.5, j + 0.5).
struct ScreenPoint {
    double x = 0, y = 0;  ///< samples from the left and from the top
    double q = 0;         ///< 1 / distance along the view [1/m]; linear over the picture
    double width = 1;     ///< of a strand there [samples]
};

/// Whether `point` is finite and near enough to the picture for the arithmetic of lines.
bool canBeDrawn(ScreenPoint point);

/// The same as kept for every node and vertex.
struct StoredPoint {
    float x = 0, y = 0;
    float q = 0;  ///< 0: before the near plane, x and y mean nothing; < 0: cannot be drawn
    float width = 1;

    bool inFront() const { return q > 0; }
    bool drawable() const { return q >= 0; }
    operator ScreenPoint() const { return {x, y, q, width}; }
};

/// From the world to the grid of samples.
class Projection {
public:
    /// width, height  samples
    Projection(const Camera& camera, int width, int height);

    /// Whether the camera looks anywhere.
    bool valid() const { return valid_; }
    double nearPlane() const { return near_; }

    /// Right, down and forward from the eye [m].
    Vec3d toView(Vec3f world) const;
    /// Of a point with view.z >= nearPlane().
    ScreenPoint toScreen(Vec3d view) const;
    StoredPoint store(Vec3f world) const;
    /// Samples that a metre takes up at a distance of a metre.
    double focalLength() const { return focal_; }
    /// From the eye through a point of the grid; view.z is 1.
    Vec3d through(double x, double y) const;
    Vec3d eye() const { return eye_; }

    /// Depth from 0 at the near plane to fullDepth at infinity, for integer arithmetic. Linear over
    /// the picture; at the target one unit of the 30 bits that count is about a millionth of its
    /// distance.
    double depth(double q) const { return (1 - q * near_) * fullDepth; }
    static constexpr double fullDepth = 0x1p62;
    /// Where the depth is as given [1/m].
    double inverseDistance(std::int64_t depth) const {
        return (1 - static_cast<double>(depth) / fullDepth) / near_;
    }

private:
    Vec3d eye_, right_, down_, forward_;
    double focal_ = 0;  // samples
    double centerX_ = 0, centerY_ = 0;
    double near_ = 0;
    bool valid_ = false;
};

}  // namespace kushi
