// SPDX-License-Identifier: MIT
#include "cli/promise_options.hpp"

#include "cli/command.hpp"
#include "convexact/io.hpp"
#include "simplify/run_names.hpp"
#include "wire/verdict_report.hpp"

namespace convexact::cli {
namespace {

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

template <class Value>
void override_by(Value& value, const auto& given) {
  if (given) value = *given;
}

}  // namespace

std::vector<ClaimCode> parse_claims(const std::string& text) {
  std::vector<ClaimCode> claims;
  for (const std::string& word : words_of(text)) {
    const auto code = claim_of_name(word);
    if (!code) {
      std::string names;
      for (const ClaimCode known : kAllClaims) {
        names += (names.empty() ? "" : ", ") + std::string(name_of(known));
      }
      for (const ClaimCode known : {ClaimCode::InsideInput, ClaimCode::IsHull}) {
        names += ", " + std::string(name_of(known));
      }
      for (const ClaimCode known : kPartsClaims) names += ", " + std::string(name_of(known));
      names += ", " + std::string(name_of(ClaimCode::TreeNested));
      throw Error(ErrorCode::InvalidArgument,
                  "--claims: expected names out of " + names + "; found " + in_quotes(word));
    }
    claims.push_back(*code);
  }
  return claims;
}

Promise PromiseOptions::promise(Asks asks_by_default) const {
  Promise result;
  result.asks = asks_by_default;
  if (!profile.empty()) result = find_profile(profile).promise;
  override_by(result.asks, asks);
  override_by(result.numbers, numbers);
  override_by(result.max_facets, max_facets);
  override_by(result.max_vertices, max_vertices);
  override_by(result.max_facet_vertices, max_facet_vertices);
  if (!tolerance.empty()) result.tolerance = parse_tolerance(tolerance);
  result.allow_flat = result.allow_flat || allow_flat;
  return result;
}

std::vector<std::string> PromiseOptions::words() const {
  std::vector<std::string> words;
  const auto add = [&](const char* option, const std::string& value) {
    words.insert(words.end(), {option, value});
  };
  const auto add_count = [&](const char* option, const std::optional<std::size_t>& count) {
    if (count) add(option, std::to_string(*count));
  };
  if (!profile.empty()) add("--profile", profile);
  if (asks) add("--asks", name_of(*asks));
  if (numbers) add("--numbers", name_in(kPrecisionNames, *numbers));
  if (!tolerance.empty()) add("--tolerance", tolerance);
  add_count("--max-facets", max_facets);
  add_count("--max-vertices", max_vertices);
  add_count("--max-facet-vertices", max_facet_vertices);
  return words;
}

void add_promise_options(Command& command, PromiseOptions& options) {
  command.add_option("--profile", options.profile,
                     "the promises of a known engine, by its name: docs/conform.md has the list; "
                     "other options override it");
  command.add_option("--tolerance", options.tolerance,
                     "let violations up to this distance pass: 1e-6, or 1e-9d of the diameter");
  add_choice(
      command, "--numbers", options.numbers, kPrecisionNames,
      "the numbers of input and output are doubles, or each is rounded to the nearest binary32 "
      "(default: binary64)");
  add_count(
      command, "--max-facets", options.max_facets, {},
      "most facets; coplanar faces count as one, in a mesh also faces that only rounding bent");
  add_count(command, "--max-vertices", options.max_vertices, {}, "most corners of the solid");
  add_count(command, "--max-facet-vertices", options.max_facet_vertices, {},
            "most corners of a facet");
}

void add_asks_option(Command& command, std::optional<Asks>& asks, const char* by_default) {
  add_choice(command, "--asks", asks, kAsksNames,
             std::string("what was to be written: an enclosure, the hull, a solid inside it, or an "
                         "enclosure of so many facets (default: ") +
                 by_default + ")");
}

}  // namespace convexact::cli
