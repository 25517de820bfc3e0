// SPDX-License-Identifier: Apache-2.0
#include "pipeline/solids.h"

#include "io/field_cache.h"

#include <kushi/head.h>
#include <kushi/settle.h>

#include <span>

namespace kushi {

namespace {

Result<Mesh> meshOf(const std::string& mesh, const MeshPlacement& placement) {
    if (mesh == "none") return Mesh{};
    if (mesh == "mannequin") return mannequin();
    return readMesh(mesh, placement);
}

Result<std::vector<Mesh>> meshesOf(std::span<const Collider> colliders) {
    std::vector<Mesh> meshes;
    std::vector<Problem> problems;
    for (const Collider& collider : colliders) {
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

// What solidsOf() is made of, in its order.
std::vector<Collider> headAndColliders(const Style& style) {
    std::vector<Collider> all;
    if (style.headCollides && style.headMesh != "none")
        all.push_back({style.headMesh, style.headPlacement, style.headGap, style.headFriction});
    all.insert(all.end(), style.colliders.begin(), style.colliders.end());
    return all;
}

}  // namespace

Result<Mesh> headOf(const Style& style) {
    return meshOf(style.headMesh, style.headPlacement);
}

Result<std::vector<Mesh>> collidersOf(const Style& style) {
    return meshesOf(style.colliders);
}

std::vector<float> frictionsOf(const Style& style) {
    std::vector<float> frictions;
    for (const Collider& collider : headAndColliders(style))
        frictions.push_back(static_cast<float>(collider.friction));
    return frictions;
}

Result<DistanceField> solidsOf(const Style& style, const std::string& cacheFolder, int threads) {
    const std::vector<Collider> colliders = headAndColliders(style);
    DistanceFieldOptions options;
    options.threads = threads;
    // The built-in head need not be made to be known.
    if (colliders.size() == 1 && colliders[0].mesh == "mannequin") {
        return cachedField(fieldName(mannequinKey, colliders[0].gap), cacheFolder, [&] {
            const Solid head = {mannequin(), colliders[0].gap};
            return distanceFieldOf({&head, 1}, options);
        });
    }
    Result<std::vector<Mesh>> meshes = meshesOf(colliders);
    if (!meshes) return meshes.problems();
    std::vector<Solid> solids;
    for (std::size_t i = 0; i < colliders.size(); ++i)
        solids.push_back({std::move((*meshes)[i]), colliders[i].gap});
    return cachedField(fieldName(solids, options), cacheFolder,
                       [&] { return distanceFieldOf(solids, options); });
}

}  // namespace kushi
