// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/result.h>

#include <string>
#include <vector>

namespace kushi {

/// Prints each problem as a line on standard error; returns the exit status that they ask for.
int report(const std::vector<Problem>& problems);

/// 50000 as "50,000".
std::string grouped(std::size_t number);

/// "1 strand", "50,000 strands".
std::string counted(std::size_t number, const char* what);

}  // namespace kushi
