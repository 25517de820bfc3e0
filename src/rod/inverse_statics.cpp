// SPDX-License-Identifier: Apache-2.0
#include "rod/inverse_statics.h"

#include "rod/kernel/batch-inl.h"

#include <kushi/rest_shape.h>

#include <cmath>
#include <limits>

namespace kushi {

namespace {

using namespace HWY_NAMESPACE;  // NOLINT: the kernels of the processor that everybody has

// What the stiffness must be above that which just holds.
constexpr double spare = 1.25;
// And how closely that is found.
constexpr double closeness = 1.01;

// Strain and moment of a segment, times and over its length, in the axes of the strand.
struct Bent {
    V3<double> strain, moment;
};

// A strand held in a shape.
class HeldStrand {
public:
    HeldStrand(Rods& rods, const RodWorld& world, std::uint32_t strand,
               std::span<const Rotation> frames)
        : rods_(rods),
          strand_(strand),
          bending_(rods.bending[strand]),
          twisting_(rods.twisting[strand]),
          batch_(batchOf(rods, world, strand_)),
          block_(batch_),
          frames_(frames),
          bent_(frames.size() - 1) {
        evaluate();
        findMoments();
    }

    // EI and GJ so many times what they were, and the natural curvature that goes with them.
    void stiffen(double factor) {
        rods_.bending[strand_] = static_cast<float>(factor * bending_);
        rods_.twisting[strand_] = static_cast<float>(factor * twisting_);
        block_.take(std::span(&place, 1));
        for (std::size_t j = 0; j < bent_.size(); ++j) {
            const auto& segment = block_.problem().elements[j];
            const Bent& bent = bent_[j];
            const V3<double> rest = {bent.strain[0] - bent.moment[0] / segment.bend,
                                     bent.strain[1] - bent.moment[1] / segment.bend,
                                     bent.strain[2] - bent.moment[2] / segment.twist};
            const V3<double> curvature = (1 / segment.length) * rest;
            rods_.naturalCurvature[rods_.offsets[strand_] + j] = {static_cast<float>(curvature[0]),
                                                                  static_cast<float>(curvature[1]),
                                                                  static_cast<float>(curvature[2])};
        }
    }

    bool holdsAt(double factor) {
        stiffen(factor);
        return evaluate();
    }

private:
    static constexpr std::uint32_t place = 0;

    static StrandBatch batchOf(const Rods& rods, const RodWorld& world,
                               const std::uint32_t& strand) {
        StrandBatch batch;
        batch.rods = &rods;
        batch.world = &world;
        batch.strands = std::span(&strand, 1);
        return batch;
    }

    // Loads and pivots in the shape; whether it is stable.
    bool evaluate() {
        block_.take(std::span(&place, 1));
        for (std::size_t j = 0; j < frames_.size(); ++j) {
            const Rotation& frame = frames_[j];
            block_.nodes()[j].state = {frame.w, {frame.v.x, frame.v.y, frame.v.z}};
        }
        Progress<double> at{};
        at.share = 1;
        NewtonOptions options;
        options.maxSteps = 0;
        options.curvature = 1;
        Newton<double, Curly<double>> newton(block_.problem(), block_.nodes(), block_.contacts());
        newton.run(options, at);
        return at.stable;
    }

    // Tip to root: each node is in balance when its two segments' moments and loads are.
    void findMoments() {
        V3<double> beyond = {0, 0, 0};
        V3<double> carried = {0, 0, 0};
        const auto nodes = block_.nodes();
        for (std::size_t j = bent_.size(); j > 0; --j) {
            const auto& a = nodes[j - 1].state;
            const auto& b = nodes[j].state;
            const Quaternion<double> r = Curly<double>::between(a, b);
            const V3<double>& v = r.v;
            const double s = dot(v, v);
            const double h = arcsineRatio(s);
            const double h1 = s < 1e-4 ? 1.0 / 6 + 0.15 * s : (1 / r.w - h) / (2 * s);

            // The load's share of the gradient is all of it where there is no moment.
            auto segment = block_.problem().elements[j - 1];
            segment.rest = (2 * h) * v;
            const auto d = Curly<double>::derive<Order::Gradient>(
                segment, a, b, beyond + 0.5 * nodes[j].load, false);
            beyond = beyond + nodes[j].load;

            // C'n = y with C = (w + [v]x) / 2, and n = 2 (h + 2 h1 vv') moment.
            const V3<double> y = -1.0 * (d.gb + carried);
            const V3<double> n = 2.0 * (r.w * y + cross(v, y) + (dot(v, y) / r.w) * v);
            const double along = 2 * h1 * dot(v, n) / (h + 2 * h1 * s);
            bent_[j - 1] = {segment.rest, (0.5 / h) * (n - along * v)};
            carried = d.ga - 0.5 * (r.w * n + cross(v, n));
        }
    }

    Rods& rods_;
    std::uint32_t strand_;
    double bending_, twisting_;
    StrandBatch batch_;
    Block<double, Curly<double>> block_;
    std::span<const Rotation> frames_;
    std::vector<Bent> bent_;
};

// The least stiffness that holds, from above; infinite if there is none up to the most that is
// tried. The moments stay as they are, so the Hessian grows with the stiffness, and what holds once
// holds for any more.
double leastFactor(HeldStrand& strand) {
    if (strand.holdsAt(1 / spare)) return 1 / spare;
    double low = 1 / spare;
    double high = 2 * low;
    while (!strand.holdsAt(high)) {
        if (high * spare >= stiffestHold) return std::numeric_limits<double>::infinity();
        low = high;
        high = std::min(2 * high, stiffestHold / spare);
    }
    while (high > closeness * low) {
        const double middle = std::sqrt(low * high);
        (strand.holdsAt(middle) ? high : low) = middle;
    }
    return high;
}

}  // namespace

Hold balance(Rods& rods, const RodWorld& world, std::uint32_t strand,
             std::span<const Rotation> frames, bool stiffen) {
    HeldStrand held(rods, world, strand, frames);
    Hold hold;
    hold.factor = spare * leastFactor(held);
    hold.stable = hold.factor <= spare && held.holdsAt(1);
    held.stiffen(stiffen && std::isfinite(hold.factor) ? hold.factor : 1);
    return hold;
}

}  // namespace kushi
