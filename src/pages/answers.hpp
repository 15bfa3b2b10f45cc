// SPDX-License-Identifier: MIT
// answers.hpp - every request that is a line of JSON, and the page that its answer may have.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "convexact/verify.hpp"

namespace convexact {

/// The answer to a line, as `convexact KIND --stdio` gives it: `hull`, `simplify`, `verify` or
/// `decompose`. With `picture` in the request, the answer has the page of `--picture` under that
/// name; `name` is its title.
/// @throws Error InvalidArgument for any other kind.
[[nodiscard]] std::string answer_line_of(std::string_view kind, std::string_view line,
                                         std::optional<double> time_limit = {});

/// The sentence of the first claim that does not hold, or that every claim holds.
[[nodiscard]] std::string first_sentence(const Verdict& verdict);

}  // namespace convexact
