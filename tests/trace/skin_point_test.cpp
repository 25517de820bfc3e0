// SPDX-License-Identifier: Apache-2.0
#include "trace/skin_point.h"

#include "core/random.h"

#include <gtest/gtest.h>

namespace kushi {
namespace {

SkinSpot spotOf(Rgb albedo) {
    const Vec3f up = normalized(Vec3f{0.2F, 1, -0.4F});
    return {.place = {}, .normal = up, .surface = up, .albedo = albedo};
}

Vec3f tilted(const SkinSpot& spot, float angle) {
    const Axes axes(spot.normal);
    return axes.toWorld({std::sin(angle), 0, std::cos(angle)});
}

/// The share of light that comes back, by samples.
float sampledAlbedo(const SkinPoint& point, std::uint64_t count) {
    double sum = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
        Sampler random(5, static_cast<std::uint32_t>(i));
        const Pair a = random.pair();
        const Turn turn = point.sample(a, random.single());
        if (turn.ok) sum += static_cast<double>(turn.weight.g);
    }
    return static_cast<float>(sum / static_cast<double>(count));
}

TEST(SkinPoint, SendsBackWhatItsPartsSay) {
    for (const float angle : {0.0F, 0.6F, 1.2F, 1.5F}) {
        for (const float width : {0.1F, 0.45F, 1.0F}) {
            const SkinSpot white = spotOf({1, 1, 1});
            const SkinPoint shiny(white, tilted(white, angle), {1, 1, 1}, 0.3F, width);
            const float back = sampledAlbedo(shiny, 1 << 14);
            EXPECT_LT(back, 1.01F) << angle << " " << width;
            EXPECT_GT(back, 0.6F);
            const SkinPoint matt(white, tilted(white, angle), {1, 1, 1}, 0, width);
            EXPECT_NEAR(sampledAlbedo(matt, 1 << 10), 1, 1e-4);
        }
    }
    // Black skin has the gloss alone: Schlick's share where facets hardly hide each other.
    const SkinSpot black = spotOf({});
    const SkinPoint gloss(black, tilted(black, 0.3F), {1, 1, 1}, 0.04F, 0.1F);
    EXPECT_NEAR(sampledAlbedo(gloss, 1 << 14), 0.04, 0.001);
}

// Light that grows with a coordinate: by sampling as by looking everywhere.
TEST(SkinPoint, IsSampledAsItResponds) {
    const SkinSpot spot = spotOf({0.3F, 0.6F, 0.2F});
    const SkinPoint point(spot, tilted(spot, 0.8F), {1, 1, 1}, 0.2F, 0.4F);
    const auto light = [](Vec3f in) { return 1 + static_cast<double>(in.x); };
    double sampled = 0;
    double everywhere = 0;
    double density = 0;
    double kept = 0;  // the others went below the surface
    constexpr std::uint32_t count = 1 << 16;
    for (std::uint32_t i = 0; i < count; ++i) {
        Sampler random(9, i);
        const Pair a = random.pair();
        const Turn turn = point.sample(a, random.single());
        if (turn.ok) kept += 1.0 / count;
        if (turn.ok) sampled += light(turn.direction) * static_cast<double>(turn.weight.g) / count;
        const Pair b = random.pair();
        const float z = 2 * b.u - 1;
        const float turnAngle = 6.2831853F * b.v;
        const float r = std::sqrt(1 - z * z);
        const Vec3f in = {r * std::cos(turnAngle), r * std::sin(turnAngle), z};
        const Response response = point.response(in);
        everywhere +=
            light(in) * static_cast<double>(response.value.g) * 4 * std::numbers::pi / count;
        density += static_cast<double>(response.pdf) * 4 * std::numbers::pi / count;
    }
    EXPECT_NEAR(sampled / everywhere, 1, 0.01);
    EXPECT_NEAR(density, kept, 0.02);
}

}  // namespace
}  // namespace kushi
