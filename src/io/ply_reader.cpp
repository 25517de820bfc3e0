// SPDX-License-Identifier: Apache-2.0
#include "io/chains.h"
#include "io/ply_body.h"
#include "io/ply_file.h"
#include "io/ply_rows.h"
#include "io/text.h"
#include "io/values.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace kushi {
namespace {

using std::to_string;

/// Where the columns of a vertex stand.
struct Columns {
    std::size_t x = 0, y = 0, z = 0;
    std::optional<std::size_t> red, green, blue, diameter, transparency;
    double colorScale = 1;
};

/// What the elements of a file have given so far.
struct Parts {
    std::optional<Strands> vertices;
    std::optional<std::vector<std::uint32_t>> offsets;
    std::optional<std::vector<Edge>> edges;
};

/// What is wrong with the properties of the vertices, or nothing.
std::string findColumns(const PlyElement& vertex, Columns& columns) {
    for (const PlyProperty& property : vertex.properties) {
        if (property.listCount) return "a list among the properties of the element 'vertex'";
    }
    const auto x = vertex.find("x"), y = vertex.find("y"), z = vertex.find("z");
    if (!x || !y || !z) return "no properties x, y and z in the element 'vertex'";
    columns.x = *x;
    columns.y = *y;
    columns.z = *z;

    columns.red = vertex.find("red");
    columns.green = vertex.find("green");
    columns.blue = vertex.find("blue");
    if (columns.red.has_value() != columns.green.has_value() ||
        columns.red.has_value() != columns.blue.has_value()) {
        return "only some of the properties red, green and blue in the element 'vertex'";
    }
    if (columns.red) {
        const PlyType type = vertex.properties[*columns.red].type;
        if (type == PlyType::UInt8) columns.colorScale = 1.0 / 255;
        if (type == PlyType::UInt16) columns.colorScale = 1.0 / 65535;
    }
    columns.diameter = vertex.find("diameter");
    const auto thickness = vertex.find("thickness");
    if (columns.diameter && thickness) return "both a diameter and a thickness per vertex";
    if (thickness) columns.diameter = thickness;
    columns.transparency = vertex.find("transparency");
    return {};
}

/// Adds one vertex; what is wrong with it, or nothing.
std::string addVertex(const Columns& columns, const std::vector<double>& row, Strands& vertices) {
    const Vec3d position = {row[columns.x], row[columns.y], row[columns.z]};
    if (!isPosition(position)) return "has a position that is not finite";
    vertices.nodes.push_back(toMeters(position));
    if (columns.red) {
        const auto channel = [&](std::size_t column) {
            return static_cast<float>(row[column] * columns.colorScale);
        };
        const Rgb color = {channel(*columns.red), channel(*columns.green), channel(*columns.blue)};
        if (!isColor(color)) return "has a colour that is not finite";
        vertices.colors.push_back(color);
    }
    if (columns.diameter) {
        const double diameter = row[*columns.diameter];
        if (!isDiameter(diameter)) return "has a diameter that is not finite or below 0";
        vertices.diameters.push_back(toMeters(diameter));
    }
    if (columns.transparency) {
        const double transparency = row[*columns.transparency];
        if (!isTransparency(transparency)) return "has a transparency that is not between 0 and 1";
        vertices.transparency.push_back(static_cast<float>(transparency));
    }
    return {};
}

Status readVertices(PlyBody& body, const PlyElement& element, const std::string& file,
                    Strands& vertices) {
    Columns columns;
    if (std::string fault = findColumns(element, columns); !fault.empty()) {
        return badFile(file, std::move(fault));
    }
    vertices.nodes.reserve(element.count);
    return readPlyRows(body, element, file, [&](const std::vector<double>& row) {
        return addVertex(columns, row, vertices);
    });
}

Status readStrands(PlyBody& body, const PlyElement& element, const std::string& file,
                   std::vector<std::uint32_t>& offsets) {
    const auto column = element.find("nsegs");
    if (!column || element.properties[*column].listCount) {
        return badFile(file, "no property nsegs (nodes - 1) in the element 'strand'");
    }
    offsets = {0};
    offsets.reserve(element.count + 1);
    return readPlyRows(body, element, file, [&](const std::vector<double>& row) -> std::string {
        constexpr double most = std::numeric_limits<std::uint32_t>::max();
        const double segments = row[*column];
        if (!(segments >= 0) || segments != std::floor(segments)) {
            return "its nsegs is not a whole number of 0 or more";
        }
        if (offsets.back() + segments + 1 > most) return "its nsegs asks for too many vertices";
        offsets.push_back(static_cast<std::uint32_t>(offsets.back() + segments + 1));
        return {};
    });
}

Status readEdges(PlyBody& body, const PlyElement& element, const std::string& file,
                 std::uint64_t vertexCount, std::vector<Edge>& edges) {
    const auto from = element.find("vertex1"), to = element.find("vertex2");
    if (!from || !to || element.properties[*from].listCount || element.properties[*to].listCount) {
        return badFile(file, "no properties vertex1 and vertex2 in the element 'edge'");
    }
    edges.reserve(element.count);
    const auto isVertex = [&](double index) {
        return index >= 0 && index < static_cast<double>(vertexCount) && index == std::floor(index);
    };
    return readPlyRows(body, element, file, [&](const std::vector<double>& row) -> std::string {
        for (const std::size_t column : {*from, *to}) {
            if (!isVertex(row[column])) {
                return "its " + element.properties[column].name +
                       " is not the index of one of the " + to_string(vertexCount) + " vertices";
            }
        }
        edges.push_back(
            {static_cast<std::uint32_t>(row[*from]), static_cast<std::uint32_t>(row[*to])});
        return {};
    });
}

/// Whether every edge joins neighbours on one strand, as in a file that has both.
bool followStrands(const std::vector<Edge>& edges, const std::vector<std::uint32_t>& offsets) {
    std::vector<bool> isRoot(offsets.back() + std::size_t{1}, false);
    for (const std::uint32_t offset : offsets)
        isRoot[offset] = true;
    return std::ranges::all_of(edges, [&](Edge edge) {
        const std::uint32_t first = std::min(edge[0], edge[1]);
        const std::uint32_t second = std::max(edge[0], edge[1]);
        return second - first == 1 && !isRoot[second];
    });
}

Result<Strands> assemble(Parts parts, const std::string& file) {
    if (!parts.vertices) return badFile(file, "no element 'vertex'");
    const auto count = static_cast<std::uint32_t>(parts.vertices->nodes.size());
    if (parts.offsets) {
        if (parts.offsets->back() != count) {
            return badFile(file, "the file contradicts itself: the nsegs of its strands ask for " +
                                     to_string(parts.offsets->back()) + " vertices, but it has " +
                                     to_string(count));
        }
        if (parts.edges && !followStrands(*parts.edges, *parts.offsets)) {
            return badFile(
                file, "the file contradicts itself: it has edges that do not follow its strands");
        }
        parts.vertices->offsets = *std::move(parts.offsets);
        return *std::move(parts.vertices);
    }
    if (!parts.edges) {
        return badFile(file,
                       "vertices, but neither an element 'strand' nor an element 'edge' "
                       "that says which of them make a strand");
    }
    const Result<Chains> chains = followEdges(count, *parts.edges, file);
    if (!chains) return chains.problems();
    return gather(*parts.vertices, *chains);
}

/// Refuses what cannot be a groom from the header alone, before anything is allocated.
Status checkHeader(const PlyHeader& header, const std::string& file) {
    constexpr std::uint64_t most = std::numeric_limits<std::int32_t>::max();
    for (const PlyElement& element : header.elements) {
        if (element.name == "face" && element.count > 0) {
            return badFile(
                file, "a mesh with " + to_string(element.count) + " faces; a groom has strands");
        }
        if (element.name == "vertex" && element.count > most) {
            return badFile(file, "the header announces " + to_string(element.count) +
                                     " vertices; at most " + to_string(most) + " are possible");
        }
    }
    return std::monostate{};
}

}  // namespace

