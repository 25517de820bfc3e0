// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/projection.h"
#include "trace/path.h"

#include <kushi/trace.h>

namespace kushi {

/// Traces the picture tile by tile; options in range.
Traced traceTiles(const World& world, const Projection& projection, const TraceOptions& options);

}  // namespace kushi
