// SPDX-License-Identifier: Apache-2.0
#include "rod/kernel/batch-inl.h"

namespace kushi {

namespace {

using namespace HWY_NAMESPACE;  // NOLINT: the kernels of the processor that everybody has

NewtonOptions brisk(double tolerance, double worse, double curvature) {
    NewtonOptions options;
    options.tolerance = tolerance;
    options.worse = worse;
    options.curvature = curvature;
    options.maxSteps = 200;
    return options;
}

NewtonOptions patient(double tolerance) {
    NewtonOptions options = brisk(tolerance, 10, 1);
    options.growth = 1.25;
    options.readiness = 1e-3;
    options.recovery = 1.25;
    options.reach = 0.5;
    options.maxSteps = 400;
    return options;
}

// Long, but each step leads down.
NewtonOptions searching(double tolerance) {
    NewtonOptions options = brisk(tolerance, 100, 1);
    options.search = true;
    options.maxSteps = 1000;
    return options;
}

// Steps of straight strands are in axes of their own place, and friction goes by the way there:
// neither can be compared with a step that is tried.
template <class Element>
bool searchable(const Block<double, Element>& block) {
    return Element::freedoms == 3 && block.problem().support.frictions == nullptr;
}

// From where the rods say to begin, with all of the loads; whether that leads to rest.
template <class Element>
bool settleNear(Block<double, Element>& block, const StrandBatch& batch, Progress<double>& at) {
    if (batch.rods->starts.empty()) return false;
    for (const NewtonOptions& options :
         {brisk(batch.tolerance, 3, 1), searching(batch.tolerance)}) {
        if (options.search && !searchable(block)) continue;
        block.begin();
        at = {};
        at.share = 1;
        settleBlock(block, options, at);
        if (at.settled) return true;
    }
    return false;
}

template <class Element>
void settleEach(const StrandBatch& batch) {
    Block<double, Element> block(batch);
    for (std::uint32_t place = 0; place < batch.strands.size(); ++place) {
        if (batch.states[batch.strands[place]] != 0) continue;
        block.take(std::span(&place, 1));
        Progress<double> at{};
        const bool near = settleNear(block, batch, at);
        const double tolerance = batch.tolerance;
        // None of these settles every strand, and together they leave out hardly any.
        for (const NewtonOptions& options :
             {brisk(tolerance, 100, 1), searching(tolerance), brisk(tolerance, 10, 0.02),
              patient(tolerance), brisk(tolerance, 3, 1)}) {
            if (near) break;
            if (options.search && !searchable(block)) continue;
            block.unbend();
            nudge(block);
            at = {};
            at.share = std::min(1.0, 1 / block.gamma());
            settleBlock(block, options, at);
            if (at.settled) break;
        }
        block.store(true);
        block.write(at, true);
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
