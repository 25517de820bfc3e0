// SPDX-License-Identifier: Apache-2.0
#include <kushi/shade.h>

namespace kushi {

namespace {

Light distantLight(Vec3f towards, Rgb color) {
    return {normalized(towards), color};
}

}  // namespace

Lights studioLights() {
    return {.ambient = {0.33F, 0.34F, 0.36F},
            .distant = {distantLight({0.74F, 0.62F, 0.27F}, {0.80F, 0.78F, 0.75F}),
                        distantLight({0.30F, 0.60F, -0.75F}, {0.18F, 0.19F, 0.20F}),
                        distantLight({-0.80F, 0.60F, 0.1F}, {0.34F, 0.34F, 0.36F})}};
}

Lights portraitLights() {
    return {.ambient = {0.34F, 0.35F, 0.37F},
            .distant = {distantLight({0.70F, 0.62F, 0.35F}, {1.20F, 1.15F, 1.08F}),
                        distantLight({0.45F, 0.45F, -0.77F}, {0.40F, 0.42F, 0.45F}),
                        distantLight({-0.75F, 0.62F, -0.2F}, {1.10F, 1.10F, 1.15F})}};
}

}  // namespace kushi
