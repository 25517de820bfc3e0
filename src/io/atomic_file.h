// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/result.h>

#include <string>
#include <string_view>

namespace kushi {

/// Writes `bytes` beside `path` and renames: `path` holds all of them or what it held before, also
/// if the program is killed (against a power cut there is no promise). A symbolic link stays one,
/// its target is replaced. What is not a regular file (a pipe, /dev/null), and the program's own
/// standard output, is written straight through.
///
/// A file that cannot be written (no folder, no permission, a full disk) is a problem with `system`
/// set, and leaves nothing behind.
Status writeFileAtomically(const std::string& path, std::string_view bytes);

/// The whole file. A missing or unreadable one, or a folder, is a problem.
Result<std::string> readFile(const std::string& path);

}  // namespace kushi
