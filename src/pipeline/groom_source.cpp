// SPDX-License-Identifier: Apache-2.0
#include "pipeline/groom_source.h"

#include "core/random.h"
#include "pipeline/hair_color.h"

#include <kushi/groom_io.h>

namespace kushi {

namespace {

Problem problemIn(const GroomSource& source, const std::string& message) {
    return atSource(Problem{message, source.path}, source);
}

void addDiameters(Strands& groom, const Hair& hair) {
    for (std::size_t i = 0; i < groom.size(); ++i) {
        const auto nodes = groom.strand(i);
        const double whole = polylineLength(nodes);
        double walked = 0;
        for (std::size_t j = 0; j < nodes.size(); ++j) {
            if (j > 0) walked += length(nodes[j].as<double>() - nodes[j - 1].as<double>());
            const double share = whole > 0 ? walked / whole : 0;
            groom.diameters.push_back(static_cast<float>(hair.diameter * (1 - hair.taper * share)));
        }
    }
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from, std::size_t begin, std::size_t end) {
    if (from.empty()) return;
    to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(begin),
              from.begin() + static_cast<std::ptrdiff_t>(end));
}

}  // namespace

Problem atSource(const Problem& problem, const GroomSource& source) {
    std::string where = problem.file.empty() ? source.path : problem.file;
    if (problem.line > 0) where += ':' + std::to_string(problem.line);
    if (problem.column > 0) where += ':' + std::to_string(problem.column);
    return {"groom: " + where + ": " + problem.message, source.place.file, source.place.line,
            source.place.column, problem.system};
}

Result<Strands> groomOf(const Part& part) {
    const GroomSource& source = *part.groom;
    Result<Strands> groom = readGroom(source.path, source.placement);
    if (!groom) return atSource(groom.problems()[0], source);
    if (groom->size() == 0) return problemIn(source, "the file has no strands");
    if (part.hair.taper > 0 && !groom->diameters.empty()) {
        return problemIn(source,
                         "the file has diameters, which 'taper' does not change; leave it out");
    }
    return groom;
}

Strands subset(const Strands& groom, std::span<const std::uint32_t> which) {
    Strands some;
    for (const std::uint32_t i : which) {
        const std::size_t begin = groom.offsets[i];
        const std::size_t end = groom.offsets[i + 1];
        append(some.nodes, groom.nodes, begin, end);
        append(some.diameters, groom.diameters, begin, end);
        append(some.transparency, groom.transparency, begin, end);
        append(some.colors, groom.colors, begin, end);
        append(some.keys, groom.keys, i, i + 1);
        some.offsets.push_back(static_cast<std::uint32_t>(some.nodes.size()));
    }
    return some;
}

void complete(Strands& groom, const Part& part, std::uint64_t seed) {
    if (groom.keys.empty()) {
        for (std::size_t i = 0; i < groom.size(); ++i)
            groom.keys.push_back(mixKey(seed, i));
    }
    if (groom.diameters.empty()) addDiameters(groom, part.hair);
    if (!groom.colors.empty()) return;
    for (std::size_t i = 0; i < groom.size(); ++i) {
        const auto nodes = groom.strand(i);
        const EllipsoidAngles angles = part.scalp.ellipsoid.angles(nodes[0].as<double>());
        appendHairColors(part, groom.keys[i], angles, nodes, groom.colors);
    }
}

}  // namespace kushi
