// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include <kushi/result.h>

namespace kushi {

/// Writes `bytes` beside `path`, flushes, and renames: `path` holds all of them or what it held
/// before. A file that cannot be written (no folder, no permission, a full disk) is a problem with
/// `system` set, and leaves nothing behind.
Status writeFileAtomically(const std::string& path, std::string_view bytes);

/// The whole file. A missing or unreadable one is a problem.
Result<std::string> readFile(const std::string& path);

}  // namespace kushi
