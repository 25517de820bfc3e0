// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/rods.h>

#include <functional>
#include <span>

namespace kushi {

/// Settles strands with their ties at given points, from where it last left them if `warm`.
using SettleTied = std::function<RestReport(std::span<const Tie> ties, bool warm)>;

/// Moves the knots of `ties` until the forces at each cancel: by Newton's method on their places,
/// with stiffnesses measured once and then kept up to date (Broyden 1965).
///
/// reach  how long tied strands are, about [m]
RestReport settleKnots(std::span<const Tie> ties, double reach, bool warm,
                       const SettleTied& settle);

}  // namespace kushi
