// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/parallel.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kushi {

/// A range of tiles, [begin, end).
struct TileRange {
    std::size_t begin = 0, end = 0;
};

/// Which items (segments, triangles) touch which tile, in ascending order. Found in two rounds that
/// both go through all items: one counts, one fills. Only the lists of some tiles are held at a
/// time.
class TileLists {
public:
    /// Counts. enumerate(begin, end, emit) goes through sources [begin, end) (strands, triangles)
    /// and calls emit(tile, item) for each tile an item touches.
    template <class Enumerate>
    TileLists(std::size_t sources, std::size_t tiles, int threads, const Enumerate& enumerate)
        : sources_(sources),
          tiles_(tiles),
          threads_(threads),
          grain_(sources / pieces + 1),
          counts_(pieces * tiles) {
        parallelFor(sources, grain_, threads, [&](std::size_t begin, std::size_t end) {
            std::uint32_t* counts = countsOf(begin);
            enumerate(begin, end, [&](std::size_t tile, std::uint32_t) { ++counts[tile]; });
        });
    }

    /// Length of a tile's list.
    std::size_t count(std::size_t tile) const {
        std::size_t sum = 0;
        for (std::size_t i = 0; i < pieces; ++i)
            sum += counts_[i * tiles_ + tile];
        return sum;
    }

    /// Fills the lists of some tiles, with the same enumerate as before.
    template <class Enumerate>
    void fill(TileRange range, const Enumerate& enumerate) {
        range_ = range;
        starts_.assign(range.end - range.begin + 1, 0);
        std::vector<std::size_t> next = layOut();
        items_.resize(starts_.back());
        parallelFor(sources_, grain_, threads_, [&](std::size_t begin, std::size_t end) {
            std::size_t* place = next.data() + begin / grain_ * (range.end - range.begin);
            enumerate(begin, end, [&](std::size_t tile, std::uint32_t item) {
                if (tile < range.begin || tile >= range.end) return;
                items_[place[tile - range.begin]++] = item;
            });
        });
    }

    /// Of a tile in the range filled.
    std::span<const std::uint32_t> items(std::size_t tile) const {
        const std::size_t i = tile - range_.begin;
        return std::span(items_).subspan(starts_[i], starts_[i + 1] - starts_[i]);
    }

private:
    static constexpr std::size_t pieces = 64;  // of the sources, whatever the number of threads

    std::uint32_t* countsOf(std::size_t begin) { return counts_.data() + begin / grain_ * tiles_; }

    /// Where each piece's items of each tile begin.
    std::vector<std::size_t> layOut() {
        const std::size_t width = range_.end - range_.begin;
        std::vector<std::size_t> next(pieces * width);
        std::size_t place = 0;
        for (std::size_t i = 0; i < width; ++i) {
            starts_[i] = place;
            for (std::size_t piece = 0; piece < pieces; ++piece) {
                next[piece * width + i] = place;
                place += counts_[piece * tiles_ + range_.begin + i];
            }
        }
        starts_[width] = place;
        return next;
    }

    std::size_t sources_, tiles_;
    int threads_;
    std::size_t grain_;
    std::vector<std::uint32_t> counts_;  // per piece and tile
    TileRange range_;
    std::vector<std::size_t> starts_;
    std::vector<std::uint32_t> items_;
};

}  // namespace kushi
