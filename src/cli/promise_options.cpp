// SPDX-License-Identifier: MIT
#include "cli/promise_options.hpp"

#include <filesystem>

#include "cli/quantity_option.hpp"
#include "cli/shipped_files.hpp"
#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "convexact/number.hpp"
#include "number/text.hpp"
#include "oracle/conformance_report.hpp"
#include "scene/result_json.hpp"

namespace convexact::cli {
namespace {

Profile find_profile(const std::string& name) {
  const auto path = find_shipped("profiles.json",
                                 [](const auto& place) { return std::filesystem::exists(place); });
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

// An option that takes one of a few words.
template <class E, std::size_t N>
void add_word(CLI::App& command, const std::string& name, std::optional<E>& value,
              const NameTable<E, N>& words, const std::string& meaning) {
  std::string list;
  for (const auto& [meant, word] : words) list += std::string(list.empty() ? "" : "|") + word;
  add_text(command, name, meaning, [&value, words, list](const auto& option, const auto& text) {
    value = value_in(words, text);
    if (value) return;
    throw Error(ErrorCode::InvalidArgument,
                option + ": expected " + list + ", found " + in_quotes(text));
  })->type_name(list);
}

}  // namespace

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

void add_promise_options(CLI::App& command, PromiseOptions& options) {
  command.add_option("--profile", options.profile,
                     "the promises of a known engine, by its name: docs/conform.md has the list; "
                     "other options override it");
  command.add_option("--tolerance", options.tolerance,
                     "let violations up to this distance pass: 1e-6, or 1e-9d of the diameter");
  add_word(
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

void add_asking_options(CLI::App& command, PromiseOptions& options) {
  add_word(command, "--asks", options.asks, kAsksNames,
           "what the program writes: an enclosure, the hull, a solid inside it, or an "
           "enclosure of {faces} facets (default: simplify with {faces}, else enclosure)");
  command.add_flag("--allow-flat", options.allow_flat,
                   "accepting points without volume is not a failure");
}

}  // namespace convexact::cli
