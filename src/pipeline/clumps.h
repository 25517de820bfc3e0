// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/vec.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace kushi {

/// Places of a scalp that the hair around them gathers at.
class ClumpCentres {
public:
    ClumpCentres() = default;

    /// Some of the roots, so that neighbours stand `size` apart on the average, none nearer than
    /// 0.83 of it to another and no root farther from all. Which, is a matter of the keys alone.
    ///
    /// roots  m, one key each; of all that grows, so that a preview has the same centres
    /// size   m, > 0
    ClumpCentres(std::span<const Vec3d> roots, std::span<const std::uint64_t> keys, double size);

    std::size_t size() const { return points_.size(); }
    Vec3d point(std::size_t i) const { return points_[i]; }
    /// Of the follicle there.
    std::uint64_t key(std::size_t i) const { return keys_[i]; }

    /// The centres about a place, ascending: all within 1.66 sizes, and some that are farther.
    std::vector<std::uint32_t> around(Vec3d place) const;

private:
    bool farFromAll(Vec3d place) const;

    double apart_ = 1;
    std::vector<Vec3d> points_;
    std::vector<std::uint64_t> keys_;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

}  // namespace kushi
