// SPDX-License-Identifier: Apache-2.0
#include "io/field_cache.h"

#include <kushi/head.h>
#include <kushi/settle.h>

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
    solid.mesh.vertices = {std::bit_cast<std::array<Vec3f, 1>>(std::array<std::uint32_t, 3>{
        static_cast<std::uint32_t>(mannequinKey), static_cast<std::uint32_t>(mannequinKey >> 32U),
        1})[0]};
    solid.offset = gap;
    return fieldName({&solid, 1}, {});
}

}  // namespace

Result<Mesh> headOf(const Style& style) {
    return meshOf(style.headMesh, style.headPlacement);
}

Result<DistanceField> solidsOf(const Style& style, const std::string& cacheFolder, int threads) {
    std::vector<Collider> colliders = style.colliders;
    if (style.headCollides && style.headMesh != "none") {
        colliders.insert(colliders.begin(), {style.headMesh, style.headPlacement, style.headGap, 0});
    }
    DistanceFieldOptions options;
    options.threads = threads;
    std::vector<Solid> solids;
    std::vector<Problem> problems;
    const auto read = [&] {
        for (const Collider& collider : colliders) {
            Result<Mesh> mesh = meshOf(collider.mesh, collider.placement);
            if (mesh) {
                solids.push_back({std::move(mesh).value(), collider.gap});
            } else {
                problems.insert(problems.end(), mesh.problems().begin(), mesh.problems().end());
            }
        }
    };
    const auto make = [&] { return distanceFieldOf(solids, options); };
    // The built-in head need not be made to be known.
    if (colliders.size() == 1 && colliders[0].mesh == "mannequin") {
        const std::string name = nameOfMannequin(colliders[0].gap);
        return cachedField(name, cacheFolder, [&] {
            read();
            return make();
        });
    }
    read();
    if (!problems.empty()) return problems;
    return cachedField(fieldName(solids, options), cacheFolder, make);
}

}  // namespace kushi
