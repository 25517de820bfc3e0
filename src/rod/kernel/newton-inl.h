// SPDX-License-Identifier: Apache-2.0
//
// Rest of strands side by side: Newton's method on the rotations of the nodes.
//
// With dead loads the internal force of a segment is the sum of what hangs beyond it, whatever the
// shape, so positions drop out and the Hessian is block tridiagonal. Where a collider is touched,
// positions come back as a quadratic cost of (displacement, rotation) carried from tip to root (a
// Riccati sweep); both are exact and O(n).
#if defined(KUSHI_ROD_NEWTON_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KUSHI_ROD_NEWTON_INL_H
#undef KUSHI_ROD_NEWTON_INL_H
#else
#define KUSHI_ROD_NEWTON_INL_H
#endif

#include "rod/kernel/curly-inl.h"
#include "rod/kernel/loads-inl.h"

#include <algorithm>
#include <memory>
#include <span>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace kushi::HWY_NAMESPACE {

// What is to come to rest: one strand in each lane, all with as many segments.
template <class V, class Element>
struct Problem {
    V3<V> root;
    typename Element::State clamp;
    std::span<const typename Element::Segment> elements;  // of segment j at index j - 1
    V3<V> gravity;                                        // times the earth's
    V3<V> tipLoad;                                        // [N]
    std::span<const BoxForce<V>> forces;
    Support<V> support;
    std::span<const LaneTie<V>> ties;
    V momentScale;                      // EI/L + w L^2/2 [N m]
    std::span<const V3<V>> loads = {};  // of each segment besides gravity, likewise; or none
};

// What a sweep keeps of a node.
template <class V, class Element>
struct Node {
    static constexpr int m = Element::freedoms;

    typename Element::State state, before;
    V3<V> position;
    V3<V> load;  // of the segment that ends here, at its middle
    // step = -(still + byTurn (step of the node before) + byPlace (displacement))
    Column<V, m> step, still;
    Matrix<V, m, m> byTurn;
};

// And where loads depend on the place: in the reach of forces, colliders and ties.
template <class V, class Element>
struct Contact {
    static constexpr int m = Element::freedoms;

    bool stiff;       // whether push and k count
    bool stiffInner;  // and what acts on the segment that ends here
    bool stale;       // whether `distance` is of an earlier place, less the way from there
    V distance;       // to the nearest collider, or less
    V layer;          // what lies between a collider and the node [m]
    V3<V> push;       // of colliders on the node
    Matrix<V, 3, 3> k;
    Matrix<V, m, 3> byPlace;
    Matrix<V, 3, m> a, b;
    V3<V> inner;  // push on the segment
    V3<V> lever;  // of that each part by its share of the way along the segment
    // Of what acts on the segment: in all, each part times its share of the way, and times the
    // square of it.
    Matrix<V, 3, 3> k0, k1, k2;
    V3<V> anchor;  // where friction holds the node
    V held;        // 1 where it does, else 0
};

template <class V>
struct Progress {
    V share;       // of the loads that has been put on, in (0, 1]
    V shift;       // added to the Hessian's diagonal [N m]
    V residual;    // largest imbalance of moments over momentScale at the last evaluation
    V steps;       // taken
    V relaxed{1};  // shortens steps that make no way, as between loads that chase each other
    MaskOf<V> stable;
    MaskOf<V> settled;
};

struct NewtonOptions {
    double tolerance = 1e-5;  // of the residual
    double reach = 0.8;       // most that a node turns in one step [rad]
    double growth = 4;        // of the loads between steps
    double readiness = 0.1;   // residual below which the loads may grow
    double worse = 100;       // a step that makes the residual so many times larger is taken back
    double harmless = 0;      // but not one that makes it no larger than this
    double recovery = 1.5;    // how fast shortened steps grow again
    // Share of a support's greatest push up to which the curvature of the surface counts while the
    // residual is large. Little is quicker while many nodes find their places; all of it is needed
    // where they nearly slide.
    double curvature = 0.02;
    // The shift where a rest is not stable, over EI / d: at first, and its change from step to
    // step.
    double shift = 1e-3;
    double raise = 16;
    double lower = 0.25;
    double firm = 0;  // it stays after a step that had to be shortened to less than this share
    // Whether a step that overshoots what is lowest on its way is shortened to there; else one
    // after which the residual is much larger is taken back. Where hair slides, contacts come and
    // go, and the residual with them. Of the reference only.
    bool search = false;
    int maxSteps = 40;
    std::size_t few = 0;  // lanes that are left alone: others are to be put beside them
};

