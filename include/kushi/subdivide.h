// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/strands.h>

namespace kushi {

/// Strands with more nodes where they turn much, for drawing: light is computed at nodes, so its
/// bands are only as sharp as the polyline. All nodes stay, in their place; those between lie on a
/// Catmull-Rom curve through them (by chord length; at an end it goes on as a parabola). Attributes
/// run linearly.
///
/// A segment is cut in as many equal parts as its tangent turns by maxTurn, at most 16. One without
/// length or with a node that is not finite is left whole.
///
/// maxTurn  rad, > 0: of the tangent from node to node. The paper's highlight asks for 0.066 (3.8
///          degrees, a quarter of its half-width at n = 80)
/// threads  0: as many as the machine has
/// returns  the strands as they are if there would be more nodes than offsets can count
Strands subdivided(Strands strands, double maxTurn, int threads = 0);

}  // namespace kushi
