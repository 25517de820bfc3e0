// SPDX-License-Identifier: Apache-2.0
#include "scene.h"

#include "input.h"
#include "progress.h"

#include <kushi/groom_io.h>
#include <kushi/head.h>
#include <kushi/shade.h>
#include <kushi/subdivide.h>

#include <algorithm>
#include <charconv>

namespace kushi {

namespace {

// Where portraits end below [cm from the shoulders up].
constexpr double collar = 0.035;

constexpr Rgb skin = {0.50F, 0.44F, 0.40F};
// Of the tangent from node to node: about as much as highlights are wide [rad].
const double mostTurn = radians(7);
constexpr Rgb backdrop = {0.40F, 0.41F, 0.43F};
constexpr Rgb felt = {0.16F, 0.17F, 0.20F};  // of what is no head

void append(Mesh& to, const Mesh& from) {
    const auto base = static_cast<std::uint32_t>(to.vertices.size());
    to.vertices.insert(to.vertices.end(), from.vertices.begin(), from.vertices.end());
    to.normals.insert(to.normals.end(), from.normals.begin(), from.normals.end());
    for (const auto& [a, b, c] : from.triangles)
        to.triangles.push_back({a + base, b + base, c + base});
}

// How many strands of the style's own each of these stands for.
float inPlaceOf(const Style& style, std::size_t strands) {
    constexpr float most = 16;
    std::size_t all = 0;
    for (const Part& part : style.parts)
        all += static_cast<std::size_t>(part.scalp.count.value_or(0));
    const float times =
        static_cast<float>(all) / static_cast<float>(std::max<std::size_t>(strands, 1));
    // Cuts and regions may leave out a few.
    return times < 1.2F ? 1 : std::min(times, most);
}

Result<Scene> loadStyle(const std::string& path, const SettleFlags& flags, bool measurePenetration,
                        StageClock& clock) {
    const Result<Style> style = readStyle(path);
    if (!style) return style.problems();
    clock.end("read");
    Result<Mesh> head = headOf(*style);
    if (!head) return head.problems();
    clock.end("head");
    const Result<SettledGroom> groom =
        settleWithProgress(*style, path, flags, measurePenetration, &*head);
    if (!groom) return groom.problems();
    Scene scene;
    scene.strands = withInnerPieces(*groom);
    scene.report = groom->report;
    scene.body = style->parts[0].scalp.ellipsoid;
    clock.add(groom->report.stages);
    scene.head = std::move(*head);
    scene.ofHead = scene.head.triangles.size();
    const bool onHead = style->parts[0].scalp.surface == ScalpSurface::Head;
    scene.skin = scalpTint(scene.head, groom->strands, onHead ? std::nullopt : scene.body, skin,
                           flags.threads);
    const Result<std::vector<Mesh>> colliders = collidersOf(*style);
    if (!colliders) return colliders.problems();
    for (const Mesh& collider : *colliders) {
        append(scene.head, collider);
        scene.skin.resize(scene.head.vertices.size(), felt);
    }
    scene.widened = inPlaceOf(*style, scene.report.strands);
    clock.end("tint");
    return scene;
}

// Colours of the hair's nodes, and of the head's vertices in it.
NodeColors lit(Scene& scene, Look look, Vec3f eye, int threads, StageClock& clock) {
    if (look == Look::Paper) {
        const Lights lights = studioLights();
        scene.head.colors = shadeMatt(scene.head, lights, scene.skin);
        return nodeColors(scene.strands, lights, HairLook{.body = scene.body}, eye);
    }
    const Lights lights = portraitLights();
    if (!scene.shadows) {
        scene.shadows.emplace(scene.strands, scene.head, lights, threads);
        scene.head.colors = shadeMatt(scene.head, lights, scene.skin, *scene.shadows);
        clock.end("shadows");
    }
    return nodeColors(scene.strands, lights, *scene.shadows, FibreLook(), eye);
}

}  // namespace

Result<Scene> loadScene(const std::string& path, const SettleFlags& flags, bool measurePenetration,
                        StageClock& clock) {
    const Result<bool> isStyle = isStylePath(path);
    if (!isStyle) return isStyle.problems();
    if (*isStyle) return loadStyle(path, flags, measurePenetration, clock);
    if (flags.count || flags.segments || !flags.method.empty()) {
        return Problem{"--count, --segments and --method are for styles; a groom is drawn as it is",
                       path};
    }
    Result<Strands> strands = readGroom(path);
    if (!strands) return strands.problems();
    Scene scene;
    scene.strands = std::move(*strands);
    scene.report.strands = scene.strands.size();
    scene.report.segments = scene.strands.segmentCount();
    clock.end("read");
    return scene;
}

Camera portrait(const Scene& scene, View view, double aspect) {
    const auto lowest = static_cast<float>(*landmarkHeight("shoulders") + collar);
    Bounds bounds = boundsOf(scene.strands.nodes);
    for (const Vec3f vertex : scene.head.vertices) {
        if (vertex.y > lowest) bounds.include(vertex);
    }
    return frame(bounds, view, aspect);
}

Look lookNamed(const std::string& name) {
    return name == "paper" ? Look::Paper : Look::Natural;
}

void prepare(Scene& scene, Look look, int threads, StageClock& clock) {
    if (look != Look::Natural) return;
    for (float& diameter : scene.strands.diameters)
        diameter *= scene.widened;
    scene.strands = subdivided(std::move(scene.strands), mostTurn, threads);
    clock.end("smooth");
}

Image drawScene(Scene& scene, const Camera& camera, DrawOptions options, Look look,
                StageClock& clock) {
    const NodeColors colors = lit(scene, look, camera.eye, options.threads, clock);
    const bool natural = look == Look::Natural;
    options.background = natural ? backdrop : DrawOptions().background;
    Image image = draw(scene.strands, colors, scene.head, camera, options);
    if (natural) image = rolledOff(std::move(image));
    clock.end("draw");
    return image;
}

LayeredImage drawSceneLayers(Scene& scene, const Camera& camera, const DrawOptions& options,
                             Look look, const Layers& wanted, StageClock& clock) {
    const NodeColors colors = lit(scene, look, camera.eye, options.threads, clock);
    LayeredImage image = drawLayers(scene.strands, colors, scene.head, camera, options, wanted);
    clock.end("draw");
    return image;
}

Result<Layers> parseLayers(const std::string& text) {
    Layers layers;
    if (text.empty()) return layers;
    for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
        end = text.find(',', begin);
        const std::string name = text.substr(begin, end - begin);
        if (name == "depth") {
            layers.depth = true;
        } else if (name == "tangent") {
            layers.tangent = true;
        } else if (name == "id") {
            layers.strand = true;
        } else if (name == "mask") {
            layers.mask = true;
        } else {
            return Problem{"--layers is some of depth,tangent,id,mask; got '" + name + "'"};
        }
    }
    return layers;
}

