// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include "input.h"

namespace kushi {

/// The flags of every command that settles a style.
inline void addSettleFlags(CLI::App& command, SettleFlags& flags) {
    command.add_option("--count", flags.count, "Strands: fewer are an evenly spread subset of the style's own")
        ->check(CLI::Range(1, 5000000));
    command.add_option("--segments", flags.segments, "Segments per strand")->check(CLI::Range(1, 256));
    command.add_option("--method", flags.method, "How to bend (only cantilever so far)")
        ->check([](const std::string& method) -> std::string {
            if (method == "cantilever") return {};
            if (method == "equilibrium") {
                return "equilibrium is not there yet for whole heads; leave it out or give cantilever";
            }
            return "no such method as '" + method + "'; give cantilever";
        });
    command.add_option("--threads", flags.threads, "Threads (as many as the machine has)")
        ->check(CLI::Range(1, 1024));
}

}  // namespace kushi
