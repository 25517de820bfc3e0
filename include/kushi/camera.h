// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/result.h>
#include <kushi/strands.h>
#include <kushi/vec.h>

#include <string>

namespace kushi {

/// A perspective camera. It sees from a thousandth of the distance to its target onwards.
struct Camera {
    Vec3f eye, target;                  ///< m, not the same
    Vec3f up = {0, 1, 0};               ///< need not be normal to the view, nor unit
    float verticalFieldOfView = 0.35F;  ///< rad, in (0, pi)
};

/// Where a camera stands around the head [rad].
struct View {
    double yaw = 0;    ///< 0 in front of the face, growing towards the person's right
    double pitch = 0;  ///< > 0 looks from above; in [-pi/2, pi/2]
};

/// front, back, left, right, top, three-quarter (45,10), or "YAW,PITCH" in degrees.
/// `left` has the camera at the person's left (-z). Anything else is a problem that lists these.
Result<View> parseView(const std::string& text);

/// A camera in the direction `view` that looks at the middle of `bounds` and sees all of the box,
/// which fills at most 94 % of the picture's height and width.
///
/// aspect  width / height of the picture, > 0
Camera frame(const Bounds& bounds, View view, double aspect);

}  // namespace kushi
