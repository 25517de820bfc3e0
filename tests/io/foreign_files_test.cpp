// SPDX-License-Identifier: Apache-2.0
//
// Files made by other programs; they are not part of Kushi. KUSHI_TEST_DATA names their folder.
#include "io/temp_folder.h"

#include <kushi/groom_io.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

namespace kushi {
namespace {

class ForeignFiles : public testing::Test {
protected:
    /// Reads the file, or skips the test where it is not there.
    void read(const std::string& name, Strands& strands) {
        const char* folder = std::getenv("KUSHI_TEST_DATA");
        if (folder == nullptr) GTEST_SKIP() << "KUSHI_TEST_DATA names no folder of sample grooms";
        const std::string path = std::filesystem::path(folder) / name;
        if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
        const Result<Strands> groom = readGroom(path);
        ASSERT_TRUE(groom.ok()) << toString(groom.problems().front());
        strands = *groom;
    }
};

TEST_F(ForeignFiles, YukselsStraightHairIsRead) {
    Strands strands;
    read("straight.hair", strands);
    if (IsSkipped() || HasFatalFailure()) return;
    EXPECT_EQ(strands.size(), 10000U);
    EXPECT_EQ(strands.nodes.size(), 160000U);
    EXPECT_EQ(strands.strand(9999).size(), 16U);
    EXPECT_EQ(strands.colors.size(), 160000U);
    EXPECT_TRUE(strands.diameters.empty());
    // The first point's bytes: -0x1.23ff0ap-1, -0x1.b16a82p0, 0x1.dd1068p5.
    EXPECT_FLOAT_EQ(strands.nodes[0].x, -0x1.23ff0ap-1F / 100);
    EXPECT_FLOAT_EQ(strands.nodes[0].y, -0x1.b16a82p0F / 100);
    EXPECT_FLOAT_EQ(strands.nodes[0].z, 0x1.dd1068p5F / 100);
}

TEST_F(ForeignFiles, OneGroomIsTheSameInThreeFormats) {
    Strands hair, text, binary;
    read("Bangs_100.hair", hair);
    if (IsSkipped() || HasFatalFailure()) return;
    read("Bangs_100_ascii.ply", text);
    read("Bangs_100_binary.ply", binary);
    if (IsSkipped() || HasFatalFailure()) return;

    EXPECT_EQ(hair.size(), 100U);
    EXPECT_EQ(hair.nodes.size(), 1165U);
    EXPECT_EQ(text.offsets, hair.offsets);
    EXPECT_EQ(binary.offsets, hair.offsets);
    EXPECT_EQ(binary.nodes, hair.nodes);
    for (std::size_t i = 0; i < text.nodes.size(); ++i) {
        const Vec3f apart = text.nodes[i] - hair.nodes[i];
        ASSERT_LE(length(apart), 1e-6F * length(hair.nodes[i])) << "node " << i;
    }
    // Each file has a random colour per strand.
    EXPECT_EQ(binary.colors.size(), 1165U);
    EXPECT_EQ(text.colors.size(), 1165U);
    EXPECT_EQ(text.colors[0], (Rgb{40.0F / 255, 139.0F / 255, 94.0F / 255}));
}

TEST_F(ForeignFiles, AForeignGroomSurvivesEveryFormat) {
    Strands strands;
    read("Bangs_100.hair", strands);
    if (IsSkipped() || HasFatalFailure()) return;
    for (const char* extension : {".hair", ".ply", ".obj"}) {
        SCOPED_TRACE(extension);
        const test::TempFolder folder;
        const std::string path = folder.path(std::string("groom") + extension);
        ASSERT_TRUE(writeGroom(strands, path).ok());
        const Result<Strands> back = readGroom(path);
        ASSERT_TRUE(back.ok());
        EXPECT_EQ(back->offsets, strands.offsets);
        for (std::size_t i = 0; i < strands.nodes.size(); ++i) {
            ASSERT_LE(length(back->nodes[i] - strands.nodes[i]), 2e-7F * length(strands.nodes[i]));
        }
    }
}

}  // namespace
}  // namespace kushi
