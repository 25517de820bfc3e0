// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "style/diagnostics.h"
#include "style/document.h"
#include "style/heights.h"
#include "style/quantity.h"

#include <kushi/vec.h>

#include <optional>
#include <string_view>

namespace kushi {

/// A number of the document in SI. One that is none or out of range is reported once, under `name`,
/// and gives nothing.
std::optional<double> readNumber(const Node& node, std::string_view name, const Quantity& quantity,
                                 Diagnostics& problems);

/// The same for an array of three.
std::optional<Vec3d> readVector(const Node& node, std::string_view name, const Quantity& quantity,
                                Diagnostics& problems);

/// A height in m, given in cm or as the name of a landmark of the head.
std::optional<double> readHeight(const Node& node, std::string_view name, const Heights& heights,
                                 Diagnostics& problems);

/// "a number from LOW to HIGH UNIT", as problems put it.
std::string expectedNumber(const Quantity& quantity);

/// What to tell who wrote a string for a number: a hint if it looks like one, or nothing.
std::string stringHint(std::string_view text);

}  // namespace kushi
