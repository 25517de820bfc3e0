// SPDX-License-Identifier: Apache-2.0
#include "style/syntax_fault.h"

#include <algorithm>

namespace kushi {

namespace {

bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool isWordCharacter(char c) {
    return isLetter(c) || (c >= '0' && c <= '9') || c == '-' || c == '_';
}

std::size_t skipBlanksBack(std::string_view text, std::size_t offset) {
    while (offset > 0 && (text[offset - 1] == ' ' || text[offset - 1] == '\t'))
        --offset;
    return offset;
}

/// A piece of the text.
struct Token {
    std::size_t begin = 0;
    std::string_view text;
};

// The bare word that `offset` lies in or just behind; empty if it is not meant as a string.
Token unquotedValue(std::string_view text, std::size_t offset) {
    std::size_t begin = offset;
    while (begin > 0 && isWordCharacter(text[begin - 1]))
        --begin;
    std::size_t end = begin;
    while (end < text.size() && isWordCharacter(text[end]))
        ++end;
    if (begin == end || !isLetter(text[begin])) return {};

    const std::size_t before = skipBlanksBack(text, begin);
    if (before == 0 || text[before - 1] != '=') return {};
    const std::string_view word = text.substr(begin, end - begin);
    if (word == "true" || word == "false" || word == "inf" || word == "nan") return {};
    return {begin, word};
}

// The bare or dotted key whose value begins at `offset`; empty if it has quotes or blanks.
Token keyOf(std::string_view text, std::size_t offset) {
    std::size_t end = skipBlanksBack(text, offset);
    if (end == 0 || text[end - 1] != '=') return {};
    end = skipBlanksBack(text, end - 1);
    std::size_t begin = end;
    while (begin > 0 && (isWordCharacter(text[begin - 1]) || text[begin - 1] == '.'))
        --begin;
    const char before = begin > 0 ? text[begin - 1] : '\n';
    if (std::string_view("\n\t ,{").find(before) == std::string_view::npos) return {};
    return {begin, text.substr(begin, end - begin)};
}

// "cannot redefine existing integer 'length'": the parser says what it would have to redefine.
bool isRepetition(std::string_view reason) {
    return reason.starts_with("cannot redefine existing ") && reason.ends_with('\'');
}

SourceFault repetition(std::string_view reason, std::string_view text, std::size_t offset) {
    if (text.substr(offset, 1) == "[") {
        const std::size_t quote = reason.find('\'');
        const std::string_view name = reason.substr(quote + 1, reason.size() - quote - 2);
        const bool plain =
            std::ranges::all_of(name, [](char c) { return isWordCharacter(c) || c == '.'; });
        return {offset,
                plain ? '[' + std::string(name) + "] is given twice" : "this table is given twice"};
    }
    const Token key = keyOf(text, offset);
    if (key.text.empty()) return {offset, "this key is given twice"};
    return {key.begin, '\'' + std::string(key.text) + "' is given twice"};
}

std::string withArticle(std::string_view noun) {
    const bool vowel = std::string_view("aeiou").find(noun.front()) != std::string_view::npos;
    return (vowel ? "an " : "a ") + std::string(noun);
}

}  // namespace

SourceFault syntaxFault(std::string_view description, std::string_view text, std::size_t offset) {
    // "Error while parsing SCOPE: REASON"
    constexpr std::string_view opening = "Error while parsing ";
    std::string_view scope;
    std::string_view reason = description;
    if (const std::size_t colon = reason.find(": ");
        reason.starts_with(opening) && colon != std::string_view::npos && colon > opening.size()) {
        scope = reason.substr(opening.size(), colon - opening.size());
        reason.remove_prefix(colon + 2);
    }
    offset = std::min(offset, text.size());

    if (isRepetition(reason)) return repetition(reason, text, offset);
    if (const Token word = unquotedValue(text, offset); !word.text.empty()) {
        const std::string name(word.text.substr(0, 40));
        return {word.begin,
                "found " + name + " without quotes, expected a value such as \"" + name + '"'};
    }
    const std::string place = scope.empty() ? "the text" : withArticle(scope);
    if (reason == "encountered end-of-file") return {offset, "the file ends within " + place};
    if (reason.starts_with("exceeded maximum nested value depth")) {
        return {offset, "found arrays or tables nested too deeply"};
    }
    return {offset, std::string(reason) + " (in " + place + ')'};
}

}  // namespace kushi
