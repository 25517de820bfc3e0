// SPDX-License-Identifier: Apache-2.0
//
// From rods to lanes and back.
#if defined(KUSHI_ROD_BATCH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KUSHI_ROD_BATCH_INL_H
#undef KUSHI_ROD_BATCH_INL_H
#else
#define KUSHI_ROD_BATCH_INL_H
#endif

#include "core/random.h"
#include "rod/kernel/gather-inl.h"
#include "rod/kernel/hanging-inl.h"
#include "rod/strand_batch.h"

#include <algorithm>
#include <optional>
#include <type_traits>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace kushi::HWY_NAMESPACE {

// Tangents or frames as floats.
template <class V>
HWY_INLINE void eachNumber(V3<V>& state, const auto& visit) {
    visit(state[0], std::size_t{0});
    visit(state[1], std::size_t{1});
    visit(state[2], std::size_t{2});
}
template <class V>
HWY_INLINE void eachNumber(Quaternion<V>& state, const auto& visit) {
    visit(state.w, std::size_t{0});
    visit(state.v[0], std::size_t{1});
    visit(state.v[1], std::size_t{2});
    visit(state.v[2], std::size_t{3});
}

template <class V>
HWY_INLINE V3<V> tangentOf(const Quaternion<V>& q) {
    const V two(2);
    return {two * (q.v[0] * q.v[2] + q.w * q.v[1]), two * (q.v[1] * q.v[2] - q.w * q.v[0]),
            V(1) - two * (q.v[0] * q.v[0] + q.v[1] * q.v[1])};
}

// Strands side by side with all that a solve of them needs. Made once for a batch and used for each
// of its blocks.
template <class V, class Element>
class Block {
public:
    static constexpr std::size_t width = LaneTraits<V>::count;
    static constexpr std::size_t numbers = Element::freedoms == 2 ? 3 : 4;

    explicit Block(const StrandBatch& batch)
        : batch_(batch),
          segments_(batch.rods->segments(batch.strands[0])),
          elementRoom_(segments_),
          nodeRoom_(segments_ + 1),
          contactRoom_(batch.world->obstacle != nullptr || batch.world->solids != nullptr ||
                               !batch.world->forces.empty() || !batch.world->ties.empty()
                           ? segments_ + 1
                           : 0),
          tieRoom_(batch.world->ties.empty() ? 0 : segments_),
          forceRoom_(batch.world->forces.size()),
          loadRoom_(batch.world->loads.empty() ? 0 : segments_),
          rowRoom_((3 * (segments_ + 1) + 3) / 4 * 4),
          placeRoom_(width * rowRoom_.items().size()),
          elements_(elementRoom_.items()),
          nodes_(nodeRoom_.items()),
          contacts_(contactRoom_.items()) {
        for (V& row : rowRoom_.items())
            row = V(0);
        for (Node<V, Element>& node : nodes_)
            node.position = {V(0), V(0), V(0)};
        if (const Ellipsoid* e = batch.world->obstacle) {
            ellipsoid_.center = everywhere<V>(e->center);
            const Vec3d axes[] = {e->toWorldDirection({1 / e->semiAxes.x, 0, 0}),
                                  e->toWorldDirection({0, 1 / e->semiAxes.y, 0}),
                                  e->toWorldDirection({0, 0, 1 / e->semiAxes.z})};
            for (int row = 0; row < 3; ++row) {
                ellipsoid_.scaling(row, 0) = number<V>(axes[row].x);
                ellipsoid_.scaling(row, 1) = number<V>(axes[row].y);
                ellipsoid_.scaling(row, 2) = number<V>(axes[row].z);
            }
        }
    }

