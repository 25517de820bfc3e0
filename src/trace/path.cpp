// SPDX-License-Identifier: Apache-2.0
// Kajiya's path tracing with light sampling at every meeting, both ways weighed by the power
// heuristic (Veach and Guibas 1995).
#include "trace/path.h"

#include <optional>

namespace kushi {

namespace {

/// Probabilities with which to choose one of the discs: by what their middles would bring.
template <class Point>
void shareDiscs(const Point& point, const Sky& sky, Rgb wanted, std::vector<float>& shares) {
    constexpr float even = 0.1F;  // kept for what only their rims bring
    shares.clear();
    float sum = 0;
    float power = 0;
    for (const Disc& disc : sky.discs) {
        const Rgb light = disc.solidAngle * disc.radiance;
        shares.push_back(luminance(wanted * light * point.response(disc.axes.z).value));
        sum += shares.back();
        power += luminance(light);
    }
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const Disc& disc = sky.discs[i];
        const float alone = luminance(disc.solidAngle * disc.radiance) / power;
        shares[i] = sum > 0 ? (1 - even) * shares[i] / sum + even * alone : alone;
    }
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
            light += powerShare(point.response(direction).pdf, shares_[i] / disc.solidAngle) *
                     disc.radiance;
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
        if (!world_.sky().discs.empty()) addDisc(point, second.v, random_.pair(), scattered + 1);
        const Turn turned = point.sample(first, second.u);
        if (!turned.ok) return std::nullopt;
        weight_ = weight_ * turned.weight;
        if (!survives(scattered)) return std::nullopt;
        sky_ = skyAlong(point, turned.direction);
        return point.leaving(turned.direction);
    }

    /// Light straight from one of the discs.
    template <class Point>
    void addDisc(const Point& point, float choice, Pair place, int scattered) {
        const Sky& sky = world_.sky();
        shareDiscs(point, sky, weight_, shares_);
        std::size_t i = 0;
        while (i + 1 < shares_.size() && choice >= shares_[i])
            choice -= shares_[i++];
        const Disc& disc = sky.discs[i];
        const Vec3f direction = disc.sample(place);
        const Response response = point.response(direction);
        const float pdf = shares_[i] / disc.solidAngle;
        const Rgb light = disc.radiance * response.value * (powerShare(pdf, response.pdf) / pdf);
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
