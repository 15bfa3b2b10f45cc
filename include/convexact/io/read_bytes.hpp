// SPDX-License-Identifier: MIT
// read_bytes.hpp - a whole file, or standard input, in memory.
#pragma once
#include <string>

namespace convexact {

/// All bytes of the file at `path`; "-" is standard input.
/// @throws Error Unreadable if it does not exist, is a directory or cannot be read.
[[nodiscard]] std::string read_bytes(const std::string& path);

/// How errors call the file: the path, or "standard input" for "-".
[[nodiscard]] std::string display_name(const std::string& path);

}  // namespace convexact
