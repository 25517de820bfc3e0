// SPDX-License-Identifier: Apache-2.0
#include "progress.h"

#include <cstdio>
#include <utility>

#include <unistd.h>

namespace kushi {

ProgressBar::ProgressBar(std::string title)
    : title_(std::move(title)), onTerminal_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
    if (lastPercent_ >= 0) std::fputs("\r\033[K", stderr);
}

void ProgressBar::show(double share) {
    if (!onTerminal_) return;
    const std::lock_guard lock(mutex_);
    const int percent = static_cast<int>(100 * share);
    if (percent <= lastPercent_) return;
    lastPercent_ = percent;
    const std::string bar(static_cast<std::size_t>(percent * 30 / 100), '=');
    std::fprintf(stderr, "\r%s [%-30s] %3d %%", title_.c_str(), bar.c_str(), percent);
    std::fflush(stderr);
}

}  // namespace kushi