template <class V, class Element>
class Newton {
public:
    static constexpr int m = Element::freedoms;
    // Searching takes time at every node; only the reference does.
    static constexpr bool searches = std::is_same_v<V, double>;
    using Row = Node<V, Element>;
    using Touch = Contact<V, Element>;

    // contacts  as many as nodes, or none if loads do not depend on the place
    Newton(const Problem<V, Element>& problem, std::span<Row> nodes, std::span<Touch> contacts)
        : problem_(problem), nodes_(nodes), contacts_(contacts) {}

    // From the states in the nodes (the first is the clamp) to rest, in place. at.share is where
    // the loads begin; they grow where the strand follows.
    HWY_INLINE void run(const NewtonOptions& options, Progress<V>& at) {
        const V base = problem_.elements[0].bend;
        at.settled = V(1) < V(0);
        at.steps = V(0);
        for (Touch& contact : contacts_)
            contact.distance = V(-1);
        V last(1e30F);     // residual before the last step
        V allowed(1e30F);  // residual above which the step is taken back
        MaskOf<V> moved = at.settled;
        MaskOf<V> closing = at.settled;  // whose next step is likely to be the last
        const bool searching = searches && options.search;
        V low(0);      // shares of a step that are too little
        V high(0);     // and too much
        V stride(0);   // the share of a step that was taken
        V descent(0);  // the slope of the energy at its beginning, negated
        V& relaxed = at.relaxed;
        for (int step = 0;; ++step) {
            const V little = number<V>(options.curvature);
            curvature_ = step == 0 ? little : select(at.residual < V(1e-2F), V(1), little);
            load(at.share);
            const V before = at.residual;
            if (any(closing) && !any(!(closing | at.settled))) {
                sweep<Order::Gradient>(at);
                at.residual = select(at.settled, before, at.residual);
                at.settled = at.settled | (at.residual <= number<V>(options.tolerance));
                if (!any(!at.settled)) return;
            }
            // What is at rest keeps the residual that told so: another sweep rounds otherwise.
            const V told = at.residual;
            sweep<Order::Hessian>(at);
            at.residual = select(at.settled, told, at.residual);
            MaskOf<V> good = at.residual <= allowed;
            MaskOf<V> much = at.settled;  // steps that were too long
            if (searching) {
                much = moved & (slope_ > V(0.5F) * descent) & (stride > V(1e-3F));
                const MaskOf<V> scant =
                    moved & (slope_ < V(-0.5F) * descent) & (V(0.9F) * high > stride);
                high = select(much, stride, high);
                low = select(scant, stride, low);
                good = !(much | scant);
            }
            const MaskOf<V> calm = at.residual <= number<V>(options.tolerance);
            // With a shift the pivots tell nothing about stability: an upright strand has no
            // moments to balance and is not at rest.
            // (At a collider it is one-sided, as where a node just grazes it; there a little shift
            // is let pass.)
            const V allowance = select(touched_, V(4e-3F) * base, V(0));
            const MaskOf<V> sure = at.stable & (at.shift <= allowance);
            at.settled = at.settled | ((at.share >= V(1)) & calm & sure);
            if (!any(!at.settled) || step == options.maxSteps) return;

            const MaskOf<V> go = (!at.settled) & at.stable & good;
            const MaskOf<V> back = (!at.settled) & !good;
            if (step > 0 && !any(back) && count(!at.settled) <= options.few) return;
            closing = go & (at.share >= V(1)) & (at.shift <= V(0)) & (at.residual <= V(3e-3F));
            at.residual = select(good, at.residual, before);
            if (!contacts_.empty() && !searching) {
                const MaskOf<V> slow =
                    (at.residual > (V(1) - V(0.1F) * relaxed) * last) & (at.shift <= V(0)) & moved;
                const V longer = least(V(1), number<V>(options.recovery) * relaxed);
                relaxed =
                    select(slow, most(V(0.1F), V(0.5F) * relaxed), select(moved, longer, relaxed));
            }
            const MaskOf<V> shorten = searching ? back : V(1) < V(0);
            const V taken = stepShare(go, shorten, relaxed, number<V>(options.reach));
            const V secant = most(V(0.1F), descent * reciprocal(descent + slope_));
            const V between = low + select(much & (low <= V(0)), secant, V(0.5F)) * (high - low);
            stride = select(shorten, between, taken);
            low = select(shorten, low, V(0));
            high = select(shorten, high, V(0));
            descent = select(shorten, descent, descent_);
            advance(go, back, select(go | shorten, stride, V(0)));
            at.steps = select(at.settled, at.steps, at.steps + V(1));

            // Small near a rest that is not stable: a strand just past buckling leaves it by the
            // ratio of what makes it fall and the shift in a step.
            const V smallest =
                select(at.residual > V(1e-3F), number<V>(options.shift), V(1e-5F)) * base;
            const V lower =
                select(at.shift < V(0.1F) * smallest, V(0), number<V>(options.lower) * at.shift);
            const V higher = most(number<V>(options.raise) * at.shift, smallest);
            const V next =
                select(taken < number<V>(options.firm) * relaxed, most(at.shift, smallest), lower);
            at.shift = select(go, next, select(at.settled | shorten, at.shift, higher));
            const MaskOf<V> ready = go & (at.residual <= number<V>(options.readiness));
            const V grown =
                select(ready, least(V(1), number<V>(options.growth) * at.share), at.share);
            const V jump = grown - at.share;
            allowed = select(go,
                             most(number<V>(options.worse) * (at.residual + jump) + V(1e-3F),
                                  number<V>(options.harmless)),
                             allowed);
            last = select(go, select(jump > V(0), V(1e30F), at.residual), last);
            // Loads that grow change what is lowest.
            descent = select(jump > V(0), V(1e30F), descent);
            at.share = grown;
            moved = go | shorten;
        }
    }

