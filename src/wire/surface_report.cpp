// SPDX-License-Identifier: MIT
#include "wire/surface_report.hpp"

#include <fmt/format.h>

#include "io/json.hpp"
#include "number/text.hpp"

namespace convexact {

Json interval_json(const Measured& x) {
  Json json = bounds_json(x.bounds);
  if (x.exact) {
    json["decimal"] = to_decimal(*x.exact, kDigits);
    json["exact"] = to_string(*x.exact);
  } else if (const auto decimal = to_decimal(x.bounds, kDigits)) {
    json["decimal"] = *decimal;
  }
  return json;
}

Json interval_json(const Enclosure& x) { return interval_json(Measured{x, std::nullopt}); }

std::string interval_text(const Enclosure& x) {
  constexpr int kFew = 4;
  if (const auto text = to_decimal(x, kFew)) return *text;
  if (x.low() <= 0) return x.high() <= 0 ? "0" : "at most " + to_decimal(x.high(), 2);
  return to_decimal(x.low(), kFew) + " to " + to_decimal(x.high(), kFew);
}

std::string interval_text(const Measured& x) {
  return x.exact ? to_decimal(*x.exact, 4) : interval_text(x.bounds);
}

std::string percent_text(const Enclosure& percent) {
  return percent.high() <= 0 ? "0%" : fmt::format("{:.3g}%", percent.high_double());
}

std::string share_text(const Enclosure& part, const Enclosure& whole) {
  if (whole.low() <= 0) return "";
  const Enclosure percent = part / whole * Enclosure(Rational(100), whole.precision());
  return " (" + percent_text(percent) + ")";
}

Json surface_json(const Surface& surface) {
  std::size_t border_edges = 0, branching_edges = 0, turned = 0, reversed = 0, twisted = 0;
  for (const SurfaceComponent& component : surface.components) {
    border_edges += component.border_edges;
    branching_edges += component.branching_edges;
    turned += component.turned;
    reversed += component.is_reversed ? 1 : 0;
    twisted += component.is_orientable ? 0 : 1;
  }
  return {{"points", surface.points.size()},
          {"triangles", surface.triangles.size()},
          {"components", surface.components.size()},
          {"closed", surface.is_closed},
          {"border_edges", border_edges},
          {"branching_edges", branching_edges},
          {"turned_triangles", turned},
          {"reversed_components", reversed},
          {"not_orientable", twisted},
          {"contradictions", surface.contradictions},
          {"flat_triangles", surface.flat_triangles},
          {"repeated_points", surface.repeated_points},
          {"unused_points", surface.unused.size()},
          {"bent_faces", surface.fans.size()}};
}

std::string surface_text(const Surface& surface) {
  return fmt::format(
      "{} on {}, {}, {}", counted(surface.triangles.size(), "triangle", "triangles"),
      counted(surface.points.size(), "point", "points"),
      counted(surface.components.size(), "component", "components"),
      surface.is_closed ? "closed: it bounds a solid" : "not closed: it bounds no solid");
}

}  // namespace convexact
