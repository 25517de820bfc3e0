// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"

#include <kushi/subdivide.h>

#include <algorithm>
#include <cmath>

namespace kushi {

namespace {

constexpr std::size_t grain = 512;  // strands
constexpr double mostParts = 16;

/// A segment of a strand as a cubic, by its share from 0 to 1.
struct Cubic {
    Vec3d start, end;       // m
    Vec3d leaving, coming;  // derivatives by the share [m]

    Vec3d at(double t) const {
        const double s = 1 - t;
        return s * s * (1 + 2 * t) * start + t * t * (1 + 2 * s) * end + t * s * s * leaving -
               t * t * s * coming;
    }
};

/// The segments of one strand, one at a time.
class Curve {
public:
    explicit Curve(std::span<const Vec3f> nodes) : nodes_(nodes) {}

    /// The segment from node i.
    Cubic cubic(std::size_t i) const {
        const Vec3d start = nodes_[i].as<double>();
        const Vec3d end = nodes_[i + 1].as<double>();
        const double size = length(end - start);
        return {start, end, size * tangent(i, i), size * tangent(i + 1, i)};
    }

    /// How far the tangent turns along the segment from node i [rad]; 0 where that has no meaning.
    double turn(std::size_t i) const {
        const Vec3d own = direction(i);
        if (dot(own, own) == 0) return 0;
        return angle(tangent(i, i), own) + angle(own, tangent(i + 1, i));
    }

private:
    static double angle(Vec3d a, Vec3d b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

    double sizeOf(std::size_t segment) const {
        return length(nodes_[segment + 1].as<double>() - nodes_[segment].as<double>());
    }
    /// 0 of a segment that has none.
    Vec3d direction(std::size_t segment) const {
        const Vec3d along = nodes_[segment + 1].as<double>() - nodes_[segment].as<double>();
        const double size = length(along);
        return std::isfinite(size) && size > 0 ? along / size : Vec3d{};
    }

    /// The curve's derivative by length at a node, for the segment `segment` that it bounds.
    Vec3d tangent(std::size_t node, std::size_t segment) const {
        if (node == 0) return endTangent(0, 1);
        if (node + 1 == nodes_.size()) return endTangent(node - 1, node - 1);
        return middleTangent(node, segment);
    }
    /// That of the parabola through the node and its neighbours, with chords as lengths.
    Vec3d middleTangent(std::size_t node, std::size_t segment) const {
        const Vec3d before = direction(node - 1);
        const Vec3d after = direction(node);
        if (dot(before, before) == 0 || dot(after, after) == 0) return direction(segment);
        const double first = sizeOf(node - 1);
        const double second = sizeOf(node);
        return (second * before + first * after) / (first + second);
    }
    /// The parabola that the segment's other node, `inner`, asks for.
    Vec3d endTangent(std::size_t segment, std::size_t inner) const {
        const Vec3d own = direction(segment);
        if (inner == 0 || inner + 1 >= nodes_.size()) return own;
        return 2.0 * own - middleTangent(inner, segment);
    }

    std::span<const Vec3f> nodes_;
};

std::uint8_t partsOf(double turn, double maxTurn) {
    return static_cast<std::uint8_t>(std::clamp(std::ceil(turn / maxTurn), 1.0, mostParts));
}

/// Whether the tangent turns by less than maxTurn along a segment whose neighbours turn from it as
/// these two do; told without angles, for most segments.
class Straightness {
public:
    /// At a node it turns by no more than from segment to segment, and by half of that where those
    /// are as long as each other.
    explicit Straightness(double maxTurn)
        : unlike_(squareOfCosine(maxTurn / 2)), alike_(squareOfCosine(0.9 * maxTurn)) {}

