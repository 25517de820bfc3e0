// SPDX-License-Identifier: Apache-2.0
#include "style/spelling.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace kushi {

namespace {

std::string spellFloat(double value) {
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    std::string text(buffer.data(), end);
    if (text.find('.') != std::string::npos) return text;
    const std::size_t exponent = text.find('e');
    text.insert(exponent == std::string::npos ? text.size() : exponent, ".0");
    return text;
}

std::string escape(char c) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    const auto byte = static_cast<unsigned char>(c);
    switch (c) {
        case '"':
            return "\\\"";
        case '\\':
            return "\\\\";
        case '\n':
            return "\\n";
        case '\t':
            return "\\t";
        default:
            break;
    }
    if (byte >= 0x20 && byte != 0x7F) return {c};
    return std::string("\\u00") + digits[byte >> 4U] + digits[byte & 15U];
}

std::string spellString(std::string_view value) {
    std::string text = "\"";
    for (const char c : value)
        text += escape(c);
    return text + '"';
}

struct Speller {
    std::string operator()(bool value) const { return value ? "true" : "false"; }
    std::string operator()(std::int64_t value) const { return std::to_string(value); }
    std::string operator()(double value) const { return spellFloat(value); }
    std::string operator()(const std::string& value) const { return spellString(value); }
    std::string operator()(const std::vector<double>& values) const {
        std::string text = "[";
        for (std::size_t i = 0; i < values.size(); ++i) {
            text += (i == 0 ? "" : ", ") + spellFloat(values[i]);
        }
        return text + ']';
    }
};

}  // namespace

std::string plainNumber(double value) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                   std::chars_format::general, 6)
                         .ptr;
    return {buffer.data(), end};
}

std::string listed(std::span<const std::string_view> names, char quote) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
        text += quote + std::string(names[i]) + quote;
    }
    return text;
}

std::string spell(const StyleValue& value) {
    return std::visit(Speller{}, value);
}

}  // namespace kushi
