// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/settle.h>

#include <chrono>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

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

/// How strands made elsewhere hold, for --report.
nlohmann::ordered_json setJson(const SetReport& set);
/// The same in words, where there is something to say.
void printHolding(const SetReport& set, std::size_t unsettled);

/// One line on standard output: how far the strands of `what` are inside of something.
void printPenetration(const std::string& what, const Penetration& found);

/// The text of --report, JSON.
std::string reportJson(const SettleReport& report, const StageClock& clock);

/// The share of the scalp that shows in a view.
struct ScalpShowing {
    std::string view;
    double share = 0;
};

/// The same of a picture, with the scalp that shows by view where there is a head.
std::string renderReportJson(const SettleReport& report, const std::vector<ScalpShowing>& showing,
                             const StageClock& clock);

/// "read 1 ms, plant 60 ms, settle 40 ms".
std::string timesLine(const StageClock& clock);

}  // namespace kushi
