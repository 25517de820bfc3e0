// SPDX-License-Identifier: Apache-2.0
#include "contact/push_out.h"

#include "contact/field_probe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace kushi {

namespace {

constexpr double shortestStep = 2e-4;  // along a segment that grazes a surface [m]
constexpr double rise = 1.0 / 3;       // of a strand that comes out of its root, by its way
constexpr double tiny = std::numeric_limits<double>::min();  // more than none
constexpr int attempts = 12;
constexpr double same = 1e-6;  // ways whose lack differs by less are as good as each other [m]
constexpr double straightOn = -0.98;  // cosine of a way to what faces it
constexpr int tilts = 12;             // of half a turn, that are tried

// How much nearer than wanted a segment is, where that is most; < 0: it is free.
struct Want {
    double lack = -1;  // m
    double at = 0;     // the share of the segment
};

class Clearing {
public:
    Clearing(const DistanceField& solids, double margin, Vec3d root)
        : solids_(solids), margin_(margin), start_(distance(root)) {}

    // From `from`, `walked` from the root, by `way`; no further than to a lack of `enough`.
    Want look(Vec3d from, Vec3d way, double walked,
              double enough = std::numeric_limits<double>::infinity()) const {
        const double size = length(way);
        Want worst{-1e9, 0};
        double along = 0;
        while (true) {
            const double here = distance(from + (size > 0 ? along / size : 0) * way);
            const double lack = wanted(walked + along) - here;
            if (lack > worst.lack) worst = {lack, size > 0 ? along / size : 1};
            if (!(along < size) || worst.lack >= enough) return worst;
            // Distances grow by no more than the way, and what is wanted by less: nearer than this,
            // it is neither taken nor worse than known.
            const double step = (std::max(worst.lack, 0.0) - lack) / (1 + rise);
            along = std::min(size, along + std::max(shortestStep, step));
        }
    }

    // The way that a segment takes instead; `free` tells whether it is free there.
    //
    // before  the way of the segment before it
    Vec3d turned(Vec3d from, Vec3d before, Vec3d way, double walked, bool& free) const {
        const double size = length(way);
        Vec3d best = way;
        Want least = look(from, way, walked);
        // Straight on, what leads aside would be rounding.
        const Vec3d out = outwardAt(solids_, from + least.at * way);
        if (dot(way, out) < straightOn * size) slide(from, out, before, way, walked, best, least);
        Want now = least;
        Vec3d next = way;
        for (int i = 0; i < attempts && now.lack > 0; ++i) {
            const double at = std::max(now.at, 0.1);
            const Vec3d place = from + now.at * next;
            next = at * next + (now.lack + 1e-5) * outwardAt(solids_, place);
            next = (size / std::max(length(next), 1e-12)) * next;
            now = look(from, next, walked);
            if (now.lack >= least.lack) continue;
            least = now;
            best = next;
        }
        if (least.lack > 0) best = searched(from, way, walked, best, least);
        free = least.lack <= 0;
        return best;
    }

private:
    double distance(Vec3d place) const {
        return static_cast<double>(distanceAt(solids_, place.as<float>()));
    }

    double wanted(double walked) const {
        return std::min(margin_, std::min(start_, 0.0) + rise * walked - 1e-6);
    }

    // The way that is turned least of those that are free and lead along the surface as the strand
    // did before; if that led straight to it, down the surface. `out` is what faces the way.
    void slide(Vec3d from, Vec3d out, Vec3d before, Vec3d way, double walked, Vec3d& best,
               Want& least) const {
        const double size = length(way);
        const Vec3d along = normalized(way);
        const auto aside = [&](Vec3d where) {
            const Vec3d on = where - dot(where, out) * out;
            return on - dot(on, along) * along;
        };
        Vec3d side = length(before) > 0 ? aside(normalized(before)) : Vec3d{};
        if (length(side) < 0.3) side = aside({0, -1, 0});
        if (length(side) < 0.3) return;
        side = normalized(side);
        for (int tilt = 1; tilt <= tilts; ++tilt) {
            const double angle = tilt * std::numbers::pi / tilts;
            const Vec3d next = size * (std::cos(angle) * along + std::sin(angle) * side);
            const Want found = look(from, next, walked, tiny);
            if (found.lack > 0) continue;
            least = found;
            best = next;
            return;
        }
    }

    // The free way that is turned least, of many around; else the best of them.
    Vec3d searched(Vec3d from, Vec3d way, double walked, Vec3d best, Want& least) const {
        constexpr int around = 16;
        const double size = length(way);
        const Vec3d along = normalized(way);
        const Vec3d other = std::abs(along.y) < 0.9 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0};
        const Vec3d u = normalized(cross(along, other));
        const Vec3d v = cross(along, u);
        for (int tilt = 1; tilt <= tilts && least.lack > 0; ++tilt) {
            const double angle = tilt * std::numbers::pi / tilts;
            for (int side = 0; side < around; ++side) {
                const double turn = side * 2 * std::numbers::pi / around;
                const Vec3d next =
                    size * (std::cos(angle) * along +
                            std::sin(angle) * (std::cos(turn) * u + std::sin(turn) * v));
                const Want found = look(from, next, walked, least.lack - same);
                if (found.lack >= least.lack - same) continue;
                least = found;
                best = next;
            }
        }
        return best;
    }

    const DistanceField& solids_;
    double margin_;
    double start_;  // distance of the root
};

}  // namespace

Pushed pushOut(const DistanceField& solids, double margin, std::span<Vec3f> nodes) {
    const Clearing clearing(solids, margin, nodes[0].as<double>());
    Pushed how = Pushed::No;
    double walked = 0;
    Vec3d moved;  // of all that lies beyond
    Vec3d before;
    for (std::size_t j = 1; j < nodes.size(); ++j) {
        const Vec3d from = nodes[j - 1].as<double>();
        const Vec3d to = nodes[j].as<double>() + moved;
        const Vec3d way = to - from;
        const double size = length(way);
        nodes[j] = to.as<float>();
        if (size > 0 && clearing.look(from, way, walked, tiny).lack > 0) {
            bool free = false;
            const Vec3d next = clearing.turned(from, before, way, walked, free);
            how = free && how != Pushed::Stuck ? Pushed::Out : Pushed::Stuck;
            moved = moved + (next - way);
            nodes[j] = (from + next).as<float>();
        }
        walked += size;
        before = nodes[j].as<double>() - from;
    }
    return how;
}

}  // namespace kushi
