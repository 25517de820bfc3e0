// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/camera.h>

#include <string>

namespace kushi {

/// A part of a picture.
struct Zoom {
    double times = 1;         ///< as large
    double x = 0.5, y = 0.5;  ///< its middle, as shares of the whole from the left and the top
};

/// "TIMES" or "TIMES,X,Y".
Result<Zoom> parseZoom(const std::string& text);

/// The camera that takes that part, from where `camera` stands.
///
/// aspect  width / height of the picture
Camera zoomed(Camera camera, const Zoom& zoom, double aspect);

}  // namespace kushi