Result<Strands> parsePly(std::string_view bytes, const std::string& file) {
    const Result<PlyHeader> header = parsePlyHeader(bytes, file);
    if (!header) return header.problems();
    if (Status possible = checkHeader(*header, file); !possible) return possible.problems();

    std::uint64_t vertexCount = 0;
    for (const PlyElement& element : header->elements) {
        if (element.name == "vertex") vertexCount = element.count;
    }
    PlyBody body(*header);
    Parts parts;
    for (const PlyElement& element : header->elements) {
        Status read = checkRoom(body, element, file);
        if (!read) return read.problems();
        if (element.name == "vertex") {
            read = readVertices(body, element, file, parts.vertices.emplace());
        } else if (element.name == "strand") {
            read = readStrands(body, element, file, parts.offsets.emplace());
        } else if (element.name == "edge") {
            read = readEdges(body, element, file, vertexCount, parts.edges.emplace());
        } else {
            read = readPlyRows(body, element, file, [](const auto&) { return std::string(); });
        }
        if (!read) return read.problems();
    }
    if (!body.atEnd()) {
        return badFile(file, "something follows the last row that the header announces",
                       body.line() > 0 ? body.line() + 1 : 0);
    }
    return assemble(std::move(parts), file);
}

}  // namespace kushi
