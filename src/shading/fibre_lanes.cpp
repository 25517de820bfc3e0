// SPDX-License-Identifier: Apache-2.0
//
// Dual scattering: Zinke, Yuksel, Weber & Keyser, "Dual Scattering Approximation for Fast Multiple
// Scattering in Hair" (2008). Only operations that IEEE rounds alike are used.
#include "shading/fibre_lanes.h"

#include "core/lane_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shading/fibre_lanes.cpp"
// Highway's file compiles this one again for each target: it comes before the kernels.
// clang-format off
#include <hwy/foreach_target.h>
#include "core/lanes-inl.h"
#include "shading/functions-inl.h"
// clang-format on

#include <bit>
#include <cmath>
#include <numbers>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace kushi::HWY_NAMESPACE {

using Row = FibreBatch::Row;
using Channels = std::array<Lanes, 3>;

constexpr float pi = std::numbers::pi_v<float>;

/// One light's direction against the fibres and the eye.
struct Incidence {
    Lanes sinIn, cosIn;    // of the angle to the normal plane
    Lanes sinOut, cosOut;  // likewise, of the eye
    Lanes cosPhi;          // around the fibre, from the eye
};

/// FarField's table for as many nodes as there are lanes.
struct FarLanes {
    Lanes r, tt, trt, pathTt, pathTrt, rHalf, ttHalf, trtHalf;

    FarLanes(const FarField& far, Lanes sinHalf, Lanes phi) {
        alignas(64) float sines[Lanes::count];
        alignas(64) float angles[Lanes::count];
        alignas(64) float rows[8][Lanes::count];
        storeLanes(sinHalf, sines);
        storeLanes(phi, angles);
        for (std::size_t lane = 0; lane < Lanes::count; ++lane) {
            const auto entry =
                std::bit_cast<std::array<float, 8>>(far.around(sines[lane], angles[lane]));
            for (std::size_t k = 0; k < 8; ++k)
                rows[k][lane] = entry[k];
        }
        const auto row = [&](std::size_t k) { return loadLanes(rows[k], Lanes()); };
        r = row(0);
        tt = row(1);
        trt = row(2);
        pathTt = row(3);
        pathTrt = row(4);
        rHalf = row(5);
        ttHalf = row(6);
        trtHalf = row(7);
    }
};

/// The nodes of a batch from `first` on, one in each lane.
class FibreLanes {
public:
    FibreLanes(const FibreScene& scene, const FibreBatch& batch, std::size_t first)
        : scene_(scene),
          batch_(batch),
          first_(first),
          sinOut_(load(batch.sinOut)),
          cosOut_(squareRoot(Lanes(1) - sinOut_ * sinOut_)),
          pastBehind_{} {
        const Lanes behind = load(batch.beyondCrossings);
        for (std::size_t c = 0; c < 3; ++c) {
            pastBehind_[c] = exponential(-behind * (Lanes(1) - load(batch.forward[c])));
            // What hair close by sends back, where there is any behind.
            near_[c] = load(batch.local[c]) * (Lanes(1) - pastBehind_[c]);
        }
    }

    /// From the eye's side hair sends the sky's light back, from beyond it lets it through.
    Channels fromSky() const {
        const Lanes crossings = load(batch_.hereCrossings);
        const auto& sky = scene_.lights.ambient;
        const std::array<float, 3> light = {sky.r, sky.g, sky.b};
        Channels sum;
        for (std::size_t c = 0; c < 3; ++c) {
            const Lanes forward = load(batch_.forward[c]);
            const Lanes before = exponential(-crossings * (Lanes(1) - forward));
            sum[c] = Lanes(light[c]) *
                     (load(batch_.hereFree) * before * (load(batch_.backward[c]) + near_[c]) +
                      load(batch_.beyondFree) * pastBehind_[c] * forward);
        }
        return sum;
    }

    Channels fromLight(std::size_t i) const {
        const FibreBatch::LightRows& rows = batch_.lights[i];
        const Rgb color = scene_.lights.distant[i].color;
        const std::array<float, 3> light = {color.r, color.g, color.b};
        const Lanes sinIn = load(rows.sinIn);
        const Lanes cosIn = squareRoot(Lanes(1) - sinIn * sinIn);
        const Lanes around =
            (load(rows.facing) - sinIn * sinOut_) / most(cosIn * cosOut_, Lanes(1e-6F));
        const Lanes cosPhi = least(most(around, Lanes(-1)), Lanes(1));
        const Channels share =
            scattered({sinIn, cosIn, sinOut_, cosOut_, cosPhi}, load(rows.crossings));
        // A white matt surface shows 1/pi of the light that meets it.
        const Lanes reaching = Lanes(pi) * load(rows.free);
        Channels sum;
        for (std::size_t c = 0; c < 3; ++c)
            sum[c] = reaching * Lanes(light[c]) * share[c];
        return sum;
    }

private:
    Lanes load(const Row& row) const { return loadLanes(row.data() + first_, Lanes()); }

