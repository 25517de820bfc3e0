// SPDX-License-Identifier: Apache-2.0
#include "io/text.h"

#include <limits>

namespace kushi {

std::string printable(std::string_view word) {
    constexpr std::size_t longest = 24;
    std::string text;
    for (const char c : word.substr(0, longest)) {
        text += c >= ' ' && c <= '~' ? c : '?';
    }
    if (word.size() > longest) text += "...";
    return text;
}

bool Lines::next(std::string_view& line) {
    if (rest_.empty()) return false;
    const std::size_t end = rest_.find('\n');
    line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++number_;
    return true;
}

std::optional<double> parseNumber(std::string_view word) {
    if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(word.begin(), word.end(), value);
    if (error == std::errc::invalid_argument || end != word.end()) return std::nullopt;
    if (error == std::errc::result_out_of_range) {
        const bool tiny =
            word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos;
        return tiny ? 0 : std::numeric_limits<double>::infinity();
    }
    return value;
}

}  // namespace kushi
