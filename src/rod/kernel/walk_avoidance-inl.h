// SPDX-License-Identifier: Apache-2.0
//
// avoid() of src/contact, on strands side by side. All of it in the space in which the ellipsoid is
// the unit sphere, where a segment's end lies inside if |u|^2 < 1.
#if defined(KUSHI_ROD_WALK_AVOIDANCE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KUSHI_ROD_WALK_AVOIDANCE_INL_H
#undef KUSHI_ROD_WALK_AVOIDANCE_INL_H
#else
#define KUSHI_ROD_WALK_AVOIDANCE_INL_H
#endif

#include "rod/kernel/gather-inl.h"
#include "rod/walk_batch.h"

HWY_BEFORE_NAMESPACE();
namespace kushi::HWY_NAMESPACE {

// The ellipsoid's implicit function below which the walk must not end a segment. isInside() allows
// a little more, for rounding.
inline constexpr float insideFrom = -0.7e-6F;

// Square of the sine of an angle that is only rounding.
inline constexpr float parallel = 1e-13F;

// From the world, relative to the ellipsoid's centre, to the unit sphere: S R' with S = 1 /
// semi-axes.
class Sphere {
public:
    explicit Sphere(const Ellipsoid& e)
        : rows_{e.toWorldDirection({1 / e.semiAxes.x, 0, 0}),
                e.toWorldDirection({0, 1 / e.semiAxes.y, 0}),
                e.toWorldDirection({0, 0, 1 / e.semiAxes.z})},
          center_(e.center) {
        for (int row = 0; row < 3; ++row) {
            scaling_(row, 0) = number<Lanes>(rows_[row].x);
            scaling_(row, 1) = number<Lanes>(rows_[row].y);
            scaling_(row, 2) = number<Lanes>(rows_[row].z);
        }
    }

    // Of a place, exactly.
    Vec3d at(Vec3d place) const {
        const Vec3d from = place - center_;
        return {dot(rows_[0], from), dot(rows_[1], from), dot(rows_[2], from)};
    }
    HWY_INLINE V3<Lanes> along(const V3<Lanes>& direction) const { return scaling_ * direction; }
    // Along the outward normal in the world.
    HWY_INLINE V3<Lanes> normal(const V3<Lanes>& u) const { return transposed(scaling_) * u; }

private:
    Vec3d rows_[3];
    Vec3d center_;
    Matrix<Lanes, 3, 3> scaling_;
};

// A segment about to be turned.
struct Segment {
    V3<Lanes> before;  // direction of the one before it, unit
    V3<Lanes> bend;    // what it was bent by, across `before`
    Lanes load;        // square of the bend with what lies along `before`
    V3<Lanes> along;   // its own direction: `before` + `bend`, unit
    Lanes length;      // m
    V3<Lanes> from;    // its beginning, on the sphere
};

// Unit vector across the segment in the plane that `wanted` gives, as far as it gives one.
HWY_INLINE LaneMask across(const V3<Lanes>& along, const V3<Lanes>& wanted, V3<Lanes>& side) {
    const V3<Lanes> part = wanted - dot(wanted, along) * along;
    const Lanes square = dot(part, part);
    const LaneMask good = square > Lanes(parallel) * dot(wanted, wanted);
    side = (Lanes(1) / squareRoot(select(good, square, Lanes(1)))) * part;
    return good;
}

// In the plane of the two segments, towards the one before: by the bend itself, since the
// difference of their directions would be mostly rounding. Where they are in line, towards the
// outward normal.
HWY_INLINE V3<Lanes> turningSide(const Sphere& sphere, const Segment& s) {
    const Lanes square = dot(s.bend, s.bend);
    const LaneMask bent = (square > Lanes(1e-18F)) & (square > Lanes(parallel) * s.load);
    const Lanes size = squareRoot(select(bent, square, Lanes(1)));
    V3<Lanes> side;
    LaneMask found = bent & across(s.along, size * s.before - (Lanes(1) / size) * s.bend, side);
    const V3<Lanes> others[] = {
        sphere.normal(s.from), {Lanes(0), Lanes(1), Lanes(0)}, {Lanes(1), Lanes(0), Lanes(0)}};
    for (const V3<Lanes>& other : others) {
        if (!any(!found)) break;
        V3<Lanes> candidate;
        const LaneMask good = across(s.along, other, candidate);
        side = select(found, side, candidate);
        found = found | good;
    }
    return side;
}

// The direction, unit, to which the segment turns where `inside`, else its own.
HWY_INLINE V3<Lanes> turnedOut(const Sphere& sphere, std::span<const AvoidanceAngle> angles,
                               const Segment& s, LaneMask inside) {
    const V3<Lanes> side = turningSide(sphere, s);
    // |u + c a + s b|^2 - 1 by its terms, so that little is lost near the surface.
    const V3<Lanes> a = s.length * sphere.along(s.along);
    const V3<Lanes> b = s.length * sphere.along(side);
    const Lanes start = dot(s.from, s.from) - Lanes(1);
    const Lanes ua = Lanes(2) * dot(s.from, a);
    const Lanes ub = Lanes(2) * dot(s.from, b);
    const Lanes aa = dot(a, a);
    const Lanes bb = dot(b, b);
    const Lanes ab = Lanes(2) * dot(a, b);

    LaneMask plus = inside;
    LaneMask minus = inside;
    Lanes cosine(1);
    Lanes sine(0);
    bool first = true;
    for (const AvoidanceAngle& angle : angles) {
        const Lanes c(angle.cosine);
        const Lanes d(angle.sine);
        const Lanes even = start + (c * (ua + c * aa) + d * d * bb);
        const Lanes odd = d * (ub + c * ab);
        LaneMask up = even + odd >= Lanes(insideFrom);
        LaneMask down = even - odd >= Lanes(insideFrom);
        // The sphere is convex: at 90 degrees one side is outside, whatever rounding says.
        if (first) {
            up = up | (odd >= Lanes(0));
            down = down | (odd < Lanes(0));
            first = false;
        }
        plus = plus & up;
        minus = minus & down;
        const LaneMask lasting = plus | minus;
        if (!any(lasting)) break;
        cosine = select(lasting, c, cosine);
        sine = select(lasting, select(plus, d, -d), sine);
    }
    return cosine * s.along + sine * side;
}

}  // namespace kushi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
