// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/settle.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace kushi {

/// How long each stage of a command took.
class StageClock {
public:
    /// Ends the stage that began where the last one ended.
    void end(const std::string& stage);
    /// Adds stages timed elsewhere, which took the time since the last one ended.
    void add(const std::vector<StageTime>& stages);
    const std::vector<StageTime>& stages() const { return stages_; }
    /// Milliseconds in all.
    double total() const;

private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
    std::vector<StageTime> stages_;
};

/// The text of --report, JSON.
std::string reportJson(const SettleReport& report, const StageClock& clock);

/// The same of a picture, with the share of scalp that shows where it is known.
std::string renderReportJson(const SettleReport& report, std::optional<double> scalpShowing,
                             const StageClock& clock);

/// "read 1 ms, plant 60 ms, settle 40 ms".
std::string timesLine(const StageClock& clock);

}  // namespace kushi
