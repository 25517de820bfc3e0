// SPDX-License-Identifier: Apache-2.0
#include "io/bytes.h"
#include "io/ply_file.h"
#include "io/text.h"
#include "io/values.h"
#include "io/writable.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace kushi {
namespace {

std::string headerOf(const Strands& strands, bool shortCounts) {
    std::string header =
        "ply\n"
        "format binary_little_endian 1.0\n"
        "comment Kushi, centimetres, y up\n"
        "element vertex " +
        std::to_string(strands.nodes.size()) +
        "\n"
        "property float x\n"
        "property float y\n"
        "property float z\n";
    if (!strands.colors.empty()) {
        header +=
            "property float red\n"
            "property float green\n"
            "property float blue\n";
    }
    if (!strands.diameters.empty()) header += "property float diameter\n";
    if (!strands.transparency.empty()) header += "property float transparency\n";
    header += "element strand " + std::to_string(strands.size()) + "\nproperty " +
              (shortCounts ? "ushort" : "uint") +
              " nsegs\n"
              "element edge " +
              std::to_string(strands.segmentCount()) +
              "\n"
              "property int vertex1\n"
              "property int vertex2\n"
              "end_header\n";
    return header;
}

void storeVertices(std::string& bytes, const Strands& strands) {
    for (std::size_t i = 0; i < strands.nodes.size(); ++i) {
        store(bytes, toCentimeters(strands.nodes[i]).as<float>());
        if (!strands.colors.empty()) store(bytes, strands.colors[i]);
        if (!strands.diameters.empty()) {
            store(bytes, static_cast<float>(toCentimeters(strands.diameters[i])));
        }
        if (!strands.transparency.empty()) store(bytes, strands.transparency[i]);
    }
}

void storeEdges(std::string& bytes, const Strands& strands) {
    for (std::size_t i = 0; i < strands.size(); ++i) {
        for (std::uint32_t node = strands.offsets[i] + 1; node < strands.offsets[i + 1]; ++node) {
            store(bytes, node - 1);
            store(bytes, node);
        }
    }
}

}  // namespace

Result<std::string> formatPly(const Strands& strands, const std::string& file) {
    if (Status writable = checkWritable(strands, file); !writable) return writable.problems();
    if (strands.nodes.size() > std::numeric_limits<std::int32_t>::max()) {
        return badFile(file, "a .ply file holds at most 2147483647 nodes, but the groom has " +
                                 std::to_string(strands.nodes.size()));
    }
    std::size_t longest = 0;
    for (std::size_t i = 0; i < strands.size(); ++i) {
        longest = std::max(longest, strands.strand(i).size() - 1);
    }
    // hairutil reads nothing but ushort.
    const bool shortCounts = longest <= std::numeric_limits<std::uint16_t>::max();

    std::string bytes = headerOf(strands, shortCounts);
    bytes.reserve(bytes.size() + strands.nodes.size() * 40 + strands.size() * 4);
    storeVertices(bytes, strands);
    for (std::size_t i = 0; i < strands.size(); ++i) {
        const auto segments = static_cast<std::uint32_t>(strands.strand(i).size() - 1);
        if (shortCounts) {
            store(bytes, static_cast<std::uint16_t>(segments));
        } else {
            store(bytes, segments);
        }
    }
    storeEdges(bytes, strands);
    return bytes;
}

}  // namespace kushi
