// SPDX-License-Identifier: Apache-2.0
#include <kushi/result.h>

namespace kushi {

std::string toString(const Problem& problem) {
    std::string text = problem.file;
    if (problem.line > 0) {
        text += ':' + std::to_string(problem.line);
        if (problem.column > 0) text += ':' + std::to_string(problem.column);
    }
    if (!text.empty()) text += ": ";
    return text + "error: " + problem.message;
}

}  // namespace kushi
