// SPDX-License-Identifier: Apache-2.0
#include "shading/functions-inl.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace kushi {
namespace {

namespace kernel = HWY_NAMESPACE;
using kernel::Lanes;

// Of each of as many numbers as there are lanes, one after the other from `first` on by `step`.
template <class Function>
std::array<float, Lanes::count> each(const Function& function, float first, float step) {
    std::array<float, Lanes::count> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = first + step * static_cast<float>(i);
    kernel::storeLanes(function(kernel::loadLanes(numbers.data(), Lanes())), numbers.data());
    return numbers;
}

TEST(Functions, ExponentialIsThatOfTheLibrary) {
    const auto exponential = [](Lanes x) { return kernel::exponential(x); };
    for (float x = -79; x < 79; x += 0.37F) {
        for (const float step : {0.0F, 0.2F, -0.01F * x, -0.5F * x}) {
            const float last = x + step * static_cast<float>(Lanes::count - 1);
            if (std::abs(last) > 80) continue;
            const auto values = each(exponential, x, step);
            for (std::size_t i = 0; i < values.size(); ++i) {
                const float at = x + step * static_cast<float>(i);
                EXPECT_NEAR(values[i] / std::exp(at), 1, 1e-6) << at;
            }
        }
    }
    EXPECT_EQ(each(exponential, 0, 0)[0], 1);
    EXPECT_EQ(each(exponential, -1e9F, 0), each(exponential, -80, 0));
    EXPECT_EQ(each(exponential, 1e9F, 0), each(exponential, 80, 0));
}

TEST(Functions, ArcCosineIsThatOfTheLibrary) {
    const auto arcCosine = [](Lanes x) { return kernel::arcCosine(x); };
    for (float x = -1; x <= 1; x += 0.01F)
        EXPECT_NEAR(each(arcCosine, x, 0).back(), std::acos(x), 7e-5) << x;
    EXPECT_EQ(each(arcCosine, 1, 0)[0], 0);
}

}  // namespace
}  // namespace kushi
