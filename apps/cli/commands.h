// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

namespace kushi {

/// Exit status of the program: 0 done; badInput for bad usage or bad input, with nothing written;
/// failure for anything else, such as an output that cannot be written.
enum ExitStatus { done = 0, failure = 1, badInput = 2 };

// Each adds one command to the program; when it is the one asked for, its exit status goes to
// `status`.
void addCheck(CLI::App& program, int& status);
void addSettle(CLI::App& program, int& status);
void addRender(CLI::App& program, int& status);
void addConvert(CLI::App& program, int& status);
void addInfo(CLI::App& program, int& status);
void addRod(CLI::App& program, int& status);

}  // namespace kushi
