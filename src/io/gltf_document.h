// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/result.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace kushi {

using Json = nlohmann::json;

/// The value of a key; null if there is none, or `object` is no object.
const Json* member(const Json& object, const char* key);

/// Puts the whole number of a key, below 2^32, into `out`, which stays where the key is missing.
/// What is wrong with it, or nothing.
std::string takeWhole(const Json& object, const char* key, std::uint64_t& out);

/// A .gltf or .glb file (glTF 2.0): its JSON and the numbers in its buffers. Functions that return
/// a text say what is wrong, or nothing.
class GltfDocument {
public:
    static Result<GltfDocument> parse(std::string_view bytes, const std::string& file);

    const Json& root() const { return root_; }
    /// Element of one of the top's arrays ("nodes"); null if it does not exist.
    const Json* item(const char* array, std::uint64_t index) const;

    /// What an accessor holds, as numbers one after the other; `type` is what it must be ("VEC3").
    std::string read(std::uint64_t accessor, std::string_view type, std::vector<double>& out);
    /// How many elements an accessor has, by its own word.
    std::string countOf(std::uint64_t accessor, std::uint64_t& count) const;

private:
    struct Layout;

    GltfDocument(Json root, std::string_view binary, std::string file);

    std::string findLayout(const Json& accessor, std::string_view type, Layout& layout);
    std::string bufferBytes(std::uint64_t index, std::string_view& bytes);
    std::string loadBuffer(const Json& buffer, std::string& bytes);

    Json root_;
    std::string_view binary_;  // what a .glb has after its JSON
    std::string file_;
    std::vector<std::optional<std::string>> buffers_;  // loaded so far
    std::uint64_t loaded_ = 0;                         // bytes
};

}  // namespace kushi
