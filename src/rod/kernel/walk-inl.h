// SPDX-License-Identifier: Apache-2.0
//
// Usami & Anjyo's walk, strands side by side.
#if defined(KUSHI_ROD_WALK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KUSHI_ROD_WALK_INL_H
#undef KUSHI_ROD_WALK_INL_H
#else
#define KUSHI_ROD_WALK_INL_H
#endif

#include "contact/avoidance.h"
#include "rod/kernel/walk_avoidance-inl.h"
#include "rod/kernel/walk_loads-inl.h"

#include <algorithm>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace kushi::HWY_NAMESPACE {

// Squares of loads stay floats up to here.
inline constexpr float mostBend = 1e17F;

// Made once for a batch and used for each of its blocks.
class Walk {
public:
    explicit Walk(const WalkBatch& batch)
        : batch_(batch),
          gravity_(everywhere<Lanes>(batch.walk->gravity)),
          pull_(number<Lanes>(batch.walk->pull / 4)),
          avoiding_(batch.walk->obstacle != nullptr),
          sphere_(avoiding_ ? *batch.walk->obstacle : Ellipsoid{{}, {1, 1, 1}}),
          forceRoom_(batch.walk->forces.size()),
          rowRoom_(3 * (longest(batch) + 1) + 3),
          placeRoom_(Lanes::count * rowRoom_.items().size()),
          rows_(rowRoom_.items()) {}

    // Strands [begin, end), no more than there are lanes.
    HWY_INLINE void bend(std::size_t begin, std::size_t end) {
        const Rods& rods = *batch_.rods;
        const auto strand = [&](std::size_t lane) { return std::min(begin + lane, end - 1); };
        std::size_t segments = 0;
        for (std::size_t i = begin; i < end; ++i)
            segments = std::max(segments, rods.segments(i));

        const auto root = gatherVector<Lanes>([&](std::size_t l) { return rods.roots[strand(l)]; });
        const auto start = gatherVector<Lanes>(
            [&](std::size_t l) { return sphere_.at(rods.roots[strand(l)].template as<double>()); });
        V3<Lanes> before = directions(strand);
        auto left = gather<Lanes>([&](std::size_t l) { return rods.segments(strand(l)); });
        const Lanes n = most(left, Lanes(1));
        const Lanes d = gather<Lanes>([&](std::size_t l) { return rods.lengths[strand(l)]; }) / n;
        // y / d = softness m^2 F for the load F of the walk's units and m segments left.
        const Lanes softness =
            least(gather<Lanes>([&](std::size_t l) { return rods.weights[strand(l)]; }) /
                      gather<Lanes>([&](std::size_t l) { return rods.bending[strand(l)]; }) * d *
                      d * d * pull_,
                  Lanes(mostBend) / (n * n));
        const std::span<const HeldForce> forces = forcesOn(strand);

        // Relative to the root: hair far from the origin is bent as well as any other.
        V3<Lanes> at = {Lanes(0), Lanes(0), Lanes(0)};
        V3<Lanes> lost = at;     // what rounding has added to it (Kahan)
        V3<Lanes> from = start;  // on the sphere
        put(0, root);
        for (std::size_t i = 1; i <= segments; ++i, left -= Lanes(1)) {
            V3<Lanes> load = gravity_;
            if (!forces.empty()) {
                const V3<Lanes> place = root + at;
                for (const HeldForce& force : forces)
                    load = load + pullAt(force, place);
            }
            // cantilever.cpp over d: of the load only what is across the segment bends it.
            load = (softness * left * left) * load;
            const V3<Lanes> across = load - dot(load, before) * before;
            const V3<Lanes> bent = before + across;
            const Lanes scale = Lanes(1) / squareRoot(most(dot(bent, bent), Lanes(1e-30F)));
            V3<Lanes> along = scale * bent;
            V3<Lanes> step = d * along - lost;
            V3<Lanes> next = at + step;
            LaneMask avoided = Lanes(1) < Lanes(0);
            if (avoiding_) {
                V3<Lanes> to = start + sphere_.along(next);
                const LaneMask inside =
                    (dot(to, to) - Lanes(1) < Lanes(insideFrom)) & (left > Lanes(0));
                avoided = inside;
                if (any(inside)) {
                    const V3<Lanes> turned =
                        turnedOut(sphere_, batch_.walk->angles,
                                  {before, across, dot(load, load), along, d, from}, inside);
                    along = select<Lanes>(inside, turned, along);
                    step = d * along - lost;
                    next = at + step;
                    to = start + sphere_.along(next);
                }
                from = to;
            }
            if (batch_.walk->solids != nullptr) {
                // What it was bent by: the difference of the directions would be mostly rounding.
                const V3<Lanes> bend = select<Lanes>(avoided, along - before, scale * across);
                const V3<Lanes> turned = outOfSolids(root + at, bend, along, d, left);
                if (any(dot(turned - along, turned - along) > Lanes(0))) {
                    along = turned;
                    step = d * along - lost;
                    next = at + step;
                    from = start + sphere_.along(next);
                }
            }
            before = along;
            lost = (next - at) - step;
            at = next;
            put(i, root + at);
        }
        write(begin, end, segments);
    }

private:
    static std::size_t longest(const WalkBatch& batch) {
        std::size_t most = 0;
        for (std::size_t i = batch.begin; i < batch.end; ++i)
            most = std::max(most, batch.rods->segments(i));
        return most;
    }

