// SPDX-License-Identifier: Apache-2.0
#include "io/field_file.h"

#include "io/damage.h"
#include "io/temp_folder.h"
#include "io/test_bytes.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kushi {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

DistanceField smallField() {
    DistanceField field;
    field.origin = {-0.1F, 0.2F, 0.3F};
    field.spacing = 0.0025F;
    field.size = {2, 3, 4};
    for (std::int16_t i = 0; i < 24; ++i) {
        field.units.push_back(static_cast<std::int16_t>(2700 * (i - 12)));
        field.nearest.push_back(static_cast<std::uint8_t>(10 * i));
    }
    return field;
}

void expectSame(const DistanceField& a, const DistanceField& b) {
    EXPECT_EQ(a.origin, b.origin);
    EXPECT_EQ(a.spacing, b.spacing);
    EXPECT_EQ(a.size, b.size);
    EXPECT_EQ(a.units, b.units);
    EXPECT_EQ(a.nearest, b.nearest);
}

std::string messageOf(const std::string& bytes) {
    const Result<DistanceField> field = parseField(bytes, "a.field");
    if (field) return {};
    EXPECT_EQ(field.problems().size(), 1U);
    EXPECT_EQ(field.problems().front().file, "a.field");
    return field.problems().front().message;
}

template <class T>
std::string changed(std::string bytes, std::size_t at, T value) {
    std::memcpy(bytes.data() + at, &value, sizeof(T));
    return bytes;
}

TEST(FieldFile, GivesBackWhatWasWritten) {
    const test::TempFolder folder;
    const std::string path = folder.path("a.field");
    DistanceField field = smallField();
    ASSERT_TRUE(writeField(path, field).ok());
    ASSERT_TRUE(readField(path).ok());
    expectSame(*readField(path), field);
    field.nearest.clear();
    ASSERT_TRUE(writeField(path, field).ok());
    expectSame(*readField(path), field);
    ASSERT_TRUE(writeField(path, {}).ok());
    expectSame(*readField(path), {});
    EXPECT_EQ(folder.files(), 1);
}

TEST(FieldFile, HoldsLittleEndianNumbersAfterItsMark) {
    const std::string bytes = formatField(smallField());
    ASSERT_EQ(bytes.size(), 56U + 24 * 3);
    EXPECT_THAT(bytes, StartsWith(std::string("KUSHIFLD\1\0\0\0\1\0\0\0", 16)));
    EXPECT_EQ(bytes.substr(32, 12), std::string("\2\0\0\0\3\0\0\0\4\0\0\0", 12));
    EXPECT_EQ(bytes.substr(56, 2), "\x70\x81");  // 2700 * -12
}

TEST(FieldFile, IsRefusedCutShortAnywhere) {
    const std::string bytes = formatField(smallField());
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_NE(messageOf(bytes.substr(0, size)), "") << size;
    EXPECT_EQ(messageOf(bytes.substr(0, 55)),
              "cut short: 55 bytes, but the header of a distance field alone has 56");
    EXPECT_EQ(messageOf(bytes.substr(0, 100)),
              "cut short: 100 bytes, but a field of 2 x 3 x 4 samples has 128");
    EXPECT_EQ(messageOf(bytes + '\0'),
              "bytes after the end: 129 bytes, but a field of 2 x 3 x 4 samples has 128");
}

TEST(FieldFile, IsRefusedWhereItIsNoField) {
    const std::string bytes = formatField(smallField());
    EXPECT_EQ(messageOf("ply\n"),
              "not a distance field of Kushi's: it does not start with 'KUSHIFLD'");
    EXPECT_EQ(messageOf(changed(bytes, 8, 2)),
              "a distance field of version 2; this Kushi reads version 1");
    const std::string damaged = "its header is damaged: a distance field cannot be like that";
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(messageOf(changed(bytes, 12, 2)), damaged);
    EXPECT_EQ(messageOf(changed(bytes, 20, nan)), damaged);
    EXPECT_EQ(messageOf(changed(bytes, 28, nan)), damaged);
    EXPECT_EQ(messageOf(changed(bytes, 28, -1.0F)), damaged);
    EXPECT_EQ(messageOf(changed(bytes, 28, 0.0F)), damaged);
    EXPECT_EQ(messageOf(changed(bytes, 32, -2)), damaged);
    EXPECT_EQ(messageOf(changed(bytes, 32, 1)), damaged);
    EXPECT_EQ(messageOf(changed(bytes, 60, '\x7f')),
              "the file is damaged: its checksum is not that of its bytes");
}

TEST(FieldFile, TakesNoMemoryForMoreThanTheFileHolds) {
    const int huge = std::numeric_limits<int>::max();
    std::string bytes = formatField(smallField());
    for (const std::size_t at : {32U, 36U, 40U})
        bytes = changed(bytes, at, huge);
    EXPECT_THAT(messageOf(bytes), StartsWith("cut short: 128 bytes, but a field of 2147483647 x"));
}

TEST(FieldFile, IsReadOrRefusedWhateverItsDamage) {
    const std::string valid = formatField(smallField());
    test::Dice dice(1992);
    for (int trial = 0; trial < 4000; ++trial) {
        const std::string bytes = test::mutated(valid, dice);
        EXPECT_EQ(messageOf(bytes).empty(), bytes == valid) << trial;
    }
}

TEST(FieldFile, NamesTheFileThatCannotBeRead) {
    const Result<DistanceField> field = readField("/nowhere/a.field");
    ASSERT_FALSE(field.ok());
    EXPECT_EQ(field.problems().front().file, "/nowhere/a.field");
    EXPECT_THAT(field.problems().front().message, HasSubstr("No such file"));
    EXPECT_FALSE(writeField("/nowhere/a.field", smallField()).ok());
}

}  // namespace
}  // namespace kushi