    // Strands of the batch by their places in it; lanes beyond the last repeat it.
    HWY_INLINE void take(std::span<const std::uint32_t> places) {
        places_ = places;
        abreast_ = std::is_same_v<ScalarOf<V>, float> && places.size() == width &&
                   places[0] % width == 0 && places.back() == places[0] + width - 1;
        const Rods& rods = *batch_.rods;
        const auto strand = [&](std::size_t lane) { return batch_.strands[place(lane)]; };
        problem_.root = gatherVector<V>([&](std::size_t l) { return rods.roots[strand(l)]; });
        const Quaternion<V> clamp = {
            gather<V>([&](std::size_t l) { return rods.clamps[strand(l)].w; }),
            {gather<V>([&](std::size_t l) { return rods.clamps[strand(l)].x; }),
             gather<V>([&](std::size_t l) { return rods.clamps[strand(l)].y; }),
             gather<V>([&](std::size_t l) { return rods.clamps[strand(l)].z; })}};
        if constexpr (Element::freedoms == 2) {
            problem_.clamp = tangentOf(clamp);
        } else {
            problem_.clamp = clamp;
        }
        length_ = gather<V>([&](std::size_t l) { return rods.lengths[strand(l)]; });
        const V bending = gather<V>([&](std::size_t l) { return rods.bending[strand(l)]; });
        const V twisting = gather<V>([&](std::size_t l) { return rods.twisting[strand(l)]; });
        const V weight = gather<V>([&](std::size_t l) { return rods.weights[strand(l)]; });

        const std::span<V> curvatures = rowRoom_.items();
        if constexpr (Element::freedoms == 3) {
            const float* from[width];
            for (std::size_t l = 0; l < width; ++l)
                from[l] = &rods.naturalCurvature[rods.offsets[strand(l)]].x;
            gatherRows(from, 3 * segments_, curvatures);
        }
        V total(0);
        V longest(0);
        for (std::size_t j = 0; j < segments_; ++j) {
            const auto segment = [&](std::size_t l) { return rods.offsets[strand(l)] + j; };
            auto& element = elements_[j];
            element.length =
                rods.segmentLengths.empty()
                    ? length_ * number<V>(1.0 / static_cast<double>(segments_))
                    : gather<V>([&](std::size_t l) { return rods.segmentLengths[segment(l)]; });
            V area(1);
            if (!rods.thickness.empty()) {
                area = gather<V>([&](std::size_t l) { return rods.thickness[segment(l)]; });
                area = area * area;
            }
            element.weight = weight * area * element.length;
            element.bend = bending * area * area / element.length;
            total += element.weight;
            longest = most(longest, element.length);
            if constexpr (Element::freedoms == 3) {
                element.twist = twisting * area * area / element.length;
                const V3<V> curvature = {curvatures[3 * j], curvatures[3 * j + 1],
                                         curvatures[3 * j + 2]};
                element.rest = element.length * curvature;
                element.chord =
                    rods.chords.empty()
                        ? helixChord(element.rest, element.length)
                        : gatherVector<V>([&](std::size_t l) { return rods.chords[segment(l)]; });
            }
        }
        problem_.elements = elements_;
        problem_.momentScale = bending / length_ + V(0.5F) * total * length_;
        problem_.gravity = everywhere<V>(batch_.world->gravity);
        problem_.tipLoad = {V(0), V(0), V(0)};
        if (rods.starts.empty()) lean(tangentOf(clamp));
        takeForces(longest);

        V pull = squareRoot(dot(problem_.gravity, problem_.gravity)) + takeLoads();
        for (const BoxForce<V>& force : forces_)
            pull += magnitude(force.strength);
        takeColliders(longest);
        problem_.support.stiffness =
            (V(4) * total * pull + bending / (length_ * length_)) * number<V>(1 / contactSkin);
        gamma_ = total * pull * length_ * length_ / bending;
        takeTies(number<V>(tieStiffness) * (total * pull + bending / (length_ * length_)) /
                 length_);
        for (const LaneTie<V>& tie : ties_)
            gamma_ += tie.stiffness * length_ * length_ * length_ / bending;
    }

    const Problem<V, Element>& problem() const { return problem_; }
    std::span<Node<V, Element>> nodes() { return nodes_; }
    std::span<Contact<V, Element>> contacts() { return contacts_; }
    std::size_t lanes() const { return std::min(width, places_.size()); }
    // w L^3 / EI with all loads.
    V gamma() const { return gamma_; }

