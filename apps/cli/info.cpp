// SPDX-License-Identifier: Apache-2.0
#include "commands.h"
#include "input.h"
#include "messages.h"

#include <kushi/groom_io.h>

#include <cstdio>

#include <nlohmann/json.hpp>

namespace kushi {

namespace {

nlohmann::ordered_json inCentimetres(Vec3f v) {
    return {100.0 * v.x, 100.0 * v.y, 100.0 * v.z};
}

void printJson(const GroomSummary& summary) {
    nlohmann::ordered_json json;
    json["strands"] = summary.strands;
    json["nodes"] = summary.nodes;
    json["segments"] = summary.segments;
    json["length_cm"] = {{"min", 100 * summary.minLength},
                         {"mean", 100 * summary.meanLength},
                         {"max", 100 * summary.maxLength}};
    json["bounds_cm"] = nullptr;
    if (!summary.bounds.empty()) {
        json["bounds_cm"] = {{"min", inCentimetres(summary.bounds.low)},
                             {"max", inCentimetres(summary.bounds.high)}};
    }
    json["attributes"] = summary.attributes;
    std::printf("%s\n", json.dump(2).c_str());
}

void printTable(const std::string& path, const GroomSummary& summary) {
    std::printf("%s\n  strands     %s\n  segments    %s\n", path.c_str(),
                grouped(summary.strands).c_str(), grouped(summary.segments).c_str());
    if (summary.strands == 0) return;
    std::printf("  length      %.2f to %.2f cm, mean %.2f\n", 100 * summary.minLength,
                100 * summary.maxLength, 100 * summary.meanLength);
    const Vec3f low = 100.0F * summary.bounds.low;
    const Vec3f high = 100.0F * summary.bounds.high;
    std::printf("  bounds      x %.2f to %.2f, y %.2f to %.2f, z %.2f to %.2f cm\n", low.x, high.x,
                low.y, high.y, low.z, high.z);
    std::string names;
    for (const std::string& name : summary.attributes)
        names += (names.empty() ? "" : ", ") + name;
    std::printf("  attributes  %s\n", names.empty() ? "none" : names.c_str());
}

}  // namespace

int runInfo(const std::string& path, bool json) {
    const Result<bool> isStyle = isStylePath(path);
    if (!isStyle) return report(isStyle.problems());
    Strands strands;
    if (*isStyle) {
        const Result<Style> style = readStyle(path);
        if (!style) return report(style.problems());
        Result<SettledGroom> groom = settleWithProgress(*style, path, {}, false);
        if (!groom) return report(groom.problems());
        strands = std::move(groom->strands);
    } else {
        Result<Strands> read = readGroom(path);
        if (!read) return report(read.problems());
        strands = std::move(*read);
    }
    const GroomSummary summary = summarize(strands);
    if (json) {
        printJson(summary);
    } else {
        printTable(path, summary);
    }
    return Done;
}

}  // namespace kushi
