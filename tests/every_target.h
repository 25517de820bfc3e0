// SPDX-License-Identifier: Apache-2.0
//
// The same test on every instruction set of this processor.
#pragma once

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>
#include <hwy/targets.h>

namespace kushi {

// All but what the lanes' sources leave out.
inline std::vector<std::int64_t> targetsHere() {
    std::vector<std::int64_t> targets;
    std::int64_t left = hwy::SupportedTargets();
    for (; left != 0; left &= left - 1) {
        const std::int64_t one = left & -left;
        if ((one & (HWY_SSSE3 | HWY_AVX3_DL)) == 0) targets.push_back(one);
    }
    return targets;
}

class OnEveryTarget : public testing::Test {
protected:
    static void use(std::int64_t target) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    }
    void TearDown() override { use(0); }
};

}  // namespace kushi
