// SPDX-License-Identifier: Apache-2.0
#include "trace/tiles.h"

#include "core/parallel.h"
#include "core/random.h"
#include "trace/pixel_filter.h"

#include <array>
#include <atomic>
#include <bit>
#include <cmath>

namespace kushi {

namespace {

constexpr int side = 16;          // pixels of a tile
constexpr int batch = 16;         // samples a pixel between two looks at the noise
constexpr double darkest = 0.02;  // brightness below which noise is no share of it any more

/// What the samples of one pixel have brought.
struct Pixel {
    Rgb sum;
    int samples = 0;
    int covered = 0;
    double brightness = 0;  // sum of luminance
    // The same when there were as many samples as the last power of two, and the one before it.
    double last = 0, before = 0;

    void add(const Seen& seen, Rgb background) {
        const Rgb light = seen.covered ? seen.light : background;
        sum += light;
        covered += seen.covered ? 1 : 0;
        brightness += static_cast<double>(luminance(light));
        if (std::has_single_bit(static_cast<unsigned>(++samples))) {
            before = last;
            last = brightness;
        }
    }
    /// Square of the standard error of the mean brightness, from how much the mean of the first
    /// samples, a power of two of them, differs from that of the others: both parts are evenly
    /// spread as the whole is, which single samples are not.
    double uncertainty() const {
        if (samples < 2) return 0;
        const double first = std::bit_floor(static_cast<unsigned>(samples)) / 2.0;
        const double others = samples - first;
        const double difference = before / first - (brightness - before) / others;
        return difference * difference * first * others / samples / samples;
    }
};

/// Sums over pixels.
struct Noise {
    double brightness = 0, uncertainty = 0;
    double samples = 0;
    double pixels = 0;

    void add(const Noise& other) {
        brightness += other.brightness;
        uncertainty += other.uncertainty;
        samples += other.samples;
        pixels += other.pixels;
    }
    double share() const {
        return std::sqrt(uncertainty / pixels) / std::max(brightness / pixels, darkest);
    }
};

class Tile {
public:
    Tile(const World& world, const Projection& projection, const PixelFilter& filter,
         const TraceOptions& options, std::size_t column, std::size_t row)
        : world_(world),
          projection_(projection),
          filter_(filter),
          options_(options),
          left_(static_cast<int>(column) * side),
          top_(static_cast<int>(row) * side),
          width_(std::min(side, options.width - left_)),
          height_(std::min(side, options.height - top_)) {}

    Noise trace(Traced& into) {
        const int step = options_.noise > 0 ? batch : options_.samplesPerPixel;
        while (samples_ < options_.samplesPerPixel) {
            addSamples(std::min(options_.samplesPerPixel, samples_ + step));
            if (noise().share() < options_.noise) break;
        }
        store(into);
        return noise();
    }

private:
    template <class Visit>
    void forEachPixel(Visit&& visit) {
        for (int y = 0; y < height_; ++y) {
            for (int x = 0; x < width_; ++x)
                visit(left_ + x, top_ + y,
                      pixels_[static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x)]);
        }
    }

    void addSamples(int until) {
        const double width = length(projection_.through(1, 0) - projection_.through(0, 0));
        const PathLimits limits = {options_.bounces, options_.clamp, static_cast<float>(width)};
        forEachPixel([&](int x, int y, Pixel& pixel) {
            const std::uint64_t key = mixKey(options_.seed, number(x, y));
            for (int i = samples_; i < until; ++i) {
                Sampler random(key, static_cast<std::uint32_t>(i));
                const Pair place = random.pair();
                const Vec3d way = normalized(projection_.through(x + 0.5 + filter_.place(place.u),
                                                                 y + 0.5 + filter_.place(place.v)));
                const Ray ray = {projection_.eye().as<float>(), way.as<float>(),
                                 static_cast<float>(projection_.nearPlane())};
                pixel.add(follow(world_, ray, random, limits, scratch_), options_.background);
            }
        });
        samples_ = until;
    }

    Noise noise() {
        Noise sum;
        forEachPixel([&](int, int, const Pixel& pixel) {
            sum.add({pixel.brightness / samples_, pixel.uncertainty(),
                     static_cast<double>(samples_), 1});
        });
        return sum;
    }

    void store(Traced& into) {
        const float share = 1 / static_cast<float>(samples_);
        forEachPixel([&](int x, int y, const Pixel& pixel) {
            into.image.at(x, y) = share * pixel.sum;
            into.alpha[number(x, y)] = share * static_cast<float>(pixel.covered);
        });
    }

    std::size_t number(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(options_.width) +
               static_cast<std::size_t>(x);
    }

    const World& world_;
    const Projection& projection_;
    const PixelFilter& filter_;
    const TraceOptions& options_;
    int left_, top_, width_, height_;
    int samples_ = 0;
    std::array<Pixel, std::size_t{side} * side> pixels_;
    std::vector<float> scratch_;
};

}  // namespace

Traced traceTiles(const World& world, const Projection& projection, const TraceOptions& options) {
    const auto tilesAlong = [](int pixels) {
        return (static_cast<std::size_t>(pixels) + side - 1) / side;
    };
    const std::size_t columns = tilesAlong(options.width);
    const std::size_t count = columns * tilesAlong(options.height);
    const PixelFilter filter;
    Traced traced;
    traced.image.width = options.width;
    traced.image.height = options.height;
    traced.image.pixels.resize(static_cast<std::size_t>(options.width) *
                               static_cast<std::size_t>(options.height));
    traced.alpha.resize(traced.image.pixels.size());
    std::vector<Noise> noise(count);
    std::atomic<std::size_t> done = 0;
    parallelFor(count, 1, options.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            noise[i] =
                Tile(world, projection, filter, options, i % columns, i / columns).trace(traced);
            if (options.progress)
                options.progress(static_cast<double>(++done) / static_cast<double>(count));
        }
    });
    Noise all;
    for (const Noise& tile : noise)
        all.add(tile);
    traced.samples = all.samples / all.pixels;
    traced.noise = all.share();
    return traced;
}

}  // namespace kushi
