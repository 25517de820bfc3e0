// SPDX-License-Identifier: Apache-2.0
#include "commands.h"
#include "input.h"
#include "messages.h"

#include <kushi/groom_io.h>

#include <cstdio>

namespace kushi {

int runConvert(const std::string& from, const std::string& to) {
    if (const Status ending = hasEnding(to, {".hair", ".ply", ".obj"}, "the output"); !ending) {
        return report(ending.problems());
    }
    const Result<Strands> strands = readGroom(from);
    if (!strands) return report(strands.problems());
    if (const Status written = writeGroom(*strands, to); !written)
        return report(written.problems());
    std::printf("%s: %s, %s\n", to.c_str(), counted(strands->size(), "strand").c_str(),
                counted(strands->segmentCount(), "segment").c_str());
    return Done;
}

}  // namespace kushi