    // Positions of all nodes.
    HWY_INLINE void place() {
        nodes_[0].position = problem_.root;
        for (std::size_t j = 1; j < nodes_.size(); ++j) {
            nodes_[j].position =
                nodes_[j - 1].position +
                Element::chord(problem_.elements[j - 1], nodes_[j - 1].state, nodes_[j].state);
        }
    }

private:
    // What acts on the strand where it is.
    HWY_INLINE void load(V share) {
        stiff_ = false;
        touched_ = V(1) < V(0);
        if (contacts_.empty()) {
            for (std::size_t j = 1; j < nodes_.size(); ++j)
                nodes_[j].load = (share * problem_.elements[j - 1].weight) * constantPull(j);
            return;
        }
        for (Touch& contact : contacts_)
            contact.stiff = contact.stiffInner = false;
        if (problem_.support.any()) {
            nodes_[0].position = problem_.root;
            for (std::size_t j = 1; j < nodes_.size(); ++j) {
                Row& node = nodes_[j];
                const V3<V> from = node.position;
                node.position =
                    nodes_[j - 1].position +
                    Element::chord(problem_.elements[j - 1], nodes_[j - 1].state, node.state);
                contacts_[j].distance = contacts_[j].distance - nearing(node.position - from);
                touch(j);
            }
        } else {
            place();
        }
        for (const LaneTie<V>& tie : problem_.ties)
            hold(tie, share);
        for (std::size_t j = 1; j < nodes_.size(); ++j)
            pullOn(j, share);
    }

    HWY_INLINE V3<V> constantPull(std::size_t j) const {
        return problem_.loads.empty() ? problem_.gravity : problem_.gravity + problem_.loads[j - 1];
    }

