// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <gtest/gtest.h>

namespace kushi::test {

/// Distance fields are kept here from one test to the next: of the mannequin they take a second,
/// and many times that under sanitizers.
inline std::string fieldCache() {
    return testing::TempDir() + "kushi_fields";
}

}  // namespace kushi::test
