// SPDX-License-Identifier: Apache-2.0
#include "io/obj_lines.h"

#include <algorithm>
#include <array>

namespace kushi {
namespace {

bool isContinued(std::string_view line) {
    if (line.find('#') != std::string_view::npos) return false;
    const std::size_t last = line.find_last_not_of('\r');
    return last != std::string_view::npos && line[last] == '\\';
}

}  // namespace

bool takeObjStatement(Lines& lines, std::string_view& statement) {
    std::string_view line;
    if (!lines.next(line)) return false;
    const char* begin = line.data();
    while (isContinued(line) && lines.next(line)) {
    }
    const auto size = static_cast<std::size_t>(line.data() + line.size() - begin);
    statement = {begin, size};
    statement = statement.substr(0, statement.find('#'));
    return true;
}

bool isObjDecoration(std::string_view keyword) {
    static constexpr std::array<std::string_view, 17> keywords = {
        "vn",    "vt",       "vp",       "g",          "o",        "s",
        "mg",    "usemtl",   "mtllib",   "usemap",     "maplib",   "lod",
        "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj"};
    return std::ranges::find(keywords, keyword) != keywords.end();
}

bool isObjFreeForm(std::string_view keyword) {
    return keyword == "curv" || keyword == "curv2" || keyword == "surf" || keyword == "cstype";
}

}  // namespace kushi
