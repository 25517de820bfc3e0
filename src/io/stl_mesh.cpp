// SPDX-License-Identifier: Apache-2.0
#include "io/bytes.h"
#include "io/mesh_file.h"
#include "io/text.h"
#include "io/values.h"

#include <cstdint>
#include <utility>

// Normals of facets say nothing that the corners do not, and many programs write zeros.

namespace kushi {
namespace {

using std::to_string;

constexpr std::size_t headerSize = 80 + sizeof(std::uint32_t);
constexpr std::size_t facetSize = 12 * sizeof(float) + sizeof(std::uint16_t);

std::uint64_t binarySize(std::string_view bytes) {
    return headerSize + std::uint64_t{facetSize} * load<std::uint32_t>(bytes.data() + 80);
}

void addFacet(Faces& faces) {
    const auto end = static_cast<std::uint32_t>(faces.points.size());
    faces.triangles.push_back({{{end - 3}, {end - 2}, {end - 1}}});
}

Result<Faces> parseBinary(std::string_view bytes, const std::string& file) {
    if (bytes.size() < headerSize) {
        return badFile(file, "not an STL file: it neither starts with 'solid' nor has the " +
                                 to_string(headerSize) + " bytes of a binary header");
    }
    const auto count = load<std::uint32_t>(bytes.data() + 80);
    if (const std::uint64_t expected = binarySize(bytes); bytes.size() != expected) {
        return badFile(
            file, (bytes.size() < expected ? "cut short, or not an STL file: "
                                           : "bytes after the last facet, or not an STL file: ") +
                      to_string(bytes.size()) + " bytes, but a header with " + to_string(count) +
                      " facets asks for " + to_string(expected));
    }
    Faces faces;
    faces.points.reserve(3 * std::size_t{count});
    faces.triangles.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const char* at = bytes.data() + headerSize + i * facetSize;
        for (std::size_t corner = 1; corner <= 3; ++corner) {
            const char* vector = at + corner * 3 * sizeof(float);
            const Vec3d point = {load<float>(vector), load<float>(vector + sizeof(float)),
                                 load<float>(vector + 2 * sizeof(float))};
            if (!isPosition(point)) {
                return badFile(file, "facet " + to_string(i) +
                                         " (counted from 0) has a position that is not finite");
            }
            faces.points.push_back(point);
        }
        addFacet(faces);
    }
    return faces;
}

std::string lowerCase(std::string_view word) {
    std::string lower(word);
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return lower;
}

/// Reads line by line; what is wrong, or nothing.
class StlTextReader {
public:
    std::string read(std::string_view line) {
        const std::string keyword = lowerCase(takeWord(line));
        if (keyword == "vertex") return readVertex(line);
        if (keyword == "facet") return open(inFacet_, "facet");
        if (keyword == "endfacet") return closeFacet();
        if (keyword == "solid") return open(inSolid_, "solid");
        if (keyword == "endsolid") {
            inSolid_ = false;
            return inFacet_ ? "found 'endsolid', expected 'endfacet' first" : "";
        }
        if (keyword.empty() || keyword == "outer" || keyword == "endloop") return {};
        return "expected a line such as 'vertex 1 2 3', found " + inQuotes(keyword);
    }
    bool atEnd() const { return !inSolid_; }

    Faces faces;

private:
    static std::string open(bool& inside, const std::string& what) {
        if (inside) return "found '" + what + "', expected 'end" + what + "' first";
        inside = true;
        return {};
    }

    std::string readVertex(std::string_view line) {
        if (!inFacet_) return "found a vertex outside of a facet";
        Vec3d point;
        for (double* const coordinate : {&point.x, &point.y, &point.z}) {
            const std::string_view word = takeWord(line);
            const auto number = parseNumber(word);
            if (!number) return "expected 'vertex' and three numbers, found " + inQuotes(word);
            *coordinate = *number;
        }
        if (!isPosition(point)) return "a position that is not finite";
        faces.points.push_back(point);
        ++corners_;
        return {};
    }

    std::string closeFacet() {
        if (!inFacet_ || corners_ != 3) {
            return "a facet of " + to_string(corners_) + " vertices, expected 3";
        }
        inFacet_ = false;
        corners_ = 0;
        addFacet(faces);
        return {};
    }

    bool inSolid_ = false;
    bool inFacet_ = false;
    std::size_t corners_ = 0;
};

Result<Faces> parseText(std::string_view bytes, const std::string& file) {
    Lines lines(bytes);
    StlTextReader reader;
    std::string_view line;
    while (lines.next(line)) {
        if (std::string fault = reader.read(line); !fault.empty()) {
            return badFile(file, std::move(fault), lines.number());
        }
    }
    if (!reader.atEnd())
        return badFile(file, "cut short: no 'endsolid' at the end", lines.number());
    return std::move(reader.faces);
}

}  // namespace

Result<Faces> parseStlMesh(std::string_view bytes, const std::string& file) {
    // Many binary files start with "solid", too, but only they have the size that they announce.
    const bool isBinary = bytes.size() >= headerSize && bytes.size() == binarySize(bytes);
    std::string_view start = bytes.substr(0, 256);
    const bool isText = lowerCase(takeWord(start)) == "solid";
    return isText && !isBinary ? parseText(bytes, file) : parseBinary(bytes, file);
}

}  // namespace kushi
