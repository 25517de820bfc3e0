// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace kushi {

/// Times the stages of a report.
class Stopwatch {
public:
    /// Milliseconds since the last lap, or since it was made.
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        const std::chrono::duration<double, std::milli> passed = now - last_;
        last_ = now;
        return passed.count();
    }

private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace kushi
