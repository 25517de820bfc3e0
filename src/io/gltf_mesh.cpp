// SPDX-License-Identifier: Apache-2.0
#include "io/affine.h"
#include "io/gltf_document.h"
#include "io/group_names.h"
#include "io/mesh_file.h"
#include "io/text.h"
#include "io/values.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace kushi {
namespace {

using std::to_string;

// Small files can ask for much: a mesh may stand on any number of nodes.
constexpr std::uint64_t mostElements = 20'000'000;

/// Puts an array of finite numbers into `out`, which stays where the key is missing.
template <std::size_t Size>
std::string takeNumbers(const Json& object, const char* key, std::array<double, Size>& out) {
    const Json* value = member(object, key);
    if (value == nullptr) return {};
    if (!value->is_array() || value->size() != Size) {
        return std::string(key) + " is not an array of " + to_string(Size);
    }
    for (std::size_t i = 0; i < Size; ++i) {
        if (!(*value)[i].is_number()) return std::string(key) + " holds what is no number";
        out[i] = (*value)[i].template get<double>();
    }
    return {};
}

Affine fromMatrix(const std::array<double, 16>& m) {
    return {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
}

// A unit quaternion's rotation; files round, so it is made one.
Affine fromQuaternion(std::array<double, 4> q) {
    const double size = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
    if (!(size > 0)) return {};
    const double x = q[0] / size, y = q[1] / size, z = q[2] / size, w = q[3] / size;
    return {{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
            {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
            {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)},
            {}};
}

/// A node's own transform; what is wrong with it, or nothing.
std::string takeTransform(const Json& node, Affine& out) {
    if (member(node, "matrix") != nullptr) {
        std::array<double, 16> matrix{};
        std::string fault = takeNumbers(node, "matrix", matrix);
        out = fromMatrix(matrix);
        return fault;
    }
    std::array<double, 3> shift = {0, 0, 0};
    std::array<double, 4> rotation = {0, 0, 0, 1};
    std::array<double, 3> scale = {1, 1, 1};
    for (std::string fault :
         {takeNumbers(node, "translation", shift), takeNumbers(node, "rotation", rotation),
          takeNumbers(node, "scale", scale)}) {
        if (!fault.empty()) return fault;
    }
    out = fromQuaternion(rotation);
    out.x *= scale[0];
    out.y *= scale[1];
    out.z *= scale[2];
    out.shift = {shift[0], shift[1], shift[2]};
    return {};
}

enum Mode : std::uint64_t { TriangleList = 4, TriangleStrip = 5, TriangleFan = 6 };

/// Walks the nodes of the scene; each function returns what is wrong, or nothing.
class GltfMeshReader {
public:
    explicit GltfMeshReader(GltfDocument& document) : document_(document) {}

    std::string read() {
        std::vector<Visit> todo;
        if (std::string fault = findRoots(todo); !fault.empty()) return fault;
        while (!todo.empty()) {
            const Visit visit = todo.back();
            todo.pop_back();
            if (std::string fault = readNode(visit, todo); !fault.empty()) {
                return "node " + to_string(visit.node) + ": " + fault;
            }
        }
        return {};
    }

    Faces faces;

private:
    struct Visit {
        std::uint64_t node = 0;
        Affine parent;
    };

    /// The nodes of the scene that is shown; where there are no scenes, those without a parent.
    std::string findRoots(std::vector<Visit>& todo) {
        const Json* nodes = member(document_.root(), "nodes");
        visited_.assign(nodes != nullptr && nodes->is_array() ? nodes->size() : 0, false);
        std::uint64_t shown = 0;
        if (std::string fault = takeWhole(document_.root(), "scene", shown); !fault.empty()) {
            return fault;
        }
        if (const Json* scene = document_.item("scenes", shown)) {
            return addNodes(*scene, "nodes", {}, todo);
        }
        std::vector<bool> isChild(visited_.size(), false);
        for (std::size_t i = 0; i < visited_.size(); ++i) {
            const Json* children = member((*nodes)[i], "children");
            if (children == nullptr || !children->is_array()) continue;
            for (const Json& child : *children) {
                if (child.is_number_unsigned() && child.get<std::uint64_t>() < isChild.size()) {
                    isChild[child.get<std::uint64_t>()] = true;
                }
            }
        }
        for (std::size_t i = isChild.size(); i > 0; --i) {
            if (!isChild[i - 1]) todo.push_back({i - 1, {}});
        }
        return {};
    }

    /// Adds the nodes that a list names, the first one last: the next to be taken.
    static std::string addNodes(const Json& object, const char* key, const Affine& parent,
                                std::vector<Visit>& todo) {
        const Json* list = member(object, key);
        if (list == nullptr) return {};
        if (!list->is_array()) return std::string(key) + " is not an array";
        for (auto node = list->rbegin(); node != list->rend(); ++node) {
            if (!node->is_number_unsigned()) return std::string(key) + " holds what is no index";
            todo.push_back({node->get<std::uint64_t>(), parent});
        }
        return {};
    }

    std::string readNode(const Visit& visit, std::vector<Visit>& todo) {
        if (visit.node >= visited_.size()) return "does not exist";
        if (visited_[visit.node]) return "is below two nodes, expected a tree";
        visited_[visit.node] = true;
        const Json& node = *document_.item("nodes", visit.node);

        Affine own;
        if (std::string fault = takeTransform(node, own); !fault.empty()) return fault;
        const Affine place = visit.parent * own;
        if (member(node, "mesh") != nullptr) {
            std::uint64_t mesh = 0;
            if (std::string fault = takeWhole(node, "mesh", mesh); !fault.empty()) return fault;
            // A mesh on a skeleton stands where its bones do, not where its node does.
            const bool skinned = member(node, "skin") != nullptr;
            const Affine where = skinned ? Affine{} : place;
            if (std::string fault = readMesh(mesh, where, nameOf(&node)); !fault.empty()) {
                return "mesh " + to_string(mesh) + ": " + fault;
            }
        }
        return addNodes(node, "children", place, todo);
    }

    static std::string nameOf(const Json* object) {
        const Json* name = object != nullptr ? member(*object, "name") : nullptr;
        return name != nullptr && name->is_string() ? name->get<std::string>() : "";
    }

    std::string readMesh(std::uint64_t index, const Affine& place, const std::string& node) {
        const Json* mesh = document_.item("meshes", index);
        if (mesh == nullptr) return "does not exist";
        const Json* primitives = member(*mesh, "primitives");
        if (primitives == nullptr || !primitives->is_array()) return "has no primitives";
        for (const Json& primitive : *primitives) {
            if (++primitives_ > mostElements) return "more primitives than a head can have";
            std::uint64_t material = std::numeric_limits<std::uint64_t>::max();
            std::string fault = takeWhole(primitive, "material", material);
            if (fault.empty()) {
                const Json* painted = document_.item("materials", material);
                fault = names_.use({node, nameOf(mesh), nameOf(painted)}, faces);
            }
            if (fault.empty()) fault = readPrimitive(primitive, place);
            if (!fault.empty()) return fault;
            names_.assign(faces);
        }
        return {};
    }

    std::string readPrimitive(const Json& primitive, const Affine& place) {
        std::uint64_t mode = TriangleList;
        if (std::string fault = takeWhole(primitive, "mode", mode); !fault.empty()) return fault;
        if (mode > TriangleFan) return "unknown mode " + to_string(mode);
        if (mode < TriangleList) return {};  // points and lines

        const auto first = static_cast<std::uint32_t>(faces.points.size());
        const auto firstNormal = static_cast<std::uint32_t>(faces.normals.size());
        const auto firstUv = static_cast<std::uint32_t>(faces.uvs.size());
        if (std::string fault = readVertices(primitive, place); !fault.empty()) return fault;
        const std::uint64_t count = faces.points.size() - first;
        const bool hasNormals = faces.normals.size() > firstNormal;
        const bool hasUvs = faces.uvs.size() > firstUv;

        std::vector<std::uint32_t> indices;
        if (std::string fault = readIndices(primitive, count, indices); !fault.empty())
            return fault;
        const auto corner = [&](std::size_t i) {
            return Faces::Corner{first + indices[i],
                                 hasNormals ? firstNormal + indices[i] : Faces::none,
                                 hasUvs ? firstUv + indices[i] : Faces::none};
        };
        const std::size_t step = mode == TriangleList ? 3 : 1;
        for (std::size_t i = 0; i + 2 < indices.size(); i += step) {
            Faces::Triangle triangle = {corner(mode == TriangleFan ? 0 : i), corner(i + 1),
                                        corner(i + 2)};
            // Every second triangle of a strip turns the other way round, and so does a mirror.
            const bool odd = mode == TriangleStrip && i % 2 == 1;
            if (odd != place.mirrors()) std::swap(triangle[1], triangle[2]);
            faces.triangles.push_back(triangle);
        }
        return {};
    }

    std::string readVertices(const Json& primitive, const Affine& place) {
        const Json* attributes = member(primitive, "attributes");
        if (attributes == nullptr || member(*attributes, "POSITION") == nullptr) {
            return "a primitive without POSITION";
        }
        std::size_t count = 0;
        std::string fault = readVectors(*attributes, "POSITION", [&](Vec3d p) {
            faces.points.push_back(place.point(p));
            ++count;
            return isPosition(faces.points.back()) ? "" : "a position that is not finite";
        });
        if (fault.empty() && member(*attributes, "NORMAL") != nullptr) {
            std::size_t normals = 0;
            fault = readVectors(*attributes, "NORMAL", [&](Vec3d n) {
                faces.normals.push_back(place.normal(n));
                ++normals;
                return "";
            });
            if (fault.empty() && normals != count) return "not as many normals as positions";
        }
        if (fault.empty() && member(*attributes, "TEXCOORD_0") != nullptr) {
            fault = readNumbers(*attributes, "TEXCOORD_0", "VEC2");
            if (fault.empty() && numbers_.size() != 2 * count)
                return "not as many texture coordinates as positions";
            // glTF counts v from the top.
            for (std::size_t i = 0; i < numbers_.size() && fault.empty(); i += 2)
                faces.uvs.push_back(
                    {static_cast<float>(numbers_[i]), static_cast<float>(1 - numbers_[i + 1])});
        }
        return fault;
    }

    /// Puts what an attribute holds into numbers_.
    std::string readNumbers(const Json& attributes, const char* key, std::string_view type) {
        std::uint64_t accessor = 0, count = 0;
        std::string fault = takeWhole(attributes, key, accessor);
        if (fault.empty()) fault = document_.countOf(accessor, count);
        if (fault.empty()) fault = spend(count);
        if (fault.empty()) fault = document_.read(accessor, type, numbers_);
        return fault;
    }

    /// Calls use(vector) for each of an attribute, which returns what is wrong with it or nothing.
    template <class Use>
    std::string readVectors(const Json& attributes, const char* key, const Use& use) {
        std::string fault = readNumbers(attributes, key, "VEC3");
        for (std::size_t i = 0; i < numbers_.size() && fault.empty(); i += 3) {
            fault = use(Vec3d{numbers_[i], numbers_[i + 1], numbers_[i + 2]});
        }
        return fault;
    }

    /// The vertices of a primitive in the order of its triangles.
    std::string readIndices(const Json& primitive, std::uint64_t vertexCount,
                            std::vector<std::uint32_t>& indices) {
        if (member(primitive, "indices") == nullptr) {
            for (std::uint32_t i = 0; i < vertexCount; ++i)
                indices.push_back(i);
            return {};
        }
        std::string fault = readNumbers(primitive, "indices", "SCALAR");
        if (!fault.empty()) return fault;
        indices.reserve(numbers_.size());
        for (const double index : numbers_) {
            if (!(index >= 0 && index < static_cast<double>(vertexCount)) ||
                index != std::floor(index)) {
                return "an index is not that of one of its " + to_string(vertexCount) + " vertices";
            }
            indices.push_back(static_cast<std::uint32_t>(index));
        }
        return {};
    }

    /// Counts what is about to be read.
    std::string spend(std::uint64_t elements) {
        elements_ += elements;
        if (elements_ <= 3 * mostElements) return {};
        return "more than " + to_string(3 * mostElements) +
               " vertices and corners; reduce the mesh to what can be seen";
    }

    GltfDocument& document_;
    GroupNames names_;
    std::vector<bool> visited_;    // per node
    std::vector<double> numbers_;  // read last
    std::uint64_t primitives_ = 0, elements_ = 0;
};

}  // namespace

Result<Faces> parseGltfMesh(std::string_view bytes, const std::string& file) {
    Result<GltfDocument> document = GltfDocument::parse(bytes, file);
    if (!document) return document.problems();
    GltfMeshReader reader(*document);
    if (std::string fault = reader.read(); !fault.empty()) return badFile(file, std::move(fault));
    return std::move(reader.faces);
}

}  // namespace kushi
