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
#include "wire/judge_fields.hpp"

namespace convexact::cli {

/// Of the shipped profiles. @throws Error InvalidArgument, with their names, if there is none such.
[[nodiscard]] Profile find_profile(const std::string& name);

/// Options as they were given; missing ones come from the profile, or are as in Promise.
struct PromiseOptions {
  std::string profile;
  GivenFields given;  ///< Of promise_fields().

  /// @param asks_by_default  Used if neither the options nor a profile says.
  /// @throws Error InvalidArgument for an unknown profile.
  Promise promise(Asks asks_by_default) const;
  /// The options with values that were given, as words of a command line.
  std::vector<std::string> words() const;
  /// The value of --asks.
  std::optional<Asks> asks() const;
  /// Whether somebody chose the question, by --asks or by a profile.
  bool is_asked() const { return given.has("asks") || !profile.empty(); }
};

/// --asks, --profile, --tolerance, --numbers and the three caps.
/// @param asks_by_default  What --asks is without the option, for the help.
/// @param may_be_flat      Whether there is --allow-flat.
void add_promise_options(Command& command, PromiseOptions& options, const char* asks_by_default,
                         bool may_be_flat = false);

/// --claims: names, separated by commas; any other word, even an empty one, is wrong usage.
void add_claims_option(Command& command, std::vector<ClaimCode>& claims,
                       const std::string& meaning);

}  // namespace convexact::cli
