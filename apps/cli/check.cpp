// SPDX-License-Identifier: Apache-2.0
#include "commands.h"
#include "messages.h"

#include <kushi/style.h>

#include <cstdio>

namespace kushi {

namespace {

std::string plural(std::size_t number, const char* what) {
    return std::to_string(number) + ' ' + what + (number == 1 ? "" : "s");
}

}  // namespace

int runCheck(const std::string& path) {
    const Result<Style> style = readStyle(path);
    if (!style) return report(style.problems());
    std::size_t forces = 0;
    std::size_t cuts = 0;
    for (const Part& part : style->parts) {
        forces += part.forces.size();
        cuts += part.cuts.size();
    }
    std::printf("%s: good (%s, %s, %s)\n", path.c_str(),
                plural(style->parts.size(), "part").c_str(), plural(forces, "force").c_str(),
                plural(cuts, "cut").c_str());
    return done;
}

}  // namespace kushi
