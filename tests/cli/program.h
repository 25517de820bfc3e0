// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <utility>

namespace kushi::test {

/// What a run of the program left.
struct Outcome {
    int status = -1;  ///< exit status; 128 + signal if it was killed
    std::string out, err;
};

/// Runs `kushi ARGUMENTS` through the shell.
Outcome runKushi(const std::string& arguments);

/// A folder of this test's own, empty at first.
std::string freshFolder();

void writeText(const std::string& path, const std::string& text);
std::string readBytes(const std::string& path);

/// Settles a style to a groom with 1, 2 and 8 threads, and expects the same bytes each time.
void expectTheSameFromAnyThreads(const std::string& style, const std::string& groom);

/// Width and height of a PNG.
std::pair<std::uint32_t, std::uint32_t> pngSize(const std::string& bytes);

/// A small valid style, and what its [head] says: hair that keeps out of it takes seconds.
std::string smallStyle(const std::string& head = "collide = false");

}  // namespace kushi::test
