// SPDX-License-Identifier: Apache-2.0
//
// What acts on strands from outside: gravity, forces in boxes, and the ellipsoid they rest on.
#if defined(KUSHI_ROD_LOADS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KUSHI_ROD_LOADS_INL_H
#undef KUSHI_ROD_LOADS_INL_H
#else
#define KUSHI_ROD_LOADS_INL_H
#endif

#include "contact/field_probe.h"
#include "rod/kernel/matrix-inl.h"

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
    V share = force.strength;
    V3<V> slope;  // of the share, over the share
    Ramp<V> edge[3];
    for (int axis = 0; axis < 3; ++axis) {
        const Ramp<V> low = ramp(at[axis] - force.low[axis], force.width);
        const Ramp<V> high = ramp(force.high[axis] - at[axis], force.width);
        edge[axis] = {low.share * high.share, low.slope * high.share - high.slope * low.share};
    }
    share = share * edge[0].share * edge[1].share * edge[2].share;
    slope[0] = force.strength * edge[0].slope * edge[1].share * edge[2].share;
    slope[1] = force.strength * edge[0].share * edge[1].slope * edge[2].share;
    slope[2] = force.strength * edge[0].share * edge[1].share * edge[2].slope;

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
    }
    pull.force = pull.force + share * direction;
    pull.varies = pull.varies | (magnitude(share) > V(0)) | (dot(slope, slope) > V(0));
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
            pull.stiffness(r, c) -= V(0.5F) * (direction[r] * slope[c] + direction[c] * slope[r]);
}

// A place as a collider sees it.
template <class V>
struct Nearness {
    V distance;                 // to the surface, < 0 inside [m]
    V3<V> normal;               // derivative of the distance, outward and nearly unit
    Matrix<V, 3, 3> curvature;  // derivative of the normal [1/m]
};

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

// A distance field, asked for one lane after the other.
template <class V>
class LaneField {
public:
    static constexpr std::size_t width = LaneTraits<V>::count;

    LaneField() = default;
    explicit LaneField(const DistanceField& field) : field_(&field) {}

    bool empty() const { return field_ == nullptr; }

    // Where it is more than `near`, it may be less than that by up to two spacings.
    HWY_INLINE V distance(const V3<V>& at, V near) const {
        alignas(64) ScalarOf<V> distances[width];
        rough(at, near, distances, [&](std::size_t lane, Vec3f place) {
            distances[lane] = static_cast<ScalarOf<V>>(probe(*field_, place).distance);
        });
        return loadLanes(distances, V());
    }

    // The distance likewise; where it is less than `near`, all of what is to be known. Whether that
    // is so anywhere.
    HWY_INLINE bool look(const V3<V>& at, V near, Nearness<V>& out) const {
        alignas(64) ScalarOf<V> numbers[10][width];
        bool found = false;
        rough(at, near, numbers[0], [&](std::size_t lane, Vec3f place) {
            if (!found) {
                for (std::size_t i = 1; i < 10; ++i)
                    for (std::size_t other = 0; other < width; ++other)
                        numbers[i][other] = 0;
            }
            found = true;
            const FieldProbe seen = probe(*field_, place);
            numbers[0][lane] = static_cast<ScalarOf<V>>(seen.distance);
            for (std::size_t i = 0; i < 3; ++i)
                numbers[1 + i][lane] = static_cast<ScalarOf<V>>(seen.gradient[i]);
            for (std::size_t i = 0; i < 6; ++i)
                numbers[4 + i][lane] = static_cast<ScalarOf<V>>(seen.hessian[i]);
        });
        const auto number = [&](std::size_t i) HWY_ATTR { return loadLanes(numbers[i], V()); };
        out.distance = number(0);
        if (!found) return false;
        out.normal = {number(1), number(2), number(3)};
        const V xy = number(7);
        const V yz = number(8);
        const V zx = number(9);
        out.curvature = {{{number(4), xy, zx}, {xy, number(5), yz}, {zx, yz, number(6)}}};
        return true;
    }

private:
    // Distances from the samples nearby; `close` is called where that is not enough.
    HWY_INLINE void rough(const V3<V>& at, V near, ScalarOf<V>* distances,
                          const auto& close) const {
        alignas(64) ScalarOf<V> places[3][width];
        alignas(64) ScalarOf<V> enough[width];
        for (int axis = 0; axis < 3; ++axis)
            storeLanes(at[axis], places[axis]);
        storeLanes(near, enough);
        for (std::size_t lane = 0; lane < width; ++lane) {
            const Vec3f place = {static_cast<float>(places[0][lane]),
                                 static_cast<float>(places[1][lane]),
                                 static_cast<float>(places[2][lane])};
            const float distance = roughDistance(*field_, place) - 2 * field_->spacing;
            distances[lane] = static_cast<ScalarOf<V>>(distance);
            if (distance <= static_cast<float>(enough[lane])) close(lane, place);
        }
    }

    const DistanceField* field_ = nullptr;
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

    HWY_INLINE bool any() const { return ellipsoid != nullptr || !field.empty(); }

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
