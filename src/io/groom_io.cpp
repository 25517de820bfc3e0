// SPDX-License-Identifier: Apache-2.0
#include "io/atomic_file.h"
#include "io/extension.h"
#include "io/hair_file.h"
#include "io/obj_file.h"
#include "io/ply_file.h"
#include "io/text.h"

#include <kushi/groom_io.h>

#include <algorithm>
#include <array>
#include <new>
#include <string_view>

namespace kushi {
namespace {

struct Format {
    std::string_view extension;
    Result<Strands> (*parse)(std::string_view bytes, const std::string& file);
    Result<std::string> (*format)(const Strands& strands, const std::string& file);
};

constexpr std::array<Format, 3> formats = {{
    {".hair", parseHair, formatHair},
    {".ply", parsePly, formatPly},
    {".obj", parseObj, formatObj},
}};

const Format* formatOf(const std::string& path) {
    const auto* const found = std::ranges::find(formats, lowerExtension(path), &Format::extension);
    return found == formats.end() ? nullptr : found;
}

Problem unknownFormat(const std::string& path) {
    const std::string extension = lowerExtension(path);
    return badFile(
        path, (extension.empty() ? "no extension" : "unknown extension " + inQuotes(extension)) +
                  "; strand files are .hair, .ply or .obj");
}

Problem outOfMemory(const std::string& path) {
    return {.message = "not enough memory for this groom", .file = path, .system = true};
}

// Formats are read as centimetres.
void place(Strands& groom, const GroomPlacement& placement) {
    const double scale = placement.unit.value_or(0.01) / 0.01;
    const Vec3d right = cross(placement.front, placement.up);
    for (Vec3f& node : groom.nodes) {
        const Vec3d own = node.as<double>();
        const Vec3d turned = {dot(own, placement.front), dot(own, placement.up), dot(own, right)};
        node = (scale * turned + placement.offset).as<float>();
    }
    for (float& diameter : groom.diameters)
        diameter = static_cast<float>(scale * diameter);
}

}  // namespace

bool isGroomPath(const std::string& path) {
    return formatOf(path) != nullptr;
}

Result<Strands> readGroom(const std::string& path) try {
    const Format* format = formatOf(path);
    if (format == nullptr) return unknownFormat(path);
    const Result<std::string> bytes = readFile(path);
    if (!bytes) return bytes.problems();
    if (bytes->empty()) return badFile(path, "the file is empty");
    return format->parse(*bytes, path);
} catch (const std::bad_alloc&) {
    return outOfMemory(path);
}

Result<Strands> readGroom(const std::string& path, const GroomPlacement& placement) {
    Result<Strands> groom = readGroom(path);
    if (!groom) return groom;
    place(*groom, placement);
    if (!std::ranges::all_of(groom->nodes, isFinite<float>))
        return badFile(path, "a node lies too far away in this unit");
    return groom;
}

Status writeGroom(const Strands& strands, const std::string& path) try {
    const Format* format = formatOf(path);
    if (format == nullptr) return unknownFormat(path);
    const Result<std::string> bytes = format->format(strands, path);
    if (!bytes) return bytes.problems();
    return writeFileAtomically(path, *bytes);
} catch (const std::bad_alloc&) {
    return outOfMemory(path);
}

}  // namespace kushi