    HWY_INLINE void pullOn(std::size_t j, V share) {
        Row& node = nodes_[j];
        const V weight = share * problem_.elements[j - 1].weight;
        Pull<V> pull{constantPull(j), diagonal<3>(V(0)), V(1) < V(0)};
        const V3<V> middle = V(0.5F) * (nodes_[j - 1].position + node.position);
        for (const BoxForce<V>& force : problem_.forces)
            addForce(force, middle, pull);
        node.load = weight * pull.force;
        if (!any(pull.varies)) return;
        stiffen(contacts_[j], weight * pull.stiffness, V(0.5F));
    }

    // By how much a collider may be nearer after a way: a distance changes by no more than the way,
    // but one that has been read between samples by a little more.
    HWY_INLINE static V nearing(const V3<V>& way) {
        const V square = most(dot(way, way), V(1e-20F));
        return V(1.2F) * square * inverseRoot(square);
    }

    // Nothing acts on a node yet.
    HWY_INLINE void open(Touch& contact) {
        if (contact.stiff) return;
        contact.push = {V(0), V(0), V(0)};
        contact.k = diagonal<3>(V(0));
        contact.stiff = true;
        stiff_ = true;
    }

    // Nor on a segment.
    HWY_INLINE void openInner(Touch& contact) {
        if (contact.stiffInner) return;
        contact.inner = contact.lever = {V(0), V(0), V(0)};
        contact.k0 = contact.k1 = contact.k2 = diagonal<3>(V(0));
        contact.stiffInner = true;
        stiff_ = true;
    }

    // What acts on a segment at a share of the way along it.
    HWY_INLINE void stiffen(Touch& contact, const Matrix<V, 3, 3>& k, V share) {
        openInner(contact);
        contact.k0 = contact.k0 + k;
        contact.k1 = contact.k1 + share * k;
        contact.k2 = contact.k2 + (share * share) * k;
    }

    HWY_INLINE void hold(const LaneTie<V>& tie, V share) {
        Touch& contact = contacts_[tie.node];
        const V stiffness = share * tie.stiffness;
        const V3<V> gap = nodes_[tie.node].position - tie.point;
        open(contact);
        contact.push = contact.push + share * tie.force - stiffness * gap;
        contact.k = contact.k + diagonal<3>(stiffness);
    }

    // Colliders on the segment that ends at node j: on the node, and at places between.
    HWY_INLINE void touch(std::size_t j) {
        const V skin = problem_.support.skin;
        Touch& contact = contacts_[j];
        const V top = skin + contact.layer;
        const bool between = problem_.support.places > 1;
        const V reach = between ? top + V(0.5F) * problem_.elements[j - 1].length : top;
        contact.stale = !any(contact.distance < reach);
        if (!contact.stale) {
            contact.distance = press(nodes_[j].position, top, [&](const auto& on) {
                open(contact);
                contact.push = contact.push + on.push;
                contact.k = contact.k + on.k;
            });
        }
        if (between) touchBetween(j);
        if (problem_.support.frictions != nullptr) rub(j);
    }

    // Friction holds a node by a spring along the surface to where it came to lie. As far as that
    // would pull by more than Coulomb's share of the push, the node slides and takes its place
    // along.
    HWY_INLINE void rub(std::size_t j) {
        Touch& contact = contacts_[j];
        const V3<V> at = nodes_[j].position;
        V3<V> push = {V(0), V(0), V(0)};
        if (contact.stiff) push = push + contact.push;
        if (contact.stiffInner) push = push + contact.inner;
        const V size = squareRoot(dot(push, push));
        const MaskOf<V> lies = size > V(0);
        contact.anchor = select<V, 3>(lies & (contact.held > V(0)), contact.anchor, at);
        contact.held = select(lies, V(1), V(0));
        if (!any(lies)) return;
        const V stiffness = problem_.support.stiffness;
        const V3<V> normal = reciprocal(most(size, V(1e-30F))) * push;
        const V3<V> way = at - contact.anchor;
        const V3<V> along = way - dot(way, normal) * normal;
        const V slid = squareRoot(dot(along, along));
        const V limit = problem_.support.friction(at) * size * reciprocal(stiffness);
        const MaskOf<V> sticks = slid <= limit;
        const V share = select(sticks, V(1), limit * reciprocal(most(slid, V(1e-12F))));
        const V3<V> pulled = share * along;
        contact.anchor = at - pulled;
        open(contact);
        contact.push = contact.push - select(lies, stiffness, V(0)) * pulled;
        contact.k = contact.k + select(lies & sticks, stiffness, V(0)) *
                                    (diagonal<3>(V(1)) - outer(normal, normal));
    }

