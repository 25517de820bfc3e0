// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace kushi {

/// A point on a tile's pixels: pixel (i, j) is the square [i, i + 1] x [j, j + 1].
struct PixelPoint {
    double x = 0, y = 0;
};

/// The exact area that a polygon covers of each pixel of a square tile: a box filter.
///
/// Every edge adds, to each pixel it passes in a row, how much the area to its right changes there
/// and to the right of that; the sum along the row is the area.
class AreaCoverage {
public:
    explicit AreaCoverage(int size)
        : size_(size), changes_(static_cast<std::size_t>(size) * stride(), 0.0F), rows_(stride()) {}

    /// Calls visit(x, y, area) for each pixel of which anything is covered, area in (0, 1]. Which
    /// way round the corners go does not matter; where the polygon crosses itself, parts that go
    /// round differently cancel.
    template <class Visit>
    void cover(std::span<const PixelPoint> corners, Visit&& visit) {
        top_ = size_;
        bottom_ = -1;
        for (std::size_t i = 0; i < corners.size(); ++i)
            addEdge(corners[i], corners[(i + 1) % corners.size()]);
        for (int y = top_; y <= bottom_; ++y) {
            Row& row = rows_[static_cast<std::size_t>(y)];
            float* changes = changes_.data() + static_cast<std::size_t>(y) * stride();
            float sum = 0;
            for (int x = row.left; x <= row.right; ++x) {
                sum += changes[x];
                changes[x] = 0;
                const float area = sum < 0 ? -sum : sum;
                if (x < size_ && area > rounding) visit(x, y, area < 1 ? area : 1.0F);
            }
            row = {};
        }
    }

private:
    static constexpr float rounding = 1e-6F;

    /// The pixels that edges have passed.
    struct Row {
        int left = 1 << 30, right = -1;
    };

    std::size_t stride() const { return static_cast<std::size_t>(size_) + 2; }

    void addEdge(PixelPoint from, PixelPoint to);
    void addClipped(PixelPoint from, PixelPoint to, float sign);
    void addToRow(int y, double height, double from, double to);

    int size_;
    std::vector<float> changes_;  // row by row, two more than there are pixels
    std::vector<Row> rows_;
    int top_ = 0, bottom_ = -1;
};

}  // namespace kushi
