// SPDX-License-Identifier: Apache-2.0
#include "commands.h"
#include "input.h"
#include "messages.h"
#include "report.h"

#include <kushi/camera.h>
#include <kushi/draw.h>
#include <kushi/groom_io.h>
#include <kushi/shade.h>

#include <charconv>
#include <cstdio>

namespace kushi {

namespace {

// What there is to draw.
struct Scene {
    Strands strands;
    Mesh head;
    SettleReport report;
};

Result<std::pair<int, int>> parseSize(const std::string& text) {
    int width = 0;
    int height = 0;
    const char* const end = text.data() + text.size();
    const auto [x, widthError] = std::from_chars(text.data(), end, width);
    const bool hasX = widthError == std::errc{} && x != end && *x == 'x';
    const bool good = hasX && std::from_chars(x + 1, end, height).ptr == end;
    if (!good || width < 1 || height < 1 || width > 16384 || height > 16384) {
        return Problem{
            "--size is WIDTHxHEIGHT in pixels, each 1 to 16384, such as 1024x1024; got '" + text +
            "'"};
    }
    return std::pair(width, height);
}

Result<Scene> loadScene(const RenderArguments& arguments, StageClock& clock) {
    const Result<bool> isStyle = isStylePath(arguments.input);
    if (!isStyle) return isStyle.problems();
    Scene scene;
    if (*isStyle) {
        const Result<Style> style = readStyle(arguments.input);
        if (!style) return style.problems();
        clock.end("read");
        const Result<SettledGroom> groom = settleWithProgress(
            *style, arguments.input, arguments.flags, !arguments.reportPath.empty());
        if (!groom) return groom.problems();
        scene.strands = withInnerPieces(*groom);
        scene.report = groom->report;
        clock.add(groom->report.stages);
        Result<Mesh> head = headOf(*style);
        if (!head) return head.problems();
        scene.head = std::move(*head);
        clock.end("head");
        return scene;
    }
    if (arguments.flags.count || arguments.flags.segments || !arguments.flags.method.empty()) {
        return Problem{"--count, --segments and --method are for styles; a groom is drawn as it is",
                       arguments.input};
    }
    Result<Strands> strands = readGroom(arguments.input);
    if (!strands) return strands.problems();
    scene.strands = std::move(*strands);
    scene.report.strands = scene.strands.size();
    scene.report.segments = scene.strands.segmentCount();
    clock.end("read");
    return scene;
}

Bounds boundsOf(const Scene& scene) {
    Bounds bounds = boundsOf(scene.strands.nodes);
    // A figure's legs would make its head tiny; the mannequin's base is above this.
    constexpr float lowestFramed = -0.34F;  // m
    for (const Vec3f vertex : scene.head.vertices) {
        if (vertex.y > lowestFramed) bounds.include(vertex);
    }
    return bounds;
}

Image drawScene(Scene& scene, const RenderArguments& arguments, View view, std::pair<int, int> size,
                StageClock& clock) {
    const Camera camera =
        frame(boundsOf(scene), view, static_cast<double>(size.first) / size.second);
    const Lights lights = studioLights();
    std::vector<Rgb> colors(scene.strands.nodes.size());
    shade(scene.strands, lights, HairLook{}, camera.eye, colors, arguments.flags.threads);
    scene.head.colors = shadeMatt(scene.head, lights, {0.62F, 0.56F, 0.52F});
    clock.end("shade");

    DrawOptions options;
    options.width = size.first;
    options.height = size.second;
    options.supersample = arguments.supersample;
    options.threads = arguments.flags.threads;
    Image image = draw(scene.strands, colors, scene.head, camera, options);
    clock.end("draw");
    return image;
}

}  // namespace

int runRender(const RenderArguments& arguments) {
    const Result<std::pair<int, int>> size = parseSize(arguments.size);
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
    Result<Scene> scene = loadScene(arguments, clock);
    if (!scene) return report(scene.problems());
    const Image image = drawScene(*scene, arguments, *view, *size, clock);
    if (const Status written = writePng(image, arguments.output); !written)
        return report(written.problems());
    clock.end("write");
    if (const Status written = writeReport(arguments.reportPath, reportJson(scene->report, clock));
        !written) {
        return report(written.problems());
    }
    std::printf("%s: %s (%s)\n", arguments.output.c_str(),
                counted(scene->strands.size(), "strand").c_str(), timesLine(clock).c_str());
    return Done;
}

}  // namespace kushi
