// SPDX-License-Identifier: Apache-2.0
#include "fuzz_groom.h"
#include "io/ply_file.h"

#include <cstddef>
#include <cstdint>

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return kushi::test::fuzzGroom(kushi::parsePly, kushi::formatPly, data, size);
}
