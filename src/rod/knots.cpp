// SPDX-License-Identifier: Apache-2.0
#include "rod/knots.h"

#include <algorithm>
#include <array>
#include <map>

namespace kushi {

namespace {

constexpr int mostSteps = 40;
constexpr double balanced = 1e-3;  // force on a knot over the forces of its ties
constexpr double probe = 2e-3;     // by which it is moved to measure its stiffness, over the reach
constexpr double longest = 0.1;    // most that it moves in a step, over the reach

using Columns = std::array<Vec3d, 3>;

Vec3d operator*(const Columns& m, Vec3d v) {
    return v.x * m[0] + v.y * m[1] + v.z * m[2];
}

// x of m x = v, by Cramer's rule; 0 if there is none.
Vec3d solve(const Columns& m, Vec3d v) {
    const double determinant = dot(m[0], cross(m[1], m[2]));
    if (determinant == 0) return {};
    return Vec3d{dot(v, cross(m[1], m[2])), dot(m[0], cross(v, m[2])), dot(m[0], cross(m[1], v))} /
           determinant;
}

struct Knot {
    std::vector<std::size_t> ties;
    Vec3d at;
    Vec3d force;      // of its ties on the strands, together
    double size = 0;  // and apart
    Columns stiffness{};
    double stride = longest;

    bool isBalanced() const { return length(force) <= balanced * size; }
};

std::vector<Knot> knotsOf(std::span<const Tie> ties) {
    std::map<std::uint32_t, Knot> knots;
    for (std::size_t t = 0; t < ties.size(); ++t) {
        if (ties[t].knot == Tie::none) continue;
        Knot& knot = knots[ties[t].knot];
        knot.at += ties[t].point.as<double>();
        knot.ties.push_back(t);
    }
    std::vector<Knot> list;
    for (auto& [name, knot] : knots) {
        knot.at = knot.at / static_cast<double>(knot.ties.size());
        list.push_back(std::move(knot));
    }
    return list;
}

class Untangling {
public:
    Untangling(std::span<const Tie> ties, double reach, const SettleTied& settle)
        : ties_(ties.begin(), ties.end()), knots_(knotsOf(ties)), reach_(reach), settle_(settle) {}

    RestReport run(bool warm) {
        solveAt({}, warm);
        if (!allBalanced()) measure();
        for (int step = 0; step < mostSteps && !allBalanced(); ++step)
            move();
        for (const Knot& knot : knots_) {
            if (knot.isBalanced()) continue;
            for (const std::size_t tie : knot.ties)
                report_.unsettled.push_back(ties_[tie].strand);
        }
        std::vector<std::uint32_t>& unsettled = report_.unsettled;
        std::sort(unsettled.begin(), unsettled.end());
        unsettled.erase(std::unique(unsettled.begin(), unsettled.end()), unsettled.end());
        return std::move(report_);
    }

private:
    bool allBalanced() const { return std::ranges::all_of(knots_, &Knot::isBalanced); }

    void solveAt(Vec3d offset, bool warm) {
        for (const Knot& knot : knots_)
            for (const std::size_t tie : knot.ties)
                ties_[tie].point = (knot.at + offset).as<float>();
        report_ = settle_(ties_, warm);
        for (Knot& knot : knots_) {
            knot.force = {};
            knot.size = 0;
            for (const std::size_t tie : knot.ties) {
                knot.force += report_.tieForces[tie].as<double>();
                knot.size += length(report_.tieForces[tie]);
            }
        }
    }

    void measure() {
        const std::vector<Knot> before = knots_;
        const double size = probe * reach_;
        const Columns axes = {Vec3d{size, 0, 0}, Vec3d{0, size, 0}, Vec3d{0, 0, size}};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            solveAt(axes[axis], true);
            for (std::size_t k = 0; k < knots_.size(); ++k)
                knots_[k].stiffness[axis] = (knots_[k].force - before[k].force) / size;
        }
        solveAt({}, true);
    }

    void move() {
        const std::vector<Knot> before = knots_;
        for (Knot& knot : knots_) {
            Vec3d step = -solve(knot.stiffness, knot.force);
            // Never along the pull: from far off the stiffness may have the wrong sign.
            if (dot(step, knot.force) >= 0) step = -knot.force;
            const double most = knot.stride * reach_;
            if (length(step) > most) step *= most / length(step);
            knot.at += step;
        }
        solveAt({}, true);
        for (std::size_t k = 0; k < knots_.size(); ++k) {
            Knot& knot = knots_[k];
            const Vec3d step = knot.at - before[k].at;
            const double square = dot(step, step);
            if (square == 0) continue;
            knot.stride = length(knot.force) > length(before[k].force)
                              ? 0.25 * length(step) / reach_
                              : std::min(longest, 2 * knot.stride);
            const Vec3d missed = (knot.force - before[k].force - knot.stiffness * step) / square;
            knot.stiffness[0] += step.x * missed;
            knot.stiffness[1] += step.y * missed;
            knot.stiffness[2] += step.z * missed;
        }
    }

    std::vector<Tie> ties_;
    std::vector<Knot> knots_;
    double reach_;
    const SettleTied& settle_;
    RestReport report_;
};

}  // namespace

RestReport settleKnots(std::span<const Tie> ties, double reach, bool warm,
                       const SettleTied& settle) {
    return Untangling(ties, reach, settle).run(warm);
}

}  // namespace kushi
