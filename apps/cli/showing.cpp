// SPDX-License-Identifier: Apache-2.0
#include "showing.h"

#include <kushi/head.h>

#include <algorithm>

namespace kushi {

std::vector<ScalpShowing> scalpShowing(const Scene& scene, const DrawOptions& options,
                                       StageClock& clock) {
    if (scene.ofHead == 0) return {};
    std::vector<std::uint8_t> scalp = scalpTriangles(scene.head);
    std::fill(scalp.begin() + static_cast<std::ptrdiff_t>(scene.ofHead), scalp.end(), 0);
    const double aspect = static_cast<double>(options.width) / options.height;
    std::vector<ScalpShowing> shares;
    for (const char* view : {"front", "back", "left", "right", "top", "three-quarter"}) {
        const Camera camera = portrait(scene, *parseView(view), aspect);
        const Showing showing = countShowing(scene.strands, scene.head, scalp, camera, options);
        shares.push_back({view, showing.share()});
    }
    clock.end("showing");
    return shares;
}

}  // namespace kushi
