// SPDX-License-Identifier: Apache-2.0
// How long a picture takes: 50,000 strands of 20 segments on an ellipsoid of
// 20,000 triangles, at 1024 x 1024. Prints medians; on a machine that does
// other work, trust their ratios.
//
//     raster_bench [REPETITIONS [THREADS]]
#include <kushi/draw.h>
#include <kushi/shade.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numbers>
#include <vector>

namespace {

using namespace kushi;

constexpr int strandCount = 50000;
constexpr int segmentCount = 20;
constexpr double strandLength = 0.25;  // m

/// A strand that leaves the ellipsoid along its normal, turns downwards and
/// follows the surface.
std::vector<Vec3f> strandFrom(const Ellipsoid& head, EllipsoidAngles root) {
    std::vector<Vec3f> nodes;
    Vec3d at = head.point(root);
    Vec3d direction = head.normal(at);
    for (int i = 0; i <= segmentCount; ++i) {
        nodes.push_back(at.as<float>());
        direction = normalized(direction + Vec3d{0, -0.35, 0});
        const Vec3d normal = head.normal(at);
        const double inwards = -dot(direction, normal);
        if (head.implicit(at) < 0.25 && inwards > 0) direction += inwards * normal;
        at += strandLength / segmentCount * normalized(direction);
    }
    return nodes;
}

/// About `strandCount` roots, evenly spread in rows over the upper part of the
/// ellipsoid.
Strands wig(const Ellipsoid& head) {
    constexpr double lowest = 1.67;  // rad from the whorl
    const double spacing = std::sqrt(2 * std::numbers::pi * (1 - std::cos(lowest)) / strandCount);
    Strands strands;
    for (int row = 0; row < static_cast<int>(lowest / spacing); ++row) {
        const double theta = (row + 0.5) * spacing;
        const int columns = static_cast<int>(2 * std::numbers::pi * std::sin(theta) / spacing);
        for (int i = 0; i < columns; ++i) {
            const double phi = 2 * std::numbers::pi * i / columns;
            strands.add(strandFrom(head, {theta, phi}), strands.size());
        }
    }
    return strands;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Prints the medians of wall time and of the time all processors spent on it.
template <class Work>
void measure(const char* name, int repetitions, const Work& work) {
    std::vector<double> wall;
    std::vector<double> processor;
    for (int i = 0; i < repetitions; ++i) {
        const auto start = std::chrono::steady_clock::now();
        const std::clock_t processorStart = std::clock();
        work();
        processor.push_back(1e3 * static_cast<double>(std::clock() - processorStart) /
                            CLOCKS_PER_SEC);
        const std::chrono::duration<double, std::milli> time =
            std::chrono::steady_clock::now() - start;
        wall.push_back(time.count());
    }
    std::printf("%-24s %8.1f %8.1f\n", name, median(wall), median(processor));
}

}  // namespace

int main(int argc, char** argv) {
    const int repetitions = argc > 1 ? std::max(1, std::atoi(argv[1])) : 9;
    const int threads = argc > 2 ? std::atoi(argv[2]) : 0;

    const Ellipsoid ellipsoid = {
        .center = {}, .semiAxes = {0.105, 0.125, 0.085}, .rotateZ = radians(20)};
    Mesh head = ellipsoidMesh(ellipsoid, 71);
    const Strands strands = wig(ellipsoid);
    Camera camera = frame(boundsOf(strands.nodes), {.yaw = 0.6, .pitch = 0.1}, 1);
    // Nearer, so that hair covers half of the picture.
    camera.eye = camera.target + 0.65F * (camera.eye - camera.target);
    const Lights lights = studioLights();
    head.colors = shadeMatt(head, lights, {0.6F, 0.6F, 0.6F});
    std::vector<Rgb> colors(strands.nodes.size());

    std::printf("%zu strands, %zu segments, %zu triangles, %d threads (0: all)\n", strands.size(),
                strands.segmentCount(), head.triangles.size(), threads);
    std::printf("median of %-14d %8s %8s\n", repetitions, "wall ms", "CPU ms");
    measure("shade", repetitions,
            [&] { shade(strands, lights, HairLook{}, camera.eye, colors, threads); });
    for (const int supersample : {1, 2, 4}) {
        const DrawOptions options = {.supersample = supersample, .threads = threads};
        char name[64];
        std::snprintf(name, sizeof name, "draw 1024 x 1024 x %d", supersample * supersample);
        measure(name, repetitions, [&] {
            const Image image = draw(strands, colors, head, camera, options);
            if (image.pixels.empty()) std::abort();
        });
    }
    return 0;
}
