// SPDX-License-Identifier: Apache-2.0
#include "style/key_path.h"

#include <algorithm>
#include <charconv>

namespace kushi {

namespace {

bool isBareKeyCharacter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
}

// Takes "[12]" off the front.
std::optional<std::size_t> takeIndex(std::string_view& text) {
    const std::size_t close = text.find(']');
    if (close == std::string_view::npos) return std::nullopt;
    std::size_t index = 0;
    const char* const end = text.data() + close;
    const auto parsed = std::from_chars(text.data() + 1, end, index);
    if (parsed.ec != std::errc{} || parsed.ptr != end) return std::nullopt;
    text.remove_prefix(close + 1);
    return index;
}

// Takes a name and the indices behind it off the front.
bool takeName(std::string_view& text, std::vector<Step>& path) {
    const auto nameEnd = std::ranges::find_if_not(text, isBareKeyCharacter);
    const auto size = static_cast<std::size_t>(nameEnd - text.begin());
    if (size == 0) return false;
    path.emplace_back(std::string(text.substr(0, size)));
    text.remove_prefix(size);
    while (text.starts_with('[')) {
        const auto index = takeIndex(text);
        if (!index) return false;
        path.emplace_back(*index);
    }
    return true;
}

}  // namespace

std::optional<std::vector<Step>> parseKeyPath(std::string_view path) {
    std::vector<Step> steps;
    if (!takeName(path, steps)) return std::nullopt;
    while (!path.empty()) {
        if (path.front() != '.') return std::nullopt;
        path.remove_prefix(1);
        if (!takeName(path, steps)) return std::nullopt;
    }
    return steps;
}

std::string toString(const std::vector<Step>& path) {
    std::string text;
    for (const Step& step : path) {
        if (const auto* index = std::get_if<std::size_t>(&step)) {
            text += '[' + std::to_string(*index) + ']';
        } else {
            text += (text.empty() ? "" : ".") + *std::get_if<std::string>(&step);
        }
    }
    return text;
}

}  // namespace kushi
