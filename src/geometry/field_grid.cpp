// SPDX-License-Identifier: Apache-2.0
#include "geometry/field_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace kushi {
namespace {

constexpr double margin = 0.02;
constexpr double usualSpacing = 0.0025;
constexpr double usualSamples = 24e6;
constexpr float farthest = 1000;  // m; from there on floats are too coarse for hair
constexpr std::size_t mostSolids = 255;

struct Box {
    Vec3d low = {1, 1, 1}, high = {-1, -1, -1};  // empty

    bool empty() const { return low.x > high.x; }
    void hold(Vec3d place, double around) {
        const Vec3d out = {around, around, around};
        const Vec3d a = place - out, b = place + out;
        const bool first = empty();
        low = first ? a : Vec3d{std::min(low.x, a.x), std::min(low.y, a.y), std::min(low.z, a.z)};
        high =
            first ? b : Vec3d{std::max(high.x, b.x), std::max(high.y, b.y), std::max(high.z, b.z)};
    }
};

bool isNear(Vec3f vertex) {
    return std::abs(vertex.x) <= farthest && std::abs(vertex.y) <= farthest &&
           std::abs(vertex.z) <= farthest;
}

/// What is wrong with a solid; empty if nothing.
std::string faultOf(const Solid& solid) {
    if (!(std::abs(solid.offset) <= double{farthest})) {
        return "its offset is not a number of metres from -1000 to 1000";
    }
    if (!std::ranges::all_of(solid.mesh.vertices, isNear)) {
        return "a vertex of its mesh is not finite, or farther than 1 km from the origin";
    }
    const std::size_t vertices = solid.mesh.vertices.size();
    for (const auto& triangle : solid.mesh.triangles) {
        if (*std::ranges::max_element(triangle) >= vertices) {
            return "a triangle of its mesh has a vertex that the mesh does not have";
        }
    }
    return {};
}

Box boxAround(std::span<const Solid> solids) {
    Box box;
    for (const Solid& solid : solids) {
        for (const auto& triangle : solid.mesh.triangles) {
            for (const std::uint32_t corner : triangle) {
                box.hold(solid.mesh.vertices[corner].as<double>(),
                         std::max(solid.offset, 0.0) + margin);
            }
        }
    }
    return box;
}

/// Samples along one side.
double samplesAlong(double side, double spacing) {
    return std::ceil(side / spacing) + 1;
}

double samplesIn(Vec3d sides, double spacing) {
    return samplesAlong(sides.x, spacing) * samplesAlong(sides.y, spacing) *
           samplesAlong(sides.z, spacing);
}

double chooseSpacing(Vec3d sides) {
    double spacing = usualSpacing;
    while (samplesIn(sides, spacing) > usualSamples)
        spacing *= std::max(1.001, std::cbrt(samplesIn(sides, spacing) / usualSamples));
    return spacing;
}

}  // namespace

Result<DistanceField> gridFor(std::span<const Solid> solids, const DistanceFieldOptions& options) {
    if (solids.size() > mostSolids) {
        return Problem{"there are " + std::to_string(solids.size()) +
                       " solids; a distance field holds 255 at most"};
    }
    for (std::size_t i = 0; i < solids.size(); ++i) {
        if (const std::string fault = faultOf(solids[i]); !fault.empty()) {
            return Problem{"solid " + std::to_string(i + 1) + ": " + fault};
        }
    }
    if (options.spacing && !(*options.spacing > 0 && *options.spacing <= double{farthest})) {
        return Problem{"the spacing of a distance field is above 0 and at most 1000 m"};
    }

    const Box box = boxAround(solids);
    if (box.empty()) return DistanceField{};
    const Vec3d sides = box.high - box.low;
    const double spacing = options.spacing ? *options.spacing : chooseSpacing(sides);
    if (const double samples = samplesIn(sides, spacing); samples > mostSamples) {
        return Problem{"a spacing of " + std::to_string(1000 * spacing) +
                       " mm takes more than 256 million samples of the distance field"};
    }
    DistanceField field;
    field.origin = box.low.as<float>();
    field.spacing = static_cast<float>(spacing);
    field.size = {static_cast<int>(samplesAlong(sides.x, spacing)),
                  static_cast<int>(samplesAlong(sides.y, spacing)),
                  static_cast<int>(samplesAlong(sides.z, spacing))};
    return field;
}

}  // namespace kushi
