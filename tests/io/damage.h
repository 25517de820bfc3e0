// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/random.h"

#include <cstdint>
#include <string>

namespace kushi::test {

/// Numbers that follow from a seed alone, on every machine.
class Dice {
public:
    explicit Dice(std::uint64_t seed) : key_(seed) {}
    std::size_t below(std::size_t end) {
        key_ = scramble(key_);
        return static_cast<std::size_t>(uniform(key_) * static_cast<double>(end));
    }

private:
    std::uint64_t key_;
};

/// Bytes with one to four changes of all kinds.
inline std::string mutated(std::string bytes, Dice& dice) {
    const std::size_t changes = 1 + dice.below(4);
    for (std::size_t i = 0; i < changes && !bytes.empty(); ++i) {
        const std::size_t at = dice.below(bytes.size());
        const auto byte = static_cast<char>(dice.below(256));
        const auto digit = static_cast<char>('0' + dice.below(10));
        switch (dice.below(7)) {
            case 0:
                bytes[at] = byte;
                break;
            case 1:
                bytes[at] = static_cast<char>(bytes[at] ^ (1 << dice.below(8)));
                break;
            case 2:
                bytes[at] = digit;
                break;
            case 3:
                bytes.resize(at);
                break;
            case 4:
                bytes.insert(at, 1 + dice.below(3), byte);
                break;
            case 5:
                bytes.erase(at, 1 + dice.below(8));
                break;
            default:
                bytes.insert(at, bytes.substr(dice.below(bytes.size()), 40));
                break;
        }
    }
    return bytes;
}

}  // namespace kushi::test
