// SPDX-License-Identifier: Apache-2.0
#include "io/writable.h"

#include "io/text.h"
#include "io/values.h"

#include <algorithm>

namespace kushi {
namespace {

bool isComplete(std::size_t attribute, std::size_t nodes) {
    return attribute == 0 || attribute == nodes;
}

bool isConsistent(const Strands& strands) {
    const std::size_t nodes = strands.nodes.size();
    return !strands.offsets.empty() && strands.offsets.front() == 0 &&
           strands.offsets.back() == nodes && std::ranges::is_sorted(strands.offsets) &&
           isComplete(strands.diameters.size(), nodes) &&
           isComplete(strands.transparency.size(), nodes) &&
           isComplete(strands.colors.size(), nodes);
}

/// What is wrong with a node, or nullptr.
const char* faultOf(const Strands& strands, std::size_t node) {
    if (!isPosition(toCentimeters(strands.nodes[node]))) return "a position that is not finite";
    if (!strands.diameters.empty() && !isDiameter(toCentimeters(strands.diameters[node]))) {
        return "a diameter that is not finite or below 0";
    }
    if (!strands.transparency.empty() && !isTransparency(strands.transparency[node])) {
        return "a transparency that is not between 0 and 1";
    }
    if (!strands.colors.empty() && !isColor(strands.colors[node])) {
        return "a colour that is not finite";
    }
    return nullptr;
}

}  // namespace

Status checkWritable(const Strands& strands, const std::string& file) {
    if (!isConsistent(strands)) {
        return badFile(file,
                       "the groom to write contradicts itself: its offsets or attributes do "
                       "not fit its nodes");
    }
    for (std::size_t i = 0; i < strands.size(); ++i) {
        const std::string strand = "strand " + std::to_string(i) + " (counted from 0)";
        if (strands.offsets[i] == strands.offsets[i + 1]) {
            return badFile(file, strand + " of the groom to write has no node");
        }
        for (std::size_t node = strands.offsets[i]; node < strands.offsets[i + 1]; ++node) {
            if (const char* fault = faultOf(strands, node)) {
                return badFile(file, strand + " of the groom to write has " + fault);
            }
        }
    }
    return std::monostate{};
}

}  // namespace kushi
