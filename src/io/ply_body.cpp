// SPDX-License-Identifier: Apache-2.0
#include "io/ply_body.h"

#include "io/bytes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace kushi {
namespace {

constexpr const char* cutShort = "the file ends before the end of the row";

template <class T>
double loadAs(const char* bytes, bool bigEndian) {
    std::array<char, sizeof(T)> ordered{};
    std::copy_n(bytes, sizeof(T), ordered.begin());
    if (bigEndian) std::ranges::reverse(ordered);
    return static_cast<double>(load<T>(ordered.data()));
}

double loadNumber(PlyType type, const char* bytes, bool bigEndian) {
    switch (type) {
        case PlyType::Int8:
            return loadAs<std::int8_t>(bytes, bigEndian);
        case PlyType::UInt8:
            return loadAs<std::uint8_t>(bytes, bigEndian);
        case PlyType::Int16:
            return loadAs<std::int16_t>(bytes, bigEndian);
        case PlyType::UInt16:
            return loadAs<std::uint16_t>(bytes, bigEndian);
        case PlyType::Int32:
            return loadAs<std::int32_t>(bytes, bigEndian);
        case PlyType::UInt32:
            return loadAs<std::uint32_t>(bytes, bigEndian);
        case PlyType::Float32:
            return loadAs<float>(bytes, bigEndian);
        case PlyType::Float64:
            break;
    }
    return loadAs<double>(bytes, bigEndian);
}

template <class T>
bool isWithin(double value) {
    return value >= std::numeric_limits<T>::min() && value <= std::numeric_limits<T>::max() &&
           value == std::floor(value);
}

/// Whether a number written in text is one of the type that the header promises.
bool isOf(PlyType type, double value) {
    switch (type) {
        case PlyType::Int8:
            return isWithin<std::int8_t>(value);
        case PlyType::UInt8:
            return isWithin<std::uint8_t>(value);
        case PlyType::Int16:
            return isWithin<std::int16_t>(value);
        case PlyType::UInt16:
            return isWithin<std::uint16_t>(value);
        case PlyType::Int32:
            return isWithin<std::int32_t>(value);
        case PlyType::UInt32:
            return isWithin<std::uint32_t>(value);
        default:
            return true;
    }
}

PlyType firstType(const PlyProperty& property) {
    return property.listCount.value_or(property.type);
}

/// Takes the next number of a text row; what is wrong with it, or nothing.
std::string takeNumber(std::string_view& line, const PlyProperty& property, PlyType type,
                       double& value) {
    const std::string_view word = takeWord(line);
    if (word.empty()) return "the row ends before its property " + inQuotes(property.name);
    const auto number = parseNumber(word);
    if (!number || !isOf(type, *number)) {
        return "found " + inQuotes(word) + " where property " + inQuotes(property.name) +
               " needs a " + (type < PlyType::Float32 ? "whole number of its type" : "number");
    }
    value = *number;
    return {};
}

}  // namespace

PlyBody::PlyBody(const PlyHeader& header)
    : format_(header.format), lines_(header.body, header.lines), rest_(header.body) {}

bool PlyBody::canHold(const PlyElement& element) const {
    const bool ascii = format_ == PlyFormat::Ascii;
    std::uint64_t least = 0;
    for (const PlyProperty& property : element.properties) {
        least += ascii ? 2 : sizeOf(firstType(property));  // a digit and what follows it
    }
    // The last line may lack its end.
    const std::uint64_t left = ascii ? lines_.rest().size() + 1 : rest_.size();
    return least == 0 || element.count <= left / least;
}

std::string PlyBody::readRow(const PlyElement& element, std::span<double> values,
                             std::vector<double>* items) {
    if (items != nullptr) items->clear();
    if (element.properties.empty()) return {};
    return format_ == PlyFormat::Ascii ? readTextRow(element, values, items)
                                       : readBinaryRow(element, values, items);
}

bool PlyBody::atEnd() const {
    if (format_ != PlyFormat::Ascii) return rest_.empty();
    return isAllBlank(lines_.rest());
}

std::string PlyBody::readTextRow(const PlyElement& element, std::span<double> values,
                                 std::vector<double>* items) {
    std::string_view line;
    do {
        if (!lines_.next(line)) return cutShort;
    } while (isAllBlank(line));

    for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const PlyProperty& property = element.properties[i];
        std::string fault = takeNumber(line, property, firstType(property), values[i]);
        double item = 0;
        for (double k = 0; property.listCount && k < values[i] && fault.empty(); ++k) {
            fault = takeNumber(line, property, property.type, item);
            if (items != nullptr && fault.empty()) items->push_back(item);
        }
        if (!fault.empty()) return fault;
    }
    if (const std::string_view extra = takeWord(line); !extra.empty()) {
        return "found " + inQuotes(extra) + " after the last property of the row";
    }
    return {};
}

std::string PlyBody::readBinaryRow(const PlyElement& element, std::span<double> values,
                                   std::vector<double>* items) {
    const bool bigEndian = format_ == PlyFormat::BigEndian;
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const PlyProperty& property = element.properties[i];
        const PlyType type = firstType(property);
        if (rest_.size() < sizeOf(type)) return cutShort;
        values[i] = loadNumber(type, rest_.data(), bigEndian);
        rest_.remove_prefix(sizeOf(type));
        if (!property.listCount) continue;
        const std::size_t itemSize = sizeOf(property.type);
        const double size = std::max(values[i], 0.0) * static_cast<double>(itemSize);
        if (size > static_cast<double>(rest_.size())) return cutShort;
        const std::string_view list = rest_.substr(0, static_cast<std::size_t>(size));
        for (std::size_t at = 0; items != nullptr && at < list.size(); at += itemSize) {
            items->push_back(loadNumber(property.type, list.data() + at, bigEndian));
        }
        rest_.remove_prefix(list.size());
    }
    return {};
}

}  // namespace kushi
