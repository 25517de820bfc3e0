// SPDX-License-Identifier: Apache-2.0
#include <kushi/style.h>

#include <gtest/gtest.h>

namespace kushi {
namespace {

// pi d^4 / 64 and pi d^2 / 4 for d = 75 micrometres, worked out by hand:
// d^4 = 3.1640625e-17 m4, I = 1.5531556e-18 m4, A = 4.4178647e-9 m2.
TEST(Hair, RigidityIsModulusTimesTheRoundSectionsMoment) {
    EXPECT_NEAR(Hair{}.rigidity(), 3.9e9 * 1.5531556e-18, 1e-15);
}

TEST(Hair, WeightPerLengthIsThatOfARoundSection) {
    EXPECT_NEAR(Hair{}.weightPerLength(), 1320 * 9.80665 * 4.4178647e-9, 1e-11);
}

TEST(Hair, RigidityGrowsWithTheFourthPowerOfTheDiameter) {
    Hair thick;
    thick.diameter = 2 * Hair{}.diameter;
    EXPECT_NEAR(thick.rigidity() / Hair{}.rigidity(), 16, 1e-12);
}

TEST(Hair, AGivenRigidityReplacesTheComputedOneAndStiffnessMultipliesEither) {
    Hair hair;
    hair.stiffness = 3;
    EXPECT_NEAR(hair.rigidity() / Hair{}.rigidity(), 3, 1e-12);
    hair.flexuralRigidity = 7.8e-9;
    EXPECT_NEAR(hair.rigidity(), 3 * 7.8e-9, 1e-22);
}

}  // namespace
}  // namespace kushi
