// SPDX-License-Identifier: Apache-2.0
//
// The elastic and potential energy of a strand, written down from its definition in double
// precision: what kernels are tested against.
#pragma once

#include "rod/rest_rods.h"

#include <algorithm>
#include <array>

namespace kushi::rest {

struct Turn {
    double w = 1, x = 0, y = 0, z = 0;

    Vec3d vector() const { return {x, y, z}; }
};

inline Turn operator*(Turn p, Turn q) {
    const Vec3d v = p.w * q.vector() + q.w * p.vector() + cross(p.vector(), q.vector());
    return {p.w * q.w - dot(p.vector(), q.vector()), v.x, v.y, v.z};
}

// By a rotation vector.
inline Turn turnBy(Vec3d r) {
    const double angle = length(r);
    const double ratio = angle < 1e-9 ? 0.5 : std::sin(0.5 * angle) / angle;
    return {std::cos(0.5 * angle), ratio * r.x, ratio * r.y, ratio * r.z};
}

inline Vec3d rotated(Turn q, Vec3d v) {
    const Vec3d t = 2.0 * cross(q.vector(), v);
    return v + q.w * t + cross(q.vector(), t);
}

// A strand with a frame at each node; straight ones have frames turned from node to node without
// twist, so that one description serves both.
struct Strand {
    const Rods* rods = nullptr;
    std::size_t index = 0;
    std::vector<Turn> frames;   // of n + 1 nodes
    std::vector<Vec3d> chords;  // of n natural helices, in the frames of their middles

    std::size_t size() const { return frames.size() - 1; }
    double segment(std::size_t j) const {
        return rods->segmentLengths.empty()
                   ? static_cast<double>(rods->lengths[index]) / static_cast<double>(size())
                   : static_cast<double>(rods->segmentLengths[rods->offsets[index] + j]);
    }
    double weight(std::size_t j) const {
        return static_cast<double>(rods->weights[index]) * segment(j);
    }
    bool straight() const { return rods->naturalCurvature.empty(); }
    Vec3d curvature(std::size_t j) const {
        return straight() ? Vec3d{} : rods->naturalCurvature[rods->offsets[index] + j].as<double>();
    }

    // Chord of segment j, between nodes j and j + 1: of the natural helix, in the middle frame.
    Vec3d chord(std::size_t j) const {
        const double d = segment(j);
        const Turn& a = frames[j];
        const Turn& b = frames[j + 1];
        if (straight()) {
            return d * normalized(rotated(a, {0, 0, 1}) + rotated(b, {0, 0, 1}));
        }
        const double scale = 1 / std::sqrt((a.w + b.w) * (a.w + b.w) +
                                           dot(a.vector() + b.vector(), a.vector() + b.vector()));
        const Turn middle = {scale * (a.w + b.w), scale * (a.x + b.x), scale * (a.y + b.y),
                             scale * (a.z + b.z)};
        return rotated(middle, chords[j]);
    }

    // The integral of the tangent along the natural helix, seen from its middle (Simpson's rule).
    Vec3d naturalChord(std::size_t j) const {
        const double d = segment(j);
        Vec3d sum;
        constexpr int steps = 64;
        for (int i = 0; i <= steps; ++i) {
            const double s = d * (static_cast<double>(i) / steps - 0.5);
            const double share = i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2;
            sum += share * rotated(turnBy(s * curvature(j)), {0, 0, 1});
        }
        return (d / (3.0 * steps)) * sum;
    }

    double bendEnergy(std::size_t j) const {
        const double d = segment(j);
        const double bending = rods->bending[index];
        const Turn& a = frames[j];
        const Turn& b = frames[j + 1];
        if (straight()) {
            const Vec3d p = rotated(a, {0, 0, 1});
            const Vec3d q = rotated(b, {0, 0, 1});
            const double angle = std::atan2(length(cross(p, q)), dot(p, q));
            return 0.5 * bending * angle * angle / d;
        }
        const Turn r = Turn{a.w, -a.x, -a.y, -a.z} * b;
        const double sine = length(r.vector());
        const double ratio = sine < 1e-9 ? 2 / r.w : 2 * std::atan2(sine, r.w) / sine;
        const Vec3d u = ratio * r.vector() - d * curvature(j);
        return 0.5 / d *
               (bending * (u.x * u.x + u.y * u.y) +
                static_cast<double>(rods->twisting[index]) * u.z * u.z);
    }

    std::vector<Vec3d> places() const {
        std::vector<Vec3d> at = {rods->roots[index].as<double>()};
        for (std::size_t j = 0; j < size(); ++j)
            at.push_back(at.back() + chord(j));
        return at;
    }

    // Elastic, and of the weight under gravity (0, -1, 0).
    double energy() const {
        const std::vector<Vec3d> at = places();
        double sum = 0;
        for (std::size_t j = 0; j < size(); ++j)
            sum += bendEnergy(j) + weight(j) * 0.5 * (at[j].y + at[j + 1].y);
        return sum;
    }

    // What is left of the moments at each node but the first, in its own axes, where each segment
    // j carries the force ends[j] at its end; by central differences.
    std::vector<Vec3d> imbalance(std::span<const Vec3d> ends) {
        std::vector<Vec3d> result(frames.size());
        const double h = 1e-5;
        for (std::size_t node = 1; node < frames.size(); ++node) {
            const Turn before = frames[node];
            const auto nearby = [&](Vec3d turn) {
                frames[node] = before * turnBy(turn);
                double sum = 0;
                for (std::size_t j = node - 1; j <= node && j < size(); ++j)
                    sum += bendEnergy(j) - dot(ends[j], chord(j));
                frames[node] = before;
                return sum;
            };
            result[node] = {(nearby({h, 0, 0}) - nearby({-h, 0, 0})) / (2 * h),
                            (nearby({0, h, 0}) - nearby({0, -h, 0})) / (2 * h),
                            (nearby({0, 0, h}) - nearby({0, 0, -h})) / (2 * h)};
        }
        return result;
    }
};

// A settled strand.
inline Strand strandOf(const Rods& rods, std::size_t index, std::span<const float> turns) {
    Strand strand;
    strand.rods = &rods;
    strand.index = index;
    const Frame& clamp = rods.clamps[index];
    strand.frames.push_back({clamp.w, clamp.x, clamp.y, clamp.z});
    for (std::size_t j = 0; j < rods.segments(index); ++j) {
        Turn q;
        if (strand.straight()) {
            const Vec3d t = normalized(Vec3d{turns[3 * j], turns[3 * j + 1], turns[3 * j + 2]});
            const Frame f = frameAlong(t);
            // In double again: frames are floats.
            const Vec3d axis = cross(Vec3d{0, 0, 1}, t);
            const double sine = length(axis);
            q = sine < 1e-12 ? Turn{f.w, f.x, f.y, f.z}
                             : turnBy((std::atan2(sine, t.z) / sine) * axis);
        } else {
            q = {turns[4 * j], turns[4 * j + 1], turns[4 * j + 2], turns[4 * j + 3]};
        }
        strand.frames.push_back(q);
    }
    for (Turn& q : strand.frames) {
        const double scale = 1 / std::sqrt(q.w * q.w + dot(q.vector(), q.vector()));
        q = {scale * q.w, scale * q.x, scale * q.y, scale * q.z};
    }
    for (std::size_t j = 0; j < strand.size(); ++j)
        strand.chords.push_back(strand.naturalChord(j));
    return strand;
}

}  // namespace kushi::rest
