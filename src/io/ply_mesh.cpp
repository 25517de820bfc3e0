// SPDX-License-Identifier: Apache-2.0
#include "io/mesh_file.h"
#include "io/ply_body.h"
#include "io/ply_rows.h"
#include "io/triangulate.h"
#include "io/values.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace kushi {
namespace {

using std::to_string;

/// Three columns of numbers, such as x, y and z.
struct VectorColumns {
    std::size_t x = 0, y = 0, z = 0;

    Vec3d of(const std::vector<double>& row) const { return {row[x], row[y], row[z]}; }
};

std::optional<std::size_t> findNumber(const PlyElement& element, const char* name) {
    const auto column = element.find(name);
    return column && !element.properties[*column].listCount ? column : std::nullopt;
}

std::optional<VectorColumns> findVector(const PlyElement& element, const char* x, const char* y,
                                        const char* z) {
    const auto atX = findNumber(element, x), atY = findNumber(element, y),
               atZ = findNumber(element, z);
    if (!atX || !atY || !atZ) return std::nullopt;
    return VectorColumns{*atX, *atY, *atZ};
}

/// Two columns of a vertex's place in a texture.
struct TextureColumns {
    std::size_t u = 0, v = 0;

    TexturePoint of(const std::vector<double>& row) const {
        return {static_cast<float>(row[u]), static_cast<float>(row[v])};
    }
};

/// By the names that programs write: Blender, MeshLab and others.
std::optional<TextureColumns> findTexture(const PlyElement& element) {
    for (const auto& [u, v] :
         {std::pair("s", "t"), std::pair("texture_u", "texture_v"), std::pair("u", "v")}) {
        const auto atU = findNumber(element, u), atV = findNumber(element, v);
        if (atU && atV) return TextureColumns{*atU, *atV};
    }
    return std::nullopt;
}

Status readVertices(PlyBody& body, const PlyElement& element, const std::string& file,
                    Faces& faces) {
    const auto position = findVector(element, "x", "y", "z");
    if (!position) return badFile(file, "no properties x, y and z in the element 'vertex'");
    const auto normal = findVector(element, "nx", "ny", "nz");
    faces.points.reserve(element.count);
    if (normal) faces.normals.reserve(element.count);
    const auto texture = findTexture(element);
    return readPlyRows(body, element, file, [&](const std::vector<double>& row) -> std::string {
        faces.points.push_back(position->of(row));
        if (normal) faces.normals.push_back(normal->of(row));
        if (texture) faces.uvs.push_back(texture->of(row));
        return isPosition(faces.points.back()) ? "" : "has a position that is not finite";
    });
}

/// Takes the corners of polygons.
class PolygonReader {
public:
    PolygonReader(Faces& faces, std::uint64_t vertexCount)
        : faces_(faces), vertexCount_(vertexCount), ofVertices_(!faces.uvs.empty()) {}

    /// Adds a polygon of vertices; what is wrong with it, or nothing.
    ///
    /// texture  u and v of its corners, one after the other; any other number of them does not
    ///          count
    std::string add(std::span<const double> indices, std::span<const double> texture) {
        if (indices.size() < 3 || indices.size() > mostCorners) {
            return "has " + to_string(indices.size()) + " corners, expected 3 to " +
                   to_string(mostCorners);
        }
        std::vector<Faces::Corner> polygon;
        for (const double index : indices) {
            if (!(index >= 0 && index < static_cast<double>(vertexCount_)) ||
                index != std::floor(index)) {
                return "a corner is not the index of one of the " + to_string(vertexCount_) +
                       " vertices";
            }
            const auto vertex = static_cast<std::uint32_t>(index);
            polygon.push_back({vertex, faces_.normals.empty() ? Faces::none : vertex,
                               ofVertices_ ? vertex : Faces::none});
        }
        if (texture.size() == 2 * indices.size()) {
            for (std::size_t k = 0; k < polygon.size(); ++k) {
                polygon[k].uv = static_cast<std::uint32_t>(faces_.uvs.size());
                faces_.uvs.push_back(
                    {static_cast<float>(texture[2 * k]), static_cast<float>(texture[2 * k + 1])});
            }
        }
        addPolygon(faces_, std::move(polygon));
        return {};
    }

private:
    Faces& faces_;
    std::uint64_t vertexCount_;
    bool ofVertices_;  // whether vertices have a place in the texture
};

/// What the list of a column holds, of all that the lists of a row hold.
std::span<const double> listOf(const PlyElement& element, const std::vector<double>& row,
                               std::span<const double> items, std::size_t column) {
    const auto size = [&](std::size_t i) {
        return element.properties[i].listCount ? static_cast<std::size_t>(std::max(row[i], 0.0))
                                               : 0;
    };
    // The lists of the properties before it come first.
    std::size_t begin = 0;
    for (std::size_t i = 0; i < column; ++i)
        begin += size(i);
    return items.subspan(begin, size(column));
}

Status readFaces(PlyBody& body, const PlyElement& element, const std::string& file, Faces& faces) {
    auto column = element.find("vertex_indices");
    if (!column) column = element.find("vertex_index");
    if (!column || !element.properties[*column].listCount) {
        return badFile(file, "no list vertex_indices in the element 'face'");
    }
    const auto texture = element.find("texcoord");
    PolygonReader polygons(faces, faces.points.size());
    std::vector<double> items;
    return readPlyRows(
        body, element, file,
        [&](const std::vector<double>& row) {
            return polygons.add(
                listOf(element, row, items, *column),
                texture ? listOf(element, row, items, *texture) : std::span<const double>());
        },
        &items);
}

}  // namespace

Result<Faces> parsePlyMesh(std::string_view bytes, const std::string& file) {
    const Result<PlyHeader> header = parsePlyHeader(bytes, file);
    if (!header) return header.problems();
    PlyBody body(*header);
    Faces faces;
    bool hasFaces = false;
    for (const PlyElement& element : header->elements) {
        Status read = checkRoom(body, element, file);
        if (!read) return read.problems();
        if (element.name == "vertex") {
            if (element.count > std::numeric_limits<std::int32_t>::max()) {
                return badFile(file,
                               "the header announces " + to_string(element.count) + " vertices");
            }
            read = readVertices(body, element, file, faces);
        } else if (element.name == "face") {
            if (element.count > 0 && faces.points.empty()) {
                return badFile(file, "faces, but no element 'vertex' before them");
            }
            hasFaces = element.count > 0;
            read = readFaces(body, element, file, faces);
        } else {
            read = readPlyRows(body, element, file, [](const auto&) { return std::string(); });
        }
        if (!read) return read.problems();
    }
    if (!body.atEnd()) {
        return badFile(file, "something follows the last row that the header announces",
                       body.line() > 0 ? body.line() + 1 : 0);
    }
    const bool hasStrands = std::ranges::any_of(header->elements, [](const PlyElement& element) {
        return element.name == "strand" || element.name == "edge";
    });
    if (!hasFaces && hasStrands) {
        return badFile(file, "no faces: this file holds strands, and a head is a mesh of faces");
    }
    return faces;
}

}  // namespace kushi