    // Lanes on which nothing acts but gravity.
    HWY_INLINE MaskOf<V> hanging() const {
        V others(0);
        for (const BoxForce<V>& force : forces_)
            others = most(others, magnitude(force.strength));
        for (const LaneTie<V>& tie : ties_)
            others = most(others, tie.stiffness);
        for (const V3<V>& load : problem_.loads)
            others = most(others, dot(load, load));
        return (others <= V(0)) & (dot(problem_.gravity, problem_.gravity) > V(0));
    }

    // The turns of the state.
    HWY_INLINE void load() {
        nodes_[0].state = problem_.clamp;
        for (std::size_t j = 1; j <= segments_; ++j) {
            eachNumber(nodes_[j].state,
                       [&](V& x, std::size_t which) HWY_ATTR { x = stored(j, which); });
        }
    }

    // The turns of some lanes.
    HWY_INLINE void store(MaskOf<V> some) {
        alignas(64) ScalarOf<V> lane[width];
        alignas(64) ScalarOf<V> wanted[width];
        storeMask(some, wanted);
        for (std::size_t j = 1; j <= segments_; ++j) {
            eachNumber(nodes_[j].state, [&](V& x, std::size_t which) HWY_ATTR {
                if constexpr (std::is_same_v<ScalarOf<V>, float>) {
                    if (abreast_) {
                        storeLanes(any(!some) ? select(some, x, stored(j, which)) : x,
                                   &turn(places_[0], j, which));
                        return;
                    }
                }
                storeLanes(x, lane);
                for (std::size_t l = 0; l < lanes(); ++l)
                    if (wanted[l] != 0) turn(places_[l], j, which) = static_cast<float>(lane[l]);
            });
        }
    }

    // Turns between those of two strands, to a third; unless the two are bent too differently.
    // Whether they are not.
    bool mix(std::uint32_t one, std::uint32_t other, float share, std::uint32_t to) const {
        const auto along = [&](std::size_t j) {
            float cosine = 0;
            for (std::size_t which = 0; which < numbers; ++which)
                cosine += turn(one, j, which) * turn(other, j, which);
            return cosine;
        };
        for (std::size_t j = 1; j <= segments_; ++j)
            if (!(along(j) > 0.95F)) return false;
        for (std::size_t j = 1; j <= segments_; ++j) {
            const float low = 1 - share;
            const float scale =
                1 / std::sqrt(low * low + share * share + 2 * low * share * along(j));
            for (std::size_t which = 0; which < numbers; ++which)
                turn(to, j, which) =
                    scale * (low * turn(one, j, which) + share * turn(other, j, which));
        }
        return true;
    }

    // Nodes, residuals and what has settled, to where they are wanted, of some lanes.
    HWY_INLINE void write(const Progress<V>& at, MaskOf<V> some) {
        alignas(64) ScalarOf<V> lane[2][width];
        alignas(64) ScalarOf<V> wanted[width];
        storeLanes(at.residual, lane[0]);
        storeMask(at.settled, lane[1]);
        storeMask(some, wanted);
        writeTies(wanted);
        const std::span<V> rows = rowRoom_.items();
        for (std::size_t j = 0; j <= segments_; ++j)
            for (int axis = 0; axis < 3; ++axis)
                rows[3 * j + static_cast<std::size_t>(axis)] = nodes_[j].position[axis];
        const std::span<float> places = placeRoom_.items();
        transpose(std::span<const V>(rows), places.data());
        for (std::size_t l = 0; l < lanes(); ++l) {
            if (wanted[l] == 0) continue;
            const std::uint32_t strand = batch_.strands[places_[l]];
            batch_.residuals[strand] = static_cast<float>(lane[0][l]);
            batch_.states[strand] = lane[1][l] != 0 ? 1 : 0;
            std::memcpy(&batch_.nodes[batch_.rods->firstNode(strand)].x, &places[l * rows.size()],
                        (segments_ + 1) * sizeof(Vec3f));
        }
    }

