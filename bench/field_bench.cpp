// SPDX-License-Identifier: Apache-2.0
//
// field_bench [THREADS]: how long the distance field of the mannequin takes, computed and read.
#include "io/field_cache.h"
#include "io/field_file.h"

#include <kushi/head.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <functional>
#include <vector>

namespace {

void report(const char* what, const std::function<bool()>& work) {
    using Clock = std::chrono::steady_clock;
    std::vector<double> times, processor;
    bool fine = true;
    for (int turn = 0; turn < 9; ++turn) {
        const auto start = Clock::now();
        const std::clock_t processorStart = std::clock();
        fine = work() && fine;
        times.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
        processor.push_back(1000.0 * static_cast<double>(std::clock() - processorStart) /
                            CLOCKS_PER_SEC);
    }
    std::ranges::sort(times);
    std::ranges::sort(processor);
    std::printf("%-10s %8.1f ms, best %8.1f; of all processors %8.1f, best %8.1f%s\n", what,
                times[4], times[0], processor[4], processor[0], fine ? "" : " FAILED");
}

}  // namespace

int main(int argc, char** argv) {
    const int threads = argc > 1 ? std::atoi(argv[1]) : 0;
    const std::vector<kushi::Solid> solids = {{kushi::mannequin(), 0}};
    const auto field = kushi::distanceFieldOf(solids);
    if (!field) return 1;
    std::printf("%zu triangles, %d x %d x %d samples\n", solids[0].mesh.triangles.size(),
                field->size[0], field->size[1], field->size[2]);
    const std::string path = std::filesystem::temp_directory_path() / "kushi_field_bench.field";
    report("computed", [&] { return kushi::distanceFieldOf(solids, {{}, threads}).ok(); });
    report("written", [&] { return kushi::writeField(path, *field).ok(); });
    report("read", [&] { return kushi::readField(path).ok(); });
    report("named", [&] { return !kushi::fieldName(solids, {}).empty(); });
    std::filesystem::remove(path);
}
