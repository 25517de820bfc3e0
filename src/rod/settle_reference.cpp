// SPDX-License-Identifier: Apache-2.0
#include "rod/kernel/batch-inl.h"

namespace kushi {

namespace {

using namespace HWY_NAMESPACE;  // NOLINT: the kernels of the processor that everybody has

NewtonOptions brisk(double tolerance) {
    NewtonOptions options;
    options.tolerance = tolerance;
    options.curvature = 1;
    options.worse = 3;
    options.maxSteps = 200;
    return options;
}

NewtonOptions patient(double tolerance) {
    NewtonOptions options = brisk(tolerance);
    options.growth = 1.25;
    options.readiness = 1e-3;
    options.recovery = 1.25;
    options.reach = 0.5;
    options.maxSteps = 400;
    return options;
}

// From where the rods say to begin, with all of the loads; whether that leads to rest.
template <class Element>
bool settleNear(Block<double, Element>& block, const StrandBatch& batch, Progress<double>& at) {
    if (batch.rods->starts.empty()) return false;
    block.begin();
    at.share = 1;
    settleBlock(block, brisk(batch.tolerance), at);
    return at.settled;
}

template <class Element>
void settleEach(const StrandBatch& batch) {
    Block<double, Element> block(batch);
    for (std::uint32_t place = 0; place < batch.strands.size(); ++place) {
        block.take(std::span(&place, 1));
        Progress<double> at{};
        const bool near = settleNear(block, batch, at);
        for (const NewtonOptions& options : {brisk(batch.tolerance), patient(batch.tolerance)}) {
            if (near) break;
            block.unbend();
            nudge(block);
            at = {};
            at.share = std::min(1.0, 1 / block.gamma());
            settleBlock(block, options, at);
            if (at.settled) break;
        }
        block.store();
        block.write(at);
    }
}

}  // namespace

void settleReference(const StrandBatch& batch) {
    if (batch.rods->naturalCurvature.empty()) {
        settleEach<Straight<double>>(batch);
    } else {
        settleEach<Curly<double>>(batch);
    }
}

}  // namespace kushi
