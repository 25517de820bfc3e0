// SPDX-License-Identifier: Apache-2.0
#include "io/base64.h"

#include <charconv>
#include <cstdint>

namespace kushi {

std::optional<std::string> decodeBase64(std::string_view text) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (int padding = 0; padding < 2 && text.ends_with('='); ++padding)
        text.remove_suffix(1);
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3 + 3);
    std::uint32_t bits = 0;
    unsigned count = 0;
    for (const char c : text) {
        const std::size_t digit = digits.find(c);
        if (digit == std::string_view::npos) return std::nullopt;
        bits = (bits << 6U | static_cast<std::uint32_t>(digit)) & 0xFFFFFFU;
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += static_cast<char>(static_cast<unsigned char>(bits >> count));
    }
    return bytes;
}

std::optional<std::string> decodePercent(std::string_view text) {
    std::string path;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            path += text[i];
            continue;
        }
        unsigned value = 0;
        const std::string_view hex = text.substr(i + 1, 2);
        const char* const end = hex.data() + hex.size();
        const auto [last, error] = std::from_chars(hex.data(), end, value, 16);
        if (hex.size() != 2 || error != std::errc{} || last != end || value == 0) {
            return std::nullopt;
        }
        path += static_cast<char>(static_cast<unsigned char>(value));
        i += 2;
    }
    return path;
}

}  // namespace kushi
