// SPDX-License-Identifier: Apache-2.0
#include "io/hair_file.h"

#include "io/bytes.h"
#include "io/text.h"
#include "io/values.h"
#include "io/writable.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace kushi {
namespace {

enum Arrays : std::uint32_t {
    Segments = 1,
    Points = 2,
    Thickness = 4,
    Transparency = 8,
    Colors = 16,
    AllArrays = 31,
};

struct Header {
    std::array<char, 4> signature = {'H', 'A', 'I', 'R'};
    std::uint32_t strands = 0;
    std::uint32_t points = 0;
    std::uint32_t arrays = Points;
    std::uint32_t defaultSegments = 0;
    float defaultThickness = 0.0075F;  // cm: medium hair
    float defaultTransparency = 0;
    std::array<float, 3> defaultColor = {1, 1, 1};
    std::array<char, 88> info = {};

    bool has(Arrays array) const { return (arrays & array) != 0; }
};
static_assert(sizeof(Header) == 128);

using std::to_string;

std::uint64_t fileSize(const Header& header) {
    std::uint64_t perPoint = 3 * sizeof(float);
    if (header.has(Thickness)) perPoint += sizeof(float);
    if (header.has(Transparency)) perPoint += sizeof(float);
    if (header.has(Colors)) perPoint += 3 * sizeof(float);
    const std::uint64_t perStrand = header.has(Segments) ? sizeof(std::uint16_t) : 0;
    return sizeof(Header) + perStrand * header.strands + perPoint * header.points;
}

/// What is wrong with the header, given the size of the file; empty if nothing.
std::string faultOf(const Header& header, std::uint64_t size) {
    if (!header.has(Points)) {
        return "no points array (bit 1 of the header's array bits is not set); strands need one";
    }
    if ((header.arrays & ~std::uint32_t{AllArrays}) != 0) {
        return "the header announces arrays that the .hair format does not have (array bits " +
               to_string(header.arrays) + "; the largest is " + to_string(AllArrays) + ")";
    }
    if (const std::uint64_t expected = fileSize(header); size != expected) {
        return (size < expected ? "cut short: " : "bytes after the last array: ") +
               to_string(size) + " bytes, but a header with " + to_string(header.strands) +
               " strands and " + to_string(header.points) + " points asks for " +
               to_string(expected);
    }
    const std::uint64_t uniform =
        std::uint64_t{header.strands} * (std::uint64_t{header.defaultSegments} + 1);
    if (!header.has(Segments) && uniform != header.points) {
        return "the file contradicts itself: " + to_string(header.strands) + " strands of " +
               to_string(header.defaultSegments) + " segments have " + to_string(uniform) +
               " points, but the header says " + to_string(header.points);
    }
    return {};
}

/// One offset more than strands; the last is the number of points that the segments ask for.
std::vector<std::uint64_t> offsetsOf(const Header& header, const char* segments) {
    std::vector<std::uint64_t> offsets = {0};
    offsets.reserve(std::size_t{header.strands} + 1);
    for (std::size_t i = 0; i < header.strands; ++i) {
        const std::uint64_t count = header.has(Segments)
                                        ? load<std::uint16_t>(segments + i * sizeof(std::uint16_t))
                                        : header.defaultSegments;
        offsets.push_back(offsets.back() + count + 1);
    }
    return offsets;
}

/// Takes arrays of floats off the front of the rest of a file.
class FloatReader {
public:
    explicit FloatReader(const char* bytes) : bytes_(bytes) {}

