// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>
#include <string>

namespace kushi {

/// A progress bar on standard error while it is a terminal; nothing otherwise. Gone when destroyed.
class ProgressBar {
public:
    explicit ProgressBar(std::string title);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// From any thread; `share` in [0, 1].
    void show(double share);

private:
    std::string title_;
    bool onTerminal_;
    int lastPercent_ = -1;
    std::mutex mutex_;
};

}  // namespace kushi
