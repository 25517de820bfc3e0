// SPDX-License-Identifier: Apache-2.0
#include "commands.h"
#include "messages.h"

#include <kushi/follicles.h>
#include <kushi/settle.h>

#include <algorithm>
#include <cstdio>

namespace kushi {

int runCheck(const std::string& path) {
    const Result<Style> style = readStyle(path);
    if (!style) return report(style.problems());
    const bool growsFromIt = std::ranges::any_of(
        style->parts, [](const Part& part) { return part.scalp.surface == ScalpSurface::Head; });
    const Result<Mesh> head = growsFromIt || isMeshPath(style->headMesh) ? headOf(*style) : Mesh{};
    if (!head) return report(head.problems());
    for (const Part& part : style->parts) {
        if (part.scalp.surface == ScalpSurface::Head) {
            // A single follicle shows whether groups, mask and head go together.
            Scalp scalp = part.scalp;
            scalp.spacing.reset();
            scalp.count = 1;
            const Result<Follicles> planted = plant(scalp, style->seed, *head);
            if (!planted) return report(planted.problems());
        }
        if (!part.groom) continue;
        if (const Result<Strands> groom = groomOf(part); !groom) return report(groom.problems());
    }
    std::size_t forces = 0;
    std::size_t cuts = 0;
    for (const Part& part : style->parts) {
        forces += part.forces.size();
        cuts += part.cuts.size();
    }
    std::printf("%s: good (%s, %s, %s)\n", path.c_str(),
                counted(style->parts.size(), "part").c_str(), counted(forces, "force").c_str(),
                counted(cuts, "cut").c_str());
    return Done;
}

}  // namespace kushi
