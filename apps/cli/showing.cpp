// SPDX-License-Identifier: Apache-2.0
#include "showing.h"

#include <kushi/head.h>

#include <algorithm>

namespace kushi {

std::optional<double> scalpShowing(const Scene& scene, View view, const DrawOptions& options,
                                   StageClock& clock) {
    if (scene.head.triangles.empty()) return std::nullopt;
    std::vector<View> views = {view};
    for (const char* name : {"front", "back", "left", "right", "top", "three-quarter"})
        views.push_back(*parseView(name));

    const std::vector<std::uint8_t> scalp = scalpTriangles(scene.head);
    const double aspect = static_cast<double>(options.width) / options.height;
    double most = 0;
    for (const View each : views) {
        const Camera camera = portrait(scene, each, aspect);
        most = std::max(most,
                        countShowing(scene.strands, scene.head, scalp, camera, options).share());
    }
    clock.end("showing");
    return most;
}

}  // namespace kushi
