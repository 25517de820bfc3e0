// SPDX-License-Identifier: Apache-2.0
#include "io/file_limit.h"

#include "io/atomic_file.h"
#include "io/text.h"

#include <filesystem>
#include <system_error>

namespace kushi {

Result<std::string> readLimitedFile(const std::string& path, std::uint64_t most) {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    const bool special = fs::exists(status) && !fs::is_regular_file(status);
    if (special && !fs::is_directory(status)) {
        return badFile(path, "found a pipe or a device, expected a file");
    }
    const std::uintmax_t size = fs::is_regular_file(status) ? fs::file_size(path, error) : 0;
    if (!error && size > most) {
        return badFile(path, "the file has " + std::to_string(size) + " bytes; at most " +
                                 std::to_string(most) +
                                 " are read: reduce the mesh to what can be seen");
    }
    return readFile(path);
}

}  // namespace kushi
