// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"

#include <algorithm>
#include <optional>

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#if defined(__SANITIZE_THREAD__)
#include <atomic>
#include <thread>
#include <vector>
#else
#include <tbb/parallel_for.h>
#endif

namespace kushi {

namespace {

#if defined(__SANITIZE_THREAD__)

// The thread sanitizer cannot see into the packaged TBB and would take its hand-overs for races.
void runPieces(std::size_t pieces, int threads, const std::function<void(std::size_t)>& run) {
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t i = next++; i < pieces; i = next++)
            run(i);
    };
    std::vector<std::thread> others;
    const int wanted =
        threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency());
    for (int i = 1; i < wanted; ++i)
        others.emplace_back(work);
    work();
    for (std::thread& other : others)
        other.join();
}

#else

void runPieces(std::size_t pieces, int threads, const std::function<void(std::size_t)>& run) {
    withThreads(threads, [&] { tbb::parallel_for(std::size_t{0}, pieces, run); });
}

#endif

}  // namespace

void parallelFor(std::size_t count, std::size_t grain, int threads,
                 const std::function<void(std::size_t begin, std::size_t end)>& body) {
    const std::size_t pieces = (count + grain - 1) / grain;
    const auto run = [&](std::size_t piece) {
        body(piece * grain, std::min(count, (piece + 1) * grain));
    };
    if (threads == 1 || pieces <= 1) {
        for (std::size_t i = 0; i < pieces; ++i)
            run(i);
    } else {
        runPieces(pieces, threads, run);
    }
}

void withThreads(int threads, const std::function<void()>& body) {
    const int most = tbb::info::default_concurrency();
    std::optional<tbb::global_control> more;
    if (threads > most) {
        more.emplace(tbb::global_control::max_allowed_parallelism,
                     static_cast<std::size_t>(threads));
    }
    tbb::task_arena arena(threads > 0 ? threads : most);
    arena.execute(body);
}

}  // namespace kushi
