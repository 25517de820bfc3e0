// SPDX-License-Identifier: Apache-2.0
#include "io/atomic_file.h"

#include "io/temp_folder.h"
#include "io/test_bytes.h"

#include <csignal>
#include <filesystem>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace kushi {
namespace {

namespace fs = std::filesystem;
using test::readBytes;
using test::writeBytes;
using testing::HasSubstr;

class AtomicFile : public testing::Test {
protected:
    std::string path(const std::string& name) const { return folder_.path(name); }
    std::ptrdiff_t files() const { return folder_.files(); }

private:
    test::TempFolder folder_;
};

/// While it lives, no file grows past `bytes`, as on a full disk.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes) : oldHandler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &old_);
        const rlimit limit = {bytes, old_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &old_);
        std::signal(SIGXFSZ, oldHandler_);
    }

private:
    rlimit old_{};
    void (*oldHandler_)(int);
};

/// While it lives, root is nobody: root may write anywhere.
class Unprivileged {
public:
    Unprivileged() {
        if (root_) changed_ = seteuid(65534) == 0;
    }
    Unprivileged(const Unprivileged&) = delete;
    Unprivileged& operator=(const Unprivileged&) = delete;
    ~Unprivileged() {
        if (root_ && seteuid(0) != 0) std::abort();
    }

    bool works() const { return changed_ || !root_; }

private:
    bool root_ = geteuid() == 0;
    bool changed_ = false;
};

void expectFailure(const Status& status, const std::string& path, const std::string& reason) {
    ASSERT_FALSE(status.ok());
    const Problem& problem = status.problems().front();
    EXPECT_THAT(problem.message, HasSubstr("cannot write: " + reason));
    EXPECT_EQ(problem.file, path);
    EXPECT_TRUE(problem.system);
}

TEST_F(AtomicFile, WritesANewFileAndNothingElse) {
    const std::string bytes("a\0b\n", 4);
    ASSERT_TRUE(writeFileAtomically(path("new"), bytes).ok());
    EXPECT_EQ(readBytes(path("new")), bytes);
    EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFile, ANewFileHasThePermissionsOfAnyOther) {
    writeBytes(path("other"), "");
    ASSERT_TRUE(writeFileAtomically(path("new"), "new").ok());
    EXPECT_EQ(fs::status(path("new")).permissions(), fs::status(path("other")).permissions());
}

TEST_F(AtomicFile, ReplacesAFileAndKeepsItsPermissions) {
    writeBytes(path("old"), "something longer than the new");
    fs::permissions(path("old"), fs::perms(0640));
    ASSERT_TRUE(writeFileAtomically(path("old"), "new").ok());
    EXPECT_EQ(readBytes(path("old")), "new");
    EXPECT_EQ(fs::status(path("old")).permissions(), fs::perms(0640));
    EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFile, ReplacesTheTargetOfALinkAndKeepsTheLink) {
    fs::create_directory(path("elsewhere"));
    writeBytes(path("elsewhere/target"), "old");
    fs::create_symlink("elsewhere/target", path("link"));
    ASSERT_TRUE(writeFileAtomically(path("link"), "new").ok());
    EXPECT_TRUE(fs::is_symlink(path("link")));
    EXPECT_EQ(readBytes(path("elsewhere/target")), "new");
}

TEST_F(AtomicFile, WritesInTheCurrentFolderToo) {
    const fs::path before = fs::current_path();
    fs::current_path(path(""));
    const bool written = writeFileAtomically("name", "new").ok();
    fs::current_path(before);
    EXPECT_TRUE(written);
    EXPECT_EQ(readBytes(path("name")), "new");
}

TEST_F(AtomicFile, NamesMayBeAsLongAsTheSystemAllows) {
    const std::string name(255, 'n');
    ASSERT_TRUE(writeFileAtomically(path(name), "new").ok());
    expectFailure(writeFileAtomically(path(name + 'n'), "new"), path(name + 'n'),
                  "File name too long");
    EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFile, AMissingFolderIsAProblem) {
    expectFailure(writeFileAtomically(path("no/new"), "new"), path("no/new"), "No such file");
    EXPECT_EQ(files(), 0);
}

TEST_F(AtomicFile, AFileInsteadOfAFolderIsAProblem) {
    writeBytes(path("file"), "old");
    expectFailure(writeFileAtomically(path("file/new"), "new"), path("file/new"),
                  "Not a directory");
    EXPECT_EQ(readBytes(path("file")), "old");
}

