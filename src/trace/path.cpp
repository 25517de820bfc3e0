// SPDX-License-Identifier: Apache-2.0
// Kajiya's path tracing with light sampling at every meeting, both ways weighed by the power
// heuristic (Veach and Guibas 1995).
#include "trace/path.h"

#include <optional>

namespace kushi {

namespace {

/// Of the luminance of all discs, as much as one ray to them may bring; where more may come, more
/// rays are sent.
constexpr float perRay = 0.03F;
constexpr float mostRays = 8;

/// Probabilities with which to choose one of the discs: by what their middles would bring.
/// Returns the luminance that they would bring together if nothing were in the way.
template <class Point>
float shareDiscs(const Point& point, const Sky& sky, Rgb wanted, std::vector<float>& shares) {
    constexpr float even = 0.1F;  // kept for what only their rims bring
    shares.clear();
    float sum = 0;
    for (const Disc& disc : sky.discs) {
        const Rgb light = disc.solidAngle * disc.radiance;
        shares.push_back(luminance(wanted * light * point.response(disc.axes.z).value));
        sum += shares.back();
    }
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const Disc& disc = sky.discs[i];
        const float alone = luminance(disc.solidAngle * disc.radiance) / sky.power;
        shares[i] = sum > 0 ? (1 - even) * shares[i] / sum + even * alone : alone;
    }
    return sum;
}

/// In [0, 1).
float fraction(float x) {
    return std::min(x - std::floor(x), 1 - 0x1p-24F);
}

/// What the first of two ways of finding a direction counts for.
float powerShare(float pdf, float other) {
    return pdf * pdf / (pdf * pdf + other * other);
}

class Path {
public:
    Path(const World& world, Sampler& random, PathLimits limits, std::vector<float>& shares)
        : world_(world), random_(random), limits_(limits), shares_(shares) {}

    Seen follow(Ray ray) {
        Seen seen;
        for (int scattered = 0;; ++scattered) {
            const Meeting met = world_.first(ray);
            if (met.kind == Meeting::Kind::Nothing) {
                if (scattered > 0) add(sky_, scattered);
                break;
            }
            seen.covered = true;
            if (scattered >= limits_.bounces) break;
            const std::optional<Ray> next = scatter(met, ray, scattered);
            if (!next) break;
            ray = *next;
        }
        const float most = limits_.clamp > 0 ? limits_.clamp : std::numeric_limits<float>::max();
        seen.light = once_ + Rgb{std::min(often_.r, most), std::min(often_.g, most),
                                 std::min(often_.b, most)};
        return seen;
    }

private:
    void add(Rgb light, int scattered) { (scattered > 1 ? often_ : once_) += weight_ * light; }

    /// Light of the sky along a turn, if nothing is in the way.
    template <class Point>
    Rgb skyAlong(const Point& point, Vec3f direction) const {
        const Sky& sky = world_.sky();
        Rgb light = sky.dome;
        for (std::size_t i = 0; i < sky.discs.size(); ++i) {
            const Disc& disc = sky.discs[i];
            if (!disc.holds(direction)) continue;
            light += powerShare(point.response(direction).pdf, discDensity(i)) * disc.radiance;
        }
        return light;
    }

    std::optional<Ray> scatter(const Meeting& met, const Ray& ray, int scattered) {
        const Vec3f toEye = -ray.direction;
        if (met.kind == Meeting::Kind::Hair) {
            const HairSpot spot = world_.hairAt(met, ray);
            // By chance a path arrives anywhere across a hair, and a pixel shows all of a thin one.
            const bool thin = scattered > 0 || 2 * spot.radius < limits_.pixel * met.distance;
            const Places places = thin ? Places::all(random_.single()) : Places::one(spot.h);
            return turn(HairPoint(world_.fibre(), spot, toEye, places, weight_), scattered);
        }
        const TraceLook& look = world_.look();
        const SkinSpot spot = world_.skinAt(met, ray);
        return turn(SkinPoint(spot, toEye, weight_, look.skinGloss, look.skinRoughness), scattered);
    }

    template <class Point>
    std::optional<Ray> turn(const Point& point, int scattered) {
        const Pair first = random_.pair();
        const Pair second = random_.pair();
        if (!world_.sky().discs.empty()) addDiscs(point, second.v, random_.pair(), scattered + 1);
        const Turn turned = point.sample(first, second.u);
        if (!turned.ok) return std::nullopt;
        weight_ = weight_ * turned.weight;
        if (!survives(scattered)) return std::nullopt;
        sky_ = skyAlong(point, turned.direction);
        return point.leaving(turned.direction);
    }

    /// How many rays are expected to be sent to a disc from the last place [1/sr].
    float discDensity(std::size_t i) const {
        return rays_ * shares_[i] / world_.sky().discs[i].solidAngle;
    }

    /// Light straight from the discs.
    template <class Point>
    void addDiscs(const Point& point, float choice, Pair place, int scattered) {
        const Sky& sky = world_.sky();
        const float sum = shareDiscs(point, sky, weight_, shares_);
        rays_ = std::clamp(std::nearbyint(sum / (perRay * sky.power)), 1.0F, mostRays);
        for (int i = 0; i < static_cast<int>(rays_); ++i) {
            const auto ray = static_cast<float>(i);
            // Evenly spread over the discs, and over each of them (Roberts's R2 sequence).
            addDisc(point, fraction(choice + ray / rays_),
                    {fraction(place.u + ray * 0.75487767F), fraction(place.v + ray * 0.56984029F)},
                    scattered);
        }
    }

    template <class Point>
    void addDisc(const Point& point, float choice, Pair place, int scattered) {
        std::size_t i = 0;
        while (i + 1 < shares_.size() && choice >= shares_[i])
            choice -= shares_[i++];
        const Disc& disc = world_.sky().discs[i];
        const Vec3f direction = disc.sample(place);
        const Response response = point.response(direction);
        const float density = discDensity(i);
        const Rgb light =
            disc.radiance * response.value * (powerShare(density, response.pdf) / density);
        if (!(brightest(light) > 0)) return;
        if (world_.blocked(point.leaving(direction))) return;
        add(light, scattered);
    }

    /// Paths that can bring little are given up by chance, the others made good for them.
    bool survives(int scattered) {
        if (scattered < 2) return true;
        const float chance = std::min(1.0F, 2 * brightest(weight_));
        if (chance >= 1) return true;
        if (!(random_.single() < chance)) return false;
        weight_ = weight_ * (1 / chance);
        return true;
    }

    const World& world_;
    Sampler& random_;
    PathLimits limits_;
    std::vector<float>& shares_;  // of the discs, at the last place
    float rays_ = 1;              // sent to them from there
    Rgb weight_ = {1, 1, 1};      // what a unit of light from here on brings
    Rgb sky_;                     // that the last turn goes to
    Rgb once_, often_;            // light that was scattered so many times
};

}  // namespace

Seen follow(const World& world, Ray ray, Sampler& random, PathLimits limits,
            std::vector<float>& scratch) {
    return Path(world, random, limits, scratch).follow(ray);
}

}  // namespace kushi
