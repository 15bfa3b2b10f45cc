// SPDX-License-Identifier: MIT
#include "wire/parts_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/json.hpp"
#include "number/precision.hpp"
#include "number/text.hpp"
#include "wire/surface_report.hpp"
#include "wire/verdict_report.hpp"

namespace convexact {
namespace {

// ---- JSON

Json part_json(const JudgedPart& part, const ConvexPart& hull, const Rational& squared_diameter) {
  Json json = {{"name", part.name}, {"dimension", hull.dimension}};
  if (part.size.facets) json["facets"] = *part.size.facets;
  json["vertices"] = hull.vertices.size();
  json["claims"] = claims_json(part.claims, squared_diameter)["claims"];
  return json;
}

Json measures_json(const PartsMeasures& measures) {
  Json json = {{"surface_area", interval_json(measures.surface_area)},
               {"uncovered_area", interval_json(measures.uncovered_area)}};
  if (measures.surface_area.low() > 0) {
    json["uncovered_area_share"] = interval_json(measures.uncovered_area / measures.surface_area);
  }
  const auto put = [&](const char* name, const auto& measured) {
    if (measured) json[name] = interval_json(*measured);
  };
  put("union_volume", measures.union_volume);
  put("overlap_volume", measures.overlap_volume);
  put("solid_volume", measures.solid_volume);
  put("uncovered_volume", measures.uncovered_volume);
  put("excess_volume", measures.excess_volume);
  json["surface_to_union"] = interval_json(measures.surface_to_union);
  put("union_to_input", measures.union_to_input);
  return json;
}

// ---- Text

// "0.0121 to 0.0125 (1.3% of the diameter)".
std::string length_text(const Enclosure& x, const Rational& squared_diameter) {
  const Enclosure diameter = sqrt(Enclosure(squared_diameter, x.precision()));
  return fmt::format(
      "{:.4g} to {:.4g}{}", x.low_double(), x.high_double(),
      x.high() > 0 ? fmt::format(" ({:.3g}% of the diameter)", 100 * (x / diameter).high_double())
                   : "");
}

// Where a distance was asked for: how far the solid and the parts are from each other.
std::string distance_text(const PartsVerdict& verdict) {
  if (!verdict.distance) return "";
  const char* solid = verdict.surface.is_closed ? "the solid" : "the surface";
  const auto& covers =
      verdict[verdict.surface.is_closed ? ClaimCode::CoversSolid : ClaimCode::CoversSurface];
  std::string text = std::string(solid) + " from the parts: ";
  if (covers.status == Status::Holds) {
    text += "0, as they hold it";
  } else if (covers.witness.squared_distance) {
    text += fmt::format("at least {}", decimal_of_root(*covers.witness.squared_distance));
  } else {
    text += "not asked";
  }
  text += fmt::format("; the parts from {}: ", solid);
  const auto& reach = verdict[ClaimCode::WithinSolid];
  if (verdict.measures && verdict.measures->union_to_input) {
    text += length_text(*verdict.measures->union_to_input, verdict.squared_diameter);
  } else {
    text += reach.status == Status::Holds ? "within the distance allowed" : "see within-solid";
  }
  return verdict_line("distance",
                      text + ", at most " + describe_distance(*verdict.distance) + " allowed");
}

std::string measures_text(const PartsMeasures& m, const Rational& squared_diameter,
                          bool has_distance) {
  std::string text =
      verdict_line("uncovered", fmt::format("area {} of {}{}", interval_text(m.uncovered_area),
                                            interval_text(m.surface_area),
                                            share_text(m.uncovered_area, m.surface_area)));
  if (m.solid_volume) {
    const Enclosure& solid = m.solid_volume->bounds;
    text += verdict_line("", fmt::format("volume {} of {}{}", interval_text(*m.uncovered_volume),
                                         interval_text(*m.solid_volume),
                                         share_text(m.uncovered_volume->bounds, solid)));
    if (m.excess_volume) {
      text += verdict_line("excess", fmt::format("volume {}{} of the union outside of the solid",
                                                 interval_text(*m.excess_volume),
                                                 share_text(m.excess_volume->bounds, solid)));
    }
  }
  if (m.union_volume) {
    text += verdict_line(
        "union", fmt::format("volume {}, parts overlap by {}", interval_text(*m.union_volume),
                             interval_text(*m.overlap_volume)));
  }
  text += verdict_line("farthest", "the surface from the union: " +
                                       length_text(m.surface_to_union, squared_diameter));
  if (!m.union_to_input || has_distance) {
    if (m.union_volume) return text;
    return text +
           verdict_line("left out", has_distance
                                        ? "volumes of the union, excess and overlap: --measures all"
                                        : "volumes of the union, excess and overlap, and the "
                                          "union's distance from the input: --measures all");
  }
  return text + verdict_line("", std::string("the union from the ") +
                                     (m.solid_volume ? "solid: " : "surface: ") +
                                     length_text(*m.union_to_input, squared_diameter));
}

std::string parts_text(const PartsVerdict& verdict) {
  if (verdict.parts.empty()) return {};
  std::size_t facets = 0, vertices = 0;
  for (std::size_t k = 0; k < verdict.parts.size(); ++k) {
    facets = std::max(facets, verdict.parts[k].size.facets.value());
    vertices = std::max(vertices, verdict.hulls[k].vertices.size());
  }
  std::string text = fmt::format("{}, at most {} facets and {} vertices each",
                                 counted(verdict.parts.size(), "part", "parts"), facets, vertices);
  if (verdict.worst_part) {
    text += fmt::format("; part {} ({}) is nearest to the uncovered point that is farthest",
                        *verdict.worst_part, in_quotes(verdict.parts[*verdict.worst_part].name));
  }
  return verdict_line("parts", text);
}

}  // namespace

Json parts_verdict_json(const PartsVerdict& verdict) {
  Json json = claims_json(verdict.claims, verdict.squared_diameter);
  Json& parts = json["parts"] = Json::array();
  for (std::size_t k = 0; k < verdict.parts.size(); ++k) {
    parts.push_back(part_json(verdict.parts[k], verdict.hulls[k], verdict.squared_diameter));
  }
  if (verdict.worst_part) json["worst_part"] = *verdict.worst_part;
  if (!verdict.surface.triangles.empty()) json["surface"] = surface_json(verdict.surface);
  if (verdict.points > 0) {
    json["outside"] = {{"points", verdict.points_outside},
                       {"tested", verdict.points},
                       {"used_by_no_face", verdict.unused_outside}};
  }
  if (verdict.coverage) {
    json["uncovered"] = {{"pieces", verdict.coverage->uncovered.size()},
                         {"triangles_in_one_part", verdict.coverage->in_one_part}};
  }
  if (verdict.measures) json["measures"] = measures_json(*verdict.measures);
  if (!verdict.notes.empty()) json["notes"] = verdict.notes;
  return json;
}

std::string parts_verdict_text(const PartsVerdict& verdict) {
  std::string text = distance_text(verdict) + claims_text(verdict.claims);
  if (!verdict.surface.triangles.empty()) {
    text += verdict_line("surface", surface_text(verdict.surface));
  }
  text += parts_text(verdict);
  if (verdict.measures)
    text +=
        measures_text(*verdict.measures, verdict.squared_diameter, verdict.distance.has_value());
  for (const std::string& note : verdict.notes) text += verdict_line("note", note);
  return text + verdict_line(verdict.claims);
}

}  // namespace convexact
