// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace kushi {

/// How high the landmarks of a style's head are [m]: the mannequin's, but for those that the style
/// gives itself.
class Heights {
public:
    void set(std::string_view landmark, double height) { own_[std::string(landmark)] = height; }

    /// Nothing if there is no landmark of that name.
    std::optional<double> find(std::string_view landmark) const;

private:
    std::map<std::string, double, std::less<>> own_;
};

}  // namespace kushi