    // The natural shape.
    HWY_INLINE void unbend() {
        nodes_[0].state = problem_.clamp;
        for (std::size_t j = 1; j <= segments_; ++j) {
            if constexpr (Element::freedoms == 2) {
                nodes_[j].state = problem_.clamp;
            } else {
                nodes_[j].state = carried(nodes_[j - 1].state, elements_[j - 1].rest);
            }
        }
    }

    // Where the rods say to begin.
    HWY_INLINE void begin() {
        nodes_[0].state = problem_.clamp;
        for (std::size_t j = 1; j <= segments_; ++j) {
            const auto frame = [&](std::size_t l) -> const Frame& {
                return batch_.rods->starts[batch_.rods->offsets[batch_.strands[place(l)]] + j - 1];
            };
            const Quaternion<V> state = {gather<V>([&](std::size_t l) { return frame(l).w; }),
                                         {gather<V>([&](std::size_t l) { return frame(l).x; }),
                                          gather<V>([&](std::size_t l) { return frame(l).y; }),
                                          gather<V>([&](std::size_t l) { return frame(l).z; })}};
            if constexpr (Element::freedoms == 2) {
                nodes_[j].state = tangentOf(state);
            } else {
                nodes_[j].state = state;
            }
        }
    }

    // The least distance from a collider to a node but the root, or to a place between.
    HWY_INLINE V nearest(bool overLayers) const {
        const Support<V>& support = problem_.support;
        V distance(1);
        for (std::size_t j = 1; j <= segments_; ++j) {
            for (int place = support.places; place > 0; --place) {
                const V share = number<V>(static_cast<double>(place) / support.places);
                const V before = V(1) - share;
                const V layer = overLayers
                                    ? before * contacts_[j - 1].layer + share * contacts_[j].layer
                                    : V(0);
                const V3<V> at = before * nodes_[j - 1].position + share * nodes_[j].position;
                const V gap = support.distance(at, support.skin + layer) - layer;
                distance = least(distance, gap);
                // The others of the segment are as far.
                if (!any(gap < support.skin + elements_[j - 1].length)) break;
            }
        }
        return distance;
    }

    // Lanes that no collider pushes.
    HWY_INLINE MaskOf<V> clear() const {
        if (!problem_.support.any()) return V(0) < V(1);
        return nearest(true) >= problem_.support.skin;
    }

    // Lays some strands on what they reach into: from the root outwards each segment turns as far
    // as its end needs, and what is beyond goes with it.
    HWY_INLINE void lay(MaskOf<V> some) {
        const Support<V>& support = problem_.support;
        V3<V> before = nodes_[0].position;  // where the node before was
        for (std::size_t j = 1; j <= segments_; ++j) {
            const V3<V> chord = nodes_[j].position - before;
            before = nodes_[j].position;
            const V length = elements_[j - 1].length;
            V3<V> at = nodes_[j - 1].position + chord;
            const V top = support.skin + contacts_[j].layer;
            for (int turn = 0; turn < 3; ++turn) {
                Nearness<V> near = support.nearness(at, top);
                const V lack = select(some, most(V(0.6F) * top - near.distance, V(0)), V(0));
                if (!any(lack > V(0))) break;
                const V3<V> way = at + lack * near.normal - nodes_[j - 1].position;
                at = nodes_[j - 1].position +
                     (length * inverseRoot(most(dot(way, way), V(1e-12F)))) * way;
            }
            nodes_[j].position = at;
        }
        if constexpr (Element::freedoms == 2) {
            for (std::size_t j = 1; j <= segments_; ++j) {
                V3<V> way = nodes_[j].position - nodes_[j - 1].position;
                if (j < segments_) way = way + nodes_[j + 1].position - nodes_[j].position;
                nodes_[j].state = select(some, unit(way), nodes_[j].state);
            }
        }
    }

    // Strands in which a node lies inside the collider; their supports begin farther out from now
    // on. (Stiffer ones would keep nodes out as well, but many a curl would never come to rest.)
    HWY_INLINE MaskOf<V> pushedOut() {
        const V deepest = nearest(false);
        const MaskOf<V> inside = deepest < number<V>(-contactDepth);
        V& skin = problem_.support.skin;
        skin = select(inside, skin - V(1.2F) * deepest + number<V>(contactDepth), skin);
        return inside;
    }

