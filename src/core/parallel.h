// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

namespace kushi {

/// Calls body(begin, end) for consecutive pieces of [0, count) of at most `grain` items each, from
/// `threads` threads (0: as many as the machine has), and returns when all are done. The pieces do
/// not depend on the number of threads; who runs which one does.
void parallelFor(std::size_t count, std::size_t grain, int threads,
                 const std::function<void(std::size_t begin, std::size_t end)>& body);

/// Calls body(), which may use TBB itself, so that it has `threads` threads (0: as many as the
/// machine has).
void withThreads(int threads, const std::function<void()>& body);

}  // namespace kushi
