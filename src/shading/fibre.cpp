// SPDX-License-Identifier: Apache-2.0
#include "shading/fibre_model.h"

#include <kushi/fibre.h>

namespace kushi {

namespace {

using Model = FibreModel<double>;
using View = FibreView<double>;

View viewOf(const Model& model, double h, FibreDirection out) {
    return {model, std::clamp(h, -1.0, 1.0), std::sin(out.theta), std::cos(out.theta)};
}

FibreLobes spread(const View& view, FibreDirection out, FibreDirection in) {
    return view.spread({std::sin(in.theta), std::cos(in.theta), in.phi - out.phi});
}

/// The shares as probabilities.
FibreLobes normalized(FibreLobes shares) {
    const double sum = shares[0] + shares[1] + shares[2] + shares[3];
    for (double& share : shares)
        share /= sum;
    return shares;
}

double weighted(const FibreLobes& weights, const FibreLobes& values) {
    double sum = 0;
    for (std::size_t p = 0; p < 4; ++p)
        sum += weights[p] * values[p];
    return sum;
}

}  // namespace

FibreLobes fibreResponse(const Fibre& fibre, double absorption, double h, FibreDirection out,
                         FibreDirection in) {
    const Model model(fibre);
    const View view = viewOf(model, h, out);
    FibreLobes response = view.attenuations(absorption);
    const FibreLobes directions = spread(view, out, in);
    for (std::size_t p = 0; p < 4; ++p)
        response[p] *= directions[p];
    return response;
}

FibreSample sampleFibre(const Fibre& fibre, double absorption, double h, FibreDirection out,
                        double u, double v, double w) {
    const Model model(fibre);
    const View view = viewOf(model, h, out);
    const FibreLobes shares = normalized(view.attenuations(absorption));
    std::size_t p = 0;
    double before = 0;
    while (p < 3 && u >= before + shares[p])
        before += shares[p++];
    // What is left of u is uniform again.
    const double rest = shares[p] > 0 ? std::clamp((u - before) / shares[p], 0.0, 1 - 0x1p-53) : 0;
    const FibreIncidence<double> in = view.sample(p, rest, v, w);
    return {{std::asin(in.sinTheta), in.phi + out.phi}, weighted(shares, view.spread(in))};
}

double fibrePdf(const Fibre& fibre, double absorption, double h, FibreDirection out,
                FibreDirection in) {
    const Model model(fibre);
    const View view = viewOf(model, h, out);
    return weighted(normalized(view.attenuations(absorption)), spread(view, out, in));
}

FibreLobes fibreAlbedo(const Fibre& fibre, double absorption, double theta) {
    const Model model(fibre);
    constexpr int steps = 256;  // of Simpson's rule over gamma in [0, pi/2]
    const double step = std::numbers::pi / 2 / steps;
    FibreLobes albedo{};
    for (int i = 0; i <= steps; ++i) {
        const double gamma = i * step;
        const double ends = i == 0 || i == steps ? 1 : 2 + 2 * (i % 2);
        const double weight = ends * step / 3 * std::cos(gamma);
        const FibreLobes shares =
            viewOf(model, std::sin(gamma), {theta, 0}).attenuations(absorption);
        for (std::size_t p = 0; p < 4; ++p)
            albedo[p] += weight * shares[p];
    }
    return albedo;
}

}  // namespace kushi
