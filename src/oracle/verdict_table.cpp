// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "convexact/number.hpp"
#include "number/precision.hpp"
#include "number/text.hpp"
#include "oracle/verdict_text.hpp"
#include "scene/summary.hpp"

namespace convexact {
namespace {

constexpr int kVerdictDigits = 6;
constexpr std::size_t kLongestFraction = 60;  // longer ones are for --json

std::string verdict_line(const char* label, const std::string& text) {
  return fmt::format("  {:<19} {}\n", label, text);
}

std::string root_text(const Rational& squared) {
  return to_decimal(sqrt(Enclosure(squared, kMeasureBits)), kVerdictDigits).value_or("?");
}

std::string claim_lines(const Claim& claim) {
  std::string text = fmt::format("  {:<19} {:<15} {}\n", name_of(claim.code), name_of(claim.status),
                                 claim.sentence);
  if (claim.witness.squared_distance) {
    const std::string exact = to_string(*claim.witness.squared_distance);
    text += fmt::format("  {:<35} the square of the distance is {}\n", "",
                        exact.size() <= kLongestFraction
                            ? exact
                            : fmt::format("a fraction of {} characters, see --json", exact.size()));
  }
  return text;
}

std::string not_asked_line(const Verdict& verdict) {
  std::string names;
  for (const Claim& claim : verdict.claims) {
    if (claim.status == Status::NotAsked) {
      names += (names.empty() ? "" : ", ") + std::string(name_of(claim.code));
    }
  }
  return names.empty() ? "" : verdict_line("not asked", names);
}

std::string size_lines(const CandidateSize& size) {
  std::string stored =
      with_separators(size.stored_faces) + (size.stored_vertices > 0 ? " faces, " : " rows");
  if (size.stored_vertices > 0) stored += with_separators(size.stored_vertices) + " vertices";
  if (!size.facets) return verdict_line("size", stored + " as stored");
  std::string text = verdict_line(
      "size", fmt::format("{} facets, {} vertices, the largest facet has {} corners ({} as "
                          "stored)",
                          with_separators(*size.facets), with_separators(*size.vertices),
                          *size.most_facet_vertices, stored));
  if (size.facets_as_meant) {
    text +=
        verdict_line("", fmt::format("{} facets as meant: coplanar if coordinates move by at "
                                     "most u, {}",
                                     with_separators(*size.facets_as_meant), describe(size.slack)));
  }
  if (size.planes_of_the_input) {
    text +=
        verdict_line("", fmt::format("{} of its planes are facet planes of the input's hull, up to "
                                     "rounding",
                                     with_separators(*size.planes_of_the_input)));
  }
  return text;
}

std::string tightness_lines(const Tightness& tightness, const Rational& squared_diameter) {
  const auto ratio = [](const Enclosure& bounds) {
    return to_decimal(bounds, kVerdictDigits).value_or("?");
  };
  return verdict_line("against the hull",
                      fmt::format("volume times {}, area times {}, mean width times {}",
                                  ratio(tightness.volume_ratio), ratio(tightness.area_ratio),
                                  ratio(tightness.mean_width_ratio))) +
         verdict_line("", fmt::format("Hausdorff distance {} ({} of the diameter)",
                                      root_text(tightness.squared_hausdorff),
                                      root_text(tightness.squared_hausdorff / squared_diameter)));
}

std::string verdict_line(const Verdict& verdict) {
  const auto violated =
      std::count_if(verdict.claims.begin(), verdict.claims.end(),
                    [](const Claim& claim) { return claim.status == Status::Violated; });
  const auto undecided = std::count_if(verdict.claims.begin(), verdict.claims.end(),
                                       [](const Claim& claim) { return claim.is_undecided(); });
  if (violated == 0 && undecided > 0) {
    return verdict_line(
        "verdict",
        fmt::format("{} asked for by name and cannot be decided",
                    undecided == 1 ? "1 claim was" : fmt::format("{} claims were", undecided)));
  }
  if (violated == 0) return verdict_line("verdict", "every claim holds");
  return verdict_line(
      "verdict",
      fmt::format("{} violated",
                  violated == 1 ? "1 claim is" : fmt::format("{} claims are", violated)));
}

}  // namespace

std::string verdict_table(const Verdict& verdict) {
  std::string text;
  for (const Claim& claim : verdict.claims) {
    if (claim.status != Status::NotAsked) text += claim_lines(claim);
  }
  text += not_asked_line(verdict);
  text += size_lines(verdict.size);
  if (verdict.tightness) text += tightness_lines(*verdict.tightness, verdict.squared_diameter);
  for (const std::string& note : verdict.notes) text += verdict_line("note", note);
  return text + verdict_line(verdict);
}

}  // namespace convexact
