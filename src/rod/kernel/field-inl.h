// SPDX-License-Identifier: Apache-2.0
//
// Distance fields (probe() of src/contact), at places side by side.
#if defined(KUSHI_ROD_FIELD_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KUSHI_ROD_FIELD_INL_H
#undef KUSHI_ROD_FIELD_INL_H
#else
#define KUSHI_ROD_FIELD_INL_H
#endif

#include "contact/field_probe.h"
#include "rod/kernel/matrix-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace kushi::HWY_NAMESPACE {

// A place as a collider sees it.
template <class V>
struct Nearness {
    V distance;                 // to the surface, < 0 inside [m]
    V3<V> normal;               // derivative of the distance, outward and nearly unit
    Matrix<V, 3, 3> curvature;  // derivative of the normal [1/m]
};

template <class V>
class LaneField;

template <>
class LaneField<double> {
public:
    LaneField() = default;
    explicit LaneField(const DistanceField& field) : field_(&field) {}

    bool empty() const { return field_ == nullptr; }

    // Of a distance that has been read, what it is at least.
    double atLeast(double distance) const {
        return distance < 1 ? distance : std::max(0.0, 0.02 - 2 * double{field_->spacing});
    }

    double distance(const V3<double>& at, double /*near*/) const { return seen(at).distance; }

    bool look(const V3<double>& at, double near, Nearness<double>& out) const {
        const auto found = seen(at);
        const auto& g = found.gradient;
        const auto& h = found.hessian;
        out = {found.distance,
               {g[0], g[1], g[2]},
               {{{h[0], h[3], h[5]}, {h[3], h[1], h[4]}, {h[5], h[4], h[2]}}}};
        return out.distance < near;
    }

private:
    BasicFieldProbe<double> seen(const V3<double>& at) const {
        return probe(*field_, Vec3d{at[0], at[1], at[2]});
    }

    const DistanceField* field_ = nullptr;
};

template <>
class LaneField<Lanes> {
public:
    LaneField() = default;
    explicit LaneField(const DistanceField& field)
        : units_(field.units.data()),
          unit_(field.unit()),
          spacing_(field.spacing),
          rim_(std::max(0.0F, 0.02F - 2 * field.spacing)),
          origin_(everywhere(field.origin)) {
        for (int axis = 0; axis < 3; ++axis)
            size_[axis] = static_cast<float>(field.size[static_cast<std::size_t>(axis)]);
    }

    bool empty() const { return units_ == nullptr; }

    // Of a distance that has been read, what it is at least: beyond its grid a field knows nothing.
    HWY_INLINE Lanes atLeast(Lanes distance) const {
        return select(distance < Lanes(1), distance, Lanes(rim_));
    }

    // Where it is more than `near`, it may be less than that by up to two spacings.
    HWY_INLINE Lanes distance(const V3<Lanes>& at, Lanes near) const {
        return distanceOf(onGrid(at), near);
    }

    // The distance likewise; where it is less than `near`, all of what is to be known. Whether that
    // is so anywhere.
    HWY_INLINE bool look(const V3<Lanes>& at, Lanes near, Nearness<Lanes>& out) const {
        const V3<Lanes> u = onGrid(at);
        out.distance = distanceOf(u, near);
        const LaneMask close = out.distance <= near + Lanes(0.2F * spacing_);
        if (!any(close)) return false;
        const Lanes far = out.distance;
        smooth(u, out);
        out.distance = select(close, out.distance, far);
        return any(out.distance < near);
    }

private:
    using Tag = Lanes::Tag;
    using IntTag = hn::RebindToSigned<Tag>;
    using Ints = hn::Vec<IntTag>;

    // Of three samples along an axis: weights of value, slope and second derivative.
    struct Weights {
        Lanes value[3], slope[3];
    };

    static V3<Lanes> everywhere(Vec3f v) { return {Lanes(v.x), Lanes(v.y), Lanes(v.z)}; }

    HWY_INLINE V3<Lanes> onGrid(const V3<Lanes>& at) const {
        return Lanes(1 / spacing_) * (at - origin_);
    }

    HWY_INLINE Lanes distanceOf(const V3<Lanes>& u, Lanes near) const {
        const Lanes far = rough(u);
        const LaneMask close = far <= near;
        if (!any(close)) return far;
        return select(close, linear(u), far);
    }

    HWY_INLINE static Lanes floored(Lanes x) { return Lanes(hn::Floor(x.v)); }

    // Which lanes are at a whole number from `low` to that many before the end of the grid; the
    // others, also those that are not a number, are set there.
    HWY_INLINE LaneMask hold(V3<Lanes>& cell, float low, float before) const {
        LaneMask inside = Lanes(0) < Lanes(1);
        for (int axis = 0; axis < 3; ++axis) {
            const Lanes high(size_[axis] - before);
            inside = inside & (cell[axis] >= Lanes(low)) & (cell[axis] <= high);
        }
        cell = select<Lanes, 3>(inside, cell, {Lanes(low), Lanes(low), Lanes(low)});
        return inside;
    }

    // Of a sample, in bytes.
    HWY_INLINE Ints offset(const V3<Lanes>& cell) const {
        const IntTag d;
        const Ints x = hn::ConvertTo(d, cell[0].v);
        const Ints y = hn::ConvertTo(d, cell[1].v);
        const Ints z = hn::ConvertTo(d, cell[2].v);
        const Ints wide = hn::Set(d, static_cast<int>(size_[0]));
        const Ints high = hn::Set(d, static_cast<int>(size_[1]));
        return hn::ShiftLeft<1>(hn::Add(hn::Mul(hn::Add(hn::Mul(z, high), y), wide), x));
    }

