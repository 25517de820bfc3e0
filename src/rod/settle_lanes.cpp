// SPDX-License-Identifier: Apache-2.0
//
// Compiled for every instruction set that the compiler knows; the processor's best is chosen when
// the program runs.
#include "core/lane_targets.h"
#include "rod/guided.h"
#include "rod/strand_batch.h"

#include <bitset>

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

// A strand that is not yet at rest.
struct Moving {
    std::uint32_t place = 0;
    float share = 1;    // how far its loads have grown
    float shift = 0;    // of its Hessian
    float relaxed = 1;  // of its steps
    int steps = 0;      // taken in this pass
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

// Settles as many strands side by side as there are lanes, and tells how far each came. Returns
// which are at rest.
template <class Element>
std::bitset<Lanes::count> settleSome(Block<Lanes, Element>& block, std::span<Moving> some,
                                     Start start, NewtonOptions options) {
    std::uint32_t places[Lanes::count] = {};
    const int steps = options.maxSteps;
    for (std::size_t lane = 0; lane < some.size(); ++lane) {
        places[lane] = some[lane].place;
        options.maxSteps = std::min(options.maxSteps, steps - some[lane].steps);
    }
    block.take(std::span(places).first(some.size()));
    const auto numbers = [&](float Moving::*which) {
        return gather<Lanes>(
            [&](std::size_t lane) { return some[std::min(lane, some.size() - 1)].*which; });
    };
    Progress<Lanes> at{};
    at.share = numbers(&Moving::share);
    at.shift = numbers(&Moving::shift);
    at.relaxed = numbers(&Moving::relaxed);
    if (start == Start::Cold) {
        block.unbend();
        nudge(block);
        at.share = least(Lanes(1), Lanes(4) * reciprocal(most(block.gamma(), Lanes(1))));
    } else if (start == Start::Given) {
        block.begin();
    } else {
        block.load();
    }
    settleBlock(block, options, at);

    alignas(64) float settled[Lanes::count];
    alignas(64) float share[Lanes::count];
    alignas(64) float shift[Lanes::count];
    alignas(64) float relaxed[Lanes::count];
    alignas(64) float taken[Lanes::count];
    storeMask(at.settled, settled);
    storeLanes(at.share, share);
    storeLanes(at.shift, shift);
    storeLanes(at.relaxed, relaxed);
    storeLanes(at.steps, taken);
    std::bitset<Lanes::count> atRest;
    bool ended = false;
    for (std::size_t lane = 0; lane < some.size(); ++lane) {
        Moving& one = some[lane];
        one = {one.place, share[lane], shift[lane], relaxed[lane],
               one.steps + static_cast<int>(taken[lane])};
        atRest[lane] = settled[lane] != 0;
        ended = ended || one.steps >= steps;
    }
    const LaneMask all = Lanes(0) < Lanes(1);
    block.store(all);
    block.write(at, ended ? all : at.settled);
    return atRest;
}

// Steps of one kind. Hasty ones are long.
struct Pass {
    double worse, curvature;
    int steps;
    bool hasty;
    bool sliding = false;  // for hair that slides off what it lies on
    bool anew = false;     // with growing loads once more
};

// A few steps for all; those that need more are put together and go on. What is quick for most is
// not for all, so that they go on in other ways as well.
constexpr Pass passes[] = {{100, 0.02, 6, true},   {100, 0.02, 12, true},
                           {100, 0.02, 40, false}, {10, 0.02, 60, false},
                           {100, 1, 60, false},    {100, 1, 150, false, false, true}};
// Of hair that has been laid on what it touches, before its loads grow anew.
constexpr Pass laidPass = {100, 0.02, 40, true, true};
// Of hair that begins between other hair: what takes longer may go to another rest.
constexpr Pass guidedPass = {100, 0.02, 16, true, true};
constexpr Pass warmPass = {100, 0.02, 4, true};

// Lanes that are left for others when no more than these have work.
constexpr std::size_t fewLanes = Lanes::count / 2;

template <class Element>
class Settling {
public:
    explicit Settling(const StrandBatch& batch) : batch_(batch), block_(batch) {
        for (std::uint32_t i = 0; i < batch.strands.size(); ++i)
            left_.push_back({i});
    }

    void run() {
        const bool given = !batch_.rods->starts.empty();
        Start start = given ? Start::Given : Start::Cold;
        // With given starts, or while other hair leads it, the rest is the one near where they
        // were.
        if (batch_.warm && (given || !batch_.world->loads.empty())) {
            pass(warmPass, Start::Warm);
            start = Start::Further;
        } else if (batch_.warm) {
            settleWarm();
        } else if (!given) {
            const Places laid = hangAll();
            const Places others = placesLeft();
            left_.clear();
            settleLaid(laid);
            if (Element::freedoms == 2 && !batch_.world->forces.empty() && !rough()) {
                settleGuided(others);
            } else {
                add(others);
            }
        }
        passAll(start);
    }

private:
    // Settles what is in `left_`, and leaves what does not come to rest.
    void passAll(Start first) {
        Start start = first;
        for (const Pass& one : passes) {
            if (one.anew && first != Start::Cold) continue;
            pass(one, one.anew ? first : start);
            start = Start::Further;
        }
    }

