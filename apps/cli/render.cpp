// SPDX-License-Identifier: Apache-2.0
#include "commands.h"
#include "input.h"
#include "messages.h"
#include "report.h"
#include "scene.h"
#include "showing.h"

#include <cstdio>

namespace kushi {

int runRender(const RenderArguments& arguments) {
    const Result<std::pair<int, int>> size = parseSize(arguments.size, "--size");
    if (!size) return report(size.problems());
    const Result<View> view = parseView(arguments.view);
    if (!view) return report(view.problems());
    if (const Status ending = hasEnding(arguments.output, {".png"}, "the picture"); !ending) {
        return report(ending.problems());
    }
    if (const Status outputs = checkOutputs(arguments.output, arguments.reportPath); !outputs) {
        return report(outputs.problems());
    }

    StageClock clock;
    const bool reporting = !arguments.reportPath.empty();
    Result<Scene> scene = loadScene(arguments.input, arguments.flags, reporting, clock);
    if (!scene) return report(scene.problems());
    const DrawOptions options = drawOptions(*size, arguments.stroke, arguments.flags.threads);
    const Camera camera = portrait(*scene, *view, static_cast<double>(size->first) / size->second);
    const Image image = drawScene(*scene, camera, options, clock);
    if (const Status written = writePng(image, arguments.output); !written)
        return report(written.problems());
    clock.end("write");
    if (reporting) {
        const auto showing = scalpShowing(*scene, options, clock);
        const std::string json = renderReportJson(scene->report, showing, clock);
        if (const Status written = writeReport(arguments.reportPath, json); !written) {
            return report(written.problems());
        }
    }
    std::printf("%s: %s (%s)\n", arguments.output.c_str(),
                counted(scene->strands.size(), "strand").c_str(), timesLine(clock).c_str());
    return Done;
}

}  // namespace kushi
