// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/vec.h>

#include <cstdint>

namespace kushi {

/// The key of the small patch of scalp, `size` [m] wide, that a hair grows on. Patches are those
/// nearest to the points of a jittered grid, so that they do not depend on how many hairs there
/// are; each salt has patches of its own.
std::uint64_t patchOf(Vec3d root, double size, std::uint64_t salt);

}  // namespace kushi