    /// M of a lobe that strays by `variance` about what 1 - exp(-2 / variance) is `whole` of, with
    /// exp(-x) I0(x) to 1.4 %.
    static Lanes stray(Lanes inverse, Lanes whole, const Incidence& in) {
        const Lanes both = in.cosIn * in.cosOut;
        const Lanes x = both * inverse;
        const Lanes bessel = Lanes(1) + Lanes(2 * pi) * x *
                                            (Lanes(0.390702F) + x * (Lanes(1.027749F) + x)) /
                                            (Lanes(1.529653F) + x * (Lanes(1.543265F) + x));
        return inverse * exponential((both - in.sinIn * in.sinOut - Lanes(1)) * inverse) /
               (whole * squareRoot(bessel));
    }
    static Lanes stray(float variance, const Incidence& in) {
        return stray(Lanes(1 / variance), Lanes(1 - std::exp(-2 / variance)), in);
    }
    static Lanes stray(Lanes variance, const Incidence& in) {
        const Lanes inverse = Lanes(1) / variance;
        return stray(inverse, Lanes(1) - exponential(Lanes(-2) * inverse), in);
    }

    /// The same seen from where way p sends what came straight: reflection turns by twice the tilt
    /// of the scales, two passages by minus one, four by minus two.
    Incidence turned(std::size_t p, Incidence in) const {
        static constexpr std::array<float, 3> times = {2, -1, -4};
        const Lanes turn = Lanes(times[p]) * load(batch_.tilt);
        const auto& lobe = scene_.along[p];
        const Lanes sine = Lanes(lobe.sinTilt) + Lanes(lobe.cosTilt) * turn;
        const Lanes cosine = Lanes(lobe.cosTilt) - Lanes(lobe.sinTilt) * turn;
        const Lanes sinTurned = in.sinOut * cosine + in.cosOut * sine;
        in.cosOut = magnitude(in.cosOut * cosine - in.sinOut * sine);
        in.sinOut = sinTurned;
        return in;
    }

    /// Response per channel after so many crossings on average.
    Channels scattered(const Incidence& in, Lanes crossings) const {
        const Lanes cosDifference = in.cosIn * in.cosOut + in.sinIn * in.sinOut;
        const Lanes sinHalf = squareRoot(most(Lanes(0.5F) - Lanes(0.5F) * cosDifference, Lanes(0)));
        const FarLanes far(scene_.far, sinHalf, arcCosine(in.cosPhi));
        const Lanes none = exponential(-crossings);
        // Fibres crossed by what has crossed any.
        const Lanes some = most(crossings / most(Lanes(1) - none, Lanes(1e-4F)), Lanes(1));

        std::array<Lanes, 3> direct;
        std::array<Lanes, 3> passed;
        for (std::size_t p = 0; p < 3; ++p) {
            const Incidence out = turned(p, in);
            direct[p] = stray(scene_.variance[p], out);
            passed[p] = stray(Lanes(scene_.variance[p]) + some * Lanes(scene_.variance[1]), out);
        }
        direct[0] = direct[0] * far.r;
        passed[0] = passed[0] * far.rHalf;
        // Into the half circle that it comes from.
        const Lanes back = most(in.cosPhi, Lanes(0)) * Lanes(0.5F) * stray(scene_.backVariance, in);

        Channels sum;
        for (std::size_t c = 0; c < 3; ++c) {
            const Lanes absorption = load(batch_.absorption[c]);
            const Lanes tt = exponential(-absorption * far.pathTt);
            const Lanes trt = exponential(-absorption * far.pathTrt);
            const Lanes sentBack = near_[c] * back;
            const Lanes any = exponential(-crossings * (Lanes(1) - load(batch_.forward[c])));
            sum[c] = none * (direct[0] + direct[1] * far.tt * tt + direct[2] * far.trt * trt +
                             sentBack) +
                     (any - none) * (passed[0] + passed[1] * far.ttHalf * tt +
                                     passed[2] * far.trtHalf * trt + sentBack);
        }
        return sum;
    }

    const FibreScene& scene_;
    const FibreBatch& batch_;
    std::size_t first_;
    Lanes sinOut_, cosOut_;
    Channels pastBehind_, near_;
};

void scatterHere(const FibreScene& scene, FibreBatch& batch) {
    for (std::size_t first = 0; first < batch.count; first += Lanes::count) {
        const FibreLanes lanes(scene, batch, first);
        Channels sum = lanes.fromSky();
        for (std::size_t i = 0; i < batch.lights.size(); ++i) {
            const Channels more = lanes.fromLight(i);
            for (std::size_t c = 0; c < 3; ++c)
                sum[c] += more[c];
        }
        for (std::size_t c = 0; c < 3; ++c)
            storeLanes(sum[c], batch.colors[c].data() + first);
    }
}

}  // namespace kushi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kushi {

HWY_EXPORT(scatterHere);

FibreScene::FibreScene(const FibreLook& itsLook, Lights itsLights)
    : look(itsLook), lights(std::move(itsLights)), far(itsLook.fibre) {
    const FibreModel<float> model(look.fibre);
    for (std::size_t p = 0; p < 3; ++p) {
        along[p] = model.along[p];
        variance[p] = 1 / model.along[p].inverseVariance;
    }
    // What comes back from near hair went through some and came back from one.
    backVariance = 2 * (variance[0] + variance[1]);
}

void scatterLanes(const FibreScene& scene, FibreBatch& batch) {
    HWY_DYNAMIC_DISPATCH(scatterHere)(scene, batch);
}

}  // namespace kushi
#endif
