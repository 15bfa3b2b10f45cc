// SPDX-License-Identifier: MIT
#include "cli/promise_options.hpp"

#include "cli/command.hpp"
#include "convexact/io.hpp"
#include "wire/verdict_report.hpp"

namespace convexact::cli {

Profile find_profile(const std::string& name) {
  const auto path = find_shipped("profiles.json");
  if (!path) throw Error(ErrorCode::Unreadable, "the shipped profiles.json was not found");
  try {
    return profile_of_name(read_profiles_bytes(read_bytes(*path)), name);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::Malformed) throw;
    throw error.in_file(*path);
  }
}

void add_claims_option(Command& command, std::vector<ClaimCode>& claims,
                       const std::string& meaning) {
  add_text(command, "--claims", meaning, [&claims](const auto& option, const auto& text) {
    const std::vector<ClaimCode> named = parse_claims(option, text);
    claims.insert(claims.end(), named.begin(), named.end());
  });
}

Promise PromiseOptions::promise(Asks asks_by_default) const {
  Promise result;
  result.asks = asks_by_default;
  if (!profile.empty()) result = find_profile(profile).promise;
  given.apply_to(result, promise_fields());
  return result;
}

std::optional<Asks> PromiseOptions::asks() const {
  if (!given.has("asks")) return std::nullopt;
  Promise promise;
  given.apply_to(promise, promise_fields());
  return promise.asks;
}

std::vector<std::string> PromiseOptions::words() const {
  std::vector<std::string> words;
  if (!profile.empty()) words = {"--profile", profile};
  for (const auto& [field, text] : given.all()) {
    if (field->kind != FieldKind::Flag) words.insert(words.end(), {option_of(*field), text});
  }
  return words;
}

void add_promise_options(Command& command, PromiseOptions& options, const char* asks_by_default,
                         bool may_be_flat) {
  for (const BoundField& field : options.given.bound(promise_fields())) {
    const std::string& name = field.info->name;
    if (name == "allow_flat" && !may_be_flat) continue;
    add_field(command, field,
              name == "asks" ? std::string(" (default: ") + asks_by_default + ")" : "");
    if (name != "asks") continue;
    command.add_option("--profile", options.profile,
                       "the promises of a known engine, by its name: docs/conform.md has the list; "
                       "other options override it");
  }
}

}  // namespace convexact::cli
