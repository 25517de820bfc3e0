// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "style/table_reader.h"

#include <kushi/style.h>

#include <optional>
#include <string>

namespace kushi {

// One function per table of the style file. What is wrong is reported to the context, and leaves a
// value that must not be used.

/// Also the heights of the head's landmarks, in the context. A relative path of a mesh starts from
/// `folder`.
void readHead(const Node& node, const std::string& folder, ReadContext& context, Style& style);
Scalp readScalp(const Node& node, ReadContext& context);
Hair readHair(const Node& node, ReadContext& context);
Force readForce(const Node& node, ReadContext& context);
Cut readCut(const Node& node, ReadContext& context);

/// { theta = [low, high], phi = [low, high] }, either of which may be left out, or
/// { where = "fringe" } with the name of a zone of the built-in head.
RootRanges readRootRanges(const Node& node, const TableKeys& kind, ReadContext& context);
/// { x = [low, high], y = ..., z = ... }, any of which may be left out.
Box readBox(const Node& node, ReadContext& context);

/// Whether the document keeps its only part's tables at the top: [hair] instead of [part.hair].
bool keepsPartAtTop(const Node& root);

}  // namespace kushi
