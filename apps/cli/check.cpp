// SPDX-License-Identifier: Apache-2.0
#include "commands.h"
#include "input.h"
#include "messages.h"
#include "report.h"

#include <kushi/follicles.h>
#include <kushi/groom_io.h>
#include <kushi/settle.h>

#include <algorithm>
#include <cstdio>

namespace kushi {

namespace {

// The files that a style names.
Status checkFiles(const Style& style) {
    const bool growsFromIt = std::ranges::any_of(
        style.parts, [](const Part& part) { return part.scalp.surface == ScalpSurface::Head; });
    const Result<Mesh> head = growsFromIt || isMeshPath(style.headMesh) ? headOf(style) : Mesh{};
    if (!head) return head.problems();
    if (const auto colliders = collidersOf(style); !colliders) return colliders.problems();
    for (const Part& part : style.parts) {
        if (part.scalp.surface == ScalpSurface::Head) {
            // A single follicle shows whether groups, mask and head go together.
            Scalp scalp = part.scalp;
            scalp.spacing.reset();
            scalp.count = 1;
            const Result<Follicles> planted = plant(scalp, style.seed, *head);
            if (!planted) return planted.problems();
        }
        if (!part.groom) continue;
        if (const Result<Strands> groom = groomOf(part); !groom) return groom.problems();
    }
    return std::monostate{};
}

int checkGroom(const CheckArguments& arguments) {
    const Result<Strands> groom = readGroom(arguments.input);
    if (!groom) return report(groom.problems());
    const Result<Solids> solids = solidsFor(arguments.solids, arguments.input, arguments.threads);
    if (!solids) return report(solids.problems());
    printPenetration(arguments.input, penetrationOf(solids->field, *groom, arguments.threads));
    return Done;
}

}  // namespace

int runCheck(const CheckArguments& arguments) {
    const std::string& path = arguments.input;
    const Result<bool> isStyle = isStylePath(path);
    if (isStyle && !*isStyle) return checkGroom(arguments);
    if (!arguments.solids.empty()) {
        return report({Problem{"--solids is for grooms; a style has its own head and colliders"}});
    }
    const Result<Style> style = readStyle(path);
    if (!style) return report(style.problems());
    if (const Status files = checkFiles(*style); !files) return report(files.problems());
    std::size_t forces = 0;
    std::size_t cuts = 0;
    for (const Part& part : style->parts) {
        forces += part.forces.size();
        cuts += part.cuts.size();
    }
    std::printf("%s: good (%s, %s, %s)\n", path.c_str(),
                counted(style->parts.size(), "part").c_str(), counted(forces, "force").c_str(),
                counted(cuts, "cut").c_str());
    if (!arguments.penetration) return Done;
    SettleFlags flags;
    flags.threads = arguments.threads;
    const Result<SettledGroom> groom = settleWithProgress(*style, path, flags, true);
    if (!groom) return report(groom.problems());
    for (const PartPenetration& part : groom->report.penetration)
        printPenetration('\'' + part.part + '\'', part.found);
    return Done;
}

}  // namespace kushi
