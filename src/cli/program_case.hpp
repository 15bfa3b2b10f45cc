// SPDX-License-Identifier: MIT
// program_case.hpp - runs a program on one input after another, and finds whether and how it fails.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "conform/program.hpp"
#include "convexact/conform.hpp"
#include "convexact/verify.hpp"

namespace convexact::cli {

/// Whether a placeholder such as "{input}" is in one of the words.
[[nodiscard]] bool mentions(const std::vector<std::string>& words, const std::string& placeholder);

/// The runs that count as failures.
enum class FailsIf {
  Either,   ///< By Exit first; by Verdict if the program succeeded.
  Exit,     ///< An exit code other than 0, a crash, no end in time.
  Verdict,  ///< The program succeeded and its output is missing or violates a claim.
  Success,  ///< Exit code 0: the program says whether an input is interesting.
};

struct ProgramCase {
  std::vector<std::string> words;                 ///< With {input}, {output} and {faces}.
  std::size_t faces = 0;                          ///< 0 if not given.
  std::string input_extension, output_extension;  ///< ".obj" and the like.
  FailsIf fails_if = FailsIf::Either;
  ProgramLimits limits;
  Precision numbers = Precision::Binary64;  ///< Of input and output.
  VerifyRequest verify;                     ///< Of the output.

  /// Makes a command for the shell the program, which succeeds on interesting inputs.
  /// @throws Error InvalidArgument if there is a program already.
  void become_predicate(const std::string& command);
  /// @throws Error InvalidArgument if a placeholder is missing or has no value.
  void require_sensible() const;
};

/// Runs the program on a file of `bytes`, which spell `input`, and returns how it fails, in words
/// that are the same for the same kind of failure: "exit code 3", "killed by signal 11", "no
/// output", "violates contains-input", "interesting"; nothing if it does not.
/// @throws Error InvalidArgument if the program cannot be started; Stopped.
[[nodiscard]] std::optional<std::string> failure_of(const ProgramCase& program,
                                                    const std::string& bytes, const Shape& input,
                                                    const ScratchFolder& folder);

}  // namespace convexact::cli