    // Hair that forces pull: the guides with growing loads. Leaves what has no two to begin
    // between, or does not soon come to rest there.
    void settleGuided(const Places& some) {
        Guided order(batch_, some);
        add(order.guides());
        passAll(Start::Cold);
        left_.clear();
        Places alone;
        const auto release = [&](std::uint32_t done) {
            Places ended = {done};
            while (!ended.empty()) {
                const std::uint32_t one = ended.back();
                ended.pop_back();
                order.release(one, [&](const Guided::Between& next) {
                    if (beginBetween(next)) {
                        left_.push_back({next.place});
                    } else {
                        alone.push_back(next.place);
                        ended.push_back(next.place);
                    }
                });
            }
        };
        for (const std::uint32_t guide : order.guides())
            release(guide);
        left_ = run(guidedPass, Start::Further, release);
        add(alone);
    }

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
        remember(placesLeft(), History::Renewed);
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
        std::erase_if(left_, [&](const Moving& one) {
            if (history(one.place) != which) return false;
            taken.push_back(one.place);
            return true;
        });
        return taken;
    }

    // Adds some to `left_`.
    void add(const Places& some) {
        for (const std::uint32_t place : some)
            left_.push_back({place});
        std::ranges::sort(left_, {}, &Moving::place);
    }

    Places placesLeft() const {
        Places places;
        for (const Moving& one : left_)
            places.push_back(one.place);
        return places;
    }

    // Settles those of `left_` that only hang. Returns those that lie on what they would hang in.
    Places hangAll() {
        Places laid;
        if constexpr (Element::freedoms == 2) {
            const Room<Hanging<Lanes>::Node> room(block_.nodes().size());
            const Places places = placesLeft();
            Places left;
            for (std::size_t from = 0; from < places.size(); from += Lanes::count) {
                const std::size_t size = std::min(Lanes::count, places.size() - from);
                hang(block_, room.items(), std::span(places).subspan(from, size), batch_.tolerance,
                     laid, left);
            }
            remember(places, History::Hung);
            remember(laid, History::Other);
            remember(left, History::Other);
            left_.clear();
            add(left);
        }
        return laid;
    }

    // Hair that lies on something.
    void settleLaid(const Places& laid) {
        Guided order(batch_, laid);
        add(order.guides());
        left_ = run(laidPass, Start::Further, [&](std::uint32_t place) {
            order.release(place, [&](const Guided::Between& next) {
                beginBetween(next);
                left_.push_back({next.place});
            });
        });
    }

    // If both are at rest and alike.
    bool beginBetween(const Guided::Between& three) {
        const auto [one, place, other] = three;
        if (!atRest(one) || !atRest(other)) return false;
        const Vec3f between = root(other) - root(one);
        const Vec3f way = root(place) - root(one);
        const float square = std::max(dot(between, between), 1e-12F);
        return block_.mix(one, other, std::clamp(dot(way, between) / square, 0.0F, 1.0F), place);
    }

    bool rough() const {
        return batch_.world->obstacleFriction > 0 ||
               std::ranges::any_of(batch_.world->solidFrictions, [](float f) { return f > 0; });
    }

    bool atRest(std::uint32_t place) const { return batch_.states[batch_.strands[place]] != 0; }
    Vec3f root(std::uint32_t place) const { return batch_.rods->roots[batch_.strands[place]]; }

    void pass(const Pass& one, Start start) {
        left_ = run(one, start, [](std::uint32_t /*place*/) {});
    }

    // Settles what is in `left_`, which `done` may add to when a strand is at rest or has taken all
    // its steps. Returns those that are not at rest.
    std::vector<Moving> run(const Pass& one, Start start, const auto& done) {
        NewtonOptions options;
        options.tolerance = batch_.tolerance;
        options.maxSteps = one.steps;
        if (one.hasty) {
            options.reach = 2;
            options.growth = 2.5;
            options.shift = one.sliding ? 0.3 : 0.01;
            options.raise = 8;
            options.lower = one.sliding ? 0.25 : 0.1;
        }
        options.worse = one.worse;
        options.curvature = one.curvature;
        if (one.sliding) {
            options.harmless = 0.6;
            options.firm = 0.3;
        }
        // Free hair takes about as many steps each, and friction would begin anew where its hair is
        // put beside other.
        const RodWorld& world = *batch_.world;
        const bool parts = (world.obstacle != nullptr || world.solids != nullptr) && !rough();
        std::vector<Moving> ended;
        for (std::size_t from = 0; from < left_.size();) {
            // What is in the midst of its steps goes on from the state.
            const auto begins = [&](const Moving& strand) {
                return start != Start::Further && strand.steps == 0;
            };
            const bool begun = !begins(left_[from]);
            std::size_t size = 1;
            while (size < Lanes::count && from + size < left_.size() &&
                   begins(left_[from + size]) != begun)
                ++size;
            Moving some[Lanes::count];
            std::copy_n(left_.begin() + static_cast<std::ptrdiff_t>(from), size, some);
            from += size;
            options.few = parts && from < left_.size() ? fewLanes : 0;
            const auto atRest = settleSome(block_, std::span(some).first(size),
                                           begun ? Start::Further : start, options);
            for (std::size_t lane = 0; lane < size; ++lane) {
                if (!atRest[lane] && some[lane].steps < options.maxSteps) {
                    left_.push_back(some[lane]);
                    continue;
                }
                if (!atRest[lane]) ended.push_back({some[lane].place, some[lane].share});
                done(some[lane].place);
            }
        }
        return ended;
    }

    const StrandBatch& batch_;
    Block<Lanes, Element> block_;
    std::vector<Moving> left_;
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
