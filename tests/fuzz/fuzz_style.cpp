// SPDX-License-Identifier: Apache-2.0
#include <kushi/style.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

// Any bytes are a style or a list of problems; an edit that is accepted gives a style again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const auto style = kushi::parseStyle(text, "fuzz.toml");
    if (!style && style.problems().empty()) std::abort();

    for (const std::string_view key : {"seed", "solver.segments", "part[0].scalp.count"}) {
        const auto changed = kushi::withValue(text, key, std::int64_t{7});
        if (changed && !kushi::parseStyle(*changed, "fuzz.toml")) std::abort();
    }
    return 0;
}