TEST_F(AtomicFile, AFolderInsteadOfAFileIsAProblem) {
    fs::create_directory(path("folder"));
    expectFailure(writeFileAtomically(path("folder"), "new"), path("folder"), "it is a folder");
    EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFile, AWriteProtectedFileIsNotReplaced) {
    writeBytes(path("protected"), "old");
    fs::permissions(path("protected"), fs::perms(0444));
    fs::permissions(path(""), fs::perms(0777));
    {
        const Unprivileged nobody;
        if (!nobody.works()) GTEST_SKIP() << "root cannot become another user here";
        expectFailure(writeFileAtomically(path("protected"), "new"), path("protected"),
                      "Permission denied");
    }
    EXPECT_EQ(readBytes(path("protected")), "old");
    EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFile, AWriteProtectedFolderIsAProblem) {
    fs::permissions(path(""), fs::perms(0555));
    {
        const Unprivileged nobody;
        if (!nobody.works()) GTEST_SKIP() << "root cannot become another user here";
        expectFailure(writeFileAtomically(path("new"), "new"), path("new"), "Permission denied");
    }
    fs::permissions(path(""), fs::perms(0755));
    EXPECT_EQ(files(), 0);
}

TEST_F(AtomicFile, AFullDiskLeavesTheOldFileAndNothingElse) {
    writeBytes(path("old"), "old");
    const std::string tooMuch(100000, 'x');
    {
        const FullDisk disk(4096);
        expectFailure(writeFileAtomically(path("old"), tooMuch), path("old"), "File too large");
        expectFailure(writeFileAtomically(path("new"), tooMuch), path("new"), "File too large");
    }
    EXPECT_EQ(readBytes(path("old")), "old");
    EXPECT_FALSE(fs::exists(path("new")));
    EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFile, ADeviceIsWrittenStraightThrough) {
    EXPECT_TRUE(writeFileAtomically("/dev/null", "new").ok());
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    expectFailure(writeFileAtomically("/dev/full", "new"), "/dev/full", "No space left on device");
}

TEST_F(AtomicFile, APipeIsWrittenStraightThrough) {
    ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
    const std::string bytes(300000, 'x');  // more than a pipe holds
    std::string received;
    std::thread reader([&] { received = readBytes(path("pipe")); });
    const bool written = writeFileAtomically(path("pipe"), bytes).ok();
    reader.join();
    EXPECT_TRUE(written);
    EXPECT_EQ(received, bytes);
    EXPECT_TRUE(fs::is_fifo(path("pipe")));
}

TEST_F(AtomicFile, StandardOutputInAFileGoesOnWhereItStands) {
    const int terminal = dup(STDOUT_FILENO);
    const int file = open(path("out").c_str(), O_CREAT | O_RDWR, 0600);
    ASSERT_EQ(dup2(file, STDOUT_FILENO), STDOUT_FILENO);
    const bool before = write(STDOUT_FILENO, "before,", 7) == 7;
    const bool written = writeFileAtomically("/dev/stdout", "bytes").ok();
    const bool after = write(STDOUT_FILENO, ",after", 6) == 6;
    dup2(terminal, STDOUT_FILENO);
    close(terminal);
    close(file);
    EXPECT_TRUE(before && written && after);
    EXPECT_EQ(readBytes(path("out")), "before,bytes,after");
}

TEST_F(AtomicFile, OfManyWritersAtOnceOneWinsWhole) {
    std::vector<std::thread> writers(8);
    for (std::size_t i = 0; i < writers.size(); ++i) {
        writers[i] = std::thread([this, i] {
            const std::string bytes(50000, "abcdefgh"[i]);
            for (int k = 0; k < 5; ++k)
                EXPECT_TRUE(writeFileAtomically(path("shared"), bytes).ok());
        });
    }
    for (std::thread& writer : writers)
        writer.join();
    const std::string bytes = readBytes(path("shared"));
    EXPECT_EQ(bytes, std::string(50000, bytes.empty() ? '?' : bytes[0]));
    EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFile, ReadsWhatIsThere) {
    const std::string bytes(200000, 'x');
    writeBytes(path("file"), bytes);
    writeBytes(path("empty"), "");
    ASSERT_TRUE(readFile(path("file")).ok());
    EXPECT_EQ(*readFile(path("file")), bytes);
    ASSERT_TRUE(readFile(path("empty")).ok());
    EXPECT_EQ(*readFile(path("empty")), "");
    // Its size is given as 0.
    ASSERT_TRUE(readFile("/proc/self/stat").ok());
    EXPECT_FALSE(readFile("/proc/self/stat")->empty());
}

TEST_F(AtomicFile, AnUnreadableFileIsTheUsersProblem) {
    writeBytes(path("secret"), "old");
    fs::permissions(path("secret"), fs::perms(0));
    const Unprivileged nobody;
    if (!nobody.works()) GTEST_SKIP() << "root cannot become another user here";
    const Result<std::string> read = readFile(path("secret"));
    ASSERT_FALSE(read.ok());
    EXPECT_EQ(read.problems().front().message, "cannot read: Permission denied");
    EXPECT_FALSE(read.problems().front().system);
}

}  // namespace
}  // namespace kushi
