// SPDX-License-Identifier: Apache-2.0
#include "io/field_cache.h"

#include "io/content_key.h"
#include "io/field_file.h"

#include <filesystem>
#include <system_error>

namespace kushi {
namespace {

/// Of how fields are computed: to be raised when that changes, so that old files are not taken.
constexpr std::uint64_t method = 1;

std::uint64_t keyOf(std::span<const Solid> solids, const DistanceFieldOptions& options,
                    std::uint64_t seed) {
    ContentKey key(seed);
    key.add(method);
    key.add(std::bit_cast<std::uint64_t>(options.spacing.value_or(0)));
    for (const Solid& solid : solids) {
        key.add(std::bit_cast<std::uint64_t>(solid.offset));
        key.add(std::span<const Vec3f>(solid.mesh.vertices));
        key.add(std::span<const std::array<std::uint32_t, 3>>(solid.mesh.triangles));
    }
    return key.value();
}

std::string hexadecimal(std::uint64_t number) {
    std::string digits;
    for (unsigned shift = 64; shift > 0; shift -= 4)
        digits += "0123456789abcdef"[(number >> (shift - 4)) & 15U];
    return digits;
}

}  // namespace

std::string fieldName(std::span<const Solid> solids, const DistanceFieldOptions& options) {
    return hexadecimal(keyOf(solids, options, 1)) + hexadecimal(keyOf(solids, options, 2));
}

std::string fieldName(std::uint64_t meshKey, double offset) {
    std::string name;
    for (const std::uint64_t seed : {3, 4}) {
        ContentKey key(seed);
        key.add(method);
        key.add(meshKey);
        key.add(std::bit_cast<std::uint64_t>(offset));
        name += hexadecimal(key.value());
    }
    return name;
}

Result<DistanceField> cachedField(const std::string& name, const std::string& folder,
                                  const std::function<Result<DistanceField>()>& make) {
    if (folder.empty()) return make();
    const std::string path = std::filesystem::path(folder) / (name + ".field");
    if (Result<DistanceField> field = readField(path)) return field;
    Result<DistanceField> field = make();
    if (!field || field->empty()) return field;
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
    static_cast<void>(writeField(path, *field));
    return field;
}

}  // namespace kushi
