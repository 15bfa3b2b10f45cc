// SPDX-License-Identifier: MIT
#include "wire/query_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "io/json.hpp"
#include "number/precision.hpp"

namespace convexact {
namespace {

Json solid_json(const NamedPolytope& named) {
  return {{"name", named.name},
          {"halfspaces", named.solid.planes.size()},
          {"vertices", named.solid.vertices.size()}};
}

Json point_json(const RationalPoint& x) {
  return {quantity_json(x[0]), quantity_json(x[1]), quantity_json(x[2])};
}

// The planes are given beside the ids, so that the sum can be checked from this object alone.
void add_multipliers(Json& list, const char* of, const Polytope& solid,
                     const std::vector<Multiplier>& y) {
  for (const Multiplier& m : y) {
    list.push_back({{"of", of},
                    {"halfspace", m.row},
                    {"plane", plane_json(solid.planes[m.row])},
                    {"multiplier", to_string(m.value)}});
  }
}

Json interval_json(const LineInterval& line) {
  return {{"entry", quantity_json(line.entry)},
          {"exit", quantity_json(line.exit)},
          {"entry_halfspaces", line.entry_facets},
          {"exit_halfspaces", line.exit_facets}};
}

Json ray_json(const RayAnswer& answer) {
  Json json = {{"hit", answer.is_hit()}};
  if (answer.is_hit()) {
    json["t"] = quantity_json(answer.first());
  } else {
    json["missed"] = answer.missed;
  }
  json["line"] = answer.line ? interval_json(*answer.line) : Json(nullptr);
  return json;
}

Json tally_json(const ProbeTally& tally) {
  return {{"samples", tally.samples},
          {"hits_a", tally.hits_a},
          {"hits_b", tally.hits_b},
          {"only_b", tally.only_b},
          {"only_a", tally.only_a},
          {"expected_hits_b", middle_double(tally.expected_b)},
          {"rate", or_null(tally.rate())},
          {"predicted", tally.prediction ? bounds_json(*tally.prediction) : Json(nullptr)},
          {"sigma", or_null(tally.sigma())},
          {"decided_exactly", tally.exact}};
}

constexpr std::array<std::pair<const char*, std::optional<ProbeTally> FalsePositives::*>, 3> kKinds{
    {{"lines", &FalsePositives::lines},
     {"planes", &FalsePositives::planes},
     {"points", &FalsePositives::points}}};

// "1/3 (0.33333333333333333)", "2", or the digits alone of a fraction too long to read.
std::string rational_text(const Rational& x) {
  constexpr std::size_t kReadable = 24;
  std::string exact = to_string(x);
  const std::string decimal = to_decimal(x, kDigits);
  if (exact == decimal) return exact;
  return exact.size() <= kReadable ? exact + " (" + decimal + ")" : decimal;
}

std::string ids_text(const std::vector<HalfspaceId>& ids) {
  std::string text;
  for (const HalfspaceId id : ids) text += (text.empty() ? "" : ",") + std::to_string(id.value);
  return text;
}

std::string ray_text(const RayAnswer& answer) {
  if (!answer.line) {
    return fmt::format("miss   no point of it is in halfspace{} {}\n",
                       answer.missed.size() > 1 ? "s" : "", ids_text(answer.missed));
  }
  const LineInterval& line = *answer.line;
  const std::string interval = fmt::format("t from {} to {}, halfspaces {} to {}",
                                           rational_text(line.entry), rational_text(line.exit),
                                           ids_text(line.entry_facets), ids_text(line.exit_facets));
  if (!answer.is_hit()) return fmt::format("miss   behind the origin: {}\n", interval);
  const char* note = line.entry < 0            ? " (begins inside)"
                     : line.entry == line.exit ? " (touches)"
                                               : "";
  return fmt::format("hit    {}{}\n", interval, note);
}

std::string multipliers_text(const char* of, const std::vector<Multiplier>& y) {
  std::string text;
  for (const Multiplier& m : y) {
    text += fmt::format("{}{} times halfspace {} of {}", text.empty() ? "" : " + ",
                        to_string(m.value), m.row, of);
  }
  return text;
}

std::string share_text(const std::optional<double>& share) {
  return share ? fmt::format("{:.5f}", *share) : "-";
}

std::string tally_text(const char* kind, const ProbeTally& tally) {
  std::optional<double> predicted;
  if (tally.prediction) predicted = std::max(0.0, middle_double(*tally.prediction));
  return fmt::format("  {:<8}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>11}{:>10}\n", kind,
                     tally.samples, tally.hits_a, tally.hits_b, tally.only_b, tally.only_a,
                     share_text(tally.rate()), share_text(predicted), share_text(tally.sigma()));
}

std::string solids_text(const NamedPolytope& a, const NamedPolytope& b) {
  return fmt::format("A  {}: {} halfspaces\nB  {}: {} halfspaces\n", a.name, a.solid.planes.size(),
                     b.name, b.solid.planes.size());
}

}  // namespace

Json overlap_json(const NamedPolytope& a, const NamedPolytope& b, const Overlap& answer) {
  Json json = {{"query", "overlap"}, {"a", solid_json(a)}, {"b", solid_json(b)}};
  const auto* common = std::get_if<CommonPoint>(&answer);
  json["overlap"] = common != nullptr;
  if (common != nullptr) {
    json["witness"] = point_json(common->point);
    return json;
  }
  const auto& apart = std::get<Separation>(answer);
  json["farkas"] = Json::array();
  add_multipliers(json["farkas"], "a", a.solid, apart.of_a);
  add_multipliers(json["farkas"], "b", b.solid, apart.of_b);
  json["separating_plane"] = plane_json(apart.plane);
  return json;
}

std::string overlap_text(const NamedPolytope& a, const NamedPolytope& b, const Overlap& answer) {
  if (const auto* common = std::get_if<CommonPoint>(&answer)) {
    const RationalPoint& x = common->point;
    return solids_text(a, b) + fmt::format("overlap: yes; common point {}, {}, {}\n",
                                           rational_text(x[0]), rational_text(x[1]),
                                           rational_text(x[2]));
  }
  const auto& apart = std::get<Separation>(answer);
  const IntegerVector3& n = apart.plane.normal();
  return solids_text(a, b) +
         fmt::format(
             "overlap: no\n  ({}) x + ({}) y + ({}) z + ({}) is negative on A and positive on B\n"
             "  no point is in all of these: {} + {}\n",
             to_string(n[0]), to_string(n[1]), to_string(n[2]), to_string(apart.plane.offset()),
             multipliers_text("A", apart.of_a), multipliers_text("B", apart.of_b));
}

Json rays_json(const NamedPolytope& a, std::span<const RayAnswer> answers) {
  Json json = {{"query", "rays"}, {"a", solid_json(a)}, {"rays", Json::array()}};
  std::size_t hits = 0;
  for (const RayAnswer& answer : answers) {
    json["rays"].push_back(ray_json(answer));
    hits += answer.is_hit();
  }
  json["hits"] = hits;
  return json;
}

std::string rays_text(const NamedPolytope& a, std::span<const RayAnswer> answers) {
  std::string text = fmt::format("A  {}: {} halfspaces\n", a.name, a.solid.planes.size());
  std::size_t hits = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    text += fmt::format("ray {:<6}", i) + ray_text(answers[i]);
    hits += answers[i].is_hit();
  }
  return text + fmt::format("{} of {} rays hit\n", hits, answers.size());
}