    // Two samples side by side.
    HWY_INLINE Ints pair(Ints at) const {
        return hn::GatherOffset(IntTag(), reinterpret_cast<const std::int32_t*>(units_), at);
    }
    HWY_INLINE static Lanes first(Ints two) {
        return Lanes(hn::ConvertTo(Tag(), hn::ShiftRight<16>(hn::ShiftLeft<16>(two))));
    }
    HWY_INLINE static Lanes second(Ints two) {
        return Lanes(hn::ConvertTo(Tag(), hn::ShiftRight<16>(two)));
    }
    HWY_INLINE Ints moved(Ints at, int y, int z) const {
        const int rows = z * static_cast<int>(size_[1]) + y;
        return hn::Add(at, hn::Set(IntTag(), 2 * rows * static_cast<int>(size_[0])));
    }

    // The sample next to a place, less two spacings.
    HWY_INLINE Lanes rough(const V3<Lanes>& u) const {
        V3<Lanes> cell = {floored(u[0] + Lanes(0.5F)), floored(u[1] + Lanes(0.5F)),
                          floored(u[2] + Lanes(0.5F))};
        const LaneMask inside = hold(cell, 0, 2);
        const Lanes units = first(pair(offset(cell)));
        return select(inside, Lanes(unit_) * units - Lanes(2 * spacing_), Lanes(1));
    }

    HWY_INLINE Lanes linear(const V3<Lanes>& u) const {
        V3<Lanes> cell = {floored(u[0]), floored(u[1]), floored(u[2])};
        const V3<Lanes> share = u - cell;
        const LaneMask inside = hold(cell, 0, 2);
        const Ints at = offset(cell);
        const auto along = [&](int y, int z) HWY_ATTR {
            const Ints two = pair(moved(at, y, z));
            const Lanes low = first(two);
            return low + share[0] * (second(two) - low);
        };
        const auto across = [&](int z) HWY_ATTR {
            const Lanes low = along(0, z);
            return low + share[1] * (along(1, z) - low);
        };
        const Lanes low = across(0);
        const Lanes units = low + share[2] * (across(1) - low);
        return select(inside, Lanes(unit_) * units, Lanes(1));
    }

    // About the sample next to a place, `f` spacings from it.
    HWY_INLINE static Weights weights(Lanes f) {
        const Lanes low = Lanes(0.5F) - f;
        const Lanes high = Lanes(0.5F) + f;
        return {{Lanes(0.5F) * low * low, Lanes(0.75F) - f * f, Lanes(0.5F) * high * high},
                {-low, Lanes(-2) * f, high}};
    }

    // By quadratic B-splines.
    HWY_INLINE void smooth(const V3<Lanes>& u, Nearness<Lanes>& out) const {
        V3<Lanes> cell = {floored(u[0] + Lanes(0.5F)), floored(u[1] + Lanes(0.5F)),
                          floored(u[2] + Lanes(0.5F))};
        const V3<Lanes> f = u - cell;
        const LaneMask inside = hold(cell, 1, 3);
        const Weights x = weights(f[0]);
        const Weights y = weights(f[1]);
        const Weights z = weights(f[2]);
        const Ints at = hn::Sub(offset(cell), hn::Set(IntTag(), 2));

        // Sums over all; a letter for each derivative.
        Lanes all(0), sx(0), sy(0), sz(0), xx(0), yy(0), zz(0), xy(0), yz(0), zx(0);
        for (int k = 0; k < 3; ++k) {
            Lanes p(0), px(0), py(0), pxx(0), pyy(0), pxy(0);  // over a plane
            for (int j = 0; j < 3; ++j) {
                const Ints row = moved(at, j - 1, k - 1);
                const Ints two = pair(row);
                const Lanes a = first(two);
                const Lanes b = second(two);
                const Lanes c = first(pair(hn::Add(row, hn::Set(IntTag(), 4))));
                const Lanes value = x.value[0] * a + x.value[1] * b + x.value[2] * c;
                const Lanes slope = x.slope[0] * a + x.slope[1] * b + x.slope[2] * c;
                p += y.value[j] * value;
                px += y.value[j] * slope;
                pxx += y.value[j] * (a + c - b - b);
                py += y.slope[j] * value;
                pxy += y.slope[j] * slope;
                pyy += j == 1 ? Lanes(-2) * value : value;
            }
            all += z.value[k] * p;
            sx += z.value[k] * px;
            sy += z.value[k] * py;
            xx += z.value[k] * pxx;
            yy += z.value[k] * pyy;
            xy += z.value[k] * pxy;
            sz += z.slope[k] * p;
            zx += z.slope[k] * px;
            yz += z.slope[k] * py;
            zz += k == 1 ? Lanes(-2) * p : p;
        }
        const Lanes none(0);
        const Lanes slope = select(inside, Lanes(unit_ / spacing_), none);
        const Lanes bend = select(inside, Lanes(unit_ / (spacing_ * spacing_)), none);
        out.distance = select(inside, Lanes(unit_) * all, Lanes(1));
        out.normal = slope * V3<Lanes>{sx, sy, sz};
        out.curvature = bend * Matrix<Lanes, 3, 3>{{{xx, xy, zx}, {xy, yy, yz}, {zx, yz, zz}}};
    }

    const std::int16_t* units_ = nullptr;
    float unit_ = 0, spacing_ = 1;
    float rim_ = 0;  // what is two spacings from the border of the grid is so far from a solid [m]
    float size_[3] = {};
    V3<Lanes> origin_{};
};

}  // namespace kushi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
