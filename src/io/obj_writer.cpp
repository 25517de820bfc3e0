// SPDX-License-Identifier: Apache-2.0
#include "io/obj_file.h"
#include "io/text.h"
#include "io/values.h"
#include "io/writable.h"

#include <array>
#include <charconv>
#include <cstdint>

namespace kushi {
namespace {

void appendNumber(std::string& text, double value) {
    std::array<char, 32> digits{};
    // What tells every float from the next.
    constexpr int significant = 9;
    const auto end =
        std::to_chars(digits.begin(), digits.end(), value, std::chars_format::general, significant);
    text.append(digits.data(), end.ptr);
}

void appendIndex(std::string& text, std::uint64_t value) {
    std::array<char, 20> digits{};
    text.append(digits.data(), std::to_chars(digits.begin(), digits.end(), value).ptr);
}

}  // namespace

Result<std::string> formatObj(const Strands& strands, const std::string& file) {
    if (Status writable = checkWritable(strands, file); !writable) return writable.problems();
    if (strands.size() == 0) {
        return badFile(file, "an .obj file cannot hold a groom without strands");
    }
    std::string text = "# Kushi, centimetres, y up\n";
    text.reserve(text.size() + strands.nodes.size() * 48);
    for (const Vec3f node : strands.nodes) {
        const Vec3d position = toCentimeters(node);
        text += 'v';
        for (const double coordinate : {position.x, position.y, position.z}) {
            text += ' ';
            appendNumber(text, coordinate);
        }
        text += '\n';
    }
    for (std::size_t i = 0; i < strands.size(); ++i) {
        // A polyline has two vertices at least; a point has one.
        text += strands.strand(i).size() == 1 ? 'p' : 'l';
        for (std::uint64_t node = strands.offsets[i]; node < strands.offsets[i + 1]; ++node) {
            text += ' ';
            appendIndex(text, node + 1);
        }
        text += '\n';
    }
    return text;
}

}  // namespace kushi
