// SPDX-License-Identifier: Apache-2.0
#include "io/gltf_document.h"

#include "io/base64.h"
#include "io/bytes.h"
#include "io/file_limit.h"
#include "io/text.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <utility>

namespace kushi {
namespace {

using std::to_string;

// Nothing of glTF that is read here lies deeper; what does (extras) is dropped while parsing.
constexpr int deepest = 16;

/// What a file is made of.
struct Chunks {
    std::string_view json, binary;
};

Result<Chunks> splitBinary(std::string_view bytes, const std::string& file) {
    constexpr std::size_t headerSize = 12;
    constexpr std::size_t chunkHeaderSize = 8;
    if (bytes.size() < headerSize + chunkHeaderSize) {
        return badFile(file, "cut short: " + to_string(bytes.size()) + " bytes of a .glb file");
    }
    if (const auto version = load<std::uint32_t>(bytes.data() + 4); version != 2) {
        return badFile(file, "glTF version " + to_string(version) + ", expected 2");
    }
    if (const auto size = load<std::uint32_t>(bytes.data() + 8); size != bytes.size()) {
        return badFile(file, (size > bytes.size() ? "cut short: " : "bytes after the end: ") +
                                 to_string(bytes.size()) + " bytes, but the header says " +
                                 to_string(size));
    }
    Chunks chunks;
    std::string_view rest = bytes.substr(headerSize);
    for (std::size_t i = 0; rest.size() >= chunkHeaderSize; ++i) {
        const std::size_t size = load<std::uint32_t>(rest.data());
        const std::string_view type = rest.substr(4, 4);
        rest.remove_prefix(chunkHeaderSize);
        if (size > rest.size()) {
            return badFile(file, "chunk " + to_string(i) + " (counted from 0) announces " +
                                     to_string(size) + " bytes, but " + to_string(rest.size()) +
                                     " are left");
        }
        if (i == 0 && type == "JSON") chunks.json = rest.substr(0, size);
        if (i == 1 && type == std::string_view("BIN\0", 4)) chunks.binary = rest.substr(0, size);
        rest.remove_prefix(size);
    }
    if (chunks.json.empty()) return badFile(file, "the first chunk is not JSON");
    return chunks;
}

Result<Json> parseJson(std::string_view text, const std::string& file) try {
    return Json::parse(
        text, [](int depth, Json::parse_event_t, const Json&) { return depth <= deepest; });
} catch (const Json::parse_error& error) {
    return badFile(file, "the JSON is malformed or cut short at byte " + to_string(error.byte) +
                             " of " + to_string(text.size()));
} catch (const Json::exception&) {
    return badFile(file, "the JSON holds a number that is too large");
}

/// Whether the geometry can be read at all.
std::string checkVersion(const Json& root) {
    const Json* asset = member(root, "asset");
    const Json* version = asset != nullptr ? member(*asset, "version") : nullptr;
    if (version == nullptr || !version->is_string()) return "not a glTF file: no asset version";
    const auto& text = version->get_ref<const std::string&>();
    if (!text.starts_with("2.")) return "glTF version " + inQuotes(text) + ", expected 2.0";
    const Json* required = member(root, "extensionsRequired");
    if (required == nullptr || !required->is_array()) return {};
    for (const Json& extension : *required) {
        for (const char* packer : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"}) {
            if (extension == packer) {
                return "its mesh is compressed (" + std::string(packer) +
                       "); export it without compression";
            }
        }
    }
    return {};
}

struct Component {
    std::uint64_t code;
    std::size_t size;
    double largest;  ///< what 1 is stored as when normalized
    double (*load)(const char* bytes);
};

template <class T>
constexpr Component component(std::uint64_t code) {
    return {code, sizeof(T), static_cast<double>(std::numeric_limits<T>::max()),
            [](const char* bytes) { return static_cast<double>(load<T>(bytes)); }};
}

const Component* findComponent(std::uint64_t code) {
    static constexpr std::array<Component, 6> components = {
        component<std::int8_t>(5120),   component<std::uint8_t>(5121),
        component<std::int16_t>(5122),  component<std::uint16_t>(5123),
        component<std::uint32_t>(5125), component<float>(5126)};
    const auto* const found = std::ranges::find(components, code, &Component::code);
    return found == components.end() ? nullptr : found;
}

}  // namespace

const Json* member(const Json& object, const char* key) {
    if (!object.is_object()) return nullptr;
    const auto found = object.find(key);
    return found == object.end() ? nullptr : &*found;
}

std::string takeWhole(const Json& object, const char* key, std::uint64_t& out) {
    const Json* value = member(object, key);
    if (value == nullptr) return {};
    if (!value->is_number_unsigned() ||
        value->get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max()) {
        return std::string(key) + " is not a whole number from 0 to 4294967295";
    }
    out = value->get<std::uint64_t>();
    return {};
}

/// Where the elements of an accessor lie.
struct GltfDocument::Layout {
    std::string_view bytes;  ///< from the first element on
    std::uint64_t count = 0;
    std::uint64_t stride = 0;
    std::size_t perElement = 1;
    const Component* component = nullptr;
    bool normalized = false;
};

GltfDocument::GltfDocument(Json root, std::string_view binary, std::string file)
    : root_(std::move(root)), binary_(binary), file_(std::move(file)) {
    const Json* buffers = member(root_, "buffers");
    if (buffers != nullptr && buffers->is_array()) buffers_.resize(buffers->size());
}

Result<GltfDocument> GltfDocument::parse(std::string_view bytes, const std::string& file) {
    Chunks chunks = {bytes, {}};
    if (bytes.starts_with("glTF")) {
        const Result<Chunks> split = splitBinary(bytes, file);
        if (!split) return split.problems();
        chunks = *split;
    }
    if (chunks.json.size() > mostText) {
        return badFile(file, "its JSON has " + to_string(chunks.json.size()) +
                                 " bytes; a .glb file, which keeps numbers apart, is read up to " +
                                 to_string(mostBytes));
    }
    Result<Json> root = parseJson(chunks.json, file);
    if (!root) return root.problems();
    if (std::string fault = checkVersion(*root); !fault.empty()) {
        return badFile(file, std::move(fault));
    }
    return GltfDocument(std::move(*root), chunks.binary, file);
}

const Json* GltfDocument::item(const char* array, std::uint64_t index) const {
    const Json* items = member(root_, array);
    if (items == nullptr || !items->is_array() || index >= items->size()) return nullptr;
    return &(*items)[index];
}

std::string GltfDocument::countOf(std::uint64_t accessor, std::uint64_t& count) const {
    const Json* found = item("accessors", accessor);
    if (found == nullptr) return "accessor " + to_string(accessor) + " does not exist";
    return takeWhole(*found, "count", count);
}

std::string GltfDocument::read(std::uint64_t accessor, std::string_view type,
                               std::vector<double>& out) {
    const std::string name = "accessor " + to_string(accessor);
    const Json* found = item("accessors", accessor);
    if (found == nullptr) return name + " does not exist";
    Layout layout;
    if (std::string fault = findLayout(*found, type, layout); !fault.empty()) {
        return name + ": " + fault;
    }
    const std::size_t size = layout.component->size;
    out.clear();
    out.reserve(layout.count * layout.perElement);
    for (std::uint64_t i = 0; i < layout.count; ++i) {
        const char* element = layout.bytes.data() + i * layout.stride;
        for (std::size_t k = 0; k < layout.perElement; ++k) {
            const double number = layout.component->load(element + k * size);
            out.push_back(layout.normalized ? std::max(number / layout.component->largest, -1.0)
                                            : number);
        }
    }
    return {};
}

std::string GltfDocument::findLayout(const Json& accessor, std::string_view type, Layout& layout) {
    if (member(accessor, "sparse") != nullptr) {
        return "a sparse accessor; export the mesh with its shape applied";
    }
    const Json* named = member(accessor, "type");
    if (named == nullptr || *named != type) return "its type is not " + std::string(type);
    std::uint64_t view = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t code = 0, offset = 0, viewOffset = 0, viewSize = 0, buffer = 0;
    for (std::string fault :
         {takeWhole(accessor, "bufferView", view), takeWhole(accessor, "componentType", code),
          takeWhole(accessor, "byteOffset", offset), takeWhole(accessor, "count", layout.count)}) {
        if (!fault.empty()) return fault;
    }
    layout.component = findComponent(code);
    if (layout.component == nullptr) return "unknown componentType " + to_string(code);
    const Json* normalized = member(accessor, "normalized");
    layout.normalized = normalized != nullptr && *normalized == true && code != 5126;
    layout.perElement = type == "VEC3" ? 3 : (type == "VEC2" ? 2 : 1);

    const Json* found = item("bufferViews", view);
    if (found == nullptr) return "its bufferView does not exist";
    const std::uint64_t elementSize = layout.perElement * layout.component->size;
    layout.stride = elementSize;
    for (std::string fault :
         {takeWhole(*found, "buffer", buffer), takeWhole(*found, "byteOffset", viewOffset),
          takeWhole(*found, "byteLength", viewSize),
          takeWhole(*found, "byteStride", layout.stride)}) {
        if (!fault.empty()) return fault;
    }
    if (layout.stride < elementSize) return "its elements overlap";
    // No product of two numbers below 2^32 overflows.
    const std::uint64_t needed =
        layout.count == 0 ? 0 : (layout.count - 1) * layout.stride + elementSize;
    if (needed > viewSize || offset > viewSize - needed) {
        return to_string(layout.count) + " elements do not fit into the " + to_string(viewSize) +
               " bytes of its bufferView";
    }
    std::string_view bytes;
    if (std::string fault = bufferBytes(buffer, bytes); !fault.empty()) return fault;
    if (viewOffset > bytes.size() || viewSize > bytes.size() - viewOffset) {
        return "its bufferView reaches past the end of buffer " + to_string(buffer) +
               ", which has " + to_string(bytes.size()) + " bytes";
    }
    layout.bytes = bytes.substr(viewOffset + offset);
    return {};
}

std::string GltfDocument::bufferBytes(std::uint64_t index, std::string_view& bytes) {
    const Json* buffer = item("buffers", index);
    const std::string name = "buffer " + to_string(index);
    if (buffer == nullptr) return name + " does not exist";
    std::uint64_t size = 0;
    if (std::string fault = takeWhole(*buffer, "byteLength", size); !fault.empty()) return fault;
    if (index == 0 && member(*buffer, "uri") == nullptr) {
        bytes = binary_;
    } else {
        std::optional<std::string>& loaded = buffers_[index];
        if (!loaded) {
            std::string all;
            if (std::string fault = loadBuffer(*buffer, all); !fault.empty()) return name + fault;
            loaded = std::move(all);
        }
        bytes = *loaded;
    }
    if (size > bytes.size()) {
        return name + " is cut short: " + to_string(bytes.size()) + " bytes, but byteLength says " +
               to_string(size);
    }
    bytes = bytes.substr(0, size);
    return {};
}

std::string GltfDocument::loadBuffer(const Json& buffer, std::string& bytes) {
    const Json* uri = member(buffer, "uri");
    if (uri == nullptr || !uri->is_string()) return " has no uri";
    const auto& text = uri->get_ref<const std::string&>();
    if (text.starts_with("data:")) {
        const std::size_t comma = text.find(";base64,");
        auto decoded = comma == std::string::npos
                           ? std::nullopt
                           : decodeBase64(std::string_view(text).substr(comma + 8));
        if (!decoded) return " is not base64";
        bytes = *std::move(decoded);
        return {};
    }
    const auto path = decodePercent(text);
    if (!path || text.find("://") != std::string::npos) {
        return " lies at " + inQuotes(text) + ", expected a file beside this one";
    }
    const std::string beside = std::filesystem::path(file_).parent_path() / *path;
    Result<std::string> read = readLimitedFile(beside, mostBytes - loaded_);
    if (!read) return ": " + beside + ": " + read.problems().front().message;
    loaded_ += read->size();
    bytes = std::move(*read);
    return {};
}

}  // namespace kushi
