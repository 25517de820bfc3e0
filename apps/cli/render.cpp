// SPDX-License-Identifier: Apache-2.0
#include "commands.h"
#include "input.h"
#include "messages.h"
#include "report.h"
#include "scene.h"
#include "showing.h"

#include <cstdio>

namespace kushi {

namespace {

Status checkEngine(const RenderArguments& arguments) {
    const PathFlags& path = arguments.path;
    const bool traces = arguments.engine == "path";
    if (!traces && (path.samples || path.bounces || path.noise || path.seed))
        return Problem{"--spp, --bounces, --noise and --seed are for --engine path"};
    if (traces && lookNamed(arguments.look) == Look::Paper)
        return Problem{"--look paper is for --engine raster; --engine path has the natural look"};
    return std::monostate{};
}

Result<Image> traced(const Scene& scene, const Camera& camera, const DrawOptions& draw,
                     const PathFlags& flags, StageClock& clock) {
    TraceOptions options;
    options.width = draw.width;
    options.height = draw.height;
    options.threads = draw.threads;
    options.samplesPerPixel = flags.samples.value_or(options.samplesPerPixel);
    options.bounces = flags.bounces.value_or(options.bounces);
    options.noise = flags.noise.value_or(options.noise);
    options.seed = flags.seed.value_or(options.seed);
    Result<Traced> result = traceScene(scene, camera, options, clock);
    if (!result) return result.problems();
    std::printf("%.4g samples a pixel, noise %.2g %%\n", result->samples, 100 * result->noise);
    return rolledOff(std::move(result->image));
}

}  // namespace

int runRender(const RenderArguments& arguments) {
    const Result<std::pair<int, int>> size = parseSize(arguments.size, "--size");
    if (!size) return report(size.problems());
    const Result<View> view = parseView(arguments.view);
    if (!view) return report(view.problems());
    if (const Status flags = checkEngine(arguments); !flags) return report(flags.problems());
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
    DrawOptions options;
    options.width = size->first;
    options.height = size->second;
    options.supersample = arguments.supersample;
    options.threads = arguments.flags.threads;
    const Camera camera = portrait(*scene, *view, static_cast<double>(size->first) / size->second);
    const Result<Image> image =
        arguments.engine == "path"
            ? traced(*scene, camera, options, arguments.path, clock)
            : drawScene(*scene, camera, options, lookNamed(arguments.look), clock);
    if (!image) return report(image.problems());
    if (const Status written = writePng(*image, arguments.output); !written)
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
