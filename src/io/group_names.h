// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/faces.h"

#include <map>
#include <string>
#include <vector>

namespace kushi {

/// Puts triangles into groups by what they are called.
class GroupNames {
public:
    /// From now on triangles go by these names; empty ones do not count. What is wrong, or nothing.
    std::string use(std::vector<std::string> names, Faces& faces);

    /// Puts the triangles added since the last call into the group in use.
    void assign(Faces& faces) const { faces.groups.resize(faces.triangles.size(), current_); }

private:
    std::map<std::vector<std::string>, std::uint16_t> known_;
    std::uint16_t current_ = 0;
};

}  // namespace kushi
