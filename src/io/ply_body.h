// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/ply_header.h"
#include "io/text.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kushi {

/// Takes the rows of a PLY file one by one, whatever its format.
class PlyBody {
public:
    explicit PlyBody(const PlyHeader& header);

    /// Whether `element.count` rows can be left in the file; before anything is allocated for them.
    bool canHold(const PlyElement& element) const;
    /// Reads a row, one value per property; of a list its length. What is wrong, or nothing.
    /// Puts what the row's lists hold into `items`, one list after the other, if asked for.
    std::string readRow(const PlyElement& element, std::span<double> values,
                        std::vector<double>* items = nullptr);
    /// Whether nothing is left but, in text, blanks.
    bool atEnd() const;
    /// Line of the row read last; 0 in a binary file.
    int line() const { return format_ == PlyFormat::Ascii ? lines_.number() : 0; }

private:
    std::string readTextRow(const PlyElement& element, std::span<double> values,
                            std::vector<double>* items);
    std::string readBinaryRow(const PlyElement& element, std::span<double> values,
                              std::vector<double>* items);

    PlyFormat format_;
    Lines lines_;            // ascii
    std::string_view rest_;  // binary
};

}  // namespace kushi
