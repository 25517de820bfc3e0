// SPDX-License-Identifier: Apache-2.0
#include "io/group_names.h"

#include <algorithm>
#include <limits>

namespace kushi {

std::string GroupNames::use(std::vector<std::string> names, Faces& faces) {
    constexpr std::size_t most = std::numeric_limits<std::uint16_t>::max();
    std::erase(names, "");
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    const auto found = known_.find(names);
    if (found == known_.end() && known_.size() == most) {
        return "more than " + std::to_string(most) +
               " groups, objects and materials; join objects before exporting them";
    }
    current_ = found != known_.end() ? found->second : static_cast<std::uint16_t>(known_.size());
    if (found != known_.end()) return {};
    known_.emplace(names, current_);
    faces.groupNames.push_back(std::move(names));
    return {};
}

}  // namespace kushi
