// SPDX-License-Identifier: Apache-2.0
#include "style/lexical_check.h"

#include <algorithm>

namespace kushi {

namespace {

constexpr std::string_view blanks = " \t\n\r\v\f";

bool isAscii(char c) {
    return static_cast<unsigned char>(c) < 0x80;
}

class Scanner {
public:
    explicit Scanner(std::string_view text) : text_(text) {
        if (text.starts_with("\xEF\xBB\xBF")) at_ = 3;
    }

    std::optional<SourceFault> run() {
        while (at_ < text_.size() && !fault_) {
            const char c = text_[at_];
            if (c == '#') {
                at_ = std::min(text_.find('\n', at_), text_.size());
            } else if (c == '"' || c == '\'') {
                skipString();
            } else {
                checkBare(c);
                ++at_;
            }
        }
        return std::move(fault_);
    }

private:
    void checkBare(char c) {
        if (!isAscii(c)) failBeyondAscii(at_);
        if (std::string_view("=,[]{}\n").find(c) != std::string_view::npos) dots_ = 0;
        if (c == '.' && ++dots_ >= longestKeyPath) {
            fault_ = SourceFault{at_, "found a dotted key of more than " +
                                          std::to_string(longestKeyPath) + " parts"};
        }
    }

    // Closed or not.
    void skipString() {
        const std::size_t begin = at_;
        const std::string fence(3, text_[at_]);
        if (text_.substr(at_, 3) == fence) {
            skipLongString(fence);
        } else {
            skipShortString(text_[at_]);
        }
        const std::string_view apart = " \t\n\r=,[{";
        if (begin == 0 || apart.find(text_[begin - 1]) != std::string_view::npos) return;
        const std::string_view string = text_.substr(begin, at_ - begin);
        const auto wide = std::ranges::find_if_not(string, isAscii);
        if (wide != string.end()) {
            failBeyondAscii(begin + static_cast<std::size_t>(wide - string.begin()));
        }
    }

    // Ends at the end of the line at the latest.
    void skipShortString(char quote) {
        for (++at_; at_ < text_.size() && text_[at_] != '\n'; ++at_) {
            if (text_[at_] == quote) {
                ++at_;
                return;
            }
            if (quote == '"' && text_[at_] == '\\' && text_.substr(at_ + 1, 1) != "\n") ++at_;
        }
        at_ = std::min(at_, text_.size());
    }

    void skipLongString(const std::string& fence) {
        at_ += 3;
        while (at_ < text_.size()) {
            if (text_.substr(at_, 3) == fence) {
                at_ += 3;
                // Up to two quotes may stand right before the closing three.
                for (int i = 0; i < 2 && text_.substr(at_, 1) == fence.substr(0, 1); ++i)
                    ++at_;
                return;
            }
            if (fence[0] == '"' && text_[at_] == '\\') {
                skipEscape();
            } else {
                ++at_;
            }
        }
    }

    // In a multi-line string, where a backslash may eat all blanks and line ends that follow.
    void skipEscape() {
        ++at_;
        const std::size_t next = std::min(text_.find_first_not_of(blanks, at_), text_.size());
        if (next < text_.size() && !isAscii(text_[next])) failBeyondAscii(next);
        at_ = next > at_ ? next : std::min(at_ + 1, text_.size());
    }

    void failBeyondAscii(std::size_t offset) {
        std::size_t end = offset + 1;
        while (end < text_.size() && (static_cast<unsigned char>(text_[end]) & 0xC0U) == 0x80U) {
            ++end;
        }
        fault_ = SourceFault{offset, "found '" + std::string(text_.substr(offset, end - offset)) +
                                         "', expected no such character outside of strings and "
                                         "comments"};
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int dots_ = 0;
    std::optional<SourceFault> fault_;
};

}  // namespace

std::optional<SourceFault> findLexicalFault(std::string_view text) {
    return Scanner(text).run();
}

}  // namespace kushi
