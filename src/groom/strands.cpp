// SPDX-License-Identifier: Apache-2.0
#include <kushi/strands.h>

#include <algorithm>

namespace kushi {

std::size_t Strands::strandOf(std::uint32_t node) const {
    const auto next = std::upper_bound(offsets.begin(), offsets.end(), node);
    return static_cast<std::size_t>(next - offsets.begin()) - 1;
}

void Strands::add(std::span<const Vec3f> strandNodes, std::uint64_t key) {
    nodes.insert(nodes.end(), strandNodes.begin(), strandNodes.end());
    offsets.push_back(static_cast<std::uint32_t>(nodes.size()));
    keys.push_back(key);
}

double polylineLength(std::span<const Vec3f> nodes) {
    double sum = 0;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
        sum += length(nodes[i].as<double>() - nodes[i - 1].as<double>());
    }
    return sum;
}

void Bounds::include(Vec3f point) {
    low = {std::min(low.x, point.x), std::min(low.y, point.y), std::min(low.z, point.z)};
    high = {std::max(high.x, point.x), std::max(high.y, point.y), std::max(high.z, point.z)};
}

Bounds boundsOf(std::span<const Vec3f> points) {
    Bounds bounds;
    for (const Vec3f point : points)
        bounds.include(point);
    return bounds;
}

GroomSummary summarize(const Strands& strands) {
    GroomSummary summary;
    summary.strands = strands.size();
    summary.nodes = strands.nodes.size();
    summary.segments = strands.segmentCount();
    summary.bounds = boundsOf(strands.nodes);

    double total = 0;
    for (std::size_t i = 0; i < strands.size(); ++i) {
        const double l = polylineLength(strands.strand(i));
        total += l;
        summary.minLength = i == 0 ? l : std::min(summary.minLength, l);
        summary.maxLength = std::max(summary.maxLength, l);
    }
    if (strands.size() > 0) summary.meanLength = total / static_cast<double>(strands.size());

    if (!strands.keys.empty()) summary.attributes.emplace_back("key");
    if (!strands.diameters.empty()) summary.attributes.emplace_back("diameter");
    if (!strands.transparency.empty()) summary.attributes.emplace_back("transparency");
    if (!strands.colors.empty()) summary.attributes.emplace_back("color");
    return summary;
}

}  // namespace kushi
