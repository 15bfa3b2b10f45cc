// SPDX-License-Identifier: MIT
// reproducer.hpp - the data for a bug report, kept when a verification of convexact itself fails.
#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace convexact::cli {

/// The command, the bytes of its inputs, and the failure.
struct Reproducer {
  std::vector<std::string> command_line;
  std::string failure;
  /// Names and bytes of the inputs that were read; their readers share the bytes.
  std::vector<std::pair<std::string, std::shared_ptr<const std::string>>> inputs;
};

/// Writes a text file "convexact-reproducer.txt" (or "-2", "-3", ... where that exists) into
/// `folder` and returns its path; empty if it cannot be written, since an error is being reported
/// anyway.
std::string write_reproducer(const Reproducer& reproducer, const std::string& folder) noexcept;

}  // namespace convexact::cli
