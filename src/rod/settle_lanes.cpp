// SPDX-License-Identifier: Apache-2.0
//
// Compiled for every instruction set that the compiler knows; the processor's best is chosen when
// the program runs.
#include "core/lane_targets.h"
#include "rod/strand_batch.h"

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

using Places = std::vector<std::uint32_t>;

// Strands that are not yet at rest, and how far the loads of each have grown.
struct Left {
    Places places;
    std::vector<float> shares;
};

// Settles what only hangs and touches nothing. What would hang in something is laid on it and
// added to `laid`, the others to `left`.
void hang(Block<Lanes, Straight<Lanes>>& block, std::span<Hanging<Lanes>::Node> nodes,
          std::span<const std::uint32_t> some, double tolerance, Places& laid, Places& left) {
    block.take(some);
    alignas(64) float settled[Lanes::count] = {};
    alignas(64) float hung[Lanes::count] = {};
    const LaneMask able = block.hanging();
    if (any(able)) {
        Progress<Lanes> at{};
        Hanging<Lanes> hanging(block.problem(), nodes);
        hanging.run(tolerance, 8, at);
        hanging.place(block.nodes());
        LaneMask hangs = at.settled & able;
        at.settled = hangs & block.clear();
        if (any(at.settled)) block.write(at, at.settled);
        // Friction holds hair where it first comes to lie.
        if (block.problem().support.frictions != nullptr) hangs = at.settled;
        if (any(hangs & !at.settled)) block.lay(hangs & !at.settled);
        if (any(hangs)) block.store(hangs);
        storeMask(at.settled, settled);
        storeMask(hangs, hung);
    }
    for (std::size_t lane = 0; lane < some.size(); ++lane) {
        if (settled[lane] == 0) (hung[lane] == 0 ? left : laid).push_back(some[lane]);
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

// Steps of one kind. Hasty ones are long.
struct Pass {
    double worse, curvature;
    int steps;
    bool hasty;
    bool sliding = false;  // for hair that slides off what it lies on
};

// A few steps for all; those that need more are put together and go on. What is quick for most is
// not for all, so that they go on in other ways as well.
constexpr Pass passes[] = {{100, 0.02, 6, true},
                           {100, 0.02, 12, true},
                           {100, 0.02, 40, false},
                           {10, 0.02, 60, false},
                           {100, 1, 60, false}};
// Of hair that has been laid on what it touches, before its loads grow anew.
constexpr Pass laidPasses[] = {{100, 0.02, 8, true, true}, {100, 0.02, 16, true, true}};
constexpr Pass warmPass = {100, 0.02, 4, true};

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
        // With given starts, or while other hair presses, the rest is the one near where they were.
        if (batch_.warm && (given || !batch_.world->loads.empty())) {
            pass(warmPass, Start::Warm);
            start = Start::Further;
        } else if (batch_.warm) {
            settleWarm();
        } else if (!given) {
            const Places laid = hangAll();
            const Places others = std::move(left_.places);
            left_ = {laid, std::vector<float>(laid.size(), 1.0F)};
            for (const Pass& one : laidPasses)
                pass(one, Start::Further);
            add(others);
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
        const Places renewed = take(History::Renewed);
        const Places others = take(History::Other);
        add(hangAll());
        add(others);
        pass(warmPass, Start::Warm);
        // On the head it takes some more to find which nodes touch.
        if (batch_.world->obstacle != nullptr || batch_.world->solids != nullptr)
            pass(passes[1], Start::Further);
        remember(left_.places, History::Renewed);
        add(renewed);
    }

    History& history(std::uint32_t place) const { return batch_.histories[batch_.strands[place]]; }

    void remember(const Places& places, History what) {
        for (const std::uint32_t place : places)
            history(place) = what;
    }

    // Takes those of a history from `left_`.
    Places take(History which) {
        Places taken;
        Places left;
        for (const std::uint32_t place : left_.places)
            (history(place) == which ? taken : left).push_back(place);
        left_.places = std::move(left);
        return taken;
    }

    // Adds some to `left_`.
    void add(const Places& some) {
        left_.places.insert(left_.places.end(), some.begin(), some.end());
        std::ranges::sort(left_.places);
    }

    // Settles those of `left_` that only hang. Returns those that lie on what they would hang in.
    Places hangAll() {
        Places laid;
        if constexpr (Element::freedoms == 2) {
            const Room<Hanging<Lanes>::Node> room(block_.nodes().size());
            const Places places = std::move(left_.places);
            left_.places.clear();
            for (std::size_t from = 0; from < places.size(); from += Lanes::count) {
                const std::size_t size = std::min(Lanes::count, places.size() - from);
                hang(block_, room.items(), std::span(places).subspan(from, size), batch_.tolerance,
                     laid, left_.places);
            }
            remember(places, History::Hung);
            remember(laid, History::Other);
            remember(left_.places, History::Other);
        }
        return laid;
    }

    void pass(const Pass& one, Start start) {
        NewtonOptions options;
        options.tolerance = batch_.tolerance;
        options.maxSteps = one.steps;
        if (one.hasty) {
            options.reach = 2;
            options.growth = 2.5;
            options.shift = one.sliding ? 1e-1 : 1e-2;
            options.raise = 8;
            options.lower = one.sliding ? 0.25 : 0.1;
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
