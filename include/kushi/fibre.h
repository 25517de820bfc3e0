// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/pigment.h>
#include <kushi/vec.h>

#include <array>

namespace kushi {

/// A hair as light meets it: a rough cylinder of tinted glass with tilted scales (Marschner et al.
/// 2003; d'Eon et al. 2011; Chiang et al. 2016).
struct Fibre {
    double eta = 1.55;           ///< index of refraction, > 1
    double longitudinal = 0.3;   ///< beta_m, roughness along the fibre, in (0, 1]
    double azimuthal = 0.3;      ///< beta_n, roughness around it, in (0, 1]
    double tilt = radians(2.0);  ///< rad; scales open towards the tip, as on real hair, if > 0
};

/// A direction away from a point of a fibre whose tangent runs from root to tip.
struct FibreDirection {
    double theta = 0;  ///< rad, from the plane normal to the fibre towards its tip, [-pi/2, pi/2]
    double phi = 0;    ///< rad, right-handed about the tangent
};

/// One number for each way light takes: R, reflected; TT, through; TRT, reflected inside once; and
/// all that is reflected inside more often.
using FibreLobes = std::array<double, 4>;

/// f |cos|: the radiance that a point of the fibre sends along `out` for a unit of radiance from
/// each steradian about `in` (Chiang et al. 2016, eq. 4-11, with an exact Bessel function). Its
/// integral over the sphere of `in` is 1 for a clear fibre. R is brightest where in.theta =
/// -out.theta - 2 tilt: light that comes in square leaves towards the root. Not reciprocal.
///
/// absorption  sigma_a, per radius of the fibre, >= 0
/// h           where across the fibre it is seen, sin(out.phi - azimuth of the normal), in [-1, 1]
FibreLobes fibreResponse(const Fibre& fibre, double absorption, double h, FibreDirection out,
                         FibreDirection in);

struct FibreSample {
    FibreDirection in;
    double pdf = 0;  ///< per steradian
};

/// A direction with a density proportional to the response, but for the lobes' shares, which are
/// the attenuations of `absorption`; with it response / pdf is the same from everywhere.
///
/// u, v, w  uniform in [0, 1)
FibreSample sampleFibre(const Fibre& fibre, double absorption, double h, FibreDirection out,
                        double u, double v, double w);

/// The density with which sampleFibre() gives `in` [1/sr].
double fibrePdf(const Fibre& fibre, double absorption, double h, FibreDirection out,
                FibreDirection in);

/// Share of the light that each way sends on, averaged over the fibre's width; for light from
/// `theta` as well as towards it. With absorption 0 they add up to 1.
FibreLobes fibreAlbedo(const Fibre& fibre, double absorption, double theta);

}  // namespace kushi
