// SPDX-License-Identifier: Apache-2.0
#include "scalp/head_surface.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace kushi {

namespace {

Problem problemAt(const TextPlace& place, std::string message) {
    return {std::move(message), place.file, place.line, place.column};
}

std::string listed(const std::set<std::string>& names) {
    std::string text;
    for (const std::string& name : names)
        text += (text.empty() ? "\"" : ", \"") + name + '"';
    return text;
}

Status checkGroups(const Scalp& scalp, const Mesh& head) {
    std::set<std::string> known;
    for (const auto& names : head.groupNames)
        known.insert(names.begin(), names.end());
    for (const std::string& name : scalp.groups) {
        if (known.contains(name)) continue;
        return problemAt(scalp.groupsPlace,
                         "groups: the head has no \"" + name + "\", " +
                             (known.empty() ? "nor any named group, object or material at all; "
                                              "leave 'groups' out"
                                            : "expected one of " + listed(known)));
    }
    return std::monostate{};
}

// The triangles of a scalp's groups; none marked means all.
std::vector<bool> markedTriangles(const Scalp& scalp, const Mesh& head) {
    std::vector<bool> marked;
    if (scalp.groups.empty()) return marked;
    std::vector<bool> grows;
    for (const auto& names : head.groupNames) {
        grows.push_back(std::ranges::any_of(names, [&](const std::string& name) {
            return std::ranges::find(scalp.groups, name) != scalp.groups.end();
        }));
    }
    for (const std::uint16_t group : head.groups)
        marked.push_back(grows[group]);
    return marked;
}

// Between the four pixels around a place; the picture repeats.
double brightnessAt(const GreyImage& image, TexturePoint at) {
    const auto wrapped = [](double pixel, int size) {
        return static_cast<std::size_t>(pixel - size * std::floor(pixel / size));
    };
    const double x = (at.u - std::floor(at.u)) * static_cast<double>(image.width) - 0.5;
    const double y = (1 - (at.v - std::floor(at.v))) * static_cast<double>(image.height) - 0.5;
    const double left = std::floor(x);
    const double top = std::floor(y);
    const auto pixel = [&](double column, double row) {
        const auto width = static_cast<std::size_t>(image.width);
        return image.pixels[wrapped(row, image.height) * width + wrapped(column, image.width)] /
               65535.0;
    };
    const double right = x - left;
    const double below = y - top;
    return (1 - below) * ((1 - right) * pixel(left, top) + right * pixel(left + 1, top)) +
           below * ((1 - right) * pixel(left, top + 1) + right * pixel(left + 1, top + 1));
}

}  // namespace

Result<HeadSurface> HeadSurface::of(const Scalp& scalp, const Mesh& head) {
    if (const Status known = checkGroups(scalp, head); !known) return known.problems();
    HeadSurface surface(scalp, head, markedTriangles(scalp, head));
    if (!scalp.mask) return surface;
    if (head.uvs.empty()) {
        return problemAt(scalp.maskPlace,
                         "mask: the head has no texture coordinates to lay the picture on; unwrap "
                         "it and export it as .obj or glTF, or leave 'mask' out");
    }
    Result<GreyImage> mask = readGreyPng(*scalp.mask);
    if (!mask) {
        const Problem& problem = mask.problems()[0];
        return Problem{"mask: " + *scalp.mask + ": " + problem.message, scalp.maskPlace.file,
                       scalp.maskPlace.line, scalp.maskPlace.column, problem.system};
    }
    surface.mask_ = std::move(*mask);
    return surface;
}

std::optional<HeadSurface::Place> HeadSurface::at(Vec3d point) const {
    const Vec3d outward = normalized(point - center_);
    const auto hit = caster_.first(point + reach * outward, center_);
    if (!hit) return std::nullopt;
    const auto& corners = head_.triangles[hit->triangle];
    Vec3d blended;
    for (std::size_t k = 0; k < 3; ++k)
        blended += hit->weights[k] * head_.normals[corners[k]].as<double>();
    // A piece of the mesh may be wound the wrong way round.
    const double side = dot(hit->normal, outward) < 0 ? -1 : 1;
    Place place = {hit->point, side * hit->normal, side * hit->normal, shareAt(*hit)};
    if (const double size = length(blended); size > 1e-6) place.normal = blended / size;
    if (dot(place.normal, place.flatNormal) < 0) place.normal = -place.normal;
    return place;
}

double HeadSurface::shareAt(const RayHit& hit) const {
    if (!mask_) return 1;
    TexturePoint at;
    for (std::size_t k = 0; k < 3; ++k) {
        const TexturePoint corner = head_.uvs[hit.triangle][k];
        at.u += static_cast<float>(hit.weights[k]) * corner.u;
        at.v += static_cast<float>(hit.weights[k]) * corner.v;
    }
    if (!std::isfinite(at.u) || !std::isfinite(at.v)) return std::nan("");
    return brightnessAt(*mask_, at);
}

}  // namespace kushi
