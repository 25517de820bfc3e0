// SPDX-License-Identifier: Apache-2.0
#include "input.h"

#include "io/atomic_file.h"
#include "pipeline/solids.h"
#include "progress.h"

#include <kushi/groom_io.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace kushi {

namespace {

std::string lowerExtension(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

// Where distance fields are kept.
std::string cacheBeside(const std::string& path) {
    return std::filesystem::path(path).parent_path() / ".kushi";
}

}  // namespace

Result<Solids> solidsFor(const std::string& stylePath, const std::string& groomPath, int threads) {
    const Result<Style> style = stylePath.empty() ? Style{} : readStyle(stylePath);
    if (!style) return style.problems();
    const std::string& beside = stylePath.empty() ? groomPath : stylePath;
    Result<DistanceField> field = solidsOf(*style, cacheBeside(beside), threads);
    if (!field) return field.problems();
    if (field->empty()) {
        return Problem{"has nothing to keep hair out of: no head that collides and no [[collider]]",
                       stylePath};
    }
    return Solids{std::move(*field), frictionsOf(*style)};
}

Result<bool> isStylePath(const std::string& path) {
    if (lowerExtension(path) == ".toml") return true;
    if (isGroomPath(path)) return false;
    return Problem{
        "not a kind of file that Kushi reads; styles end in .toml, grooms in .hair, .ply or .obj",
        path};
}

Result<SettledGroom> settleWithProgress(const Style& style, const std::string& path,
                                        const SettleFlags& flags, bool measurePenetration,
                                        const Mesh* head) {
    ProgressBar bar("settling");
    SettleOptions options;
    options.segments = flags.segments;
    options.count = flags.count;
    if (!flags.method.empty()) {
        options.method = flags.method == "equilibrium" ? Method::Equilibrium : Method::Cantilever;
    }
    options.threads = flags.threads;
    options.measurePenetration = measurePenetration;
    options.cacheFolder = cacheBeside(path);
    options.head = head;
    options.progress = [&bar](double share) { bar.show(share); };
    Result<SettledGroom> groom = settle(style, options);
    if (groom && groom->strands.size() == 0) {
        return Problem{"no hair is left: the regions hold no follicle, or the cuts leave nothing",
                       path};
    }
    if (groom) return groom;
    std::vector<Problem> problems = groom.problems();
    for (Problem& problem : problems) {
        if (problem.file.empty()) problem.file = path;
    }
    return problems;
}

Status hasEnding(const std::string& path, const std::vector<std::string>& endings,
                 const char* what) {
    const std::string extension = lowerExtension(path);
    if (std::find(endings.begin(), endings.end(), extension) != endings.end())
        return std::monostate{};
    std::string list;
    for (const std::string& ending : endings) {
        list += (list.empty() ? "" : ending == endings.back() ? " or " : ", ") + ending;
    }
    return Problem{std::string(what) + " must end in " + list, path};
}

Status checkOutputs(const std::string& output, const std::string& reportPath) {
    if (!reportPath.empty()) {
        Status ending = hasEnding(reportPath, {".json"}, "the report");
        if (!ending) return ending;
    }
    for (const std::string& path : {output, reportPath}) {
        const std::filesystem::path folder = std::filesystem::path(path).parent_path();
        std::error_code unknown;
        if (!folder.empty() && !std::filesystem::is_directory(folder, unknown)) {
            return Problem{.message = "cannot be written: there is no folder " + folder.string(),
                           .file = path,
                           .system = true};
        }
    }
    return std::monostate{};
}

Status writeReport(const std::string& path, const std::string& json) {
    return path.empty() ? Status(std::monostate{}) : writeFileAtomically(path, json);
}

}  // namespace kushi