    HWY_INLINE void touchBetween(std::size_t j) {
        const V skin = problem_.support.skin;
        Touch& contact = contacts_[j];
        const int places = problem_.support.places;
        const V far = V(0.5F) * problem_.elements[j - 1].length + contact.layer + skin;
        const V nearer = j > 1 ? least(contact.distance, contacts_[j - 1].distance) : V(0);
        if (!any(nearer < far)) return;
        const V3<V> chord = nodes_[j].position - nodes_[j - 1].position;
        for (int place = 1; place < places; ++place) {
            const V share = number<V>(static_cast<double>(place) / places);
            const V before = V(1) - share;
            const V layer = before * contacts_[j - 1].layer + share * contact.layer;
            press(nodes_[j - 1].position + share * chord, skin + layer, [&](const auto& on) {
                stiffen(contact, on.k, share);
                contact.inner = contact.inner + on.push;
                contact.lever = contact.lever + share * on.push;
            });
        }
    }

    struct Pressure {
        V3<V> push;
        Matrix<V, 3, 3> k;
    };

    // What each collider that is nearer than `skin` does at a place. Returns the distance to the
    // nearest.
    HWY_INLINE V press(const V3<V>& at, V skin, const auto& apply) {
        const Support<V>& support = problem_.support;
        const auto spring = [&](const Nearness<V>& near) HWY_ATTR {
            const MaskOf<V> within = near.distance < skin;
            touched_ = touched_ | within;
            const V push = support.stiffness * most(skin - near.distance, V(0));
            const V stiffness = select(within, support.stiffness, V(0));
            apply(Pressure{
                push * near.normal,
                stiffness * outer(near.normal, near.normal) -
                    least(push, curvature_ * support.stiffness * support.skin) * near.curvature});
        };
        V nearest(1);
        if (support.ellipsoid != nullptr) {
            nearest = support.ellipsoid->distance(at);
            if (any(nearest < skin)) {
                Nearness<V> near = support.ellipsoid->nearness(at);
                near.distance = nearest;
                spring(near);
            }
        }
        if (!support.field.empty()) {
            Nearness<V> near;
            const bool found = support.field.look(at, skin, near);
            nearest = least(nearest, support.atLeast(near.distance));
            if (found) spring(near);
        }
        return nearest;
    }

    // How much of the step to take: no node turns by more than `reach`, nor goes far into a
    // collider at once.
    HWY_INLINE V stepShare(MaskOf<V> go, MaskOf<V> keep, V relaxed, V reach) {
        const V largest = substitute(keep);
        const V scale = relaxed * least(V(1), reach * reciprocal(most(largest, V(1e-6F))));
        return problem_.support.any() ? untilTouch(go, scale) : scale;
    }

    // The share of a step up to where a node has just entered the skin: there the collider pushes
    // back in the next.
    HWY_INLINE V untilTouch(MaskOf<V> go, V scale) {
        const Support<V>& support = problem_.support;
        typename Element::State state = nodes_[0].state;
        V3<V> at = problem_.root;
        V reach(1);
        for (std::size_t j = 1; j < nodes_.size(); ++j) {
            const auto next = Element::turned(nodes_[j].state, scale * nodes_[j].step);
            at = at + Element::chord(problem_.elements[j - 1], state, next);
            state = next;
            Touch& contact = contacts_[j];
            const V bottom = V(0.98F) * (support.skin + contact.layer);
            const auto freeFrom = [&](V now)
                                      HWY_ATTR { return now - least(bottom, V(0.5F) * now); };
            if (!any(go & (freeFrom(contact.distance) < nearing(at - nodes_[j].position))))
                continue;
            if (contact.stale)
                contact.distance = support.atLeast(support.distance(nodes_[j].position, bottom));
            contact.stale = false;
            const V now = contact.distance;
            const V free = freeFrom(now);
            const V fall = most(now - support.distance(at, bottom), V(1e-9F));
            reach =
                select((free < fall) & (now > V(0)), least(reach, free * reciprocal(fall)), reach);
        }
        return scale * select(go, reach, V(0));
    }

