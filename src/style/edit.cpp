// SPDX-License-Identifier: Apache-2.0
#include "style/document.h"
#include "style/key_path.h"
#include "style/read_parts.h"
#include "style/spelling.h"

#include <kushi/style.h>

#include <algorithm>

namespace kushi {

namespace {

/// `size` bytes at `offset` become `text`.
struct Replacement {
    std::size_t offset = 0;
    std::size_t size = 0;
    std::string text;
};

/// A table on the way to a value, and the key it has in the one before.
struct Stage {
    const Node* node = nullptr;
    std::string key;
};

const Node* follow(const Node& node, const Step& step) {
    if (const auto* index = std::get_if<std::size_t>(&step)) {
        const bool has = node.kind == Kind::Array && *index < node.items.size();
        return has ? &node.items[*index] : nullptr;
    }
    const Entry* entry = node.find(*std::get_if<std::string>(&step));
    return entry != nullptr ? &entry->value : nullptr;
}

// "part[0].hair.length" in a style that has [hair] at the top.
void dropPart(std::vector<Step>& path, const Node& root) {
    if (!keepsPartAtTop(root) || path.size() < 3) return;
    if (path[0] != Step("part") || path[1] != Step(std::size_t{0})) return;
    const auto* key = std::get_if<std::string>(&path[2]);
    if (key == nullptr || std::ranges::find(keysOfPart, *key) == keysOfPart.end()) return;
    path.erase(path.begin(), path.begin() + 2);
}

// Past the last value written in the table itself, not under a header inside; 0 if there is none.
std::size_t bodyEnd(const Node& table) {
    std::size_t end = 0;
    for (const Entry& entry : table.entries) {
        if (entry.value.form == Form::Value) end = std::max(end, entry.value.end);
        if (entry.value.form == Form::Dotted) end = std::max(end, bodyEnd(entry.value));
    }
    return end;
}

/// Writes new keys in the manner of the text around.
class Inserter {
public:
    explicit Inserter(const Document& document) : text_(document.text) {}

    /// `stages` leads from the document to the table that gets the key.
    Replacement insert(const std::vector<Stage>& stages, std::string assignment) const {
        const Node& table = *stages.back().node;
        if (table.form == Form::Implicit) return insertHeader(stages, assignment);

        // Of a dotted table: beside its other keys, with the same dots.
        std::size_t i = stages.size() - 1;
        for (; stages[i].node->form == Form::Dotted; --i) {
            assignment.insert(0, stages[i].key + '.');
        }
        const Node& around = *stages[i].node;
        const std::size_t end = bodyEnd(table);
        if (around.form == Form::Value) return insertInline(around, end, assignment);
        return i == 0 && end == 0 ? insertFirst(assignment) : insertLine(around, end, assignment);
    }

private:
    static Replacement insertInline(const Node& table, std::size_t end, const std::string& key) {
        if (end > 0) return {end, 0, ", " + key};
        return {table.begin + 1, table.end - table.begin - 2, ' ' + key + ' '};
    }

    // On a line of its own below `end`, or below the header.
    Replacement insertLine(const Node& table, std::size_t end, const std::string& line) const {
        const std::size_t place = end > 0 ? end : table.begin;
        const std::size_t lineEnd = text_.find('\n', place);
        const std::string indented = indentAt(end > 0 ? keyBefore(table, end) : place) + line;
        if (lineEnd == std::string_view::npos) return {text_.size(), 0, newline() + indented};
        return {lineEnd + 1, 0, indented + newline()};
    }

    // The document has no key of its own yet.
    Replacement insertFirst(const std::string& line) const {
        return {text_.starts_with("\xEF\xBB\xBF") ? std::size_t{3} : 0, 0, line + newline()};
    }

    // A table named only by the headers of those inside gets its own before the first of them.
    Replacement insertHeader(const std::vector<Stage>& stages, const std::string& line) const {
        std::string name;
        for (const Stage& stage : stages) {
            if (!stage.key.empty()) name += (name.empty() ? "" : ".") + stage.key;
        }
        const std::string header = '[' + name + ']' + newline() + line + newline() + newline();
        return {stages.back().node->begin, 0, header};
    }

    // Where the entry of `table` begins that ends at `end`.
    static std::size_t keyBefore(const Node& table, std::size_t end) {
        std::size_t key = table.begin;
        for (const Entry& entry : table.entries) {
            if (entry.at < end) key = std::max(key, entry.at);
        }
        return key;
    }

    std::string indentAt(std::size_t offset) const {
        const std::size_t lineStart = text_.substr(0, offset).rfind('\n') + 1;
        const std::size_t first = text_.find_first_not_of(" \t", lineStart);
        return std::string(text_.substr(lineStart, first - lineStart));
    }

    std::string newline() const {
        const std::size_t end = text_.find('\n');
        return end != std::string_view::npos && end > 0 && text_[end - 1] == '\r' ? "\r\n" : "\n";
    }

    std::string_view text_;
};

Result<Replacement> findReplacement(const Document& document, const std::vector<Step>& path,
                                    const std::string& value) {
    std::vector<Stage> stages = {{&document.root, ""}};
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const Node* next = follow(*stages.back().node, path[i]);
        if (next == nullptr) {
            const std::vector<Step> missing(path.begin(), path.begin() + static_cast<long>(i) + 1);
            return Problem{"the style has no " + toString(missing), {}};
        }
        const auto* key = std::get_if<std::string>(&path[i]);
        stages.push_back({next, key != nullptr ? *key : ""});
    }
    const Node& table = *stages.back().node;
    if (const Node* old = follow(table, path.back())) {
        if (old->form == Form::Value) return Replacement{old->begin, old->end - old->begin, value};
        return Problem{toString(path) + " is a table, expected the key of a value", {}};
    }
    const auto* key = std::get_if<std::string>(&path.back());
    if (key == nullptr || table.kind != Kind::Table) {
        return Problem{"the style has no " + toString(path), {}};
    }
    return Inserter(document).insert(stages, *key + " = " + value);
}

}  // namespace

Result<std::string> withValue(std::string_view text, std::string_view key,
                              const StyleValue& value) {
    const Result<Document> document = parseDocument(text, {});
    if (!document) return document.problems();
    auto path = parseKeyPath(key);
    if (!path) {
        return Problem{
            "found the key " + std::string(key) + ", expected one such as part[0].hair.length", {}};
    }
    dropPart(*path, document->root);

    const Result<Replacement> replacement = findReplacement(*document, *path, spell(value));
    if (!replacement) return replacement.problems();
    std::string changed(text);
    changed.replace(replacement->offset, replacement->size, replacement->text);
    const Result<Style> style = parseStyle(changed, {});
    if (!style) return style.problems();
    return changed;
}

}  // namespace kushi
