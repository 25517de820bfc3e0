// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/result.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kushi {

enum class PlyFormat { Ascii, LittleEndian, BigEndian };

enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

/// Bytes of a number.
std::size_t sizeOf(PlyType type);

/// A column of an element.
struct PlyProperty {
    std::string name;
    PlyType type = PlyType::Float32;
    std::optional<PlyType> listCount;  ///< a list with its length in this type ahead
};

/// A table: `count` rows.
struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;

    /// Index of the property, or nothing.
    std::optional<std::size_t> find(std::string_view property) const;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::Ascii;
    std::vector<PlyElement> elements;  ///< in the order of the body
    std::string_view body;             ///< what follows the header
    int lines = 0;                     ///< of the header
};

/// The header of a PLY file (Turk 1994); the body stays as it is, no count is believed yet.
Result<PlyHeader> parsePlyHeader(std::string_view bytes, const std::string& file);

}  // namespace kushi
