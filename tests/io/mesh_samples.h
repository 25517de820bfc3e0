// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/test_bytes.h"

#include <cstdint>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kushi::test {

// One tetrahedron, spelled out in every format: corners (0 0 0), (10 0 0), (0 30 0) and (0 0 9) in
// cm, four faces that are counter-clockwise from outside, always in the same order.

inline std::string objTetra() {
    return "# tetrahedron\nmtllib none.mtl\no head\nv 0 0 0\nv 10 0 0\nv 0 30 0\nv 0 0 9\n"
           "usemtl skin\ns 1\nf 1 3 2\nf 1/1 2/2 4/3\nf -4 -1 -2\nf 2 \\\n 3 4\n";
}

inline std::string plyHeader(const std::string& format) {
    return "ply\nformat " + format +
           " 1.0\ncomment made by hand\nelement vertex 4\nproperty float x\nproperty float y\n"
           "property float z\nproperty uchar red\nelement face 4\n"
           "property list uchar float texcoord\nproperty list uchar int vertex_indices\n"
           "end_header\n";
}

inline std::string textPlyTetra() {
    return plyHeader("ascii") +
           "0 0 0 1\n10 0 0 1\n0 30 0 1\n0 0 9 1\n"
           "0 3 0 2 1\n2 0.5 0.5 3 0 1 3\n0 3 0 3 2\n0 3 1 2 3\n";
}

inline std::string binaryPlyTetra(bool bigEndian) {
    Bytes bytes(bigEndian);
    bytes.text(plyHeader(bigEndian ? "binary_big_endian" : "binary_little_endian"));
    bytes.f32({0, 0, 0}).u8({1}).f32({10, 0, 0}).u8({1});
    bytes.f32({0, 30, 0}).u8({1}).f32({0, 0, 9}).u8({1});
    bytes.u8({0, 3}).u32({0, 2, 1}).u8({2}).f32({0.5, 0.5}).u8({3}).u32({0, 1, 3});
    bytes.u8({0, 3}).u32({0, 3, 2}).u8({0, 3}).u32({1, 2, 3});
    return bytes;
}

inline std::string textStlTetra() {
    const auto facet = [](const char* a, const char* b, const char* c) {
        return "  facet normal 0 0 0\n    outer loop\n      vertex " + std::string(a) +
               "\n      vertex " + b + "\n      vertex " + c + "\n    endloop\n  endfacet\n";
    };
    const char* const o = "0 0 0";
    const char* const x = "1e1 0 0";
    const char* const y = "0 30.0 0";
    const char* const z = "0 0 9";
    return "solid tetra\n" + facet(o, y, x) + facet(o, x, z) + facet(o, z, y) + facet(x, y, z) +
           "endsolid tetra\n";
}

inline std::string binaryStlTetra() {
    const std::string header = "solid, says a header that is not to be believed";
    Bytes bytes;
    bytes.text(header).zeros(80 - header.size()).u32({4});
    bytes.f32({0, 0, 0, 0, 0, 0, 0, 30, 0, 10, 0, 0}).u16({0});
    bytes.f32({0, 0, 0, 0, 0, 0, 10, 0, 0, 0, 0, 9}).u16({0});
    bytes.f32({0, 0, 0, 0, 0, 0, 0, 0, 9, 0, 30, 0}).u16({0});
    bytes.f32({0, 0, 0, 10, 0, 0, 0, 30, 0, 0, 0, 9}).u16({0});
    return bytes;
}

/// In metres; the 48 bytes of the corners, then 12 indices of two bytes.
inline std::string gltfTetraBuffer() {
    Bytes bytes;
    bytes.f32({0, 0, 0, 0.1, 0, 0, 0, 0.3, 0, 0, 0, 0.09});
    bytes.u16({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
    return bytes;
}

inline std::string base64(const std::string& bytes) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto byte =
                i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : std::uint8_t{0};
            bits = bits << 8U | byte;
        }
        for (std::size_t k = 0; k < 4; ++k) {
            text += i + k > bytes.size() ? '=' : digits[bits >> (18 - 6 * k) & 63U];
        }
    }
    return text;
}

/// The parts of a glTF file that tests exchange.
struct Gltf {
    std::string nodes = R"([{"mesh":0}])";
    std::string primitive = R"({"attributes":{"POSITION":0},"indices":1})";
    std::string accessors = R"([{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
                            R"({"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}])";
    std::string views =
        R"([{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}])";
    std::string buffer = gltfTetraBuffer();
    std::string extra;  ///< more at the top

    std::string json(const std::string& uri) const {
        return R"({"asset":{"version":"2.0"},)" + extra + R"("scene":0,"scenes":[{"nodes":[0]}],)" +
               R"("nodes":)" + nodes + R"(,"meshes":[{"primitives":[)" + primitive +
               R"(]}],"accessors":)" + accessors + R"(,"bufferViews":)" + views +
               R"(,"buffers":[{"byteLength":)" + std::to_string(buffer.size()) + uri + "}]}";
    }
    std::string text() const {
        return json(R"(,"uri":"data:application/octet-stream;base64,)" + base64(buffer) + '"');
    }
    std::string binary() const {
        std::string chunk = json("");
        chunk.resize((chunk.size() + 3) / 4 * 4, ' ');
        std::string data = buffer;
        data.resize((data.size() + 3) / 4 * 4, '\0');
        const auto size = [](const std::string& bytes) {
            return static_cast<std::int64_t>(bytes.size());
        };
        Bytes bytes;
        bytes.text("glTF").u32({2, 28 + size(chunk) + size(data)});
        bytes.u32({size(chunk)}).text("JSON" + chunk);
        bytes.u32({size(data)}).text("BIN").zeros(1).text(data);
        return bytes;
    }
};

/// File name and bytes of the tetrahedron in every format.
inline std::vector<std::pair<std::string, std::string>> tetraFiles() {
    return {{"t.obj", objTetra()},
            {"text.ply", textPlyTetra()},
            {"little.ply", binaryPlyTetra(false)},
            {"big.ply", binaryPlyTetra(true)},
            {"text.stl", textStlTetra()},
            {"binary.stl", binaryStlTetra()},
            {"t.gltf", Gltf().text()},
            {"t.glb", Gltf().binary()}};
}

}  // namespace kushi::test
