// SPDX-License-Identifier: Apache-2.0
#include "io/field_cache.h"

#include "io/field_file.h"
#include "io/temp_folder.h"
#include "io/test_bytes.h"

#include <filesystem>
#include <functional>
#include <limits>
#include <set>

#include <gtest/gtest.h>

namespace kushi {
namespace {

std::vector<Solid> egg() {
    return {{ellipsoidMesh({{0.1, 0.2, 0.3}, {0.03, 0.04, 0.02}, 0.3}, 8), 0.001}};
}

Result<DistanceField> cached(const std::string& folder) {
    return cachedField(fieldName(egg(), {}), folder, [] { return distanceFieldOf(egg()); });
}

TEST(FieldName, FollowsFromEveryContentThatCounts) {
    const std::string name = fieldName(egg(), {});
    EXPECT_EQ(name.size(), 32U);
    EXPECT_EQ(name.find_first_not_of("0123456789abcdef"), std::string::npos);
    EXPECT_EQ(fieldName(egg(), {}), name);
    EXPECT_EQ(fieldName(egg(), {{}, 7}), name);  // threads make no difference

    std::set<std::string> names = {name, fieldName(egg(), {0.003, 0}), fieldName({}, {})};
    const auto addWith = [&names](const std::function<void(std::vector<Solid>&)>& change) {
        std::vector<Solid> solids = egg();
        change(solids);
        names.insert(fieldName(solids, {}));
    };
    addWith([](auto& solids) { solids[0].offset = 0.002; });
    addWith([](auto& solids) { solids[0].mesh.vertices[5].y += 1e-7F; });
    addWith(
        [](auto& solids) { std::swap(solids[0].mesh.triangles[3], solids[0].mesh.triangles[4]); });
    addWith([](auto& solids) { solids[0].mesh.triangles.pop_back(); });
    addWith([](auto& solids) { solids.emplace_back(); });
    addWith([](auto& solids) { solids.push_back(solids[0]); });
    EXPECT_EQ(names.size(), 9U);
}

TEST(CachedField, IsPutThereOnceAndTakenFromThereAfterwards) {
    const test::TempFolder folder;
    const std::string cache = folder.path("made/anew");
    const Result<DistanceField> first = cached(cache);
    ASSERT_TRUE(first.ok());
    EXPECT_EQ(first->units, distanceFieldOf(egg())->units);
    const std::string path = cache + '/' + fieldName(egg(), {}) + ".field";
    ASSERT_TRUE(std::filesystem::exists(path));

    // Whoever takes the file gets what it holds.
    DistanceField other = *first;
    other.units[0] = 77;
    ASSERT_TRUE(writeField(path, other).ok());
    EXPECT_EQ(cached(cache)->units[0], 77);
}

TEST(CachedField, IsComputedAnewWhereTheFileIsDamaged) {
    const test::TempFolder folder;
    const std::string path = folder.path(fieldName(egg(), {}) + ".field");
    const std::string cache = std::filesystem::path(path).parent_path();
    test::writeBytes(path, "KUSHIFLD and nothing else");
    const Result<DistanceField> field = cached(cache);
    ASSERT_TRUE(field.ok());
    EXPECT_EQ(field->units, distanceFieldOf(egg())->units);
    EXPECT_TRUE(readField(path).ok());
}

TEST(CachedField, IsGivenWhereTheFolderCannotBeWritten) {
    const test::TempFolder folder;
    test::writeBytes(folder.path("file"), "in the way");
    const Result<DistanceField> field = cached(folder.path("file"));
    ASSERT_TRUE(field.ok());
    EXPECT_EQ(field->units, distanceFieldOf(egg())->units);
    EXPECT_EQ(folder.files(), 1);
}

TEST(CachedField, OfWhatIsNoSolidIsAProblemAndLeavesNothing) {
    const test::TempFolder folder;
    std::vector<Solid> solids = egg();
    solids[0].offset = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(cachedField(fieldName(solids, {}), folder.path("cache"), [&] {
                     return distanceFieldOf(solids);
                 }).ok());
    EXPECT_EQ(folder.files(), 0);
}

}  // namespace
}  // namespace kushi
