// SPDX-License-Identifier: Apache-2.0
#include "io/field_cache.h"

#include <kushi/head.h>
#include <kushi/settle.h>

#include <array>
#include <bit>

namespace kushi {

namespace {

Result<Mesh> meshOf(const std::string& mesh, const MeshPlacement& placement) {
    if (mesh == "none") return Mesh{};
    if (mesh == "mannequin") return mannequin();
    return readMesh(mesh, placement);
}

std::string nameOfMannequin(double gap) {
    // Its key in the place of its places.
    Solid solid;
    solid.mesh.vertices = {std::bit_cast<std::array<Vec3f, 1>>(
        std::array<std::uint32_t, 3>{static_cast<std::uint32_t>(mannequinKey),
                                     static_cast<std::uint32_t>(mannequinKey >> 32U), 1})[0]};
    solid.offset = gap;
    return fieldName({&solid, 1}, {});
}

}  // namespace

Result<Mesh> headOf(const Style& style) {
    return meshOf(style.headMesh, style.headPlacement);
}

Result<std::vector<Mesh>> collidersOf(const Style& style) {
    std::vector<Mesh> meshes;
    std::vector<Problem> problems;
    for (const Collider& collider : style.colliders) {
        Result<Mesh> mesh = meshOf(collider.mesh, collider.placement);
        if (mesh) {
            meshes.push_back(std::move(mesh).value());
        } else {
            problems.insert(problems.end(), mesh.problems().begin(), mesh.problems().end());
        }
    }
    if (!problems.empty()) return problems;
    return meshes;
}

Result<DistanceField> solidsOf(const Style& style, const std::string& cacheFolder, int threads) {
    Style all;
    all.colliders = style.colliders;
    std::vector<Collider>& colliders = all.colliders;
    if (style.headCollides && style.headMesh != "none") {
        colliders.insert(colliders.begin(),
                         {style.headMesh, style.headPlacement, style.headGap, 0});
    }
    DistanceFieldOptions options;
    options.threads = threads;
    std::vector<Solid> solids;
    // The built-in head need not be made to be known.
    if (colliders.size() == 1 && colliders[0].mesh == "mannequin") {
        return cachedField(nameOfMannequin(colliders[0].gap), cacheFolder, [&] {
            const Solid head = {mannequin(), colliders[0].gap};
            return distanceFieldOf({&head, 1}, options);
        });
    }
    Result<std::vector<Mesh>> meshes = collidersOf(all);
    if (!meshes) return meshes.problems();
    for (std::size_t i = 0; i < colliders.size(); ++i)
        solids.push_back({std::move((*meshes)[i]), colliders[i].gap});
    return cachedField(fieldName(solids, options), cacheFolder,
                       [&] { return distanceFieldOf(solids, options); });
}

}  // namespace kushi
