// SPDX-License-Identifier: Apache-2.0
#include "io/group_names.h"
#include "io/mesh_file.h"
#include "io/obj_lines.h"
#include "io/triangulate.h"
#include "io/values.h"

#include <optional>
#include <utility>

namespace kushi {
namespace {

using std::to_string;

/// Reads statement by statement; each function returns what is wrong, or nothing.
class ObjMeshReader {
public:
    std::string read(std::string_view keyword, std::string_view arguments) {
        if (keyword == "v") return readVector(arguments, "v", faces.points);
        if (keyword == "vn") return readVector(arguments, "vn", faces.normals);
        if (keyword == "vt") return readTexturePoint(arguments);
        if (keyword == "f" || keyword == "fo") return readFace(arguments);
        if (keyword == "g" || keyword == "o" || keyword == "usemtl") {
            readNames(keyword, arguments);
            return {};
        }
        if (isObjFreeForm(keyword)) {
            return "a free-form curve or surface (" + std::string(keyword) +
                   "); export the head as a mesh of polygons";
        }
        if (keyword == "l" || keyword == "p" || isObjDecoration(keyword)) return {};
        return "unknown keyword " + inQuotes(keyword);
    }

    Faces faces;

private:
    static std::string readVector(std::string_view line, const std::string& keyword,
                                  std::vector<Vec3d>& vectors) {
        Vec3d vector;
        for (double* const coordinate : {&vector.x, &vector.y, &vector.z}) {
            const std::string_view word = takeObjWord(line);
            const auto number = parseNumber(word);
            if (!number) {
                return "expected " + keyword + " and three numbers, found " + inQuotes(word);
            }
            *coordinate = *number;
        }
        // A weight or a colour may follow.
        for (auto word = takeObjWord(line); !word.empty(); word = takeObjWord(line)) {
            if (!parseNumber(word)) return "expected numbers only, found " + inQuotes(word);
        }
        if (keyword == "v" && !isPosition(vector)) return "a position that is not finite";
        vectors.push_back(vector);
        return {};
    }

    std::string readTexturePoint(std::string_view line) {
        TexturePoint point;
        float depth = 0;
        for (float* const coordinate : {&point.u, &point.v, &depth}) {
            const std::string_view word = takeObjWord(line);
            if (word.empty() && coordinate != &point.u) break;
            const auto number = parseNumber(word);
            if (!number) return "expected vt and numbers, found " + inQuotes(word);
            *coordinate = static_cast<float>(*number);
        }
        faces.uvs.push_back(point);
        return {};
    }

    void readNames(std::string_view keyword, std::string_view line) {
        std::vector<std::string>& names =
            keyword == "g" ? groups_ : (keyword == "o" ? object_ : material_);
        names.clear();
        for (auto word = takeObjWord(line); !word.empty(); word = takeObjWord(line)) {
            // Groups may be several; the names of objects and materials may have blanks.
            if (keyword == "g" || names.empty()) {
                names.emplace_back(word);
            } else {
                names.back().append(" ").append(word);
            }
        }
        named_ = false;
    }

    std::string useNames() {
        if (named_) return {};
        named_ = true;
        std::vector<std::string> all = groups_;
        for (const auto& names : {object_, material_})
            all.insert(all.end(), names.begin(), names.end());
        return names_.use(std::move(all), faces);
    }

    std::string readFace(std::string_view line) {
        if (std::string fault = useNames(); !fault.empty()) return fault;
        std::vector<Faces::Corner> polygon;
        for (auto word = takeObjWord(line); !word.empty(); word = takeObjWord(line)) {
            Faces::Corner corner;
            if (std::string fault = readCorner(word, corner); !fault.empty()) return fault;
            if (polygon.size() == mostCorners) {
                return "a face of more than " + to_string(mostCorners) +
                       " corners; triangulate the mesh before exporting it";
            }
            polygon.push_back(corner);
        }
        if (polygon.size() < 3) {
            return "a face of " + to_string(polygon.size()) + " corners, expected 3 or more";
        }
        addPolygon(faces, std::move(polygon));
        names_.assign(faces);
        return {};
    }

    /// "point", "point/texture", "point//normal" or "point/texture/normal".
    std::string readCorner(std::string_view word, Faces::Corner& corner) const {
        const std::size_t first = word.find('/');
        const std::size_t second =
            first == std::string_view::npos ? first : word.find('/', first + 1);
        if (std::string fault =
                readIndex(word.substr(0, first), "vertex", faces.points.size(), corner.point);
            !fault.empty()) {
            return fault;
        }
        if (first != std::string_view::npos) {
            // Many a file names texture coordinates that it does not have.
            const std::string_view texture = word.substr(first + 1, second - first - 1);
            std::uint32_t uv = 0;
            if (readIndex(texture, "vt", faces.uvs.size(), uv).empty()) corner.uv = uv;
        }
        if (second == std::string_view::npos) return {};
        return readIndex(word.substr(second + 1), "normal", faces.normals.size(), corner.normal);
    }

    static std::string readIndex(std::string_view word, const char* what, std::size_t size,
                                 std::uint32_t& out) {
        const auto index = parseInteger<std::int64_t>(word);
        if (!index)
            return "expected the index of a " + std::string(what) + ", found " + inQuotes(word);
        const auto count = static_cast<std::int64_t>(size);
        if (*index == 0 || *index > count || *index < -count) {
            return std::string(what) + ' ' + inQuotes(word) + " does not exist; " +
                   to_string(count) + " are defined so far, counted from 1, or backwards from -1";
        }
        out = static_cast<std::uint32_t>(*index > 0 ? *index - 1 : count + *index);
        return {};
    }

    GroupNames names_;
    std::vector<std::string> object_, groups_, material_;  // as the lines so far say
    bool named_ = false;                                   // whether names_ knows them
};

}  // namespace

Result<Faces> parseObjMesh(std::string_view bytes, const std::string& file) {
    Lines lines(bytes);
    ObjMeshReader reader;
    std::string_view statement;
    while (takeObjStatement(lines, statement)) {
        const std::string_view keyword = takeObjWord(statement);
        if (keyword.empty()) continue;
        if (std::string fault = reader.read(keyword, statement); !fault.empty()) {
            return badFile(file, std::move(fault), lines.number());
        }
    }
    return std::move(reader.faces);
}

}  // namespace kushi
