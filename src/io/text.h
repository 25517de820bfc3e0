// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/result.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace kushi {

/// A problem with what `file` holds; line 0 where there are no lines.
inline Problem badFile(const std::string& file, std::string message, int line = 0) {
    return {std::move(message), file, line, 0, false};
}

/// A word of a file as a message shows it: short, without control characters.
std::string printable(std::string_view word);
inline std::string inQuotes(std::string_view word) {
    return '\'' + printable(word) + '\'';
}

/// Takes the lines of a text one by one.
class Lines {
public:
    /// `number` is that of the line before the first.
    explicit Lines(std::string_view text, int number = 0) : rest_(text), number_(number) {}

    /// Puts the next line, without its end, into `line`; false if there is none.
    bool next(std::string_view& line);
    /// Number of the line taken last, from 1.
    int number() const { return number_; }
    /// What follows the line taken last.
    std::string_view rest() const { return rest_; }

private:
    std::string_view rest_;
    int number_;
};

inline bool isBlank(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

inline bool isAllBlank(std::string_view text) {
    return std::ranges::all_of(text, isBlank);
}

/// Cuts the next word off `line`; empty if there is none. `blank` counts as a blank, too.
inline std::string_view takeWord(std::string_view& line, char blank = ' ') {
    const auto separates = [blank](char c) { return isBlank(c) || c == blank; };
    const auto* const begin = std::find_if_not(line.begin(), line.end(), separates);
    const auto* const end = std::find_if(begin, line.end(), separates);
    line = {end, line.end()};
    return {begin, end};
}

/// The number that a whole word spells; one too large for a double is infinite.
std::optional<double> parseNumber(std::string_view word);

/// The whole number that a whole word spells.
template <class Integer>
std::optional<Integer> parseInteger(std::string_view word) {
    Integer value{};
    const auto [end, error] = std::from_chars(word.begin(), word.end(), value);
    if (error != std::errc{} || end != word.end()) return std::nullopt;
    return value;
}

}  // namespace kushi
