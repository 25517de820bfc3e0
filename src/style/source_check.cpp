// SPDX-License-Identifier: Apache-2.0
#include "style/source_check.h"

#include "style/lexical_check.h"
namespace kushi {

namespace {

unsigned byteAt(std::string_view text, std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
}

bool within(unsigned byte, unsigned low, unsigned high) {
    return byte >= low && byte <= high;
}

// Length of the well-formed character at `i`, or 0 (The Unicode Standard 15, table 3-7).
std::size_t characterLength(std::string_view text, std::size_t i) {
    const unsigned first = byteAt(text, i);
    if (first < 0x80) return 1;
    const auto continues = [&](std::size_t k) { return within(byteAt(text, i + k), 0x80, 0xBF); };
    const unsigned second = byteAt(text, i + 1);
    if (within(first, 0xC2, 0xDF)) return continues(1) ? 2 : 0;
    if (within(first, 0xE0, 0xEF)) {
        const unsigned low = first == 0xE0 ? 0xA0 : 0x80;
        const unsigned high = first == 0xED ? 0x9F : 0xBF;
        return within(second, low, high) && continues(2) ? 3 : 0;
    }
    if (within(first, 0xF0, 0xF4)) {
        const unsigned low = first == 0xF0 ? 0x90 : 0x80;
        const unsigned high = first == 0xF4 ? 0x8F : 0xBF;
        return within(second, low, high) && continues(2) && continues(3) ? 4 : 0;
    }
    return 0;
}

std::string hexadecimal(unsigned byte) {
    constexpr std::string_view digits = "0123456789abcdef";
    return {'0', 'x', digits[byte >> 4U], digits[byte & 15U]};
}

std::optional<SourceFault> findBadCharacter(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        if (text[i] == '\0') return SourceFault{i, "found a zero byte, expected a text file"};
        const std::size_t size = characterLength(text, i);
        if (size == 0) {
            return SourceFault{i, "found the byte " + hexadecimal(byteAt(text, i)) +
                                      ", expected text in UTF-8; save the file as UTF-8"};
        }
        i += size;
    }
    return std::nullopt;
}

}  // namespace

std::optional<SourceFault> findSourceFault(std::string_view text) {
    if (text.size() > longestStyle) {
        return SourceFault{{},
                           "the style is longer than " + std::to_string(longestStyle >> 20U) +
                               " MiB, the most that is read"};
    }
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
        return SourceFault{{}, "found text in UTF-16, expected UTF-8; save the file as UTF-8"};
    }
    if (auto fault = findBadCharacter(text)) return fault;
    return findLexicalFault(text);
}

}  // namespace kushi
