// SPDX-License-Identifier: Apache-2.0
#include "pipeline/grow.h"

#include "core/random.h"
#include "pipeline/growth.h"
#include "pipeline/patch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kushi {

namespace {

constexpr double pi = std::numbers::pi;
constexpr std::uint64_t lengthSalt = 0x6c656e677468;
constexpr std::uint64_t phaseSalt = 0x7068617365;
constexpr std::uint64_t rollSalt = 0x726f6c6c;
constexpr std::uint64_t sizeSalt = 0x73697a65;
constexpr std::uint64_t lockSalt = 0x6c6f636b;

Frame product(Frame p, Frame q) {
    return {p.w * q.w - p.x * q.x - p.y * q.y - p.z * q.z,
            p.w * q.x + q.w * p.x + p.y * q.z - p.z * q.y,
            p.w * q.y + q.w * p.y + p.z * q.x - p.x * q.z,
            p.w * q.z + q.w * p.z + p.x * q.y - p.y * q.x};
}

Frame turn(Vec3d axis, double angle) {
    const Vec3f v = (std::sin(angle / 2) * axis).as<float>();
    return {static_cast<float>(std::cos(angle / 2)), v.x, v.y, v.z};
}

// A wave's direction is a sine of the arc length; its greatest tilt [rad] and its wave number
// [1/m] give amplitude and length.
struct SineWave {
    double tilt = 0, number = 0;
};

// The wave's amplitude and length as multiples of 1 / number, by the midpoint rule.
std::pair<double, double> sizeOf(double tilt) {
    constexpr int points = 64;
    double across = 0;
    double along = 0;
    for (int i = 0; i < points; ++i) {
        const double angle = tilt * std::cos((i + 0.5) * pi / 2 / points);
        across += std::sin(angle) * pi / 2 / points;
        along += std::cos(angle) * 2 * pi / points;
    }
    return {across, along};
}

// Beyond a tilt of 2 the wave would run back into itself.
SineWave sineWave(const Wave& wave) {
    double low = 0;
    double high = 2;
    for (int i = 0; i < 50; ++i) {
        const double tilt = (low + high) / 2;
        const auto [across, along] = sizeOf(tilt);
        (across / along < wave.amplitude / wave.length ? low : high) = tilt;
    }
    return {low, sizeOf(low).second / wave.length};
}

// Hair winds in locks: strands that grow from the same small patch of scalp wind together, but for
// the hair's variation.
constexpr double lockSize = 0.012;  // m

std::uint64_t lockOf(Vec3d root) {
    return patchOf(root, lockSize, lockSalt);
}

// Random about a strand's natural shape: mostly its lock's, and a little its own.
struct Character {
    double variation = 0;
    std::uint64_t key = 0, lock = 0;

    double size() const {
        return 1 + variation * (0.7 * uniformSigned(mixKey(lock, sizeSalt)) +
                                0.3 * uniformSigned(mixKey(key, sizeSalt)));
    }
    double turn(std::uint64_t salt) const {
        return 2 * pi * uniform(mixKey(lock, salt)) +
               pi * variation * uniformSigned(mixKey(key, salt));
    }
};

// A strand's way of winding: the frame it starts with relative to one along the growth direction,
// and the curvature between two places on it.
class NaturalShape {
public:
    // wave  of the hair, if it waves
    NaturalShape(const Hair& hair, const SineWave& wave, std::uint64_t key, Vec3d root) {
        if (hair.curl) {
            const Character own = {hair.curl->variation, key, lockOf(root)};
            const double radius = own.size() * hair.curl->radius;
            const double rise = own.size() * hair.curl->pitch / (2 * pi);
            const double square = radius * radius + rise * rise;
            helix_ = {static_cast<float>(radius / square), 0, static_cast<float>(rise / square)};
            // The helix winds about its Darboux vector; that is laid along the growth direction.
            start_ = product(turn({0, 0, 1}, own.turn(rollSalt)),
                             turn({0, 1, 0}, -std::atan2(radius, rise)));
        } else if (hair.wave) {
            const Character own = {hair.wave->variation, key, lockOf(root)};
            wave_ = wave;
            wave_.tilt *= own.size();
            phase_ = own.turn(phaseSalt);
            start_ = product(turn({0, 0, 1}, own.turn(rollSalt)), turn({1, 0, 0}, tiltAt(0)));
        }
    }

