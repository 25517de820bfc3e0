// SPDX-License-Identifier: Apache-2.0
#include "commands.h"
#include "input.h"
#include "messages.h"
#include "report.h"
#include "scene.h"
#include "showing.h"
#include "zoom.h"

#include <cstdio>
#include <optional>

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

/// The picture by following light; with layers beside it, without background.
Result<LayeredImage> traced(const Scene& scene, const Camera& camera, const DrawOptions& draw,
                            const PathFlags& flags, const std::optional<Layers>& layers,
                            StageClock& clock) {
    TraceOptions options;
    options.width = draw.width;
    options.height = draw.height;
    options.threads = draw.threads;
    options.samplesPerPixel = flags.samples.value_or(options.samplesPerPixel);
    options.bounces = flags.bounces.value_or(options.bounces);
    options.noise = flags.noise.value_or(options.noise);
    options.seed = flags.seed.value_or(options.seed);
    Result<Traced> result = traceScene(scene, camera, options, layers.has_value(), clock);
    if (!result) return result.problems();
    std::printf("%.4g samples a pixel, noise %.2g %%\n", result->samples, 100 * result->noise);
    LayeredImage image;
    if (layers) {
        const std::vector<Rgb> dark(scene.strands.nodes.size());
        image = drawLayers(scene.strands, dark, scene.head, camera, draw, *layers);
        clock.end("draw");
    }
    image.image = std::move(result->image);
    image.alpha = std::move(result->alpha);
    return image;
}

/// layers  beside a picture without background; or none, for a picture with one
Status renderTo(const RenderArguments& arguments, Scene& scene, const Camera& camera,
                const DrawOptions& options, const std::optional<Layers>& layers,
                StageClock& clock) {
    const std::string& path = arguments.output;
    const Look look = lookNamed(arguments.look);
    LayeredImage image;
    if (arguments.engine == "path") {
        Result<LayeredImage> result = traced(scene, camera, options, arguments.path, layers, clock);
        if (!result) return result.problems();
        image = std::move(*result);
        if (!layers) return writePng(rolledOff(std::move(image.image)), path);
    } else {
        if (!layers) return writePng(drawScene(scene, camera, options, look, clock), path);
        image = drawSceneLayers(scene, camera, options, look, *layers, clock);
    }
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
    const Result<Zoom> zoom = arguments.zoom.empty() ? Zoom() : parseZoom(arguments.zoom);
    if (!zoom) return report(zoom.problems());
    if (const Status flags = checkEngine(arguments); !flags) return report(flags.problems());
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
    prepare(*scene, look, arguments.flags.threads, clock);
    const DrawOptions options = drawOptions(*size, arguments.stroke, look, arguments.flags.threads);
    const double aspect = static_cast<double>(size->first) / size->second;
    Camera camera = portrait(*scene, *view, aspect);
    if (!arguments.zoom.empty()) camera = zoomed(camera, *zoom, aspect);
    const std::optional<Layers> wanted =
        exr || arguments.alpha ? std::optional(*layers) : std::nullopt;
    if (const Status written = renderTo(arguments, *scene, camera, options, wanted, clock);
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
