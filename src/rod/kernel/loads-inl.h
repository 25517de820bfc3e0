// SPDX-License-Identifier: Apache-2.0
//
// What acts on strands from outside: gravity, forces in boxes, and the ellipsoid they rest on.
#if defined(KUSHI_ROD_LOADS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KUSHI_ROD_LOADS_INL_H
#undef KUSHI_ROD_LOADS_INL_H
#else
#define KUSHI_ROD_LOADS_INL_H
#endif

#include "rod/kernel/field-inl.h"

#include <kushi/rods.h>

HWY_BEFORE_NAMESPACE();
namespace kushi::HWY_NAMESPACE {

// A force as multiples of the hair's own weight, wherever it acts in full.
template <class V>
struct BoxForce {
    V3<V> low, high;  // the box [m]; may be infinite
    V width;          // of the ramp across its faces [m], > 0
    bool radial = false;
    V3<V> direction;  // unit; not used if radial
    V strength;       // magnitude times the share of the root range
};

// A smooth step from 0 to 1 across an edge, and its slope.
template <class V>
struct Ramp {
    V share, slope;
};

template <class V>
HWY_INLINE Ramp<V> ramp(V inside, V width) {
    const V scale = reciprocal(width);
    const V t = least(most(inside * scale + V(0.5F), V(0)), V(1));
    return {t * t * (V(3) - V(2) * t), V(6) * t * (V(1) - t) * scale};
}

// What forces do at a place, in multiples of the hair's own weight.
template <class V>
struct Pull {
    V3<V> force;
    Matrix<V, 3, 3> stiffness;  // the symmetric part of its derivative, negated [1/m]
    MaskOf<V> varies;
};

template <class V>
HWY_INLINE void addForce(const BoxForce<V>& force, const V3<V>& at, Pull<V>& pull) {
    V depth = least(at[0] - force.low[0], force.high[0] - at[0]);
    for (int axis = 1; axis < 3; ++axis)
        depth = least(depth, least(at[axis] - force.low[axis], force.high[axis] - at[axis]));
    const V half = V(0.5F) * force.width;
    const MaskOf<V> acts = (depth > -half) & (magnitude(force.strength) > V(0));
    if (!any(acts)) return;
    const MaskOf<V> fades = acts & (depth < half);

    V share = select(acts, force.strength, V(0));
    V3<V> slope = {V(0), V(0), V(0)};
    if (any(fades)) {
        Ramp<V> edge[3];
        for (int axis = 0; axis < 3; ++axis) {
            const Ramp<V> low = ramp(at[axis] - force.low[axis], force.width);
            const Ramp<V> high = ramp(force.high[axis] - at[axis], force.width);
            edge[axis] = {low.share * high.share, low.slope * high.share - high.slope * low.share};
        }
        slope[0] = share * edge[0].slope * edge[1].share * edge[2].share;
        slope[1] = share * edge[0].share * edge[1].slope * edge[2].share;
        slope[2] = share * edge[0].share * edge[1].share * edge[2].slope;
        share = share * edge[0].share * edge[1].share * edge[2].share;
    }

    V3<V> direction = force.direction;
    if (force.radial) {
        // Faded out towards the axis, where there is no direction: hair that is pulled there finds
        // its rest.
        const V core = V(0.5F) * force.width;
        const V scale = inverseRoot(at[0] * at[0] + at[2] * at[2] + core * core);
        direction = {scale * at[0], V(0), scale * at[2]};
        // The direction turns with the place.
        const V across = share * scale;
        pull.stiffness(0, 0) -= across * (V(1) - direction[0] * direction[0]);
        pull.stiffness(2, 2) -= across * (V(1) - direction[2] * direction[2]);
        pull.stiffness(0, 2) += across * direction[0] * direction[2];
        pull.stiffness(2, 0) += across * direction[0] * direction[2];
        pull.varies = pull.varies | acts;
    }
    pull.force = pull.force + share * direction;
    if (!any(fades)) return;
    pull.varies = pull.varies | fades;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
            pull.stiffness(r, c) -= V(0.5F) * (direction[r] * slope[c] + direction[c] * slope[r]);
}

// An ellipsoid, in world axes: f(x) = |S R' (x - center)| - 1 with S = 1 / semi-axes.
template <class V>
struct LaneEllipsoid {
    V3<V> center;
    Matrix<V, 3, 3> scaling;  // S R'

