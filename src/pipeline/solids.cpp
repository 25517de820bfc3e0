// SPDX-License-Identifier: Apache-2.0
#include <kushi/head.h>
#include <kushi/settle.h>

namespace kushi {

namespace {

Result<Mesh> meshOf(const std::string& mesh, const MeshPlacement& placement) {
    if (mesh == "none") return Mesh{};
    if (mesh == "mannequin") return mannequin();
    return readMesh(mesh, placement);
}

}  // namespace

Result<Mesh> headOf(const Style& style) {
    return meshOf(style.headMesh, style.headPlacement);
}

Result<DistanceField> solidsOf(const Style& style, int threads) {
    std::vector<Solid> solids;
    std::vector<Problem> problems;
    const auto add = [&](const std::string& mesh, const MeshPlacement& placement, double gap) {
        Result<Mesh> read = meshOf(mesh, placement);
        if (read) {
            solids.push_back({std::move(read).value(), gap});
        } else {
            problems.insert(problems.end(), read.problems().begin(), read.problems().end());
        }
    };
    if (style.headCollides && style.headMesh != "none")
        add(style.headMesh, style.headPlacement, style.headGap);
    for (const Collider& collider : style.colliders)
        add(collider.mesh, collider.placement, collider.gap);
    if (!problems.empty()) return problems;
    DistanceFieldOptions options;
    options.threads = threads;
    return distanceFieldOf(solids, options);
}

}  // namespace kushi
