// SPDX-License-Identifier: Apache-2.0
#include "commands.h"
#include "input.h"
#include "messages.h"
#include "scene.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace kushi {

namespace {

constexpr int gutter = 6;  // pixels between pictures
constexpr Rgb paper = {0.95F, 0.95F, 0.95F};

Result<std::vector<View>> parseViews(const std::string& text) {
    std::vector<View> views;
    std::istringstream names(text + '/');
    for (std::string name; std::getline(names, name, '/');) {
        const Result<View> view = parseView(name);
        if (!view) return view.problems();
        views.push_back(*view);
    }
    return views;
}

/// Pictures side by side and row by row, all of one size.
class Sheet {
public:
    Sheet(int columns, int rows, int width, int height)
        : columns_(columns), width_(width), height_(height) {
        image_.width = columns * width + (columns - 1) * gutter;
        image_.height = rows * height + (rows - 1) * gutter;
        image_.pixels.assign(
            static_cast<std::size_t>(image_.width) * static_cast<std::size_t>(image_.height),
            paper);
    }

    void add(const Image& picture) {
        const int left = (next_ % columns_) * (width_ + gutter);
        const int top = (next_ / columns_) * (height_ + gutter);
        for (int y = 0; y < height_; ++y)
            std::copy_n(&picture.at(0, y), width_, &image_.at(left, top + y));
        ++next_;
    }

    const Image& image() const { return image_; }

private:
    int columns_, width_, height_;
    int next_ = 0;
    Image image_;
};

// Of one view of each a block, as square as it goes; of several a row for each style.
int columnsFor(std::size_t inputs, std::size_t views) {
    return views > 1 ? static_cast<int>(views)
                     : static_cast<int>(std::ceil(std::sqrt(static_cast<double>(inputs))));
}

}  // namespace

int runSheet(const SheetArguments& arguments) {
    const Result<std::pair<int, int>> size = parseSize(arguments.cell, "--cell");
    if (!size) return report(size.problems());
    const Result<std::vector<View>> views = parseViews(arguments.views);
    if (!views) return report(views.problems());
    if (const Status ending = hasEnding(arguments.output, {".png"}, "the sheet"); !ending) {
        return report(ending.problems());
    }
    if (const Status outputs = checkOutputs(arguments.output, ""); !outputs) {
        return report(outputs.problems());
    }

    const Look look = lookNamed(arguments.look);
    const DrawOptions options = drawOptions(*size, arguments.stroke, look, arguments.flags.threads);
    const auto pictures = static_cast<int>(arguments.inputs.size() * views->size());
    const int columns = columnsFor(arguments.inputs.size(), views->size());
    const int rows = (pictures + columns - 1) / columns;
    constexpr int most = 32768;
    if (columns > most / (options.width + gutter) || rows > most / (options.height + gutter)) {
        return report({{"the sheet would be larger than 32768 pixels; give a smaller --cell"}});
    }

    Sheet sheet(columns, rows, options.width, options.height);
    for (const std::string& input : arguments.inputs) {
        StageClock clock;
        Result<Scene> scene = loadScene(input, arguments.flags, false, clock);
        if (!scene) return report(scene.problems());
        prepare(*scene, look, arguments.flags.threads, clock);
        for (const View view : *views) {
            const double aspect = static_cast<double>(options.width) / options.height;
            sheet.add(drawScene(*scene, portrait(*scene, view, aspect), options, look, clock));
        }
    }
    if (const Status written = writePng(sheet.image(), arguments.output); !written)
        return report(written.problems());
    std::printf("%s: %s\n", arguments.output.c_str(),
                counted(static_cast<std::size_t>(pictures), "picture").c_str());
    return Done;
}

}  // namespace kushi
