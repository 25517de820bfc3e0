// SPDX-License-Identifier: Apache-2.0
#include <kushi/style.h>

namespace kushi {

double Hair::rigidity() const {
    const double square = diameter * diameter;
    const double sectionMoment = std::numbers::pi / 64 * square * square;
    return stiffness * flexuralRigidity.value_or(youngsModulus * sectionMoment);
}

double Hair::torsionalRigidity() const {
    return rigidity() * 2 * shearModulus / youngsModulus;
}

double Hair::weightPerLength() const {
    const double section = std::numbers::pi / 4 * diameter * diameter;
    return density * earthGravity * section;
}

}  // namespace kushi
