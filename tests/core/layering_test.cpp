// SPDX-License-Identifier: Apache-2.0
//
// Data flows one way: a file may include from its own layer and from those before it.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;

const std::vector<std::string> layers = {"core",    "geometry", "head",    "groom", "io",
                                         "style",   "scalp",    "contact", "rod",   "pipeline",
                                         "shading", "render",   "trace"};

// Which layer implements each public header; kushi.h includes all of them.
const std::map<std::string, std::string> headerLayers = {{"result.h", "core"},
                                                         {"color.h", "core"},
                                                         {"node_colors.h", "core"},
                                                         {"vec.h", "geometry"},
                                                         {"ellipsoid.h", "geometry"},
                                                         {"mesh.h", "geometry"},
                                                         {"distance_field.h", "geometry"},
                                                         {"head.h", "head"},
                                                         {"strands.h", "groom"},
                                                         {"pigment.h", "groom"},
                                                         {"groom_io.h", "io"},
                                                         {"image.h", "io"},
                                                         {"mesh_io.h", "io"},
                                                         {"style.h", "style"},
                                                         {"follicles.h", "scalp"},
                                                         {"cantilever.h", "rod"},
                                                         {"cantilevers.h", "rod"},
                                                         {"planar_rod.h", "rod"},
                                                         {"rods.h", "rod"},
                                                         {"rest_shape.h", "rod"},
                                                         {"settle_groom.h", "pipeline"},
                                                         {"settle.h", "pipeline"},
                                                         {"push_out.h", "pipeline"},
                                                         {"fibre.h", "shading"},
                                                         {"shade.h", "shading"},
                                                         {"shadows.h", "shading"},
                                                         {"subdivide.h", "groom"},
                                                         {"layered_image.h", "io"},
                                                         {"camera.h", "render"},
                                                         {"draw.h", "render"},
                                                         {"trace.h", "trace"}};

// Images are plain values that io writes and render fills.
bool isPlainValue(const std::string& header) {
    return header == "image.h" || header == "layered_image.h" || header == "color.h";
}

std::ptrdiff_t rank(const std::string& layer) {
    return std::find(layers.begin(), layers.end(), layer) - layers.begin();
}

std::vector<std::string> linesOf(const fs::path& file) {
    std::ifstream in(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

// What stands between `before` and the next `end` on lines that begin with `before`.
std::vector<std::string> between(const fs::path& file, const std::string& before, char end) {
    std::vector<std::string> found;
    for (const std::string& line : linesOf(file)) {
        if (!line.starts_with(before)) continue;
        const std::size_t until = line.find(end, before.size());
        if (until != std::string::npos)
            found.push_back(line.substr(before.size(), until - before.size()));
    }
    return found;
}

std::vector<std::string> internalFolders(const fs::path& file) {
    return between(file, "#include \"", '/');
}

std::vector<std::string> publicHeaders(const fs::path& file) {
    return between(file, "#include <kushi/", '>');
}

void expectNothingAbove(const fs::path& file, const std::string& layer) {
    for (const std::string& folder : internalFolders(file)) {
        EXPECT_LE(rank(folder), rank(layer))
            << file << " includes from the higher layer " << folder;
    }
    for (const std::string& header : publicHeaders(file)) {
        if (isPlainValue(header)) continue;
        const auto owner = headerLayers.find(header);
        ASSERT_NE(owner, headerLayers.end()) << file << " includes the unlisted header " << header;
        EXPECT_LE(rank(owner->second), rank(layer)) << file << " includes the higher " << header;
    }
}

TEST(Layering, NoSourceIncludesFromALayerAboveItsOwn) {
    const fs::path root = fs::path(KUSHI_SOURCE_DIR) / "src";
    int files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
        if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
        const std::string layer = fs::relative(entry.path(), root).begin()->string();
        ASSERT_LT(rank(layer), std::ssize(layers)) << "src/" << layer << " is not in the list";
        expectNothingAbove(entry.path(), layer);
        ++files;
    }
    EXPECT_GT(files, 20);
}

TEST(Layering, NoPublicHeaderIncludesFromALayerAboveItsOwn) {
    for (const auto& entry : fs::directory_iterator(fs::path(KUSHI_SOURCE_DIR) / "include/kushi")) {
        const std::string name = entry.path().filename().string();
        if (name == "kushi.h") continue;
        const auto owner = headerLayers.find(name);
        ASSERT_NE(owner, headerLayers.end()) << name << " is not in the list";
        expectNothingAbove(entry.path(), owner->second);
        EXPECT_TRUE(internalFolders(entry.path()).empty())
            << name << " includes an internal header";
    }
}

// The library neither prints nor exits.
TEST(Layering, TheLibraryDoesNotPrintOrExit) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(KUSHI_SOURCE_DIR) / "src")) {
        if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
        for (const std::string& line : linesOf(entry.path())) {
            for (const char* forbidden :
                 {"std::cout", "std::cerr", " printf(", "std::printf(", "std::exit", "abort("}) {
                EXPECT_EQ(line.find(forbidden), std::string::npos) << entry.path() << ": " << line;
            }
        }
    }
}

}  // namespace
