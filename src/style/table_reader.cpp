// SPDX-License-Identifier: Apache-2.0
#include "style/table_reader.h"

#include "style/read_number.h"
#include "style/spelling.h"

#include <algorithm>

namespace kushi {

namespace {

std::string quoted(std::string_view name) {
    return '\'' + std::string(name) + '\'';
}

bool knows(const TableKeys& table, std::string_view key) {
    return std::ranges::find(table.keys(), key) != table.keys().end();
}

std::string expectedTable(const std::string& label) {
    return label.starts_with('[') ? "the table " + label : "a table";
}

std::string expectedTables(const std::string& label) {
    return label.starts_with('[') ? label + ", one for each" : "an array of tables";
}

// What a table is called in the file when the only part's tables stand at the top.
std::string atTop(std::string_view label) {
    std::string text(label);
    if (const std::size_t found = text.find("part."); found != std::string::npos) {
        text.erase(found, 5);
    }
    return text;
}

}  // namespace

std::string ReadContext::label(const TableKeys& table) const {
    return partAtTop ? atTop(table.label) : std::string(table.label);
}

TableReader::TableReader(const Node& table, const TableKeys& known, ReadContext& context)
    : node_(table), known_(known), context_(context) {
    for (const Entry& entry : table.entries) {
        if (!knows(known, entry.key)) reportUnknown(entry);
    }
}

void TableReader::reportUnknown(const Entry& entry) {
    std::string message =
        "unknown key " + quoted(excerpt(entry.key)) + " in " + context_.label(known_) + "; ";
    const auto home = std::ranges::find_if(
        tables::all, [&](const TableKeys* table) { return knows(*table, entry.key); });
    if (const std::string_view meant = nearest(entry.key, known_.keys()); !meant.empty()) {
        message += "did you mean " + quoted(meant) + '?';
        misspelt_.push_back(meant);
    } else if (home != std::end(tables::all)) {
        message += *home == &tables::top ? "it belongs at the top, before any [table]"
                                         : "it belongs in " + context_.label(**home);
    } else {
        message += "expected " + listed(known_.keys(), '\'');
    }
    context_.problems.add(entry.at, message);
}

const Node* TableReader::find(std::string_view key) const {
    const Entry* entry = node_.find(key);
    return entry != nullptr ? &entry->value : nullptr;
}

bool TableReader::has(std::string_view key) const {
    return find(key) != nullptr || std::ranges::find(misspelt_, key) != misspelt_.end();
}

void TableReader::require(std::string_view key, const std::string& expected) const {
    if (has(key)) return;
    context_.problems.add(
        node_.begin, context_.label(known_) + " has no " + quoted(key) + ", expected " + expected);
}

void TableReader::requireOne(std::string_view first, std::string_view second,
                             const std::string& example) const {
    if (!has(first) && !has(second)) {
        context_.problems.add(node_.begin, context_.label(known_) + " has neither " +
                                               quoted(first) + " nor " + quoted(second) +
                                               ", expected one of them, as in " + example);
    } else if (find(first) != nullptr && find(second) != nullptr) {
        context_.problems.add(
            std::max(node_.find(first)->at, node_.find(second)->at),
            "found both " + quoted(first) + " and " + quoted(second) + ", expected one of them");
    }
}

void TableReader::number(std::string_view key, const Quantity& quantity, double& out) const {
    const Node* value = find(key);
    if (value != nullptr) out = readNumber(*value, key, quantity, context_.problems).value_or(out);
}

void TableReader::number(std::string_view key, const Quantity& quantity,
                         std::optional<double>& out) const {
    const Node* value = find(key);
    if (value != nullptr) out = readNumber(*value, key, quantity, context_.problems);
}

void TableReader::vector(std::string_view key, const Quantity& quantity, Vec3d& out) const {
    const Node* value = find(key);
    if (value != nullptr) out = readVector(*value, key, quantity, context_.problems).value_or(out);
}

void TableReader::text(std::string_view key, std::string& out) const {
    const Node* value = find(key);
    if (value == nullptr) return;
    if (value->kind == Kind::String) {
        out = value->string();
    } else {
        context_.problems.unexpected(key, *value, "a string");
    }
}

void TableReader::boolean(std::string_view key, bool& out) const {
    const Node* value = find(key);
    if (value == nullptr) return;
    if (value->kind == Kind::Boolean) {
        out = *std::get_if<bool>(&value->scalar);
    } else {
        context_.problems.unexpected(key, *value, "true or false");
    }
}

std::optional<std::int64_t> TableReader::whole(std::string_view key, std::int64_t low,
                                               std::int64_t high) const {
    const Node* value = find(key);
    if (value == nullptr) return std::nullopt;
    if (value->kind == Kind::Integer && value->integer() >= low && value->integer() <= high) {
        return value->integer();
    }
    context_.problems.unexpected(
        key, *value, "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
    return std::nullopt;
}

std::optional<std::size_t> TableReader::chosenName(std::string_view key,
                                                   std::span<const std::string_view> names,
                                                   std::span<const std::string_view> later) const {
    const Node* value = find(key);
    if (value == nullptr) return std::nullopt;
    const std::string expected = listed(names, '"');
    if (value->kind != Kind::String) {
        context_.problems.unexpected(key, *value, expected);
        return std::nullopt;
    }
    const std::string& name = value->string();
    const auto found = std::ranges::find(names, name);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    if (std::ranges::find(later, name) != later.end()) {
        context_.problems.add(value->begin, std::string(key) + ": \"" + name +
                                                "\" is not there yet in this version, expected " +
                                                expected);
    } else {
        const std::string_view meant = nearest(name, names);
        context_.problems.unexpected(
            key, *value, expected,
            meant.empty() ? "" : "did you mean \"" + std::string(meant) + "\"?");
    }
    return std::nullopt;
}

const Node* TableReader::table(std::string_view key, const TableKeys& kind) const {
    const Node* value = find(key);
    if (value == nullptr || value->kind == Kind::Table) return value;
    context_.problems.unexpected(key, *value, expectedTable(context_.label(kind)));
    return nullptr;
}

std::vector<const Node*> TableReader::tables(std::string_view key, const TableKeys& kind) const {
    const Node* value = find(key);
    std::vector<const Node*> found;
    if (value == nullptr) return found;
    if (value->kind != Kind::Array) {
        context_.problems.unexpected(key, *value, expectedTables(context_.label(kind)));
        return found;
    }
    for (const Node& item : value->items) {
        if (item.kind == Kind::Table) {
            found.push_back(&item);
        } else {
            context_.problems.unexpected(key, item, "a table");
        }
    }
    return found;
}

}  // namespace kushi
