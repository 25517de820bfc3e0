// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/text.h"

#include <string_view>

namespace kushi {

// The statements of a .obj file, whatever it describes.

/// Takes a line and those that a backslash at the end adds to it, without comments.
bool takeObjStatement(Lines& lines, std::string_view& statement);

/// Takes the next word; a backslash only continues a line.
inline std::string_view takeObjWord(std::string_view& line) {
    return takeWord(line, '\\');
}

/// Whether the keyword says neither where anything is nor how it hangs together: names, materials,
/// display settings.
bool isObjDecoration(std::string_view keyword);

/// Whether the keyword belongs to a free-form curve or surface.
bool isObjFreeForm(std::string_view keyword);

}  // namespace kushi
