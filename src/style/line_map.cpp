// SPDX-License-Identifier: Apache-2.0
#include "style/line_map.h"

#include <algorithm>

namespace kushi {

namespace {

constexpr std::size_t blockSize = 256;

bool beginsCharacter(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}

std::size_t countCharacters(std::string_view text) {
    return static_cast<std::size_t>(std::ranges::count_if(text, beginsCharacter));
}

}  // namespace

LineMap::LineMap(std::string_view text) : text_(text) {
    lineStarts_.push_back(text.starts_with("\xEF\xBB\xBF") ? 3 : 0);
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\n') lineStarts_.push_back(i + 1);
    }
    characterCounts_.push_back(0);
    for (std::size_t i = 0; i < text.size(); i += blockSize) {
        characterCounts_.push_back(characterCounts_.back() +
                                   countCharacters(text.substr(i, blockSize)));
    }
}

std::size_t LineMap::charactersBefore(std::size_t offset) const {
    const std::size_t block = offset / blockSize;
    const std::size_t start = block * blockSize;
    return characterCounts_[block] + countCharacters(text_.substr(start, offset - start));
}

Position LineMap::position(std::size_t offset) const {
    offset = std::clamp(offset, lineStarts_.front(), text_.size());
    const auto next = std::ranges::upper_bound(lineStarts_, offset);
    const std::size_t start = *(next - 1);
    return {static_cast<int>(next - lineStarts_.begin()),
            static_cast<int>(charactersBefore(offset) - charactersBefore(start)) + 1};
}

std::size_t LineMap::offset(Position position) const {
    const auto line = static_cast<std::size_t>(std::max(position.line, 1)) - 1;
    if (line >= lineStarts_.size()) return text_.size();
    const std::size_t wanted = charactersBefore(lineStarts_[line]) +
                               static_cast<std::size_t>(std::max(position.column, 1)) - 1;

    const auto block =
        std::ranges::upper_bound(characterCounts_, wanted) - characterCounts_.begin();
    if (static_cast<std::size_t>(block) == characterCounts_.size()) return text_.size();
    std::size_t count = characterCounts_[static_cast<std::size_t>(block - 1)];
    std::size_t i = static_cast<std::size_t>(block - 1) * blockSize;
    while (i < text_.size() && (count < wanted || !beginsCharacter(text_[i]))) {
        count += beginsCharacter(text_[i]) ? 1 : 0;
        ++i;
    }
    return i;
}

}  // namespace kushi
