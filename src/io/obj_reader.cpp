// SPDX-License-Identifier: Apache-2.0
#include "io/chains.h"
#include "io/obj_file.h"
#include "io/obj_lines.h"
#include "io/text.h"
#include "io/values.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace kushi {
namespace {

using std::to_string;

/// Reads statement by statement; each function returns what is wrong, or nothing.
class ObjReader {
public:
    std::string read(std::string_view keyword, std::string_view arguments) {
        if (keyword == "v") return readVertex(arguments);
        if (keyword == "l") return readPolyline(arguments);
        if (keyword == "p") return readPoints(arguments);
        if (keyword == "f" || keyword == "fo") {
            return "a face; a groom has polylines (l) only: export the hair alone, as curves or "
                   "lines";
        }
        if (isObjFreeForm(keyword)) {
            return "a free-form curve or surface (" + std::string(keyword) +
                   "); a groom has polylines (l) only";
        }
        if (!isObjDecoration(keyword)) return "unknown keyword " + inQuotes(keyword);
        if (keyword == "o" || keyword == "g") chaining_ = false;
        return {};
    }

    /// What is wrong with the whole, or nothing.
    std::string finish() const {
        constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max();
        if (std::max(used_.size(), chains_.order.size()) > most) {
            return "more than " + to_string(most) + " vertices";
        }
        if (chains_.order.empty()) {
            return "no polyline (l) among " + to_string(vertices_.nodes.size()) + " vertices (v)";
        }
        const auto unused = std::ranges::find(used_, false);
        if (unused != used_.end()) {
            return "vertex " + to_string(unused - used_.begin() + 1) + " of " +
                   to_string(used_.size()) +
                   " is on no polyline (l); the file is cut short, or holds more than strands";
        }
        return {};
    }

    Strands strands() const { return gather(vertices_, chains_); }

private:
    std::string readVertex(std::string_view line) {
        std::array<double, 3> position{};
        for (double& coordinate : position) {
            const std::string_view word = takeObjWord(line);
            const auto number = parseNumber(word);
            if (!number) return "expected v and three numbers, found " + inQuotes(word);
            coordinate = *number;
        }
        // A weight or a colour may follow.
        for (auto word = takeObjWord(line); !word.empty(); word = takeObjWord(line)) {
            if (!parseNumber(word)) return "expected numbers only, found " + inQuotes(word);
        }
        const Vec3d centimeters = {position[0], position[1], position[2]};
        if (!isPosition(centimeters)) return "a position that is not finite";
        vertices_.nodes.push_back(toMeters(centimeters));
        used_.push_back(false);
        return {};
    }

    std::string readPolyline(std::string_view line) {
        const std::size_t begin = chains_.order.size();
        if (std::string fault = takeIndices(line); !fault.empty()) return fault;
        const std::size_t count = chains_.order.size() - begin;
        if (count == 0) return "expected l and the indices of vertices, found nothing";

        if (chaining_ && count == 2 && chains_.order[begin] == chains_.order[begin - 1]) {
            chains_.order.erase(chains_.order.end() - 2);
            chains_.offsets.pop_back();
        }
        endStrand();
        chaining_ = count == 2;
        return {};
    }

    std::string readPoints(std::string_view line) {
        const std::size_t begin = chains_.order.size();
        if (std::string fault = takeIndices(line); !fault.empty()) return fault;
        const std::vector<std::uint32_t> points(
            chains_.order.begin() + static_cast<std::ptrdiff_t>(begin), chains_.order.end());
        if (points.empty()) return "expected p and the indices of vertices, found nothing";
        for (std::size_t i = 0; i < points.size(); ++i) {
            chains_.offsets.push_back(static_cast<std::uint32_t>(begin + i + 1));
        }
        chaining_ = false;
        return {};
    }

    /// Appends the vertices that the words name.
    std::string takeIndices(std::string_view line) {
        const auto count = static_cast<std::int64_t>(used_.size());
        for (auto word = takeObjWord(line); !word.empty(); word = takeObjWord(line)) {
            const std::size_t slash = word.find('/');
            const auto index = parseInteger<std::int64_t>(word.substr(0, slash));
            if (!index || (slash != std::string_view::npos &&
                           !parseInteger<std::int64_t>(word.substr(slash + 1)))) {
                return "expected the index of a vertex, found " + inQuotes(word);
            }
            if (*index == 0 || *index > count || *index < -count) {
                return "vertex " + inQuotes(word) + " does not exist; " + to_string(count) +
                       " are defined so far, counted from 1, or backwards from -1";
            }
            const auto vertex =
                static_cast<std::uint32_t>(*index > 0 ? *index - 1 : count + *index);
            chains_.order.push_back(vertex);
            used_[vertex] = true;
        }
        return {};
    }

    void endStrand() {
        chains_.offsets.push_back(static_cast<std::uint32_t>(chains_.order.size()));
    }

    Strands vertices_;
    std::vector<bool> used_;  // per vertex
    Chains chains_;
    bool chaining_ = false;  // the last strand is made of lines of two vertices
};

}  // namespace

Result<Strands> parseObj(std::string_view text, const std::string& file) {
    Lines lines(text);
    ObjReader reader;
    std::string_view statement;
    while (takeObjStatement(lines, statement)) {
        const std::string_view keyword = takeObjWord(statement);
        if (keyword.empty()) continue;
        if (std::string fault = reader.read(keyword, statement); !fault.empty()) {
            return badFile(file, std::move(fault), lines.number());
        }
    }
    if (std::string fault = reader.finish(); !fault.empty()) {
        return badFile(file, std::move(fault), lines.number());
    }
    return reader.strands();
}

}  // namespace kushi
