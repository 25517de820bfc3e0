// SPDX-License-Identifier: Apache-2.0
#include "style/keys.h"
#include "style/read_number.h"
#include "style/spelling.h"

#include <kushi/head.h>

#include <vector>

namespace kushi {

namespace {

void reportUnknownLandmark(const Node& node, std::string_view name, Diagnostics& problems) {
    std::vector<std::string_view> names;
    for (const Landmark& landmark : headLandmarks())
        names.push_back(landmark.name);
    std::string hint = stringHint(node.string());
    if (const std::string_view meant = nearest(node.string(), names); !meant.empty()) {
        hint = "did you mean \"" + std::string(meant) + "\"?";
    }
    problems.unexpected(
        name, node,
        expectedNumber(quantities::place) + " or a landmark of the head: " + listed(names, '"'),
        hint);
}

}  // namespace

std::optional<double> Heights::find(std::string_view landmark) const {
    const auto own = own_.find(landmark);
    return own != own_.end() ? own->second : landmarkHeight(landmark);
}

std::optional<double> readHeight(const Node& node, std::string_view name, const Heights& heights,
                                 Diagnostics& problems) {
    if (node.kind != Kind::String) return readNumber(node, name, quantities::place, problems);
    const auto height = heights.find(node.string());
    if (!height) reportUnknownLandmark(node, name, problems);
    return height;
}

}  // namespace kushi
