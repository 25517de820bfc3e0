// SPDX-License-Identifier: Apache-2.0
#include "style/diagnostics.h"

#include <algorithm>
#include <tuple>

namespace kushi {

void Diagnostics::add(std::size_t offset, std::string message) {
    if (problems_.size() == most) {
        ++unlisted_;
        return;
    }
    const Position position = document_.lines.position(offset);
    problems_.push_back({std::move(message), file_, position.line, position.column});
}

void Diagnostics::unexpected(std::string_view name, const Node& value, const std::string& expected,
                             const std::string& hint) {
    std::string message =
        std::string(name) + ": found " + describe(value) + ", expected " + expected;
    if (!hint.empty()) message += "; " + hint;
    add(value.begin, std::move(message));
}

std::vector<Problem> Diagnostics::take() {
    std::ranges::stable_sort(problems_, {},
                             [](const Problem& p) { return std::tuple(p.line, p.column); });
    if (unlisted_ > 0) {
        problems_.push_back({"and " + std::to_string(unlisted_) + " more problems", file_});
    }
    return std::move(problems_);
}

TextPlace Diagnostics::place(std::size_t offset) const {
    const Position position = document_.lines.position(offset);
    return {file_, position.line, position.column};
}

std::string Diagnostics::source(const Node& value) const {
    return excerpt(document_.text.substr(value.begin, value.end - value.begin));
}

std::string Diagnostics::describe(const Node& value) const {
    switch (value.kind) {
        case Kind::String:
            return "the string " + source(value);
        case Kind::Date:
            return "the date " + source(value);
        case Kind::Array:
            if (value.items.empty()) return "an empty array";
            return "an array of " + std::to_string(value.items.size());
        case Kind::Table:
            return "a table";
        default:
            return source(value);
    }
}

std::string excerpt(std::string_view text) {
    constexpr std::size_t longest = 40;
    const bool cut = text.size() > longest;
    if (cut) {
        // Not within a character.
        std::size_t end = longest;
        while ((static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)
            --end;
        text = text.substr(0, end);
    }
    std::string shown(text);
    std::ranges::replace_if(
        shown, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, ' ');
    return cut ? shown + "..." : shown;
}

}  // namespace kushi