    // The distance is exact on the surface and of first order beside it.
    HWY_INLINE Nearness<V> nearness(const V3<V>& at) const {
        const V3<V> local = scaling * (at - center);
        const V size = squareRoot(most(dot(local, local), V(1e-12F)));
        const V3<V> gradient = (V(1) / size) * (transposed(scaling) * local);
        const V slope = squareRoot(most(dot(gradient, gradient), V(1e-12F)));
        const V3<V> normal = (V(1) / slope) * gradient;
        // Of the surface through the place that is scaled about the center.
        const Matrix<V, 3, 3> across = diagonal<3>(V(1)) - outer(normal, normal);
        const Matrix<V, 3, 3> shape = across * (transposed(scaling) * scaling) * across;
        return {(size - V(1)) / slope, normal, (V(1) / (size * slope)) * shape};
    }

    HWY_INLINE V distance(const V3<V>& at) const {
        const V3<V> local = scaling * (at - center);
        const V size = squareRoot(most(dot(local, local), V(1e-12F)));
        const V3<V> gradient = transposed(scaling) * local;
        return (size - V(1)) * size / squareRoot(most(dot(gradient, gradient), V(1e-12F)));
    }
};

// What strands lie on. A spring begins `skin` above each surface: there the strands are held so
// that none reaches the surface itself.
template <class V>
struct Support {
    const LaneEllipsoid<V>* ellipsoid = nullptr;
    LaneField<V> field;
    V skin;          // [m]
    V stiffness;     // [N/m]
    int places = 1;  // of a segment at which it may lie on something; the last is its end
    const RodWorld* frictions = nullptr;  // null: there is none

    HWY_INLINE bool any() const { return ellipsoid != nullptr || !field.empty(); }

    // Of the nearest surface, where that is nearer than `near`.
    HWY_INLINE Nearness<V> nearness(const V3<V>& at, V near) const {
        Nearness<V> nearest;
        nearest.distance = V(1);
        nearest.normal = {V(0), V(0), V(0)};
        if (ellipsoid != nullptr) nearest = ellipsoid->nearness(at);
        if (field.empty()) return nearest;
        Nearness<V> other;
        if (!field.look(at, near, other)) return nearest;
        const auto nearer = other.distance < nearest.distance;
        nearest.distance = select(nearer, other.distance, nearest.distance);
        nearest.normal = select(nearer, other.normal, nearest.normal);
        return nearest;
    }

    // Of a distance that has been read, what it is at least.
    HWY_INLINE V atLeast(V distance) const {
        return field.empty() ? distance : field.atLeast(distance);
    }

    // Coulomb's coefficient of the nearest surface.
    HWY_INLINE V friction(const V3<V>& at) const {
        alignas(64) ScalarOf<V> where[3][LaneTraits<V>::count];
        alignas(64) ScalarOf<V> solid[LaneTraits<V>::count];
        for (int axis = 0; axis < 3; ++axis)
            storeLanes(at[axis], where[axis]);
        for (std::size_t lane = 0; lane < LaneTraits<V>::count; ++lane) {
            const Vec3f place = {static_cast<float>(where[0][lane]),
                                 static_cast<float>(where[1][lane]),
                                 static_cast<float>(where[2][lane])};
            solid[lane] = frictions->solidFrictions.empty()
                              ? 0
                              : frictions->solidFrictions[nearestSolid(*frictions->solids, place)];
        }
        const V ofSolid = loadLanes(solid, V());
        const V ofEllipsoid(frictions->obstacleFriction);
        if (ellipsoid == nullptr) return ofSolid;
        if (field.empty()) return ofEllipsoid;
        return select(ellipsoid->distance(at) < field.distance(at, skin), ofEllipsoid, ofSolid);
    }

    // To the nearest surface; farther off than `near` it may be a little too small.
    HWY_INLINE V distance(const V3<V>& at, V near) const {
        V nearest(1);
        if (ellipsoid != nullptr) nearest = least(nearest, ellipsoid->distance(at));
        if (!field.empty()) nearest = least(nearest, field.distance(at, near));
        return nearest;
    }
};

// A spring to a point, and the force that it had before it was last stretched (the method of
// multipliers): what the tie pulls with in the end, with the spring at rest.
template <class V>
struct LaneTie {
    std::size_t node;
    V3<V> point;
    V stiffness;  // [N/m]; 0 in lanes that are not tied here
    V3<V> force;
};

}  // namespace kushi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
