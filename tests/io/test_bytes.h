// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace kushi::test {

/// Spells a binary file number by number.
class Bytes {
public:
    explicit Bytes(bool bigEndian = false) : bigEndian_(bigEndian) {}

    Bytes& text(const std::string& characters) {
        bytes_ += characters;
        return *this;
    }
    Bytes& u8(std::initializer_list<int> values) { return add<std::uint8_t>(values); }
    Bytes& u16(std::initializer_list<int> values) { return add<std::uint16_t>(values); }
    Bytes& u32(std::initializer_list<std::int64_t> values) { return add<std::uint32_t>(values); }
    Bytes& f32(std::initializer_list<double> values) { return add<float>(values); }
    Bytes& f64(std::initializer_list<double> values) { return add<double>(values); }
    Bytes& zeros(std::size_t count) { return text(std::string(count, '\0')); }

    operator std::string() const { return bytes_; }

private:
    template <class T, class From>
    Bytes& add(std::initializer_list<From> values) {
        for (const From value : values) {
            const T number = static_cast<T>(value);
            std::string raw(sizeof(T), '\0');
            std::memcpy(raw.data(), &number, sizeof(T));
            if (bigEndian_) std::ranges::reverse(raw);
            bytes_ += raw;
        }
        return *this;
    }

    bool bigEndian_;
    std::string bytes_;
};

/// The header of a .hair file, as the format's page describes it.
struct HairHeader {
    std::int64_t strands = 0, points = 0, arrays = 2, defaultSegments = 0;

    operator Bytes() const {
        Bytes bytes;
        bytes.text("HAIR").u32({strands, points, arrays, defaultSegments});
        bytes.f32({1, 0, 1, 1, 1}).zeros(88);
        return bytes;
    }
};

inline void writeBytes(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

inline std::string readBytes(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace kushi::test
