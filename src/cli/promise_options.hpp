// SPDX-License-Identifier: MIT
// promise_options.hpp - the promise of a program, from --profile and single options, and the claims
// to decide.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "cli/parser.hpp"
#include "convexact/conform.hpp"
#include "convexact/verify.hpp"

namespace convexact::cli {

/// Options as they were given; missing ones come from the profile, or are as in Promise.
struct PromiseOptions {
  std::string profile, tolerance;
  std::optional<Asks> asks;
  std::optional<Precision> numbers;
  bool allow_flat = false;
  std::optional<std::size_t> max_facets, max_vertices, max_facet_vertices;

  /// @param asks_by_default  Used if neither the options nor a profile says.
  /// @throws Error InvalidArgument for an unknown profile or a malformed tolerance.
  Promise promise(Asks asks_by_default) const;
  /// The options that were given, as words of a command line.
  std::vector<std::string> words() const;
  /// Whether somebody chose the question, by --asks or by a profile.
  bool is_asked() const { return asks || !profile.empty(); }
};

/// --profile, --tolerance, --numbers and the three caps.
void add_promise_options(Command& command, PromiseOptions& options);
/// --asks. @param by_default  What it is without the option, for the help.
void add_asks_option(Command& command, std::optional<Asks>& asks, const char* by_default);

/// The value of --claims: names, separated by commas.
/// @throws Error InvalidArgument, listing the names, for any other word, even an empty one.
[[nodiscard]] std::vector<ClaimCode> parse_claims(const std::string& text);

}  // namespace convexact::cli
