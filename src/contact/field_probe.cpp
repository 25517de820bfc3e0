// SPDX-License-Identifier: Apache-2.0
#include "contact/field_probe.h"

#include <cmath>

namespace kushi {

namespace {

// A quadratic B-spline's weights of three samples, and their first and second derivatives; a fourth
// that does not count.
template <class T>
struct Weights {
    T first = 0;
    T value[4]{}, slope[4]{}, bend[4]{};
};

template <class T>
Weights<T> weightsAt(T u) {
    constexpr T half(0.5);
    const T nearest = std::floor(u + half);
    const T f = u - nearest;
    const T low = half - f;
    const T high = half + f;
    return {nearest - 1,
            {half * low * low, T(0.75) - f * f, half * high * high, 0},
            {-low, -2 * f, high, 0},
            {1, -2, 1, 0}};
}

// Four numbers at once.
template <class T>
struct Row {
    T at[4]{};
    void add(T scale, const Row& row) {
        for (int i = 0; i < 4; ++i)
            at[i] += scale * row.at[i];
    }
    T dot(const T (&weights)[4]) const {
        return at[0] * weights[0] + at[1] * weights[1] + at[2] * weights[2];
    }
};

template <class T, class Place>
BasicFieldProbe<T> probeAt(const DistanceField& field, Place place) {
    const Place origin = field.origin.as<T>();
    const T scale = 1 / T(field.spacing);
    const Weights<T> x = weightsAt((place.x - origin.x) * scale);
    const Weights<T> y = weightsAt((place.y - origin.y) * scale);
    const Weights<T> z = weightsAt((place.z - origin.z) * scale);
    const auto within = [](const Weights<T>& weights, int size) {
        return weights.first >= 0 && weights.first + 3 < static_cast<T>(size);
    };
    // (Neither is a place that is not a number.)
    if (!within(x, field.size[0]) || !within(y, field.size[1]) || !within(z, field.size[2]))
        return {1, {}, {}};
    const std::size_t first = field.index(static_cast<int>(x.first), static_cast<int>(y.first),
                                          static_cast<int>(z.first));

    Row<T> value, alongY, alongZ, bendY, bendZ, twist;  // sums over y and z
    for (int k = 0; k < 3; ++k) {
        Row<T> plane, slope, bend;  // sums over y
        for (int j = 0; j < 3; ++j) {
            const std::int16_t* units = &field.units[first + field.index(0, j, k)];
            Row<T> row;
            for (int i = 0; i < 4; ++i)
                row.at[i] = static_cast<T>(units[i]);
            plane.add(y.value[j], row);
            slope.add(y.slope[j], row);
            bend.add(y.bend[j], row);
        }
        value.add(z.value[k], plane);
        alongY.add(z.value[k], slope);
        bendY.add(z.value[k], bend);
        alongZ.add(z.slope[k], plane);
        twist.add(z.slope[k], slope);
        bendZ.add(z.bend[k], plane);
    }
    const T unit = T(field.spacing) / T(DistanceField::unitsPerSpacing);
    const T slope = unit * scale;
    const T bend = slope * scale;
    return {unit * value.dot(x.value),
            {slope * value.dot(x.slope), slope * alongY.dot(x.value), slope * alongZ.dot(x.value)},
            {bend * value.dot(x.bend), bend * bendY.dot(x.value), bend * bendZ.dot(x.value),
             bend * alongY.dot(x.slope), bend * twist.dot(x.value), bend * alongZ.dot(x.slope)}};
}

}  // namespace

FieldProbe probe(const DistanceField& field, Vec3f place) {
    return probeAt<float>(field, place);
}

BasicFieldProbe<double> probe(const DistanceField& field, Vec3d place) {
    return probeAt<double>(field, place);
}

Vec3d outwardAt(const DistanceField& field, Vec3d place) {
    const FieldProbe seen = probe(field, place.as<float>());
    const Vec3d gradient = {seen.gradient[0], seen.gradient[1], seen.gradient[2]};
    return length(gradient) > 1e-3 ? normalized(gradient) : Vec3d{0, 1, 0};
}

}  // namespace kushi