    float take() {
        const auto value = load<float>(bytes_);
        bytes_ += sizeof(float);
        return value;
    }
    Vec3d takePosition() {
        const double x = take(), y = take(), z = take();
        return {x, y, z};
    }
    Rgb takeColor() {
        const float r = take(), g = take(), b = take();
        return {r, g, b};
    }

private:
    const char* bytes_;
};

/// Reads the arrays after the segments; what is wrong with them, or nothing.
std::string readArrays(const Header& header, const char* bytes, Strands& strands) {
    const std::size_t points = header.points;
    const auto fault = [](std::size_t point, const char* what) {
        return "point " + to_string(point) + " (counted from 0) has " + what;
    };
    FloatReader in(bytes);
    strands.nodes.reserve(points);
    for (std::size_t i = 0; i < points; ++i) {
        const Vec3d position = in.takePosition();
        if (!isPosition(position)) return fault(i, "a position that is not finite");
        strands.nodes.push_back(toMeters(position));
    }
    for (std::size_t i = 0; i < points && header.has(Thickness); ++i) {
        const float thickness = in.take();
        if (!isDiameter(thickness)) return fault(i, "a thickness that is not finite or below 0");
        strands.diameters.push_back(toMeters(thickness));
    }
    for (std::size_t i = 0; i < points && header.has(Transparency); ++i) {
        const float transparency = in.take();
        if (!isTransparency(transparency)) {
            return fault(i, "a transparency that is not between 0 and 1");
        }
        strands.transparency.push_back(transparency);
    }
    for (std::size_t i = 0; i < points && header.has(Colors); ++i) {
        const Rgb color = in.takeColor();
        if (!isColor(color)) return fault(i, "a colour that is not finite");
        strands.colors.push_back(color);
    }
    return {};
}

Header headerFor(const Strands& strands, bool uniform) {
    Header header;
    header.strands = static_cast<std::uint32_t>(strands.size());
    header.points = static_cast<std::uint32_t>(strands.nodes.size());
    if (!uniform) header.arrays |= Segments;
    if (!strands.diameters.empty()) header.arrays |= Thickness;
    if (!strands.transparency.empty()) header.arrays |= Transparency;
    if (!strands.colors.empty()) header.arrays |= Colors;
    if (uniform && strands.size() > 0) header.defaultSegments = strands.offsets[1] - 1;
    constexpr std::string_view info = "Kushi, centimetres, y up";
    std::ranges::copy(info, header.info.begin());
    return header;
}

}  // namespace

Result<Strands> parseHair(std::string_view bytes, const std::string& file) {
    if (!bytes.starts_with("HAIR")) {
        return badFile(file, "not a .hair file: it starts with " + inQuotes(bytes.substr(0, 4)) +
                                 " instead of 'HAIR'");
    }
    if (bytes.size() < sizeof(Header)) {
        return badFile(file, "cut short: " + to_string(bytes.size()) +
                                 " bytes, but the header of a .hair file alone has 128");
    }
    const auto header = load<Header>(bytes.data());
    if (std::string fault = faultOf(header, bytes.size()); !fault.empty()) {
        return badFile(file, std::move(fault));
    }

    const char* arrays = bytes.data() + sizeof(Header);
    const std::vector<std::uint64_t> offsets = offsetsOf(header, arrays);
    if (offsets.back() != header.points) {
        return badFile(file, "the file contradicts itself: its segments ask for " +
                                 to_string(offsets.back()) + " points, but the header says " +
                                 to_string(header.points));
    }

    Strands strands;
    strands.offsets.assign(offsets.begin(), offsets.end());
    if (header.has(Segments)) arrays += header.strands * sizeof(std::uint16_t);
    if (std::string fault = readArrays(header, arrays, strands); !fault.empty()) {
        return badFile(file, std::move(fault));
    }
    return strands;
}

Result<std::string> formatHair(const Strands& strands, const std::string& file) {
    if (Status writable = checkWritable(strands, file); !writable) return writable.problems();
    constexpr std::size_t most = std::numeric_limits<std::uint16_t>::max() + std::size_t{1};
    bool uniform = true;
    for (std::size_t i = 0; i < strands.size(); ++i) {
        const std::size_t count = strands.strand(i).size();
        if (count < 2 || count > most) {
            return badFile(file, "a .hair file holds strands of 2 to " + to_string(most) +
                                     " nodes, but strand " + to_string(i) +
                                     " (counted from 0) has " + to_string(count) +
                                     "; .ply and .obj have no such limit");
        }
        uniform = uniform && count == strands.strand(0).size();
    }

    const Header header = headerFor(strands, uniform);
    std::string bytes;
    bytes.reserve(fileSize(header));
    store(bytes, header);
    for (std::size_t i = 0; !uniform && i < strands.size(); ++i) {
        store(bytes, static_cast<std::uint16_t>(strands.strand(i).size() - 1));
    }
    for (const Vec3f node : strands.nodes)
        store(bytes, toCentimeters(node).as<float>());
    for (const float diameter : strands.diameters) {
        store(bytes, static_cast<float>(toCentimeters(diameter)));
    }
    for (const float transparency : strands.transparency)
        store(bytes, transparency);
    for (const Rgb color : strands.colors)
        store(bytes, color);
    return bytes;
}

}  // namespace kushi
