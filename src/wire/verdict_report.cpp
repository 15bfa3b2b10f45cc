// SPDX-License-Identifier: MIT
#include "wire/verdict_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "convexact/number.hpp"
#include "io/json.hpp"
#include "number/precision.hpp"
#include "number/text.hpp"
#include "simplify/run_names.hpp"

namespace convexact {
namespace {

// ---- JSON

Json distance_json(const Rational& squared, const Rational& squared_diameter) {
  Json json = {{"squared", to_string(squared)}, {"decimal", decimal_of_root(squared, kDigits)}};
  if (squared_diameter > 0) {
    json["relative"] = decimal_of_root(squared / squared_diameter, kDigits);
  }
  return json;
}

Json witness_json(const Witness& w, const Rational& squared_diameter) {
  Json json = Json::object();
  if (w.input_point) json["input_point"] = *w.input_point;
  if (!w.vertices.empty()) json["vertices"] = w.vertices;
  if (!w.faces.empty()) json["faces"] = w.faces;
  if (!w.rows.empty()) json["rows"] = w.rows;
  if (w.line) json["line"] = *w.line;
  if (w.plane) json["plane"] = plane_json(*w.plane);
  if (w.point) json["point"] = vector_json(*w.point);
  if (w.nearest) json["nearest"] = vector_json(*w.nearest);
  if (w.direction) json["direction"] = vector_json(*w.direction);
  if (w.squared_distance) json["distance"] = distance_json(*w.squared_distance, squared_diameter);
  if (w.count) json["count"] = *w.count;
  if (!w.parts.empty()) json["parts"] = w.parts;
  if (w.input_face) json["input_face"] = *w.input_face;
  if (w.winding) json["winding"] = *w.winding;
  if (!w.nodes.empty()) json["nodes"] = w.nodes;
  return json;
}

Json size_json(const CandidateSize& size) {
  Json json = {{"stored_faces", size.stored_faces}, {"stored_vertices", size.stored_vertices}};
  const auto add = [&](const char* key, std::optional<std::size_t> count) {
    if (count) json[key] = *count;
  };
  add("facets", size.facets);
  add("vertices", size.vertices);
  add("most_facet_vertices", size.most_facet_vertices);
  add("facets_as_meant", size.facets_as_meant);
  if (size.facets_as_meant) {
    const bool is_own = size.slack.ulps_of_largest == 0;
    json["u"] = {{"ulps", is_own ? 0.5 : size.slack.ulps_of_largest},
                 {"of", is_own ? "each" : "largest"},
                 {"numbers", name_in(kPrecisionNames, size.slack.precision)}};
  }
  if (size.planes_of_the_input) json["planes_of_the_input"] = size.planes_of_the_input->size();
  return json;
}

// ---- Text

constexpr int kVerdictDigits = 6;

std::string claim_lines(const Claim& claim) {
  std::string text = fmt::format("  {:<19} {:<15} {}\n", name_of(claim.code), name_of(claim.status),
                                 claim.sentence);
  if (claim.witness.squared_distance) {
    text += fmt::format("  {:<35} the square of the distance is {}\n", "",
                        in_sentence(*claim.witness.squared_distance));
  }
  return text;
}

std::string not_asked_line(std::span<const Claim> claims) {
  std::string names;
  for (const Claim& claim : claims) {
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
    text += verdict_line("", with_separators(*size.facets_as_meant) +
                                 " facets as meant: coplanar if coordinates move by at most u, " +
                                 describe(size.slack));
  }
  if (size.planes_of_the_input) {
    text +=
        verdict_line("", with_separators(size.planes_of_the_input->size()) +
                             " of its planes are facet planes of the input's hull, up to rounding");
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
         verdict_line("",
                      fmt::format("Hausdorff distance {} ({} of the diameter)",
                                  decimal_of_root(tightness.squared_hausdorff, kVerdictDigits),
                                  decimal_of_root(tightness.squared_hausdorff / squared_diameter,
                                                  kVerdictDigits)));
}

// An enclosure may be of any size, and who asks about a hull may not know that.
std::string hull_not_asked_line(const std::optional<Tightness>& tightness) {
  const Rational large(3, 2);
  if (!tightness || tightness->volume_ratio.low() <= large) {
    return verdict_line("not asked", "whether it is the hull: --asks hull");
  }
  return verdict_line("not asked", to_decimal(tightness->volume_ratio, 3).value_or("?") +
                                       " times the hull: --asks hull asks whether it is the hull");
}

}  // namespace

std::string verdict_line(const char* label, const std::string& text) {
  return fmt::format("  {:<19} {}\n", label, text);
}

bool is_violated(std::span<const Claim> claims) {
  return std::any_of(claims.begin(), claims.end(),
                     [](const Claim& claim) { return claim.status == Status::Violated; });
}

Json claims_json(std::span<const Claim> claims, const Rational& squared_diameter) {
  Json list = Json::array();
  for (const Claim& claim : claims) {
    Json& json = list.emplace_back();
    json = {{"code", name_of(claim.code)}, {"status", name_of(claim.status)}};
    if (!claim.sentence.empty()) json["sentence"] = claim.sentence;
    Json witness = witness_json(claim.witness, squared_diameter);
    if (!witness.empty()) json["witness"] = std::move(witness);
  }
  const bool is_undecided = std::any_of(claims.begin(), claims.end(), [](const Claim& claim) {
    return claim.status == Status::Undecided || claim.is_unanswered();
  });
  return {{"verdict", is_violated(claims) ? "violated"
                      : is_undecided      ? "undecided"
                                          : "holds"},
          {"claims", std::move(list)}};
}

std::string claims_text(std::span<const Claim> claims) {
  std::string text;
  for (const Claim& claim : claims) {
    if (claim.status != Status::NotAsked) text += claim_lines(claim);
  }
  return text + not_asked_line(claims);
}

std::string verdict_line(std::span<const Claim> claims) {
  const auto count = [&](const auto& is_meant) {
    return std::count_if(claims.begin(), claims.end(), is_meant);
  };
  const auto violated = count([](const Claim& c) { return c.status == Status::Violated; });
  const auto undecided = count([](const Claim& c) { return c.status == Status::Undecided; });
  const auto inapplicable = count([](const Claim& c) { return c.is_unanswered(); });
  const auto counted = [](std::ptrdiff_t number, const char* one, const char* many) {
    return number == 1 ? std::string("1 claim ") + one : fmt::format("{} claims {}", number, many);
  };
  return verdict_line("verdict", violated > 0    ? counted(violated, "is violated", "are violated")
                                 : undecided > 0 ? counted(undecided, "is", "are") + " not decided"
                                 : inapplicable > 0 ? counted(inapplicable, "was", "were") +
                                                          " asked for by name and cannot be decided"
                                                    : "every claim holds");
}

Json verdict_json(const Verdict& verdict) {
  Json json = claims_json(verdict.claims, verdict.squared_diameter);
  json["candidate"] = size_json(verdict.size);
  if (const auto& outside = verdict.outside) {
    json["outside"] = {{"points", outside->points},
                       {"tested", outside->tested},
                       {"used_by_no_face", outside->unused}};
    if (const auto& worst = outside->relative_squared_distance) {
      json["outside"]["worst_relative"] = decimal_of_root(*worst, kDigits);
    }
  }
  if (const auto& tightness = verdict.tightness) {
    json["tightness"] = {
        {"volume_ratio", measured_json({tightness->volume_ratio, {}}, kDigits)},
        {"area_ratio", measured_json({tightness->area_ratio, {}}, kDigits)},
        {"mean_width_ratio", measured_json({tightness->mean_width_ratio, {}}, kDigits)},
        {"hausdorff", distance_json(tightness->squared_hausdorff, verdict.squared_diameter)}};
  }
  if (const auto& least = verdict.smallest_tolerance) {
    json["smallest_tolerance"] = {{"value", least->decimal}, {"rounding", least->is_rounding}};
  }
  if (!verdict.notes.empty()) json["notes"] = verdict.notes;
  return json;
}

const char* name_of(Asks asks) { return name_in(kAsksNames, asks); }

std::string verdict_table(const Verdict& verdict, bool is_asked) {
  std::string text = claims_text(verdict.claims);
  text += size_lines(verdict.size);
  if (verdict.tightness) text += tightness_lines(*verdict.tightness, verdict.squared_diameter);
  for (const std::string& note : verdict.notes) text += verdict_line("note", note);
  if (!is_asked) text += hull_not_asked_line(verdict.tightness);
  return text + verdict_line(verdict.claims);
}

}  // namespace convexact
