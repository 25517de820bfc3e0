// SPDX-License-Identifier: Apache-2.0
#include "trace/tiles.h"

#include <kushi/trace.h>

#include <string>

namespace kushi {

namespace {

class Check {
public:
    void within(const char* what, double value, double least, double most) {
        if (value >= least && value <= most) return;
        fail(std::string(what) + " is " + text(value) + ", expected " + text(least) + " to " +
             text(most));
    }
    void as(const char* what, std::size_t count, std::size_t expected, const char* of) {
        if (count == expected) return;
        fail("there are " + std::to_string(count) + " " + what + ", expected one for each of the " +
             std::to_string(expected) + " " + of);
    }
    void that(bool good, const char* otherwise) {
        if (!good) fail(otherwise);
    }
    const std::vector<Problem>& problems() const { return problems_; }

private:
    static std::string text(double value) {
        std::string digits = std::to_string(value);
        while (digits.find('.') != std::string::npos &&
               (digits.back() == '0' || digits.back() == '.')) {
            const bool point = digits.back() == '.';
            digits.pop_back();
            if (point) break;
        }
        return digits;
    }
    void fail(std::string message) { problems_.push_back({.message = std::move(message)}); }

    std::vector<Problem> problems_;
};

bool isLight(Rgb color) {
    const auto good = [](float x) { return x >= 0 && std::isfinite(x); };
    return good(color.r) && good(color.g) && good(color.b);
}

void checkOptions(const TraceOptions& options, Check& check) {
    check.within("width", options.width, 1, 16384);
    check.within("height", options.height, 1, 16384);
    check.within("the number of samples per pixel", options.samplesPerPixel, 1, 65536);
    check.within("the number of bounces", options.bounces, 0, 10000);
    check.within("noise", static_cast<double>(options.noise), 0, 1);
    check.within("clamp", static_cast<double>(options.clamp), 0, 1e30);
}

void checkLook(const TraceLook& look, Check& check) {
    check.within("the fibre's index of refraction", look.fibre.eta, 1.001, 4);
    check.within("the fibre's longitudinal roughness", look.fibre.longitudinal, 0.01, 1);
    check.within("the fibre's azimuthal roughness", look.fibre.azimuthal, 0.01, 1);
    check.within("the fibre's tilt in radians", look.fibre.tilt, -0.5, 0.5);
    check.within("the tilt's variation in radians", static_cast<double>(look.tiltVariation), 0,
                 0.5);
    check.within("the hair's diameter in metres", static_cast<double>(look.diameter), 0, 1);
    check.within("the skin's gloss", static_cast<double>(look.skinGloss), 0, 1);
    check.within("the skin's roughness", static_cast<double>(look.skinRoughness), 0.05, 1);
}

void checkLights(const Lights& lights, Check& check) {
    bool good = isLight(lights.ambient);
    for (const Light& light : lights.distant) {
        const float size = length(light.direction);
        good = good && isLight(light.color) && std::isfinite(size) && size > 0;
        check.within("half the angle of a light in radians", static_cast<double>(light.halfAngle),
                     0, 1.58);
    }
    check.that(good, "a light is negative, not finite or comes from nowhere");
}

void checkSizes(const Strands& strands, const Mesh& head, std::span<const Rgb> skin, Check& check) {
    const std::size_t nodes = strands.nodes.size();
    const std::size_t vertices = head.vertices.size();
    if (!strands.colors.empty()) check.as("hair colours", strands.colors.size(), nodes, "nodes");
    if (!strands.diameters.empty()) check.as("diameters", strands.diameters.size(), nodes, "nodes");
    if (!skin.empty()) check.as("skin colours", skin.size(), vertices, "vertices");
    if (!head.triangles.empty()) check.as("normals", head.normals.size(), vertices, "vertices");
}

}  // namespace

Result<Traced> trace(const Strands& strands, const Mesh& head, std::span<const Rgb> skin,
                     const Lights& lights, const Camera& camera, const TraceLook& look,
                     const TraceOptions& options) {
    Check check;
    checkOptions(options, check);
    checkLook(look, check);
    checkLights(lights, check);
    checkSizes(strands, head, skin, check);
    const Projection projection(camera, options.width, options.height);
    check.that(projection.valid(), "the camera looks nowhere");
    if (!check.problems().empty()) return check.problems();
    const World world(strands, head, skin, lights, look, options.threads);
    return traceTiles(world, projection, options);
}

}  // namespace kushi
