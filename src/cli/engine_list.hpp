// SPDX-License-Identifier: MIT
// engine_list.hpp - engines as words of the command line.
#pragma once
#include <string>
#include <vector>

#include "convexact/simplify.hpp"

namespace convexact::cli {

/// "exact,float" and the like. @param option  Its name, for the message.
/// @throws Error InvalidArgument for any other word.
[[nodiscard]] std::vector<Engine> parse_engines(const std::string& text, const char* option);

}  // namespace convexact::cli