    // Tip to root: moments, residual, and but for the gradient alone the elimination of each node's
    // rotation, which tells whether it is stable.
    template <Order order>
    HWY_INLINE void sweep(Progress<V>& at) {
        const V least = V(1e-6F) * problem_.elements[0].bend;
        V3<V> beyond = at.share * problem_.tipLoad;  // force on the end of segment j
        V worst(0);
        slope_ = descent_ = V(0);
        if constexpr (order == Order::Hessian) {
            at.stable = V(0) < V(1);
            lastHeld_ = 0;
        }
        Matrix<V, m, m> hessian = diagonal<m>(V(0));  // of all beyond node j in its turn
        Column<V, m> pull = zeros<m>();
        Column<V, m> carried = zeros<m>();  // the gradient that segment j + 1 gives node j
        Cost cost = Cost::none();

        for (std::size_t j = nodes_.size() - 1; j > 0; --j) {
            Row& node = nodes_[j];
            const bool coupled = order == Order::Hessian && stiff_ &&
                                 (lastHeld_ > 0 || contacts_[j].stiff || contacts_[j].stiffInner);
            V3<V> carries = beyond + V(0.5F) * node.load;
            beyond = beyond + node.load;
            if (stiff_) {
                const Touch& contact = contacts_[j];
                if (contact.stiff) {
                    carries = carries + contact.push;
                    beyond = beyond + contact.push;
                }
                if (contact.stiffInner) {
                    carries = carries + contact.lever;
                    beyond = beyond + contact.inner;
                }
            }
            const auto d = Element::template derive<order>(
                problem_.elements[j - 1], nodes_[j - 1].state, node.state, carries, coupled);
            const Column<V, m> gradient = d.gb + carried;
            for (int r = 0; r < m; ++r)
                worst = most(worst, magnitude(gradient[r]));
            if constexpr (searches) slope_ += dot(gradient, node.step);
            carried = d.ga;
            if constexpr (order == Order::Gradient) continue;

            hessian = hessian + d.hbb;
            for (int r = 0; r < m; ++r)
                hessian(r, r) = hessian(r, r) + at.shift;
            pull = pull + d.gb;
            if (coupled) {
                lastHeld_ = std::max(lastHeld_, j);
                couple(node, contacts_[j], d, least, at.stable, hessian, pull, cost);
            } else {
                const auto factors = factorize(hessian, least, at.stable);
                node.still = factors.solve(pull);
                if constexpr (searches) descent_ += dot(pull, node.still);
                node.byTurn = factors.solve(transposed(d.hab));
                hessian = d.haa - d.hab * node.byTurn;
                pull = d.ga - d.hab * node.still;
            }
        }
        at.residual = worst * reciprocal(problem_.momentScale);
    }

    template <int R>
    HWY_INLINE static Column<V, R> zeros() {
        Column<V, R> zero;
        for (int r = 0; r < R; ++r)
            zero[r] = V(0);
        return zero;
    }

    // What lies beyond a node costs when the node is displaced: place' xx place / 2 +
    // place' xf turn + x' place.
    struct Cost {
        Matrix<V, 3, 3> xx;
        Matrix<V, 3, m> xf;
        V3<V> x;

        HWY_INLINE static Cost none() {
            Cost cost;
            cost.xx = diagonal<3>(V(0));
            for (int r = 0; r < 3; ++r)
                for (int c = 0; c < m; ++c)
                    cost.xf(r, c) = V(0);
            cost.x = zeros<3>();
            return cost;
        }
    };

