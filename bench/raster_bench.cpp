// SPDX-License-Identifier: Apache-2.0
// How long a picture takes: the mannequin under 50,000 strands of 20 segments, at 1024 x 1024, and
// the same picture by Mesa's OpenGL where that was found at build time. They take turns, so that
// what else the machine does meets all of them; prints medians. Trust ratios more than times.
//
//     raster_bench [REPETITIONS [THREADS]]
#include "wig.h"

#include <kushi/draw.h>
#include <kushi/shade.h>
#include <kushi/shadows.h>
#include <kushi/subdivide.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#ifdef KUSHI_BENCH_MESA
#include "mesa_lines.h"
#endif

namespace {

using namespace kushi;

constexpr int size = 1024;  // pixels

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Something to be timed: the time it takes, and that of all processors together [ms].
struct Contender {
    std::string name;
    std::function<void()> work;
    std::vector<double> wall{}, processor{};

    void run() {
        const auto start = std::chrono::steady_clock::now();
        const std::clock_t processorStart = std::clock();
        work();
        processor.push_back(1e3 * static_cast<double>(std::clock() - processorStart) /
                            CLOCKS_PER_SEC);
        const std::chrono::duration<double, std::milli> time =
            std::chrono::steady_clock::now() - start;
        wall.push_back(time.count());
    }
    void print() const {
        std::printf("%-28s %8.1f %8.1f %8.1f\n", name.c_str(), median(wall),
                    *std::min_element(wall.begin(), wall.end()), median(processor));
    }
};

/// All that the natural look does to settled strands.
Image natural(const bench::Wig& wig, int threads) {
    const Lights lights = portraitLights();
    const Strands strands = subdivided(wig.strands, radians(7), threads);
    const Shadows shadows(strands, wig.head, lights, threads);
    Mesh head = wig.head;
    head.colors = shadeMatt(head, lights, wig.head.colors, shadows);
    return draw(strands, nodeColors(strands, lights, shadows, FibreLook{}, wig.camera.eye), head,
                wig.camera,
                {.width = size, .height = size, .threads = threads, .stroke = Stroke::Sampled});
}

/// The mean of all channels.
double brightness(const Image& image) {
    double sum = 0;
    for (const Rgb p : image.pixels)
        sum += p.r + p.g + p.b;
    return sum / (3 * static_cast<double>(image.pixels.size()));
}

/// How alike two pictures are, as the ratio of white to their mean difference [dB].
double likeness(const Image& a, const Image& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const Rgb p = a.pixels[i];
        const Rgb q = b.pixels[i];
        for (const double d : {p.r - q.r, p.g - q.g, p.b - q.b})
            sum += d * d;
    }
    return -10 * std::log10(sum / (3 * static_cast<double>(a.pixels.size())));
}

#ifdef KUSHI_BENCH_MESA

/// Share of the pixels that are not background.
double coverage(const Image& image, Rgb background) {
    const auto differs = [&](Rgb p) {
        return std::max({std::abs(p.r - background.r), std::abs(p.g - background.g),
                         std::abs(p.b - background.b)}) > 0.01F;
    };
    return static_cast<double>(std::count_if(image.pixels.begin(), image.pixels.end(), differs)) /
           static_cast<double>(image.pixels.size());
}

#endif

}  // namespace

int main(int argc, char** argv) {
    const int repetitions = argc > 1 ? std::max(1, std::atoi(argv[1])) : 9;
    const int threads = argc > 2 ? std::atoi(argv[2]) : 0;

    const bench::Wig wig = bench::mannequinWig();
    const Lights lights = studioLights();
    std::vector<Rgb> colors(wig.colors.size());
    std::vector<Contender> contenders;
    contenders.push_back(
        {"shade",
         [&] { shade(wig.strands, lights, HairLook{}, wig.camera.eye, colors, threads); }});
    const auto ours = [&](Stroke stroke, int supersample, int width = size, int height = size) {
        return draw(wig.strands, wig.colors, wig.head, wig.camera,
                    {.width = width,
                     .height = height,
                     .supersample = supersample,
                     .threads = threads,
                     .stroke = stroke});
    };
    const auto contend = [&](const std::string& name, const auto& picture) {
        contenders.push_back({name, [picture] {
                                  if (picture().pixels.empty()) std::abort();
                              }});
    };
    for (const int supersample : {1, 2, 4}) {
        contend("lines, samples: " + std::to_string(supersample * supersample),
                [&ours, supersample] { return ours(Stroke::Line, supersample); });
    }
    contend("true width, samples: 16", [&] { return ours(Stroke::Sampled, 4); });
    contend("true width, analytic", [&] { return ours(Stroke::Analytic, 4); });
    contend("preview, 1280 x 800", [&] { return ours(Stroke::Sampled, 1, 1280, 800); });
    contend("natural look, from strands", [&] { return natural(wig, threads); });

#ifdef KUSHI_BENCH_MESA
    const Rgb background = DrawOptions{}.background;
    bench::MesaLines mesaOne(wig, size, 1, background);
    bench::MesaLines mesaFour(wig, size, 4, background);
    const bool mesa = mesaOne.problem().empty() && mesaFour.problem().empty();
    if (mesa) {
        contenders.push_back({"Mesa, samples: 1", [&] { mesaOne.draw(); }});
        contenders.push_back({"Mesa, samples: 16", [&] { mesaFour.draw(); }});
    }
#endif

    std::printf("%zu strands, %zu segments, %zu triangles, %d x %d pixels, threads: %s\n",
                wig.strands.size(), wig.strands.segmentCount(), wig.head.triangles.size(), size,
                size, threads > 0 ? std::to_string(threads).c_str() : "all");
    for (Contender& contender : contenders)  // the first time is not like the others
        contender.work();
    for (int i = 0; i < repetitions; ++i) {
        for (Contender& contender : contenders)
            contender.run();
    }
    std::printf("%-28s %8s %8s %8s\n", ("of " + std::to_string(repetitions) + " turns").c_str(),
                "wall ms", "least", "CPU ms");
    for (const Contender& contender : contenders)
        contender.print();

    const Image sampled = ours(Stroke::Sampled, 4);
    const Image analytic = ours(Stroke::Analytic, 4);
    std::printf("brightness: sampled %.4f, analytic %.4f; alike to %.1f dB\n", brightness(sampled),
                brightness(analytic), likeness(sampled, analytic));

#ifdef KUSHI_BENCH_MESA
    if (!mesa) {
        std::printf("Mesa: %s\n", (mesaOne.problem() + mesaFour.problem()).c_str());
        return 0;
    }
    std::printf("Mesa is %s\n", mesaOne.renderer().c_str());
    const auto compare = [&](int supersample, bench::MesaLines& theirs, const Contender& us,
                             const Contender& them) {
        const Image a = ours(Stroke::Line, supersample);
        const Image b = theirs.draw();
        std::printf(
            "samples: %-2d  Mesa takes %.1f times as long; covered: %.3f, Mesa %.3f; brightness: "
            "%.4f, Mesa %.4f; alike to %.1f dB\n",
            supersample * supersample, median(them.wall) / median(us.wall), coverage(a, background),
            coverage(b, background), brightness(a), brightness(b), likeness(a, b));
    };
    compare(1, mesaOne, contenders[1], contenders[8]);
    compare(4, mesaFour, contenders[3], contenders[9]);
#endif
    return 0;
}
