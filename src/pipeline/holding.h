// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/settle.h>

#include <cstddef>
#include <vector>

namespace kushi {

/// What SetGroom says of how its strands hold, of one groom or several.
struct Holding {
    std::vector<float> factors;  ///< how many times its stiffness each strand needs, as there
    std::size_t unstable = 0, unheld = 0;
};

SetReport describe(const Holding& holding);

}  // namespace kushi
