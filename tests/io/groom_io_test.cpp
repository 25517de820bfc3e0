// SPDX-License-Identifier: Apache-2.0
#include "io/temp_folder.h"
#include "io/test_bytes.h"

#include <kushi/groom_io.h>

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kushi {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

Strands oneStrand() {
    Strands strands;
    strands.add(std::vector<Vec3f>{{0, 0, 0}, {0, 1, 0}}, 5);
    return strands;
}

class GroomIo : public testing::Test {
protected:
    std::string path(const std::string& name) const { return folder_.path(name); }
    std::ptrdiff_t files() const { return folder_.files(); }

private:
    test::TempFolder folder_;
};

TEST_F(GroomIo, KnowsItsExtensionsInCapitalsToo) {
    EXPECT_TRUE(isGroomPath("a.hair"));
    EXPECT_TRUE(isGroomPath("a.b/c.PLY"));
    EXPECT_TRUE(isGroomPath("a.toml.Obj"));
    EXPECT_FALSE(isGroomPath("a.toml"));
    EXPECT_FALSE(isGroomPath("hair"));
    EXPECT_FALSE(isGroomPath("a.hair/b"));
    EXPECT_FALSE(isGroomPath(""));
}

TEST_F(GroomIo, WritesEachFormatAndReadsItBack) {
    for (const char* name : {"a.hair", "a.ply", "a.obj", "A.HAIR"}) {
        SCOPED_TRACE(name);
        ASSERT_TRUE(writeGroom(oneStrand(), path(name)).ok());
        const Result<Strands> back = readGroom(path(name));
        ASSERT_TRUE(back.ok());
        EXPECT_EQ(back->nodes, oneStrand().nodes);
        EXPECT_EQ(back->offsets, oneStrand().offsets);
    }
    EXPECT_EQ(test::readBytes(path("a.hair")).substr(0, 4), "HAIR");
    EXPECT_EQ(test::readBytes(path("a.ply")).substr(0, 4), "ply\n");
    EXPECT_EQ(test::readBytes(path("a.obj")).substr(0, 2), "# ");
    EXPECT_EQ(test::readBytes(path("a.hair")), test::readBytes(path("A.HAIR")));
}

// In millimetres, x up, the face along -y: the person's right is then -y cross x, which is z.
TEST_F(GroomIo, PutsAGroomInItsPlace) {
    Strands strands;
    strands.add(std::vector<Vec3f>{{0, 0, 0}, {0.5F, -0.25F, 0.125F}}, 0);
    strands.diameters = {1e-3F, 2e-3F};
    ASSERT_TRUE(writeGroom(strands, path("a.ply")).ok());
    GroomPlacement placement;
    placement.unit = 0.001;
    placement.up = {1, 0, 0};
    placement.front = {0, -1, 0};
    placement.offset = {1, 2, 3};
    const Result<Strands> placed = readGroom(path("a.ply"), placement);
    ASSERT_TRUE(placed.ok());
    EXPECT_EQ(placed->nodes[0], (Vec3f{1, 2, 3}));
    EXPECT_LT(length(placed->nodes[1] - Vec3f{1.025F, 2.05F, 3.0125F}), 1e-6F);
    EXPECT_NEAR(placed->diameters[1], 2e-4, 1e-9);
    EXPECT_EQ(readGroom(path("a.ply"), {})->nodes, strands.nodes);

    strands.nodes[1].x = 1e30F;
    ASSERT_TRUE(writeGroom(strands, path("far.ply")).ok());
    placement.unit = 1e10;
    const Result<Strands> far = readGroom(path("far.ply"), placement);
    ASSERT_FALSE(far.ok());
    EXPECT_THAT(far.problems()[0].message, HasSubstr("too far away in this unit"));
}

TEST_F(GroomIo, AnUnknownExtensionIsRefusedBeforeTheDiskIsTouched) {
    const Result<Strands> read = readGroom(path("a.abc"));
    ASSERT_FALSE(read.ok());
    EXPECT_EQ(read.problems().front().message,
              "unknown extension '.abc'; strand files are .hair, .ply or .obj");
    EXPECT_EQ(read.problems().front().file, path("a.abc"));

    const Status written = writeGroom(oneStrand(), path("hair"));
    ASSERT_FALSE(written.ok());
    EXPECT_THAT(written.problems().front().message, HasSubstr("no extension"));
    EXPECT_FALSE(written.problems().front().system);
    EXPECT_EQ(files(), 0);
}

TEST_F(GroomIo, AMissingFileIsTheUsersProblem) {
    const Result<Strands> read = readGroom(path("missing.hair"));
    ASSERT_FALSE(read.ok());
    EXPECT_EQ(read.problems().front().message, "cannot read: No such file or directory");
    EXPECT_EQ(read.problems().front().file, path("missing.hair"));
    EXPECT_FALSE(read.problems().front().system);
}

TEST_F(GroomIo, AFolderIsNotAFile) {
    fs::create_directory(path("folder.ply"));
    const Result<Strands> read = readGroom(path("folder.ply"));
    ASSERT_FALSE(read.ok());
    EXPECT_EQ(read.problems().front().message, "cannot read: Is a directory");
    EXPECT_FALSE(read.problems().front().system);
}

TEST_F(GroomIo, WhatTheFormatCannotHoldLeavesTheOldFileAlone) {
    test::writeBytes(path("old.hair"), "old");
    Strands bald;
    bald.add(std::vector<Vec3f>{{0, 0, 0}}, 1);
    const Status written = writeGroom(bald, path("old.hair"));
    ASSERT_FALSE(written.ok());
    EXPECT_FALSE(written.problems().front().system);
    EXPECT_EQ(written.problems().front().file, path("old.hair"));
    EXPECT_EQ(test::readBytes(path("old.hair")), "old");
}

TEST_F(GroomIo, AnOutputThatCannotBeWrittenIsTheMachinesProblem) {
    const Status written = writeGroom(oneStrand(), path("missing/a.hair"));
    ASSERT_FALSE(written.ok());
    EXPECT_TRUE(written.problems().front().system);
    EXPECT_THAT(written.problems().front().message, HasSubstr("cannot write: No such file"));
}

}  // namespace
}  // namespace kushi
