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
        hanging.run(tolerance, 8, at);
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

// Passes of at most so many steps take long ones.
constexpr int hasty = 12;

struct Pass {
    int steps;
    double worse, curvature;
};

// A few steps for all; those that need more are put together and go on. What is quick for most is
// not for all, so that they go on in other ways as well.
constexpr Pass passes[] = {
    {6, 100, 0.02}, {12, 100, 0.02}, {40, 100, 0.02}, {60, 10, 0.02}, {60, 100, 1}};

template <class Element>
class Settling {
public:
    explicit Settling(const StrandBatch& batch) : batch_(batch), block_(batch) {
        for (std::uint32_t i = 0; i < batch.strands.size(); ++i)
            left_.places.push_back(i);
    }

    void run() {
        const bool given = !batch_.rods->starts.empty();
        Start start = given ? Start::Given : Start::Cold;
        if (given && batch_.warm) {
            pass({4, 100, 0.02}, Start::Warm);
            start = Start::Further;
        } else if (batch_.warm) {
            settleWarm();
        } else if (!given) {
            hangAll();
        }
        for (const Pass& one : passes) {
            pass(one, start);
            start = Start::Further;
        }
    }

private:
    // The rest from before may be gone, and where a strand goes from there need not be where
    // growing loads would take it, nor is it there when the loads come back. So what does not come
    // to rest in a few steps begins anew, now and from now on, and ends where a cold solve would.
    void settleWarm() {
        const Left renewed = take(History::Renewed);
        Left others = take(History::Other);
        hangAll();
        add(others);
        pass({4, 100, 0.02}, Start::Warm);
        // On the head it takes some more to find which nodes touch.
        if (batch_.world->obstacle != nullptr) pass({12, 100, 0.02}, Start::Further);
        for (const std::uint32_t place : left_.places)
            history(place) = static_cast<std::uint8_t>(History::Renewed);
        add(renewed);
    }

    std::uint8_t& history(std::uint32_t place) const {
        return batch_.histories[batch_.strands[place]];
    }

    // Takes those of a history from `left_`.
    Left take(History which) {
        Left taken;
        Left left;
        for (const std::uint32_t place : left_.places)
            (history(place) == static_cast<std::uint8_t>(which) ? taken : left)
                .places.push_back(place);
        left_ = std::move(left);
        return taken;
    }

    // Adds some to `left_`, with all of the loads.
    void add(const Left& some) {
        left_.places.insert(left_.places.end(), some.places.begin(), some.places.end());
        std::ranges::sort(left_.places);
        left_.shares.assign(left_.places.size(), 1);
    }

    // Settles those of `left_` that only hang.
    void hangAll() {
        if constexpr (Element::freedoms == 2) {
            const Room<Hanging<Lanes>::Node> room(block_.nodes().size());
            for (const std::uint32_t place : left_.places)
                history(place) = static_cast<std::uint8_t>(History::Hung);
            Left left;
            const std::span<const std::uint32_t> places = left_.places;
            for (std::size_t from = 0; from < places.size(); from += Lanes::count) {
                hang(block_, room.items(),
                     places.subspan(from, std::min(Lanes::count, places.size() - from)),
                     batch_.tolerance, left);
            }
            left_ = std::move(left);
            for (const std::uint32_t place : left_.places)
                history(place) = static_cast<std::uint8_t>(History::Other);
        }
    }

    void pass(const Pass& one, Start start) {
        NewtonOptions options;
        options.tolerance = batch_.tolerance;
        options.maxSteps = one.steps;
        if (one.steps <= hasty) {
            options.reach = 2;
            options.growth = 2.5;
            options.shift = 1e-2;
            options.raise = 8;
            options.lower = 0.1;
        }
        options.worse = one.worse;
        options.curvature = one.curvature;
        Left left;
        for (std::size_t from = 0; from < left_.places.size(); from += Lanes::count)
            settleSome(block_, left_, from, start, options, left);
        left_ = std::move(left);
    }

    const StrandBatch& batch_;
    Block<Lanes, Element> block_;
    Left left_;
};

void settleLanesHere(const StrandBatch& batch) {
    if (batch.rods->naturalCurvature.empty()) {
        Settling<Straight<Lanes>>(batch).run();
    } else {
        Settling<Curly<Lanes>>(batch).run();
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
