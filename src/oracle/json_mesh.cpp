// SPDX-License-Identifier: MIT
#include "oracle/json_mesh.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "convexact/error.hpp"
#include "io/json_text.hpp"
#include "number/text.hpp"

namespace convexact {

using nlohmann::json;

Rational coordinate_of_json(const json& value, Decimal decimal) {
  const std::string_view text = spelling_of(value);
  if (text.empty()) {
    throw Error(ErrorCode::Malformed, "expected a number, or a string that holds one");
  }
  const bool is_hex = is_hex_float(text);
  const bool is_fraction = text.find('/') != std::string_view::npos;
  if (!is_hex && !is_fraction && decimal != Decimal::Exact) {
    return to_rational(decimal == Decimal::Nearest ? nearest_double(text) : nearest_float(text));
  }
  const Rational spelled = is_hex ? parse_hex_float(text) : parse_number(text, Decimal::Exact);
  if (decimal != Decimal::Nearest32) return spelled;
  const float rounded = to_float(spelled, Rounding::Nearest);
  if (!std::isfinite(rounded)) {
    throw Error(ErrorCode::NotFinite,
                "expected a number within binary32, found " + in_quotes(text));
  }
  return to_rational(rounded);
}

Mesh mesh_of_json(const json& object, Decimal decimal) {
  Mesh mesh;
  mesh.points = points_of_json(object["vertices"], "vertex",
                               [&](const json& x) { return coordinate_of_json(x, decimal); });
  if (object.contains("faces")) {
    mesh.polygons = polygons_of_json(object["faces"], mesh.points.size());
  }
  return mesh;
}

}  // namespace convexact
