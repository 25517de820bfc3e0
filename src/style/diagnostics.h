// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "style/document.h"

#include <kushi/style.h>

#include <string>
#include <string_view>
#include <vector>

namespace kushi {

/// Collects what is wrong with a document.
class Diagnostics {
public:
    /// No more problems than this are listed: a file that has more is not a style with slips.
    static constexpr std::size_t most = 1000;

    Diagnostics(const Document& document, std::string file)
        : document_(document), file_(std::move(file)) {}

    /// A problem at a byte offset.
    void add(std::size_t offset, std::string message);
    /// "NAME: found VALUE, expected EXPECTED", and "; HINT" if there is one.
    void unexpected(std::string_view name, const Node& value, const std::string& expected,
                    const std::string& hint = {});

    /// Where a byte offset is, for problems that show up after reading.
    TextPlace place(std::size_t offset) const;

    /// How a value is written in the file, cut short if long.
    std::string source(const Node& value) const;

    bool empty() const { return problems_.empty(); }
    /// In the order of the text.
    std::vector<Problem> take();

private:
    std::string describe(const Node& value) const;

    const Document& document_;
    std::string file_;
    std::vector<Problem> problems_;
    std::size_t unlisted_ = 0;
};

/// A piece of the file fit for one line: cut short, without control characters.
std::string excerpt(std::string_view text);

}  // namespace kushi
