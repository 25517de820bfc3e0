// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/ply_body.h"

#include <string>
#include <utility>
#include <vector>

namespace kushi {

/// Whether the rest of the file has room for all rows of an element; to be asked before memory is
/// taken for them.
inline Status checkRoom(const PlyBody& body, const PlyElement& element, const std::string& file) {
    if (body.canHold(element)) return std::monostate{};
    return badFile(file, "cut short: the header announces " + std::to_string(element.count) +
                             " rows of element " + inQuotes(element.name) +
                             ", more than the file has room for");
}

/// Calls use(row) for every row of an element, which returns what is wrong with it or nothing.
/// What the lists of the row hold is in `items` meanwhile, one list after the other.
template <class Use>
Status readPlyRows(PlyBody& body, const PlyElement& element, const std::string& file,
                   const Use& use, std::vector<double>* items = nullptr) {
    std::vector<double> row(element.properties.size());
    for (std::uint64_t i = 0; i < element.count && !row.empty(); ++i) {
        std::string fault = body.readRow(element, row, items);
        if (fault.empty()) fault = use(std::as_const(row));
        if (!fault.empty()) {
            return badFile(file,
                           printable(element.name) + ' ' + std::to_string(i) +
                               " (counted from 0) of " + std::to_string(element.count) + ": " +
                               fault,
                           body.line());
        }
    }
    return std::monostate{};
}

}  // namespace kushi
