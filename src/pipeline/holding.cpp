// SPDX-License-Identifier: Apache-2.0
#include "pipeline/holding.h"

#include <algorithm>
#include <cmath>

namespace kushi {

SetReport describe(const Holding& holding) {
    SetReport report;
    report.unstable = holding.unstable;
    report.unheld = holding.unheld;
    std::vector<float> raised;
    for (const float factor : holding.factors) {
        if (factor > 1 && std::isfinite(factor)) raised.push_back(factor);
    }
    report.stiffened = raised.size();
    if (raised.empty()) return report;
    std::sort(raised.begin(), raised.end());
    report.stiffenedMedian = raised[raised.size() / 2];
    report.stiffenedMost = raised.back();
    return report;
}

}  // namespace kushi
