// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pipeline/clumps.h"
#include "pipeline/layers.h"

#include <kushi/follicles.h>
#include <kushi/strands.h>

#include <optional>

namespace kushi {

/// What a part's hair comes from.
struct PartSource {
    Follicles follicles;           ///< of hair that grows
    std::optional<Strands> groom;  ///< else; with keys, diameters and colours
    LayerMap layers = {};          ///< what the hair that grows lies on
    ClumpCentres clumps = {};      ///< of all the style's own strands
    double standsFor = 1;          ///< how many of the style's own each stands for

    std::size_t size() const { return groom ? groom->size() : follicles.size(); }
};

/// The sources of every part, with as many strands in all as asked for: in proportion to what the
/// parts have, but no more of a groom than its file has.
///
/// head  of the style; null: it is read or made if hair grows from it
Result<std::vector<PartSource>> sourcesOf(const Style& style, std::optional<std::size_t> count,
                                          const Mesh* head);

}  // namespace kushi
