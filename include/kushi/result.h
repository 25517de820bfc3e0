// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace kushi {

/// Something a user can mend: a sentence, and where it applies when that is known.
struct Problem {
    std::string message = {};  ///< what was found and what was expected, without a final full stop
    std::string file = {};     ///< path as the user gave it; empty if none
    int line = 0;              ///< from 1; 0 if unknown
    int column = 0;            ///< from 1, in characters; 0 if unknown
    bool system = false;       ///< the machine's fault (a full disk), not the input's
};

/// "file:line:column: error: message", leaving out what is unknown.
std::string toString(const Problem& problem);

/// A value, or at least one problem. Nothing in the library throws across its border.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : state_(std::move(value)) {}
    Result(Problem problem) : state_(std::vector<Problem>{std::move(problem)}) {}
    Result(std::vector<Problem> problems) : state_(std::move(problems)) {}

    bool ok() const { return std::holds_alternative<T>(state_); }
    explicit operator bool() const { return ok(); }

    /// Only after ok().
    const T& value() const& { return *std::get_if<T>(&state_); }
    T& value() & { return *std::get_if<T>(&state_); }
    T&& value() && { return std::move(*std::get_if<T>(&state_)); }
    const T& operator*() const& { return value(); }
    T& operator*() & { return value(); }
    T&& operator*() && { return std::move(*this).value(); }
    const T* operator->() const { return &value(); }
    T* operator->() { return &value(); }

    /// Only after !ok().
    const std::vector<Problem>& problems() const {
        return *std::get_if<std::vector<Problem>>(&state_);
    }

private:
    std::variant<T, std::vector<Problem>> state_;
};

/// Success, or at least one problem.
using Status = Result<std::monostate>;

}  // namespace kushi