    // Strands with a tied node that is not at its point. The ties of `some` have the force from now
    // on that their springs had.
    HWY_INLINE MaskOf<V> tightened(MaskOf<V> some) {
        V widest(0);
        for (LaneTie<V>& tie : ties_) {
            const V3<V> gap = nodes_[tie.node].position - tie.point;
            const MaskOf<V> tied = tie.stiffness > V(0);
            widest = most(widest, select(tied, dot(gap, gap), V(0)));
            tie.force = select<V, 3>(some, tie.force - tie.stiffness * gap, tie.force);
            tie.stiffness = select(some, V(4) * tie.stiffness, tie.stiffness);
        }
        return widest > number<V>(tieGap * tieGap);
    }

    // The key's choice of a side, in [-1, 1).
    HWY_INLINE V3<V> lean() const {
        const auto part = [&](std::uint64_t salt) {
            return gather<V>([&](std::size_t l) {
                return uniformSigned(mixKey(batch_.rods->keys[batch_.strands[place(l)]], salt));
            });
        };
        return {part(0x6c65616e78), part(0x6c65616e79), part(0x6c65616e7a)};
    }

private:
    // A clamp that points straight against gravity, tilted a little to the side that the key
    // chooses: else rounding would choose.
    HWY_INLINE void lean(const V3<V>& tangent) {
        const V3<V>& down = problem_.gravity;
        const V3<V> off = cross(tangent, down);
        const V square = dot(down, down);
        const MaskOf<V> upright =
            (dot(off, off) <= V(1e-10F) * square) & (dot(tangent, down) < V(0));
        if (!any(upright)) return;
        const V3<V> side = number<V>(1e-5) * lean();
        Column<V, Element::freedoms> turn;
        turn[0] = side[0];
        turn[1] = side[1];
        if constexpr (Element::freedoms == 3) turn[2] = V(0);
        problem_.clamp = select(upright, Element::turned(problem_.clamp, turn), problem_.clamp);
    }

    std::uint32_t place(std::size_t lane) const {
        return places_[std::min(lane, places_.size() - 1)];
    }

    HWY_INLINE V stored(std::size_t node, std::size_t which) const {
        if constexpr (std::is_same_v<ScalarOf<V>, float>) {
            if (abreast_) return loadLanes(&turn(places_[0], node, which), V());
        }
        return gather<V>([&](std::size_t l) { return turn(place(l), node, which); });
    }

    float& turn(std::uint32_t strandPlace, std::size_t node, std::size_t which) const {
        return batch_.turns[turnIndex(strandPlace, segments_, numbers, node, which)];
    }

    // Those of a strand in a lane.
    std::span<const Tie> tiesOf(std::size_t lane) const {
        const std::uint32_t strand = batch_.strands[place(lane)];
        const std::uint32_t first = batch_.firstTies[strand];
        return batch_.world->ties.subspan(first, batch_.firstTies[strand + 1] - first);
    }

    // Place among all ties of that at a node of a lane's strand; none if there is none.
    std::optional<std::size_t> tieAt(std::size_t lane, std::size_t node) const {
        const std::span<const Tie> own = tiesOf(lane);
        for (const Tie& tie : own)
            if (tie.node == node) return static_cast<std::size_t>(&tie - batch_.world->ties.data());
        return std::nullopt;
    }

    void takeTies(V stiffness) {
        ties_ = {};
        if (batch_.world->ties.empty()) return;
        std::size_t count = 0;
        for (std::size_t j = 1; j <= segments_; ++j) {
            std::optional<std::size_t> at[width];
            bool found = false;
            for (std::size_t l = 0; l < width; ++l) {
                at[l] = tieAt(l, j);
                found = found || at[l].has_value();
            }
            if (!found) continue;
            LaneTie<V>& tie = tieRoom_.items()[count++];
            tie.node = j;
            tie.point = gatherVector<V>(
                [&](std::size_t l) { return at[l] ? batch_.world->ties[*at[l]].point : Vec3f{}; });
            tie.force = gatherVector<V>(
                [&](std::size_t l) { return at[l] ? batch_.tieForces[*at[l]] : Vec3f{}; });
            tie.stiffness = gather<V>([&](std::size_t l) { return at[l] ? 1 : 0; }) * stiffness;
        }
        ties_ = tieRoom_.items().first(count);
        problem_.ties = ties_;
    }

