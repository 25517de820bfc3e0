// SPDX-License-Identifier: Apache-2.0
#include "commands.h"
#include "input.h"
#include "io/atomic_file.h"
#include "messages.h"
#include "starter.h"

#include <cstdio>
#include <filesystem>

namespace kushi {

int runNew(const std::string& path) {
    if (const Status ending = hasEnding(path, {".toml"}, "a style"); !ending) {
        return report(ending.problems());
    }
    std::error_code unknown;
    if (std::filesystem::exists(std::filesystem::symlink_status(path, unknown))) {
        return report({{"exists already; give the new style another name", path}});
    }
    if (const Status outputs = checkOutputs(path, ""); !outputs) return report(outputs.problems());
    if (const Status written = writeFileAtomically(path, starterStyle); !written) {
        return report(written.problems());
    }
    std::printf("%s: a style to begin with. Edit it, then: kushi render %s -o picture.png\n",
                path.c_str(), path.c_str());
    return Done;
}

}  // namespace kushi