    HWY_INLINE void couple(Row& node, Touch& contact, const Derivatives<V, m>& d, V least,
                           MaskOf<V>& stable, Matrix<V, m, m>& hessian, Column<V, m>& pull,
                           Cost& cost) {
        // The end of the segment is displaced by u = x + a alpha + b beta, a place on it at the
        // share t of the way by x + t (a alpha + b beta). What follows is written in beta, alpha
        // and y = x + a alpha.
        const Matrix<V, 3, 3> q = contact.stiff ? contact.k + cost.xx : cost.xx;
        const Matrix<V, 3, m> qb = q * d.b;
        const Matrix<V, m, 3> bt = transposed(d.b);
        const Matrix<V, m, 3> at = transposed(d.a);
        const Matrix<V, m, m> mixed = bt * cost.xf;
        Matrix<V, 3, m> w = qb + cost.xf;  // of y and beta
        Matrix<V, m, m> hab = d.hab;       // of alpha and beta
        Matrix<V, m, m> haa = d.haa;       // of alpha
        Matrix<V, 3, 3> yy = q;            // of y
        hessian = hessian + bt * qb + mixed + transposed(mixed);
        pull = pull + bt * cost.x;
        if (contact.stiffInner) {
            const Matrix<V, 3, 3> after = contact.k1 - contact.k2;
            const Matrix<V, 3, 3> before = contact.k0 - contact.k1;
            hessian = hessian + bt * (contact.k2 * d.b);
            w = w + contact.k1 * d.b;
            hab = hab - at * (after * d.b);
            haa = haa + at * ((before - after) * d.a);
            yy = yy + contact.k0;
        }

        const auto factors = factorize(hessian, least, stable);
        node.still = factors.solve(pull);
        if constexpr (searches) descent_ += dot(pull, node.still);
        node.byTurn = factors.solve(transposed(hab));
        contact.byPlace = factors.solve(transposed(w));
        contact.a = d.a;
        contact.b = d.b;

        yy = yy - w * contact.byPlace;
        const Matrix<V, 3, m> yya = yy * d.a;
        Matrix<V, 3, m> ya = V(-1) * (w * node.byTurn);
        if (contact.stiffInner) ya = ya + (contact.k1 - contact.k0) * d.a;
        const Matrix<V, m, m> aya = at * ya;
        hessian = haa - hab * node.byTurn + at * yya + aya + transposed(aya);
        cost.xx = yy;
        cost.xf = yya + ya;
        cost.x = cost.x - w * node.still;
        pull = d.ga - hab * node.still + at * cost.x;
    }

    // Root to tip: the step of each node, but for lanes that keep theirs. Returns the largest turn.
    HWY_INLINE V substitute(MaskOf<V> keep) {
        Column<V, m> turn = zeros<m>();
        V3<V> moved = {V(0), V(0), V(0)};
        V largest(0);
        for (std::size_t j = 1; j < nodes_.size(); ++j) {
            Row& node = nodes_[j];
            const bool coupled = j <= lastHeld_;
            Column<V, m> back = node.still + node.byTurn * turn;
            if (coupled) {
                moved = moved + contacts_[j].a * turn;
                back = back + contacts_[j].byPlace * moved;
            }
            turn = V(-1) * back;
            if (coupled) moved = moved + contacts_[j].b * turn;
            if constexpr (searches) {
                node.step = select<V, m>(keep, node.step, turn);
            } else {
                node.step = turn;
            }
            largest = most(largest, dot(turn, turn));
        }
        return squareRoot(largest);
    }

    // Steps of some lanes, and others back to where they came from.
    HWY_INLINE void advance(MaskOf<V> go, MaskOf<V> back, V scale) {
        for (std::size_t j = 1; j < nodes_.size(); ++j) {
            Row& node = nodes_[j];
            node.before = select(go, node.state, node.before);
            const auto from = select(go | back, node.before, node.state);
            node.state = select(scale > V(0), Element::turned(from, scale * node.step), from);
        }
    }

    const Problem<V, Element>& problem_;
    std::span<Row> nodes_;
    std::span<Touch> contacts_;
    V curvature_{};
    V slope_{};                 // of the energy along the last step
    V descent_{};               // of the energy at the beginning of the next step, downwards
    MaskOf<V> touched_{};       // lanes in which a node touches the collider
    bool stiff_ = false;        // any k of any lane
    std::size_t lastHeld_ = 0;  // the last node whose place counts; 0 if none
};

}  // namespace kushi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
