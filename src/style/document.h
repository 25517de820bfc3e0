// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "style/line_map.h"

#include <kushi/result.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace kushi {

// A TOML document that knows where everything stands in its text, so that problems can point and
// edits can leave the rest alone. No other file knows which parser is behind it.

enum class Kind { Boolean, Integer, Float, String, Date, Array, Table };

/// How an array or table came to be.
enum class Form {
    Value,     ///< written after '=' or inside brackets, as all scalars are
    Header,    ///< [table] or [[table]]; also the document itself
    Implicit,  ///< named only on the way to a deeper header, as `a` in [a.b]
    Dotted,    ///< named only in dotted keys, as `a` in a.b = 1
};

struct Entry;

struct Node {
    Kind kind = Kind::Table;
    Form form = Form::Value;
    std::size_t begin = 0;  ///< where it stands: offset of the value, header or first dotted key
    std::size_t end = 0;    ///< past the last byte; only for Form::Value

    std::variant<std::monostate, bool, std::int64_t, double, std::string> scalar;
    std::vector<Node> items;     ///< of an array
    std::vector<Entry> entries;  ///< of a table, in the order of the text

    bool isNumber() const { return kind == Kind::Integer || kind == Kind::Float; }
    /// An integer or float; only if isNumber().
    double number() const;
    /// Only of kind String.
    const std::string& string() const { return *std::get_if<std::string>(&scalar); }
    /// Only of kind Integer.
    std::int64_t integer() const { return *std::get_if<std::int64_t>(&scalar); }
    /// The entry of a table; null if there is none.
    const Entry* find(std::string_view key) const;
};

struct Entry {
    std::string key;
    std::size_t at = 0;  ///< offset of the key where it is first written
    Node value;
};

struct Document {
    std::string_view text;
    LineMap lines;
    Node root;
};

/// Parses TOML 1.0. `text` must outlive the document; `file` stands in the problem.
///
/// Syntax errors end the parse, so there is one problem at most.
Result<Document> parseDocument(std::string_view text, const std::string& file);

}  // namespace kushi