Json false_positives_json(const NamedPolytope& a, const NamedPolytope& b,
                          const FalsePositives& found) {
  Json json = {{"query", "false-positives"}, {"a", solid_json(a)}, {"b", solid_json(b)}};
  json["inside"] = !found.outside;
  if (found.outside) {
    json["outside"] = {{"vertex", point_json(a.solid.vertices[found.outside->vertex])},
                       {"halfspace", found.outside->facet}};
  }
  json["center"] = point_json(found.center);
  json["radius"] = quantity_json(found.radius);
  for (const auto& [name, kind] : kKinds) {
    if (const auto& tally = found.*kind) json[name] = tally_json(*tally);
  }
  return json;
}

std::string false_positives_text(const NamedPolytope& a, const NamedPolytope& b,
                                 const FalsePositives& found) {
  std::string text = solids_text(a, b);
  if (found.outside) {
    const RationalPoint& v = a.solid.vertices[found.outside->vertex];
    text += fmt::format(
        "A is not inside B: its vertex {}, {}, {} is beyond halfspace {} of B. No rate is "
        "predicted.\n",
        rational_text(v[0]), rational_text(v[1]), rational_text(v[2]), found.outside->facet.value);
  } else {
    text += "A is inside B, proven exactly\n";
  }
  text +=
      fmt::format("  {:<8}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>11}{:>10}\n", "probes", "samples",
                  "hit A", "hit B", "only B", "only A", "rate", "predicted", "sigma");
  for (const auto& [name, kind] : kKinds) {
    if (const auto& tally = found.*kind) text += tally_text(name, *tally);
  }
  return text;
}

}  // namespace convexact
