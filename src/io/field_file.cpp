// SPDX-License-Identifier: Apache-2.0
#include "io/field_file.h"

#include "io/atomic_file.h"
#include "io/bytes.h"
#include "io/content_key.h"
#include "io/file_limit.h"
#include "io/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace kushi {
namespace {

using std::to_string;

constexpr std::array<char, 8> mark = {'K', 'U', 'S', 'H', 'I', 'F', 'L', 'D'};
constexpr std::uint32_t currentVersion = 1;

struct Header {
    std::array<char, 8> signature = mark;
    std::uint32_t version = currentVersion;
    std::uint32_t hasNearest = 0;
    std::array<float, 3> origin{};
    float spacing = 0;
    std::array<std::int32_t, 3> size{};
    std::uint32_t unused = 0;
    std::uint64_t checksum = 0;

    /// As a double it does not overflow.
    double samples() const { return double(size[0]) * double(size[1]) * double(size[2]); }
    double fileSize() const { return sizeof(Header) + samples() * (hasNearest != 0 ? 3 : 2); }
};
static_assert(sizeof(Header) == 56);

/// Of all but the checksum itself.
std::uint64_t checksumOf(Header header, std::string_view samples) {
    header.checksum = 0;
    ContentKey key(header.version);
    key.add(std::span<const Header>(&header, 1));
    key.add(samples);
    return key.value();
}

bool isSound(const Header& header) {
    const bool empty = header.size == std::array<std::int32_t, 3>{} && header.spacing == 0;
    const bool full = std::ranges::all_of(header.size, [](int n) { return n >= 2; }) &&
                      std::isfinite(header.spacing) && header.spacing > 0;
    return (empty || full) && header.hasNearest <= 1 &&
           std::ranges::all_of(header.origin, [](float x) { return std::isfinite(x); });
}

/// What is wrong with a file; empty if nothing.
std::string faultOf(const Header& header, std::string_view bytes) {
    if (header.version != currentVersion) {
        return "a distance field of version " + to_string(header.version) +
               "; this Kushi reads version " + to_string(currentVersion);
    }
    if (!isSound(header)) return "its header is damaged: a distance field cannot be like that";
    const double expected = header.fileSize();
    if (const auto size = static_cast<double>(bytes.size()); size != expected) {
        return (size < expected ? "cut short: " : "bytes after the end: ") +
               to_string(bytes.size()) + " bytes, but a field of " + to_string(header.size[0]) +
               " x " + to_string(header.size[1]) + " x " + to_string(header.size[2]) +
               " samples has " + (expected < 1e15 ? to_string(std::llround(expected)) : "more");
    }
    if (checksumOf(header, bytes.substr(sizeof(Header))) != header.checksum) {
        return "the file is damaged: its checksum is not that of its bytes";
    }
    return {};
}

template <class T>
void append(std::string& bytes, const std::vector<T>& values) {
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

template <class T>
void take(std::string_view& bytes, std::vector<T>& values, std::size_t count) {
    values.resize(count);
    std::copy_n(bytes.data(), count * sizeof(T), reinterpret_cast<char*>(values.data()));
    bytes.remove_prefix(count * sizeof(T));
}

}  // namespace

Result<DistanceField> parseField(std::string_view bytes, const std::string& file) {
    const std::string_view signature(mark.data(), mark.size());
    if (!bytes.starts_with(signature)) {
        return badFile(file, "not a distance field of Kushi's: it does not start with '" +
                                 std::string(signature) + "'");
    }
    if (bytes.size() < sizeof(Header)) {
        return badFile(file, "cut short: " + to_string(bytes.size()) +
                                 " bytes, but the header of a distance field alone has " +
                                 to_string(sizeof(Header)));
    }
    const auto header = load<Header>(bytes.data());
    if (std::string fault = faultOf(header, bytes); !fault.empty()) {
        return badFile(file, std::move(fault));
    }
    DistanceField field;
    field.origin = {header.origin[0], header.origin[1], header.origin[2]};
    field.spacing = header.spacing;
    field.size = header.size;
    const auto samples = static_cast<std::size_t>(header.samples());
    bytes.remove_prefix(sizeof(Header));
    take(bytes, field.units, samples);
    if (header.hasNearest != 0) take(bytes, field.nearest, samples);
    return field;
}

std::string formatField(const DistanceField& field) {
    Header header;
    header.hasNearest = field.nearest.empty() ? 0 : 1;
    header.origin = {field.origin.x, field.origin.y, field.origin.z};
    header.spacing = field.spacing;
    header.size = field.size;
    std::string bytes;
    bytes.reserve(sizeof(Header) + 2 * field.units.size() + field.nearest.size());
    store(bytes, header);
    append(bytes, field.units);
    append(bytes, field.nearest);
    header.checksum = checksumOf(header, std::string_view(bytes).substr(sizeof(Header)));
    std::memcpy(bytes.data(), &header, sizeof(Header));
    return bytes;
}

Result<DistanceField> readField(const std::string& path) {
    const Result<std::string> bytes = readLimitedFile(path, mostBytes);
    if (!bytes) return bytes.problems();
    return parseField(*bytes, path);
}

Status writeField(const std::string& path, const DistanceField& field) {
    return writeFileAtomically(path, formatField(field));
}

}  // namespace kushi