    void writeTies(std::span<const ScalarOf<V>> wanted) {
        alignas(64) ScalarOf<V> force[3][width];
        for (const LaneTie<V>& tie : ties_) {
            for (int axis = 0; axis < 3; ++axis)
                storeLanes(tie.force[axis], force[axis]);
            for (std::size_t l = 0; l < lanes(); ++l) {
                const std::optional<std::size_t> at = tieAt(l, tie.node);
                if (wanted[l] == 0 || !at) continue;
                batch_.tieForces[*at] = {static_cast<float>(force[0][l]),
                                         static_cast<float>(force[1][l]),
                                         static_cast<float>(force[2][l])};
            }
        }
    }

    // The largest of them.
    HWY_INLINE V takeLoads() {
        const std::span<V3<V>> loads = loadRoom_.items();
        V largest(0);
        for (std::size_t j = 0; j < loads.size(); ++j) {
            loads[j] = gatherVector<V>([&](std::size_t l) {
                return batch_.world->loads[batch_.rods->offsets[batch_.strands[place(l)]] + j];
            });
            largest = most(largest, dot(loads[j], loads[j]));
        }
        problem_.loads = loads;
        return squareRoot(largest);
    }

    // How far apart the places lie at which hair may lie on something: the ellipsoid is smooth.
    void takeColliders(V longest) {
        const RodWorld& world = *batch_.world;
        Support<V>& support = problem_.support;
        support.ellipsoid = world.obstacle == nullptr ? nullptr : &ellipsoid_;
        support.field = world.solids == nullptr ? LaneField<V>() : LaneField<V>(*world.solids);
        support.skin = number<V>(contactSkin);
        if (!support.any()) return;
        const V apart = number<V>(world.solids == nullptr ? 0.025 : 0.011);
        support.places = 1;
        while (support.places < mostTouchPlaces &&
               any(longest > V(static_cast<float>(support.places)) * apart))
            ++support.places;
        V walked(0);
        V slope(0);
        V reach(0);
        if (!world.layers.empty()) {
            slope = gather<V>(
                [&](std::size_t l) { return world.layers[batch_.strands[place(l)]].slope; });
            reach = gather<V>(
                [&](std::size_t l) { return world.layers[batch_.strands[place(l)]].reach; });
        }
        const bool rough = world.obstacleFriction > 0 ||
                           std::ranges::any_of(world.solidFrictions, [](float f) { return f > 0; });
        support.frictions = rough ? &world : nullptr;
        for (Contact<V, Element>& contact : contacts_) {
            contact.held = V(0);
            contact.distance = V(0);  // nothing is known of what is around
        }
        contacts_[0].layer = V(0);
        for (std::size_t j = 1; j <= segments_; ++j) {
            walked += elements_[j - 1].length;
            contacts_[j].layer = slope * least(walked, reach);
        }
    }

    void takeForces(V longest) {
        std::size_t count = 0;
        const RodWorld& world = *batch_.world;
        for (std::size_t f = 0; f < world.forces.size(); ++f) {
            const Force& force = world.forces[f];
            const V share = gather<V>([&](std::size_t l) {
                return world.rootShares[batch_.strands[place(l)] * world.forces.size() + f];
            });
            if (!any(share > V(0)) || force.magnitude == 0) continue;
            BoxForce<V>& box = forceRoom_.items()[count++];
            box.low = everywhere<V>({force.within.x.low, force.within.y.low, force.within.z.low});
            box.high =
                everywhere<V>({force.within.x.high, force.within.y.high, force.within.z.high});
            box.width = most(longest, number<V>(force.falloff.distance));
            box.radial = force.direction.radial;
            box.direction = everywhere<V>(force.direction.vector);
            box.strength = number<V>(force.magnitude) * share;
        }
        forces_ = forceRoom_.items().first(count);
        problem_.forces = forces_;
    }