    // d3 of the clamps.
    template <class Strand>
    HWY_INLINE V3<Lanes> directions(const Strand& strand) const {
        const auto number = [&](float Frame::*member) HWY_ATTR {
            return gather<Lanes>(
                [&](std::size_t l) { return batch_.rods->clamps[strand(l)].*member; });
        };
        const Lanes w = number(&Frame::w);
        const Lanes x = number(&Frame::x);
        const Lanes y = number(&Frame::y);
        const Lanes z = number(&Frame::z);
        const V3<Lanes> d3 = {Lanes(2) * (x * z + w * y), Lanes(2) * (y * z - w * x),
                              w * w - x * x - y * y + z * z};
        return (Lanes(1) / squareRoot(dot(d3, d3))) * d3;
    }

    // The forces that hold any of the strands' roots.
    template <class Strand>
    HWY_INLINE std::span<const HeldForce> forcesOn(const Strand& strand) {
        const RodWorld& world = *batch_.world;
        std::size_t count = 0;
        for (const WalkForce& force : batch_.walk->forces) {
            const auto strength = gather<Lanes>([&](std::size_t l) {
                return force.magnitude *
                       double{world.rootShares[strand(l) * world.forces.size() + force.index]};
            });
            if (!any(magnitude(strength) > Lanes(0))) continue;
            forceRoom_.items()[count++] = {&force, strength, everywhere<Lanes>(force.direction)};
        }
        return forceRoom_.items().first(count);
    }

    // Segments that end in solids turn as avoid() has it, one by one; the others stay. `bend` is
    // what `along` has that the direction before has not.
    HWY_INLINE V3<Lanes> outOfSolids(const V3<Lanes>& from, const V3<Lanes>& bend,
                                     const V3<Lanes>& along, Lanes size, Lanes left) const {
        alignas(64) float numbers[4][3][Lanes::count];
        alignas(64) float sizes[Lanes::count];
        alignas(64) float segments[Lanes::count];
        const V3<Lanes> to = from + size * along;
        for (int axis = 0; axis < 3; ++axis) {
            storeLanes(from[axis], numbers[0][axis]);
            storeLanes(bend[axis], numbers[1][axis]);
            storeLanes(along[axis], numbers[2][axis]);
            storeLanes(to[axis], numbers[3][axis]);
        }
        storeLanes(size, sizes);
        storeLanes(left, segments);
        const Obstacles obstacles = {batch_.walk->obstacle, batch_.walk->solids};
        const auto steps = static_cast<int>(batch_.walk->angles.size());
        for (std::size_t lane = 0; lane < Lanes::count; ++lane) {
            const auto vector = [&](std::size_t which) {
                const auto& of = numbers[which];
                return Vec3f{of[0][lane], of[1][lane], of[2][lane]};
            };
            if (segments[lane] <= 0 || distanceAt(*obstacles.solids, vector(3)) >= 0) continue;
            const Vec3d start = vector(0).as<double>();
            const auto length = static_cast<double>(sizes[lane]);
            const Vec3d way = normalized(vector(2).as<double>());
            const Vec3d behind = start - length * (way - vector(1).as<double>());
            const Vec3d turned =
                (avoid(obstacles, behind, start, start + length * way, steps) - start) / length;
            numbers[2][0][lane] = static_cast<float>(turned.x);
            numbers[2][1][lane] = static_cast<float>(turned.y);
            numbers[2][2][lane] = static_cast<float>(turned.z);
        }
        const auto& turned = numbers[2];
        return {loadLanes(turned[0], Lanes()), loadLanes(turned[1], Lanes()),
                loadLanes(turned[2], Lanes())};
    }

    HWY_INLINE void put(std::size_t node, const V3<Lanes>& at) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            rows_[3 * node + axis] = at[static_cast<int>(axis)];
    }

    // Each lane's numbers to its strand's nodes.
    HWY_INLINE void write(std::size_t begin, std::size_t end, std::size_t segments) {
        const Rods& rods = *batch_.rods;
        const std::size_t rows = (3 * (segments + 1) + 3) / 4 * 4;
        const std::span<float> places = placeRoom_.items();
        transpose(std::span<const Lanes>(rows_).first(rows), places.data());
        for (std::size_t i = begin; i < end; ++i) {
            std::memcpy(&batch_.nodes[rods.firstNode(i)].x, &places[(i - begin) * rows],
                        (rods.segments(i) + 1) * sizeof(Vec3f));
        }
    }

    const WalkBatch& batch_;
    V3<Lanes> gravity_;
    Lanes pull_;
    bool avoiding_;
    Sphere sphere_;
    Room<HeldForce> forceRoom_;
    Room<Lanes> rowRoom_;
    Room<float> placeRoom_;
    std::span<Lanes> rows_;
};

}  // namespace kushi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
