// SPDX-License-Identifier: Apache-2.0
#include "style/document.h"

#include "style/syntax_fault.h"

#include <algorithm>

// The parser asserts, or worse assumes, that an array holds no stray bracket and the like before it
// reports just that. Without NDEBUG it assumes nothing, and here it asserts nothing either.
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(condition) static_assert(true)
#define TOML_HEADER_ONLY 1
#define TOML_EXCEPTIONS 0
#define TOML_ENABLE_FORMATTERS 0
#define TOML_MAX_NESTED_VALUES 32  // a style needs four
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

namespace kushi {

namespace {

Position positionOf(const toml::source_position& from) {
    return {static_cast<int>(from.line), static_cast<int>(from.column)};
}

bool isHeaderTable(const toml::node& node) {
    if (const toml::table* table = node.as_table()) return !table->is_inline();
    return node.is_array_of_tables() && !node.as_array()->get(0)->as_table()->is_inline();
}

class Converter {
public:
    Converter(std::string_view text, const LineMap& lines) : text_(text), lines_(lines) {}

    Node convert(const toml::node& from) const {
        Node node;
        node.begin = lines_.offset(positionOf(from.source().begin));
        node.end = lines_.offset(positionOf(from.source().end));
        if (const toml::table* table = from.as_table()) {
            node.kind = Kind::Table;
            node.form = formOf(*table, node.begin);
            node.entries = entriesOf(*table);
        } else if (const toml::array* array = from.as_array()) {
            node.kind = Kind::Array;
            node.form = isHeaderTable(from) ? Form::Header : Form::Value;
            for (const toml::node& item : *array)
                node.items.push_back(convert(item));
        } else {
            setScalar(node, from);
        }
        return node;
    }

private:
    static void setScalar(Node& node, const toml::node& from) {
        if (const auto* boolean = from.as_boolean()) {
            node.kind = Kind::Boolean;
            node.scalar = boolean->get();
        } else if (const auto* integer = from.as_integer()) {
            node.kind = Kind::Integer;
            node.scalar = integer->get();
        } else if (const auto* number = from.as_floating_point()) {
            node.kind = Kind::Float;
            node.scalar = number->get();
        } else if (const auto* string = from.as_string()) {
            node.kind = Kind::String;
            node.scalar = string->get();
        } else {
            node.kind = Kind::Date;
        }
    }

    // The parser gives a table that has no header of its own the place of what first named it: the
    // header of a table inside, or a key.
    Form formOf(const toml::table& table, std::size_t begin) const {
        if (table.is_inline()) return Form::Value;
        if (begin >= text_.size() || text_[begin] != '[') return Form::Dotted;
        for (auto&& [key, child] : table) {
            if (isHeaderTable(child) && child.source().begin == table.source().begin) {
                return Form::Implicit;
            }
        }
        return Form::Header;
    }

    std::vector<Entry> entriesOf(const toml::table& table) const {
        std::vector<Entry> entries;
        for (auto&& [key, child] : table) {
            entries.push_back({std::string(key.str()),
                               lines_.offset(positionOf(key.source().begin)), convert(child)});
        }
        std::ranges::sort(entries, {}, &Entry::at);
        return entries;
    }

    std::string_view text_;
    const LineMap& lines_;
};

Problem problemOf(SourceFault fault, const LineMap& lines, const std::string& file) {
    if (!fault.offset) return {std::move(fault.message), file};
    const Position position = lines.position(*fault.offset);
    return {std::move(fault.message), file, position.line, position.column};
}

}  // namespace

double Node::number() const {
    return kind == Kind::Integer ? static_cast<double>(integer()) : *std::get_if<double>(&scalar);
}

const Entry* Node::find(std::string_view key) const {
    const auto found = std::ranges::find(entries, key, &Entry::key);
    return found == entries.end() ? nullptr : &*found;
}

Result<Document> parseDocument(std::string_view text, const std::string& file) {
    Document document = {text, LineMap(text), {}};
    if (auto fault = findSourceFault(text)) return problemOf(*fault, document.lines, file);

    const toml::parse_result parsed = toml::parse(text);
    if (!parsed) {
        const toml::parse_error& error = parsed.error();
        const std::size_t offset = document.lines.offset(positionOf(error.source().begin));
        return problemOf(syntaxFault(error.description(), text, offset), document.lines, file);
    }
    document.root = Converter(text, document.lines).convert(parsed.table());
    document.root.form = Form::Header;
    return document;
}

}  // namespace kushi
