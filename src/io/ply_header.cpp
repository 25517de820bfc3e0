// SPDX-License-Identifier: Apache-2.0
#include "io/ply_header.h"

#include "io/text.h"

#include <algorithm>
#include <array>
#include <utility>

namespace kushi {
namespace {

std::optional<PlyType> parseType(std::string_view word) {
    using Name = std::pair<std::string_view, PlyType>;
    static constexpr std::array<Name, 16> names = {{
        {"char", PlyType::Int8},
        {"int8", PlyType::Int8},
        {"uchar", PlyType::UInt8},
        {"uint8", PlyType::UInt8},
        {"short", PlyType::Int16},
        {"int16", PlyType::Int16},
        {"ushort", PlyType::UInt16},
        {"uint16", PlyType::UInt16},
        {"int", PlyType::Int32},
        {"int32", PlyType::Int32},
        {"uint", PlyType::UInt32},
        {"uint32", PlyType::UInt32},
        {"float", PlyType::Float32},
        {"float32", PlyType::Float32},
        {"double", PlyType::Float64},
        {"float64", PlyType::Float64},
    }};
    const auto* const found = std::ranges::find(names, word, &Name::first);
    if (found == names.end()) return std::nullopt;
    return found->second;
}

// Far above any use; looking for names stays quick.
constexpr std::size_t mostNames = 1000;

bool isFloating(PlyType type) {
    return type == PlyType::Float32 || type == PlyType::Float64;
}

// Each of the following reads what is left of a header line; what is wrong with it, or nothing.

std::string readFormat(std::string_view line, PlyFormat& format) {
    const std::string_view name = takeWord(line);
    const std::string_view version = takeWord(line);
    if (name == "ascii") {
        format = PlyFormat::Ascii;
    } else if (name == "binary_little_endian") {
        format = PlyFormat::LittleEndian;
    } else if (name == "binary_big_endian") {
        format = PlyFormat::BigEndian;
    } else {
        return "unknown format " + inQuotes(name) +
               ": expected ascii, binary_little_endian or binary_big_endian";
    }
    if (version != "1.0") return "unknown PLY version " + inQuotes(version) + ": expected 1.0";
    return {};
}

std::string readElement(std::string_view line, std::vector<PlyElement>& elements) {
    const std::string_view name = takeWord(line);
    const std::string_view count = takeWord(line);
    const auto number = parseInteger<std::uint64_t>(count);
    if (name.empty() || !number) {
        return "expected 'element', a name and a count, found the count " + inQuotes(count);
    }
    if (std::ranges::find(elements, name, &PlyElement::name) != elements.end()) {
        return "a second element " + inQuotes(name);
    }
    if (elements.size() == mostNames) return "more than " + std::to_string(mostNames) + " elements";
    elements.push_back({std::string(name), *number, {}});
    return {};
}

std::string readProperty(std::string_view line, std::vector<PlyElement>& elements) {
    if (elements.empty()) return "a property before the first element";
    PlyProperty property;
    std::string_view type = takeWord(line);
    if (type == "list") {
        const std::string_view count = takeWord(line);
        property.listCount = parseType(count);
        if (!property.listCount || isFloating(*property.listCount)) {
            return "unknown type " + inQuotes(count) + " for the length of a list";
        }
        type = takeWord(line);
    }
    const auto known = parseType(type);
    if (!known) return "unknown type " + inQuotes(type) + " of a property";
    property.type = *known;
    property.name = takeWord(line);
    if (property.name.empty()) return "a property without a name";
    if (elements.back().find(property.name)) {
        return "a second property " + inQuotes(property.name) + " of element " +
               inQuotes(elements.back().name);
    }
    if (elements.back().properties.size() == mostNames) {
        return "more than " + std::to_string(mostNames) + " properties of an element";
    }
    elements.back().properties.push_back(std::move(property));
    return {};
}

}  // namespace

std::size_t sizeOf(PlyType type) {
    static constexpr std::array<std::size_t, 8> sizes = {1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

std::optional<std::size_t> PlyElement::find(std::string_view property) const {
    const auto found = std::ranges::find(properties, property, &PlyProperty::name);
    if (found == properties.end()) return std::nullopt;
    return static_cast<std::size_t>(found - properties.begin());
}

Result<PlyHeader> parsePlyHeader(std::string_view bytes, const std::string& file) {
    Lines lines(bytes);
    std::string_view line;
    if (!lines.next(line) || takeWord(line) != "ply" || !takeWord(line).empty()) {
        return badFile(file, "not a PLY file: its first line is not 'ply'");
    }
    PlyHeader header;
    bool hasFormat = false;
    while (lines.next(line)) {
        const std::string_view keyword = takeWord(line);
        std::string fault;
        if (keyword == "end_header") {
            if (!hasFormat) return badFile(file, "the header names no format", lines.number());
            header.body = lines.rest();
            header.lines = lines.number();
            return header;
        }
        if (keyword == "format") {
            hasFormat = true;
            fault = readFormat(line, header.format);
        } else if (keyword == "element") {
            fault = readElement(line, header.elements);
        } else if (keyword == "property") {
            fault = readProperty(line, header.elements);
        } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
            fault = "unknown keyword " + inQuotes(keyword) + " in the header";
        }
        if (!fault.empty()) return badFile(file, std::move(fault), lines.number());
    }
    return badFile(file, "cut short: the header has no 'end_header'", lines.number());
}

}  // namespace kushi