    // d (alpha e3 + beta k3 k): the chord of a helix with natural curvature k in the frame of its
    // middle.
    HWY_INLINE static V3<V> helixChord(const V3<V>& rest, V length) {
        const V s = dot(rest, rest);
        const MaskOf<V> gentle = s < V(1e-2F);
        const V half = V(0.5F) * squareRoot(s);
        const V sine = sineCosineOfTwice(V(0.5F) * half).sine;
        const V alpha =
            select(gentle, V(1) - s * number<V>(1.0 / 24) + s * s * number<V>(1.0 / 1920),
                   sine / most(half, V(1e-6F)));
        const V beta = select(gentle, number<V>(1.0 / 24) - s * number<V>(1.0 / 1920),
                              (V(1) - alpha) / most(s, V(1e-6F)));
        const V along = beta * rest[2];
        return length * V3<V>{along * rest[0], along * rest[1], alpha + along * rest[2]};
    }

    // The frame at the far end of an unloaded segment: turned by its rest strain.
    HWY_INLINE static auto carried(const typename Element::State& from, const V3<V>& rest) {
        const V size = squareRoot(dot(rest, rest));
        const auto [sine, cosine] = sineCosineOfTwice(V(0.25F) * size);
        const V ratio = select(size < V(1e-4F), V(0.5F), sine / most(size, V(1e-6F)));
        return unitQuaternion(product(from, Quaternion<V>{cosine, ratio * rest}));
    }

    const StrandBatch& batch_;
    std::size_t segments_;
    std::span<const std::uint32_t> places_;
    bool abreast_ = false;  // whether their turns lie side by side
    Problem<V, Element> problem_;
    Room<typename Element::Segment> elementRoom_;
    Room<Node<V, Element>> nodeRoom_;
    Room<Contact<V, Element>> contactRoom_;
    Room<LaneTie<V>> tieRoom_;
    Room<BoxForce<V>> forceRoom_;
    Room<V3<V>> loadRoom_;
    Room<V> rowRoom_;  // three numbers of each node
    Room<float> placeRoom_;
    std::span<typename Element::Segment> elements_;
    std::span<Node<V, Element>> nodes_;
    std::span<Contact<V, Element>> contacts_;
    std::span<BoxForce<V>> forces_;
    std::span<LaneTie<V>> ties_;
    LaneEllipsoid<V> ellipsoid_;
    V length_;
    V gamma_;
};

// Where a cold solve begins: the unloaded shape, bent a little to the side that the key chooses
// where the load pushes straight back along the root.
template <class V, class Element>
HWY_INLINE void nudge(Block<V, Element>& block) {
    const auto nodes = block.nodes();
    const V3<V> side = block.lean();
    for (std::size_t j = 1; j < nodes.size(); ++j) {
        const V size = number<V>(1e-5 * static_cast<double>(j) / static_cast<double>(nodes.size()));
        Column<V, Element::freedoms> turn;
        turn[0] = size * side[0];
        turn[1] = size * side[1];
        if constexpr (Element::freedoms == 3) turn[2] = V(0);
        nodes[j].state = Element::turned(nodes[j].state, turn);
    }
}

// Brings a block to rest from the states and the share of loads that it has.
template <class V, class Element>
HWY_INLINE void settleBlock(Block<V, Element>& block, NewtonOptions options, Progress<V>& at) {
    Newton<V, Element> newton(block.problem(), block.nodes(), block.contacts());
    V steps(0);
    for (int round = 0; round < 12; ++round) {
        newton.run(options, at);
        newton.place();
        steps += at.steps;
        if (!any(at.settled)) break;
        MaskOf<V> again = V(1) < V(0);
        if (block.problem().support.any()) again = again | block.pushedOut();
        if (!block.problem().ties.empty()) again = again | block.tightened(at.settled);
        again = again & at.settled;
        if (!any(again)) break;
        at.settled = at.settled & !again;
        at.relaxed = V(1);
        options.few = 0;
    }
    at.steps = steps;
}

}  // namespace kushi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
