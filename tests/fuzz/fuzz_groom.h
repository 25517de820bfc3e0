// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/result.h>
#include <kushi/strands.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

namespace kushi::test {

using Parse = Result<Strands> (*)(std::string_view bytes, const std::string& file);
using Format = Result<std::string> (*)(const Strands& strands, const std::string& file);

/// Whatever the bytes, the reader returns; what it returns can be written, unless the format says
/// no, and is then read again with the same strands.
inline int fuzzGroom(Parse parse, Format format, const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const Result<Strands> strands = parse(bytes, "fuzz");
    if (!strands) return 0;
    const Result<std::string> written = format(*strands, "fuzz");
    if (!written) {
        // A groom that contradicts itself would be the reader's fault.
        const std::string& message = written.problems().front().message;
        if (message.find("the groom to write") != std::string::npos) std::abort();
        return 0;
    }
    const Result<Strands> again = parse(*written, "fuzz");
    if (!again || again->offsets != strands->offsets) std::abort();
    return 0;
}

}  // namespace kushi::test
