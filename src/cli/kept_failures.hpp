// SPDX-License-Identifier: MIT
// kept_failures.hpp - what is kept of each failure of conform: a folder to look into.
#pragma once
#include <string>

#include "cli/promise_options.hpp"
#include "convexact/conform.hpp"

namespace convexact::cli {

/// A folder, made with the first failure, with a folder for each vector on which a program fails,
/// named by its id:
///   input.obj       the input, as the program received it; input.EXT where that is no mesh
///   output.EXT      what the program wrote, if it did
///   printed.txt     the end of what it printed
///   verdict.json    as in the report
///   shrink.sh       the command that makes the input minimal, from the folder of the run
class KeptFailures {
 public:
  /// @throws Error InvalidArgument if the folder exists and is not empty; Unwritable.
  KeptFailures(std::string folder, const ConformRun& run, const PromiseOptions& promise);

  /// Keeps one; threads may call this at the same time. @throws Error Unwritable.
  void operator()(const FailedRun& failed) const;

 private:
  std::string folder_;
  const ConformRun& run_;
  const PromiseOptions& promise_;
};

/// The command line of shrink for a failure; empty if shrink judges nothing that fails there.
/// @param input  Where the input was kept; `minimal` is where the result is to go.
[[nodiscard]] std::string shrink_line(const ConformRun& run, const PromiseOptions& promise,
                                      const FailedRun& failed, const std::string& input,
                                      const std::string& minimal);

}  // namespace convexact::cli
