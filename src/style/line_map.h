// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstddef>
#include <string_view>
#include <vector>

namespace kushi {

/// A place in a text, as an editor shows it.
struct Position {
    int line = 1;    ///< from 1
    int column = 1;  ///< from 1, in characters, not bytes

    friend auto operator<=>(Position, Position) = default;
};

/// Translates between byte offsets and positions, both ways in about the same short time however
/// long the lines are. The text must be UTF-8 and outlive the map.
class LineMap {
public:
    explicit LineMap(std::string_view text);

    Position position(std::size_t offset) const;
    /// Offset of the character at `position`; the end of the text if it has none such.
    std::size_t offset(Position position) const;

private:
    std::size_t charactersBefore(std::size_t offset) const;

    std::string_view text_;
    std::vector<std::size_t> lineStarts_;       // offset of each line, after a byte order mark
    std::vector<std::size_t> characterCounts_;  // characters before each block of bytes
};

}  // namespace kushi