    bool between(Vec3f one, Vec3f next) const {
        const float ones = dot(one, one);
        const float nexts = dot(next, next);
        const float cosine = dot(one, next);
        const bool alike = std::max(ones, nexts) < 1.4F * std::min(ones, nexts);
        // Also false for what is no number.
        return cosine > 0 && cosine * cosine > (alike ? alike_ : unlike_) * ones * nexts;
    }

private:
    static float squareOfCosine(double angle) {
        const double cosine = std::cos(std::min(angle, 1.5)) + 1e-6;
        return static_cast<float>(cosine * cosine);
    }
    float unlike_, alike_;
};

/// Parts of each segment of a strand, by its first node.
void findParts(std::span<const Vec3f> nodes, double maxTurn, std::span<std::uint8_t> parts) {
    const Curve curve(nodes);
    const Straightness straightness(maxTurn);
    bool straightBefore = true;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
        const bool straightAfter =
            i + 2 == nodes.size() ||
            straightness.between(nodes[i + 1] - nodes[i], nodes[i + 2] - nodes[i + 1]);
        if (!straightBefore || !straightAfter) parts[i] = partsOf(curve.turn(i), maxTurn);
        straightBefore = straightAfter;
    }
}

float mixed(float a, float b, float share) {
    return a * (1 - share) + b * share;
}

/// values  per node
template <class T>
std::vector<T> spread(const std::vector<T>& values, const Strands& from, const Strands& to,
                      const std::vector<std::uint8_t>& parts, int threads) {
    if (values.empty()) return {};
    std::vector<T> more(to.nodes.size());
    parallelFor(from.size(), grain, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t strand = begin; strand < end; ++strand) {
            std::size_t next = to.offsets[strand];
            for (std::size_t node = from.offsets[strand]; node < from.offsets[strand + 1]; ++node) {
                more[next++] = values[node];
                for (std::uint8_t i = 1; i < parts[node]; ++i) {
                    const float share = static_cast<float>(i) / static_cast<float>(parts[node]);
                    more[next++] = mixed(values[node], values[node + 1], share);
                }
            }
        }
    });
    return more;
}

}  // namespace

Strands subdivided(Strands strands, double maxTurn, int threads) {
    // Parts of the segment after each node; 1 after a strand's last.
    std::vector<std::uint8_t> parts(strands.nodes.size(), 1);
    parallelFor(strands.size(), grain, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t strand = begin; strand < end; ++strand) {
            const std::span<const Vec3f> nodes = strands.strand(strand);
            findParts(nodes, maxTurn,
                      std::span(parts).subspan(strands.offsets[strand], nodes.size()));
        }
    });

    Strands finer;
    finer.keys = strands.keys;
    finer.offsets.reserve(strands.offsets.size());
    std::uint64_t count = 0;
    for (std::size_t strand = 0; strand < strands.size(); ++strand) {
        for (std::uint32_t node = strands.offsets[strand]; node < strands.offsets[strand + 1];
             ++node)
            count += parts[node];
        if (count > 0xffffffffU) return strands;
        finer.offsets.push_back(static_cast<std::uint32_t>(count));
    }
    if (count == strands.nodes.size()) return strands;
    finer.nodes.resize(count);
    parallelFor(strands.size(), grain, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t strand = begin; strand < end; ++strand) {
            const Curve curve(strands.strand(strand));
            std::size_t next = finer.offsets[strand];
            for (std::uint32_t node = strands.offsets[strand]; node < strands.offsets[strand + 1];
                 ++node) {
                finer.nodes[next++] = strands.nodes[node];
                if (parts[node] == 1) continue;
                const Cubic cubic = curve.cubic(node - strands.offsets[strand]);
                for (std::uint8_t i = 1; i < parts[node]; ++i)
                    finer.nodes[next++] =
                        cubic.at(static_cast<double>(i) / parts[node]).as<float>();
            }
        }
    });
    finer.diameters = spread(strands.diameters, strands, finer, parts, threads);
    finer.transparency = spread(strands.transparency, strands, finer, parts, threads);
    finer.colors = spread(strands.colors, strands, finer, parts, threads);
    return finer;
}

}  // namespace kushi
