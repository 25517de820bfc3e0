// SPDX-License-Identifier: Apache-2.0
#include <kushi/head.h>

#include <cstring>

#include <gtest/gtest.h>

namespace kushi {
namespace {

std::uint64_t hashed(std::uint64_t hash, const void* from, std::size_t bytes) {
    const auto* byte = static_cast<const unsigned char*>(from);
    for (std::size_t i = 0; i < bytes; ++i)
        hash = (hash ^ byte[i]) * 0x100000001b3U;
    return hash;
}

// If this fails, the mannequin has changed: mannequinKey is to be set to what is found here, so
// that distance fields of the old one are not taken for the new one's.
TEST(Mannequin, HasTheKeyOfItsContents) {
    const Mesh mesh = mannequin();
    std::uint64_t hash = 0xcbf29ce484222325U;
    hash = hashed(hash, mesh.vertices.data(), mesh.vertices.size() * sizeof(Vec3f));
    hash = hashed(hash, mesh.triangles.data(), mesh.triangles.size() * sizeof mesh.triangles[0]);
    EXPECT_EQ(hash, mannequinKey);
}

}  // namespace
}  // namespace kushi
