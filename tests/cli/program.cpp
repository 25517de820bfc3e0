// SPDX-License-Identifier: Apache-2.0
#include "cli/program.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>
#include <sys/wait.h>

namespace kushi::test {

namespace fs = std::filesystem;

std::string freshFolder() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    const fs::path folder = fs::path(testing::TempDir()) /
                            (std::string("kushi-") + test->test_suite_name() + "-" + test->name());
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder.string();
}

Outcome runKushi(const std::string& arguments) {
    const std::string base = testing::TempDir() + "kushi-run-" + std::to_string(getpid());
    const std::string command =
        std::string(KUSHI_PROGRAM) + " " + arguments + " >" + base + ".out 2>" + base + ".err";
    const int raw = std::system(command.c_str());
    Outcome outcome;
    outcome.status = WIFEXITED(raw) ? WEXITSTATUS(raw) : 128 + WTERMSIG(raw);
    outcome.out = readBytes(base + ".out");
    outcome.err = readBytes(base + ".err");
    fs::remove(base + ".out");
    fs::remove(base + ".err");
    return outcome;
}

void writeText(const std::string& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

std::string readBytes(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void expectTheSameFromAnyThreads(const std::string& style, const std::string& groom) {
    std::string first;
    for (const char* threads : {"1", "2", "8"}) {
        ASSERT_EQ(runKushi("settle " + style + " -o " + groom + " --threads " + threads).status, 0);
        const std::string bytes = readBytes(groom);
        if (first.empty()) first = bytes;
        EXPECT_TRUE(bytes == first) << threads;
    }
}

std::pair<std::uint32_t, std::uint32_t> pngSize(const std::string& bytes) {
    const auto bigEndian = [&](std::size_t at) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < 4; ++i)
            value = value << 8U | static_cast<unsigned char>(bytes.at(at + i));
        return value;
    };
    return {bigEndian(16), bigEndian(20)};
}

std::string smallStyle(const std::string& head) {
    return "kushi = 1\nname = \"small\"\n\n[head]\n" + head + R"(

[scalp]
ellipsoid = { center = [0, 0, 0], semi_axes = [10.5, 12.5, 8.5], rotate_z = 20 }
count = 200
regions = [ { theta = [0, 100] } ]

[hair]
length = 20
)";
}

}  // namespace kushi::test
