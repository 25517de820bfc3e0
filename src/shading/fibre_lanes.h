// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "shading/far_field.h"
#include "shading/fibre_model.h"

#include <kushi/shade.h>

#include <array>
#include <cstddef>
#include <vector>

namespace kushi {

/// Some nodes side by side, for the lanes of a register. What lies beyond the last of them counts
/// for nothing, but is always a number.
struct FibreBatch {
    static constexpr std::size_t most = 128;
    using Row = std::array<float, most>;

    struct LightRows {
        Row sinIn{};      ///< of the angle to the normal plane
        Row facing{};     ///< cosine between the directions to the light and to the eye
        Row free{};       ///< as in Passage
        Row crossings{};  ///< likewise
    };

    explicit FibreBatch(std::size_t lightCount) : lights(lightCount) {}

    std::size_t count = 0;  ///< nodes
    Row sinOut{};
    Row tilt{};                           ///< by which the scales of the strand differ [rad]
    Row hereFree{}, hereCrossings{};      ///< of the sky's half around the eye
    Row beyondFree{}, beyondCrossings{};  ///< of its other half
    std::array<Row, 3> absorption{};      ///< per radius, of each channel
    std::array<Row, 3> forward{}, backward{}, local{};  ///< FarField::Albedo
    std::vector<LightRows> lights;
    std::array<Row, 3> colors{};  ///< what comes of it
};

/// What fibres of one look in some lights have in common.
struct FibreScene {
    FibreScene(const FibreLook& itsLook, Lights itsLights);

    FibreLook look;
    Lights lights;
    FarField far;
    std::array<FibreModel<float>::Longitudinal, 3> along;
    std::array<float, 3> variance{};
    float backVariance = 0;  ///< of what hair close by sends back
};

/// The colours of a batch, by dual scattering. All processors give the same bytes.
void scatterLanes(const FibreScene& scene, FibreBatch& batch);

}  // namespace kushi
