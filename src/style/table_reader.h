// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "style/diagnostics.h"
#include "style/document.h"
#include "style/heights.h"
#include "style/keys.h"
#include "style/quantity.h"

#include <kushi/vec.h>

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kushi {

/// Where one reads a style: the document's problems, and how its tables are called.
struct ReadContext {
    Diagnostics& problems;
    bool partAtTop = false;  ///< [hair] stands for [part.hair]
    std::string folder;      ///< where relative paths start
    Heights heights;         ///< of the head's landmarks
    bool walks = true;       ///< the method is the cantilever's
    bool headless = false;   ///< there is no head

    std::string label(const TableKeys& table) const;
};

/// Reads one table of the document, reporting what is wrong with it, in the words of its keys.
///
/// The functions that take a reference leave it as it is where the key is missing or wrong: the
/// default is what stands there before.
class TableReader {
public:
    /// Reports the keys of `table` that `known` does not have.
    TableReader(const Node& table, const TableKeys& known, ReadContext& context);

    const Node& node() const { return node_; }
    /// As problems name it.
    std::string label() const { return context_.label(known_); }
    ReadContext& context() const { return context_; }

    /// The value of a key; null if it is missing.
    const Node* find(std::string_view key) const;
    /// Whether a key is there, or one that was meant to be it.
    bool has(std::string_view key) const;
    /// Reports the key if it is missing.
    void require(std::string_view key, const std::string& expected) const;

    /// Reports if not exactly one of two keys is there.
    void requireOne(std::string_view first, std::string_view second,
                    const std::string& example) const;

    void number(std::string_view key, const Quantity& quantity, double& out) const;
    void number(std::string_view key, const Quantity& quantity, std::optional<double>& out) const;
    void vector(std::string_view key, const Quantity& quantity, Vec3d& out) const;
    void text(std::string_view key, std::string& out) const;
    void boolean(std::string_view key, bool& out) const;
    std::optional<std::int64_t> whole(std::string_view key, std::int64_t low,
                                      std::int64_t high) const;

    /// Which of a few strings the value is; those of `later` are known to later versions only.
    std::optional<std::size_t> chosenName(std::string_view key,
                                          std::span<const std::string_view> names,
                                          std::span<const std::string_view> later = {}) const;
    /// What one of a few strings stands for; those of `later` are known to later versions only.
    template <class T>
    void choice(std::string_view key, std::initializer_list<std::pair<std::string_view, T>> choices,
                T& out, std::initializer_list<std::string_view> later = {}) const {
        std::vector<std::string_view> names;
        for (const auto& [name, value] : choices)
            names.push_back(name);
        if (const auto chosen = chosenName(key, names, later))
            out = (choices.begin() + *chosen)->second;
    }

    /// A table; null if it is missing or no table.
    const Node* table(std::string_view key, const TableKeys& kind) const;
    /// Tables, in order; none if they are missing or no array of tables.
    std::vector<const Node*> tables(std::string_view key, const TableKeys& kind) const;

private:
    void reportUnknown(const Entry& entry);

    const Node& node_;
    const TableKeys& known_;
    ReadContext& context_;
    std::vector<std::string_view> misspelt_;  // the known keys that unknown ones resemble
};

}  // namespace kushi