DrawOptions drawOptions(std::pair<int, int> size, const StrokeFlags& flags, Look look,
                        int threads) {
    DrawOptions options;
    const bool line = flags.stroke.empty() ? look == Look::Paper : flags.stroke == "line";
    options.width = size.first;
    options.height = size.second;
    options.supersample = flags.supersample;
    options.threads = threads;
    options.stroke = line                         ? Stroke::Line
                     : flags.stroke == "analytic" ? Stroke::Analytic
                                                  : Stroke::Sampled;
    options.widen = static_cast<float>(flags.widen);
    options.round = look == Look::Natural;
    return options;
}

Result<Traced> traceScene(const Scene& scene, const Camera& camera, const TraceOptions& options,
                          bool withoutBackdrop, StageClock& clock) {
    ProgressBar bar("tracing");
    TraceOptions shown = options;
    shown.background = withoutBackdrop ? Rgb() : backdrop;
    shown.progress = [&](double share) { bar.show(share); };
    Result<Traced> traced =
        trace(scene.strands, scene.head, scene.skin, portraitLights(), camera, TraceLook{}, shown);
    clock.end("trace");
    return traced;
}

Result<std::pair<int, int>> parseSize(const std::string& text, const char* flag) {
    int width = 0;
    int height = 0;
    const char* const end = text.data() + text.size();
    const auto [x, widthError] = std::from_chars(text.data(), end, width);
    const bool hasX = widthError == std::errc{} && x != end && *x == 'x';
    const bool good = hasX && std::from_chars(x + 1, end, height).ptr == end;
    if (!good || width < 1 || height < 1 || width > 16384 || height > 16384) {
        return Problem{std::string(flag) +
                       " is WIDTHxHEIGHT in pixels, each 1 to 16384, such as 1024x1024; got '" +
                       text + "'"};
    }
    return std::pair(width, height);
}

}  // namespace kushi
