// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "wig.h"

#include <kushi/image.h>

#include <memory>
#include <string>

namespace kushi::bench {

/// The benchmark's rival: the same picture by Mesa's OpenGL on the processor, without a display.
/// Hair as lines one sample wide, the head as triangles, both with vertex colours and a depth test.
/// It draws supersample times wider and higher, as its own multisampling ends at four samples a
/// pixel, and averages on its side too. The scene is handed over once, and not timed.
class MesaLines {
public:
    MesaLines(const Wig& wig, int size, int supersample, Rgb background);
    ~MesaLines();
    MesaLines(const MesaLines&) = delete;
    MesaLines& operator=(const MesaLines&) = delete;

    /// Why it cannot draw; empty if it can.
    const std::string& problem() const;
    /// What draws, as it names itself.
    const std::string& renderer() const;

    /// Draws, averages and reads back.
    Image draw();

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace kushi::bench
