// SPDX-License-Identifier: Apache-2.0
#include "messages.h"

#include "commands.h"

#include <algorithm>
#include <cstdio>

namespace kushi {

int report(const std::vector<Problem>& problems) {
    for (const Problem& problem : problems) {
        std::fprintf(stderr, "%s\n", toString(problem).c_str());
    }
    const bool machine = std::any_of(problems.begin(), problems.end(),
                                     [](const Problem& problem) { return problem.system; });
    return machine ? Failure : BadInput;
}

std::string grouped(std::size_t number) {
    std::string digits = std::to_string(number);
    for (auto at = std::ssize(digits) - 3; at > 0; at -= 3)
        digits.insert(static_cast<std::size_t>(at), 1, ',');
    return digits;
}

std::string counted(std::size_t number, const char* what) {
    return grouped(number) + ' ' + what + (number == 1 ? "" : "s");
}

}  // namespace kushi
