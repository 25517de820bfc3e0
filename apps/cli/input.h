// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands.h"

#include <kushi/settle.h>

#include <string>
#include <vector>

namespace kushi {

/// Whether `path` names a style (.toml); neither style nor groom is a problem.
Result<bool> isStylePath(const std::string& path);

/// Settles the style of `path`, with a progress bar.
///
/// head  of the style, if it is at hand already; else null
Result<SettledGroom> settleWithProgress(const Style& style, const std::string& path,
                                        const SettleFlags& flags, bool measurePenetration,
                                        const Mesh* head = nullptr);

/// What a groom is kept out of.
struct Solids {
    DistanceField field;
    std::vector<float> frictions;  ///< of each
};

/// Those of a style, or the mannequin if `stylePath` is empty. Fields are kept beside the style, or
/// beside `groomPath`.
Result<Solids> solidsFor(const std::string& stylePath, const std::string& groomPath, int threads);

/// Whether `path` ends in one of `endings` (".png"), and the problem if not.
Status hasEnding(const std::string& path, const std::vector<std::string>& endings,
                 const char* what);

/// Whether the outputs of a command can be written where they are to go: their folders exist, and a
/// report ends in .json. To be asked before any work.
Status checkOutputs(const std::string& output, const std::string& reportPath);

/// Writes the --report file, if there is one to write.
Status writeReport(const std::string& path, const std::string& json);

}  // namespace kushi
