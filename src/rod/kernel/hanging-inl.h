// SPDX-License-Identifier: Apache-2.0
//
// Straight hair under its own weight alone: it hangs in the plane of its clamp and gravity, and of
// the shapes whose every tangent points between the clamp and straight down only one is at rest
// (sin x / x falls from 0 to pi: Brezis and Oswald 1986). The unknowns are the angles phi by which
// the nodes are turned from the clamp towards gravity, so that a strand that hardly bends keeps its
// digits, and Newton's method begins so near that the whole load acts at once.
#if defined(KUSHI_ROD_HANGING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KUSHI_ROD_HANGING_INL_H
#undef KUSHI_ROD_HANGING_INL_H
#else
#define KUSHI_ROD_HANGING_INL_H
#endif

#include "rod/kernel/newton-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kushi::HWY_NAMESPACE {

// A rough arctangent, for x in [0, 1].
template <class V>
HWY_INLINE V roughArctangent(V x) {
    const V xx = x * x;
    V p = V(0.0208351F) * xx - V(0.085133F);
    p = p * xx + V(0.180141F);
    p = p * xx - V(0.3302995F);
    return (p * xx + V(0.999866F)) * x;
}

template <class V>
class Hanging {
public:
    struct Node {
        V phi;              // angle from the clamp's tangent
        V down, side;       // the chord that ends here, over its length
        V still, byBefore;  // step = -(still + byBefore (step of the node before))
    };

    // nodes  as many as the problem has; the first is the clamp
    Hanging(const Problem<V, Straight<V>>& problem, std::span<Node> nodes)
        : problem_(problem), nodes_(nodes) {
        const V3<V>& gravity = problem.gravity;
        pull_ = squareRoot(dot(gravity, gravity));
        down_ = reciprocal(most(pull_, V(1e-20F))) * gravity;
        const V along = dot(problem.clamp, down_);
        const V3<V> off = problem.clamp - along * down_;
        const V across = squareRoot(dot(off, off));
        side_ = reciprocal(most(across, V(1e-20F))) * off;
        const V scale = inverseRoot(along * along + across * across);
        cosine_ = scale * along;
        sine_ = scale * across;
    }

    // Where these are not settled the strand needs another way.
    HWY_INLINE void run(double tolerance, int maxSteps, Progress<V>& at) {
        begin();
        for (int step = 0;; ++step) {
            eliminate(at);
            at.settled = at.stable & (at.residual <= number<V>(tolerance));
            if (!any(!at.settled) || step == maxSteps) return;
            advance(at.settled);
        }
    }

    // Nodes and tangents in the world.
    HWY_INLINE void place(std::span<kushi::HWY_NAMESPACE::Node<V, Straight<V>>> out) const {
        out[0].position = problem_.root;
        for (std::size_t j = 1; j < nodes_.size(); ++j) {
            const Node& node = nodes_[j];
            const V length = problem_.elements[j - 1].length;
            out[j].position =
                out[j - 1].position + (length * node.down) * down_ + (length * node.side) * side_;
            const auto half = sineCosineOfTwice(V(0.25F) * node.phi);
            const V s = V(2) * half.sine * half.cosine;
            const V c = V(1) - V(2) * half.sine * half.sine;
            out[j].state = (cosine_ * c + sine_ * s) * down_ + (sine_ * c - cosine_ * s) * side_;
        }
    }

private:
    // tan(delta / 4), delta the angle from gravity, falls along the strand as delta would if it
    // were small; so it does exactly under a constant tension.
    HWY_INLINE void begin() {
        V force(0);
        V beyond(0);
        for (std::size_t j = nodes_.size() - 1; j > 0; --j) {
            const auto& element = problem_.elements[j - 1];
            const V load = loadOn(element, force);
            const V k = element.bend;
            const V h = V(0.25F) * load;
            const V ratio = (k - h) * reciprocal(beyond + k + h);
            beyond = k + h - (k - h) * ratio;
            nodes_[j].byBefore = most(ratio, V(0.02F));
        }
        // tan(x / 2) = sin(x) / (1 + cos(x)), and again.
        const V c2 = squareRoot(most(V(0.5F) * (V(1) + cosine_), V(1e-14F)));
        const V s2 = V(0.5F) * sine_ * reciprocal(c2);
        const V whole = least(s2 * reciprocal(V(1) + c2), V(1));
        V part = whole;
        nodes_[0].phi = V(0);
        for (std::size_t j = 1; j < nodes_.size(); ++j) {
            part = part * nodes_[j].byBefore;
            nodes_[j].phi =
                V(4) * roughArctangent((whole - part) * reciprocal(V(1) + whole * part));
        }
    }

    // Moment of what a segment carries, for a chord that lies level. `force` is that on its end
    // and, after it, on its beginning.
    HWY_INLINE V loadOn(const typename Straight<V>::Segment& element, V& force) const {
        const V half = V(0.5F) * pull_ * element.weight;
        const V load = element.length * (force + half);
        force = force + half + half;
        return load;
    }

    HWY_INLINE void eliminate(Progress<V>& at) {
        const V least = V(1e-6F) * problem_.elements[0].bend;
        V force(0);
        V hessian(0);
        V pull(0);
        V carried(0);
        V worst(0);
        at.stable = V(0) < V(1);
        for (std::size_t j = nodes_.size() - 1; j > 0; --j) {
            Node& node = nodes_[j];
            const V before = nodes_[j - 1].phi;
            const auto& element = problem_.elements[j - 1];
            const V load = loadOn(element, force);
            const auto [s, c] = sineCosineOfTwice(V(0.25F) * (before + node.phi));
            node.down = cosine_ * c + sine_ * s;
            node.side = sine_ * c - cosine_ * s;
            const V half = V(0.5F) * load * node.side;
            const V h = V(0.25F) * load * node.down;
            const V moment = element.bend * (node.phi - before);

            const V gradient = moment - half;
            worst = most(worst, magnitude(gradient + carried));
            carried = -(moment + half);
            const V straight = element.bend + h;
            const V across = h - element.bend;
            hessian = hessian + straight;
            pull = pull + gradient;
            // Segments that are long for their load swing about the vertical.
            const MaskOf<V> between = (node.side >= V(-1e-5F)) | (node.down > V(0));
            const MaskOf<V> good = (hessian > least) & between;
            at.stable = at.stable & good;
            const V inverse = reciprocal(select(hessian > least, hessian, V(1)));
            node.still = inverse * pull;
            node.byBefore = inverse * across;
            hessian = straight - across * node.byBefore;
            pull = carried - across * node.still;
        }
        at.residual = worst * reciprocal(problem_.momentScale);
    }

    HWY_INLINE void advance(MaskOf<V> done) {
        V step(0);
        for (std::size_t j = 1; j < nodes_.size(); ++j) {
            Node& node = nodes_[j];
            step = -(node.still + node.byBefore * step);
            // A bound that only what strays needs. On few segments a node may turn beyond gravity,
            // so that the chord points there.
            const V next = least(most(node.phi + step, V(0)), number<V>(6.2831853));
            node.phi = select(done, node.phi, next);
        }
    }

    const Problem<V, Straight<V>>& problem_;
    std::span<Node> nodes_;
    V pull_;             // of gravity, times the earth's
    V3<V> down_, side_;  // unit; the clamp's tangent lies between them
    V cosine_, sine_;    // of the angle from down to the clamp
};

}  // namespace kushi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
