// SPDX-License-Identifier: Apache-2.0
#include "contact/field_probe.h"

#include <cmath>

namespace kushi {

namespace {

// A quadratic B-spline's weights of three samples, and their first and second derivatives; a fourth
// that does not count.
struct Weights {
    float first = 0;
    float value[4]{}, slope[4]{}, bend[4]{};
};

Weights weightsAt(float u) {
    const float nearest = std::floor(u + 0.5F);
    const float f = u - nearest;
    const float low = 0.5F - f;
    const float high = 0.5F + f;
    return {nearest - 1,
            {0.5F * low * low, 0.75F - f * f, 0.5F * high * high, 0},
            {-low, -2 * f, high, 0},
            {1, -2, 1, 0}};
}

// Four numbers at once.
struct Row {
    float at[4]{};
    void add(float scale, const Row& row) {
        for (int i = 0; i < 4; ++i)
            at[i] += scale * row.at[i];
    }
    float dot(const float (&weights)[4]) const {
        return at[0] * weights[0] + at[1] * weights[1] + at[2] * weights[2];
    }
};

}  // namespace

FieldProbe probe(const DistanceField& field, Vec3f place) {
    const float scale = 1 / field.spacing;
    const Weights x = weightsAt((place.x - field.origin.x) * scale);
    const Weights y = weightsAt((place.y - field.origin.y) * scale);
    const Weights z = weightsAt((place.z - field.origin.z) * scale);
    const auto within = [](const Weights& weights, int size) {
        return weights.first >= 0 && weights.first + 3 < static_cast<float>(size);
    };
    // (Neither is a place that is not a number.)
    if (!within(x, field.size[0]) || !within(y, field.size[1]) || !within(z, field.size[2]))
        return {1, {}, {}};
    const std::size_t first = field.index(static_cast<int>(x.first), static_cast<int>(y.first),
                                          static_cast<int>(z.first));

    Row value, alongY, alongZ, bendY, bendZ, twist;  // sums over y and z
    for (int k = 0; k < 3; ++k) {
        Row plane, slope, bend;  // sums over y
        for (int j = 0; j < 3; ++j) {
            const std::int16_t* units = &field.units[first + field.index(0, j, k)];
            Row row;
            for (int i = 0; i < 4; ++i)
                row.at[i] = static_cast<float>(units[i]);
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
    const float unit = field.unit();
    const float slope = unit * scale;
    const float bend = slope * scale;
    return {unit * value.dot(x.value),
            {slope * value.dot(x.slope), slope * alongY.dot(x.value), slope * alongZ.dot(x.value)},
            {bend * value.dot(x.bend), bend * bendY.dot(x.value), bend * bendZ.dot(x.value),
             bend * alongY.dot(x.slope), bend * twist.dot(x.value), bend * alongZ.dot(x.slope)}};
}

}  // namespace kushi
