// SPDX-License-Identifier: Apache-2.0
#include "io/triangulate.h"

namespace kushi {
namespace {

/// A polygon seen along its own normal.
class Outline {
public:
    Outline(const Faces& faces, const std::vector<Faces::Corner>& corners)
        : faces_(faces), corners_(corners) {
        // Newell's normal, which all edges have a part in.
        for (std::size_t i = 0; i < corners.size(); ++i) {
            normal_ += cross(at(i) - at(0), at(i + 1) - at(0));
        }
    }

    /// Whether corner i can be cut off: it bulges outwards, and no other lies in its triangle.
    bool isEar(std::size_t i) const {
        const std::size_t before = i + corners_.size() - 1;
        if (!turnsLeft(at(before), at(i), at(i + 1))) return false;
        for (std::size_t k = i + 2; k < before; ++k) {
            if (isInside(at(k), at(before), at(i), at(i + 1))) return false;
        }
        return true;
    }

private:
    Vec3d at(std::size_t i) const { return faces_.points[corners_[i % corners_.size()].point]; }

    bool turnsLeft(Vec3d a, Vec3d b, Vec3d c) const {
        return dot(cross(b - a, c - a), normal_) > 0;
    }
    bool isInside(Vec3d p, Vec3d a, Vec3d b, Vec3d c) const {
        return turnsLeft(a, b, p) && turnsLeft(b, c, p) && turnsLeft(c, a, p);
    }

    const Faces& faces_;
    const std::vector<Faces::Corner>& corners_;
    Vec3d normal_;
};

// Of a polygon that crosses itself none may be an ear; then any will do.
std::size_t findEar(const Outline& outline, std::size_t corners) {
    for (std::size_t i = 1; i <= corners; ++i) {
        if (outline.isEar(i % corners)) return i % corners;
    }
    return 1;
}

}  // namespace

void addPolygon(Faces& faces, std::vector<Faces::Corner> polygon) {
    const Outline outline(faces, polygon);
    while (polygon.size() > 3) {
        const std::size_t count = polygon.size();
        const std::size_t ear = findEar(outline, count);
        faces.triangles.push_back(
            {polygon[(ear + count - 1) % count], polygon[ear], polygon[(ear + 1) % count]});
        polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    faces.triangles.push_back({polygon[0], polygon[1], polygon[2]});
}

}  // namespace kushi
