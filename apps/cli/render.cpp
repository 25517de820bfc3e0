// SPDX-License-Identifier: Apache-2.0
#include "commands.h"
#include "input.h"
#include "messages.h"
#include "report.h"
#include "scene.h"
#include "showing.h"

#include <cstdio>
#include <optional>

namespace kushi {

namespace {

/// layers  beside a picture without background; or none, for a picture with one
Status drawTo(const std::string& path, Scene& scene, const Camera& camera,
              const DrawOptions& options, Look look, const std::optional<Layers>& layers,
              StageClock& clock) {
    if (!layers) return writePng(drawScene(scene, camera, options, look, clock), path);
    LayeredImage image = drawSceneLayers(scene, camera, options, look, *layers, clock);
    if (hasEnding(path, {".exr"}, "").ok()) return writeExr(image, path);
    if (look == Look::Natural) image.image = rolledOff(std::move(image.image));
    return writePng(image, path);
}

}  // namespace

int runRender(const RenderArguments& arguments) {
    const Result<std::pair<int, int>> size = parseSize(arguments.size, "--size");
    if (!size) return report(size.problems());
    const Result<View> view = parseView(arguments.view);
    if (!view) return report(view.problems());
    if (const Status ending = hasEnding(arguments.output, {".png", ".exr"}, "the picture");
        !ending) {
        return report(ending.problems());
    }
    const Result<Layers> layers = parseLayers(arguments.layers);
    if (!layers) return report(layers.problems());
    const bool exr = hasEnding(arguments.output, {".exr"}, "").ok();
    if (!arguments.layers.empty() && !exr) {
        return report(
            {{"--layers needs an output that can hold them: end it in .exr", arguments.output}});
    }
    if (const Status outputs = checkOutputs(arguments.output, arguments.reportPath); !outputs) {
        return report(outputs.problems());
    }

    StageClock clock;
    const bool reporting = !arguments.reportPath.empty();
    Result<Scene> scene = loadScene(arguments.input, arguments.flags, reporting, clock);
    if (!scene) return report(scene.problems());
    const Look look = lookNamed(arguments.look);
    prepare(*scene, look, clock);
    const DrawOptions options = drawOptions(*size, arguments.stroke, look, arguments.flags.threads);
    const Camera camera = portrait(*scene, *view, static_cast<double>(size->first) / size->second);
    const std::optional<Layers> wanted =
        exr || arguments.alpha ? std::optional(*layers) : std::nullopt;
    if (const Status written =
            drawTo(arguments.output, *scene, camera, options, look, wanted, clock);
        !written) {
        return report(written.problems());
    }
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
