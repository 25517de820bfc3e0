// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "style/table_reader.h"

#include <kushi/style.h>

#include <array>
#include <optional>
#include <string>

namespace kushi {

// One function per table of the style file. What is wrong is reported to the context, and leaves a
// value that must not be used.

/// Also the heights of the head's landmarks, in the context.
void readHead(const Node& node, ReadContext& context, Style& style);
Collider readCollider(const Node& node, ReadContext& context);
Contact readContact(const Node& node, ReadContext& context);
Scalp readScalp(const Node& node, ReadContext& context);
/// A path, or a table of a path and how its numbers are meant.
GroomSource readGroomSource(const Entry& entry, ReadContext& context);
/// What hair that grows needs and the strands of a groom must not have, and the other way round.
Hair readHair(const Node& node, bool grows, ReadContext& context);
/// `lift`, `towards` and `whorl` of a hair's table.
void readLean(const TableReader& table, Hair& hair);
/// `color` of a hair's, a highlight's or another table.
void readColor(const TableReader& table, Rgb& color);
/// Whatever colours a hair's table has.
void readColors(const TableReader& table, Hair& hair);
Highlight readHighlight(const Node& node, ReadContext& context);
/// `clump` and `flyaway`, each a number or a table.
void readDress(const TableReader& table, Hair& hair);
Force readForce(const Node& node, ReadContext& context);
Cut readCut(const Node& node, ReadContext& context);
/// Its place is not finite where it could not be read.
HairTie readTie(const Node& node, ReadContext& context);

/// { theta = [low, high], phi = [low, high] }, either of which may be left out, or
/// { where = "fringe" } with the name of a zone of the built-in head.
RootRanges readRootRanges(const Node& node, const TableKeys& kind, ReadContext& context);
/// { x = [low, high], y = ..., z = ... }, any of which may be left out.
Box readBox(const Node& node, ReadContext& context);

/// What a part has, which may stand at the top where there is only one.
inline constexpr std::array<std::string_view, 7> keysOfPart = {
    "scalp", "groom", "hair", "force", "cut", "tie", "highlight"};

/// Whether the document keeps its only part's tables at the top: [hair] instead of [part.hair].
bool keepsPartAtTop(const Node& root);

}  // namespace kushi
