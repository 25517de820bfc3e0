// SPDX-License-Identifier: Apache-2.0
//
// Compiled for every instruction set that the compiler knows; the processor's best is chosen when
// the program runs.
#include "rod/strand_batch.h"

// One target for each width of register is enough; under sanitizers, which make these files slow to
// compile, one beside the baseline.
#ifdef KUSHI_FEW_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL)
#else
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#endif
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rod/settle_lanes.cpp"
// Highway's file compiles this one again for each target: it comes before the kernels.
// clang-format off
#include <hwy/foreach_target.h>
#include "rod/kernel/batch-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace kushi::HWY_NAMESPACE {

enum class Start { Cold, Given, Warm, Further };

// How far the loads of a strand had grown when it was left.
struct Left {
    std::vector<std::uint32_t> places;
    std::vector<float> shares;
};

// Settles what only hangs and touches nothing; the others are added to `left`.
void hang(Block<Lanes, Straight<Lanes>>& block, std::span<Hanging<Lanes>::Node> nodes,
          std::span<const std::uint32_t> some, double tolerance, Left& left) {
    block.take(some);
    alignas(64) float settled[Lanes::count] = {};
    const LaneMask able = block.hanging();
    if (any(able)) {
        Progress<Lanes> at{};
        Hanging<Lanes> hanging(block.problem(), nodes);
        hanging.run(tolerance, 6, at);
        hanging.place(block.nodes());
        at.settled = at.settled & able & block.clear();
        if (any(at.settled)) {
            block.store(at.settled);
            block.write(at, at.settled);
        }
        storeMask(at.settled, settled);
    }
    for (std::size_t lane = 0; lane < some.size(); ++lane) {
        if (settled[lane] != 0) continue;
        left.places.push_back(some[lane]);
        left.shares.push_back(1);
    }
}

// Settles strands side by side; those that are not yet at rest are added to `left`.
template <class Element>
void settleSome(Block<Lanes, Element>& block, const Left& some, std::size_t from, Start start,
                const NewtonOptions& options, Left& left) {
    const std::size_t size = std::min(Lanes::count, some.places.size() - from);
    block.take(std::span(some.places).subspan(from, size));
    Progress<Lanes> at{};
    if (start == Start::Cold) {
        block.unbend();
        nudge(block);
        at.share = least(Lanes(1), Lanes(4) * reciprocal(most(block.gamma(), Lanes(1))));
    } else if (start == Start::Given) {
        block.begin();
        at.share = Lanes(1);
    } else {
        block.load();
        at.share = gather<Lanes>([&](std::size_t lane) {
            return start == Start::Warm ? 1.0F
                                        : some.shares[std::min(from + lane, from + size - 1)];
        });
    }
    settleBlock(block, options, at);
    const LaneMask all = Lanes(0) < Lanes(1);
    block.store(all);
    block.write(at, all);

    alignas(64) float settled[Lanes::count];
    alignas(64) float share[Lanes::count];
    storeMask(at.settled, settled);
    storeLanes(at.share, share);
    for (std::size_t lane = 0; lane < size; ++lane) {
        if (settled[lane] != 0) continue;
        left.places.push_back(some.places[from + lane]);
        left.shares.push_back(share[lane]);
    }
}

// A few steps for all; those that need more are put together and go on. What is quick for most is
// not for all, so that they go on in other ways as well.
template <class Element>
void settleAll(const StrandBatch& batch) {
    Block<Lanes, Element> block(batch);
    Left some;
    for (std::uint32_t i = 0; i < batch.strands.size(); ++i)
        some.places.push_back(i);

    if constexpr (Element::freedoms == 2) {
        if (batch.rods->starts.empty()) {
            const Room<Hanging<Lanes>::Node> room(block.nodes().size());
            Left left;
            const std::span<const std::uint32_t> places = some.places;
            for (std::size_t from = 0; from < places.size(); from += Lanes::count) {
                hang(block, room.items(),
                     places.subspan(from, std::min(Lanes::count, places.size() - from)),
                     batch.tolerance, left);
            }
            some = std::move(left);
        }
    }

    NewtonOptions options;
    options.tolerance = batch.tolerance;
    Start start = batch.warm                   ? Start::Warm
                  : batch.rods->starts.empty() ? Start::Cold
                                               : Start::Given;
    struct Pass {
        int steps;
        double worse, curvature;
    };
    for (const Pass& pass : {Pass{batch.warm ? 3 : 6, 100, 0.02}, Pass{12, 100, 0.02},
                             Pass{40, 100, 0.02}, Pass{60, 10, 0.02}, Pass{60, 100, 1}}) {
        options.maxSteps = pass.steps;
        options.worse = pass.worse;
        options.curvature = pass.curvature;
        Left left;
        for (std::size_t from = 0; from < some.places.size(); from += Lanes::count)
            settleSome(block, some, from, start, options, left);
        some = std::move(left);
        start = Start::Further;
    }
}

void settleLanesHere(const StrandBatch& batch) {
    if (batch.rods->naturalCurvature.empty()) {
        settleAll<Straight<Lanes>>(batch);
    } else {
        settleAll<Curly<Lanes>>(batch);
    }
}

}  // namespace kushi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kushi {

HWY_EXPORT(settleLanesHere);

void settleLanes(const StrandBatch& batch) {
    HWY_DYNAMIC_DISPATCH(settleLanesHere)(batch);
}

}  // namespace kushi
#endif