    Frame start() const { return start_; }

    // Mean curvature from one arc length to another [m].
    Vec3f curvature(double from, double to) const {
        if (wave_.number == 0) return helix_;
        return {static_cast<float>((tiltAt(to) - tiltAt(from)) / (to - from)), 0, 0};
    }

private:
    double tiltAt(double s) const { return wave_.tilt * std::sin(wave_.number * s + phase_); }

    Frame start_;
    Vec3f helix_;
    SineWave wave_;
    double phase_ = 0;
};

}  // namespace

double grownLength(const Hair& hair, std::uint64_t key) {
    return hair.length * (1 + hair.lengthVariation * uniformSigned(mixKey(key, lengthSalt)));
}

Sizes uncut(const Hair& hair, const Follicles& follicles, int segments) {
    Sizes sizes;
    sizes.segments.assign(follicles.size(), static_cast<std::size_t>(segments));
    for (const std::uint64_t key : follicles.keys)
        sizes.lengths.push_back(grownLength(hair, key));
    return sizes;
}

Rods grow(const Part& part, const Follicles& follicles, const Sizes& sizes,
          std::span<const std::uint32_t> which, double grading) {
    const Hair& hair = part.hair;
    const bool shaped = hair.curl || hair.wave;
    const SineWave wave = hair.wave ? sineWave(*hair.wave) : SineWave{};
    Rods rods;
    for (const std::uint32_t i : which) {
        const Vec3d root = follicles.roots[i];
        const std::uint64_t key = follicles.keys[i];
        const NaturalShape shape(hair, wave, key, root);
        const Frame along =
            frameAlong(growthDirection(part, {root, follicles.normals[i], follicles.angles[i]}));
        rods.roots.push_back(root.as<float>());
        rods.clamps.push_back(shaped ? product(along, shape.start()) : along);
        rods.lengths.push_back(static_cast<float>(sizes.lengths[i]));
        rods.keys.push_back(key);

        const std::size_t n = sizes.segments[i];
        const auto place = [&](std::size_t j) {
            const double share = static_cast<double>(j) / static_cast<double>(n);
            return sizes.lengths[i] * (grading == 1 ? share : std::pow(share, grading));
        };
        for (std::size_t j = 0; j < n; ++j) {
            const double from = place(j);
            const double to = place(j + 1);
            if (grading != 1) rods.segmentLengths.push_back(static_cast<float>(to - from));
            if (shaped) rods.naturalCurvature.push_back(shape.curvature(from, to));
            if (hair.taper > 0) {
                // Of the hair as it grew: a cut strand ends where it is still thick.
                const double middle = std::min(1.0, (from + to) / 2 / hair.length);
                rods.thickness.push_back(static_cast<float>(1 - hair.taper * middle));
            }
        }
        rods.offsets.push_back(rods.offsets.back() + static_cast<std::uint32_t>(n));
    }
    rods.bending.assign(rods.size(), static_cast<float>(hair.rigidity()));
    rods.twisting.assign(rods.size(), static_cast<float>(hair.torsionalRigidity()));
    rods.weights.assign(rods.size(), static_cast<float>(hair.weightPerLength()));
    return rods;
}

double largestTurn(const Rods& rods) {
    double largest = 0;
    if (rods.naturalCurvature.empty()) return largest;
    for (std::size_t i = 0; i < rods.size(); ++i) {
        for (std::size_t j = 0; j < rods.segments(i); ++j) {
            const Vec3f curvature = rods.naturalCurvature[rods.offsets[i] + j];
            largest = std::max(largest, rods.segmentLength(i, j) * length(curvature));
        }
    }
    return largest;
}

}  // namespace kushi
