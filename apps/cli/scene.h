// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands.h"
#include "report.h"

#include <kushi/camera.h>
#include <kushi/draw.h>
#include <kushi/settle.h>
#include <kushi/shadows.h>
#include <kushi/trace.h>

#include <optional>
#include <string>

namespace kushi {

/// What there is to draw of a style or a groom.
struct Scene {
    Strands strands;                 ///< with their inner pieces, if a style's
    Mesh head;                       ///< and the colliders; may be empty
    std::size_t ofHead = 0;          ///< triangles; those of colliders come after
    std::vector<Rgb> skin;           ///< albedo of each of the head's vertices
    float widened = 1;               ///< times their width, strands of a preview stand for the rest
    std::optional<Shadows> shadows;  ///< once a picture in the natural look has been drawn
    std::optional<Ellipsoid> body;   ///< what the hair grows on, if it is known
    SettleReport report;
};

/// Reads and settles a style, with the stages `read`, `plant`, `settle` and `head`, or reads a
/// groom.
Result<Scene> loadScene(const std::string& path, const SettleFlags& flags, bool measurePenetration,
                        StageClock& clock);

/// A camera that sees all of the hair and the head down to its collar; the bust runs out of the
/// picture.
Camera portrait(const Scene& scene, View view, double aspect);

enum class Look {
    Natural,  ///< fibres in their own shadow, by portrait lights, fit for a screen
    Paper,    ///< that of 1992, by the studio's lights
};

/// "natural" or "paper".
Look lookNamed(const std::string& name);

/// Makes the strands smooth enough for the look's highlights. Stage `smooth`.
void prepare(Scene& scene, Look look, int threads, StageClock& clock);

/// The picture; `options` but for the background, which is the look's. Stages `shadows`, of the
/// first in the natural look, and `draw`, in which what shows is shaded.
Image drawScene(Scene& scene, const Camera& camera, DrawOptions options, Look look,
                StageClock& clock);

/// The same without its background, in linear light, and with layers.
LayeredImage drawSceneLayers(Scene& scene, const Camera& camera, const DrawOptions& options,
                             Look look, const Layers& wanted, StageClock& clock);

/// Some of depth, tangent, id and mask, separated by commas; none if empty.
Result<Layers> parseLayers(const std::string& text);

/// For a picture of width x height pixels; strokes that the flags leave open are the look's.
DrawOptions drawOptions(std::pair<int, int> size, const StrokeFlags& flags, Look look, int threads);

/// The natural look by light that is followed through every hair, before it is made fit for a
/// screen, with a progress bar; `options` but for the background. Stage `trace`.
Result<Traced> traceScene(const Scene& scene, const Camera& camera, const TraceOptions& options,
                          bool withoutBackdrop, StageClock& clock);

/// "1024x1024" as width and height in pixels, each 1 to 16384. `flag` stands in the problem.
Result<std::pair<int, int>> parseSize(const std::string& text, const char* flag);

}  // namespace kushi
