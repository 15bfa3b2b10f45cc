// SPDX-License-Identifier: MIT
// The V-representation of cdd and lrs: a row 1 x y z is a point, a row 0 x y z a ray.
#include "convexact/error.hpp"
#include "io/halfspace_formats.hpp"
#include "io/mesh_readers.hpp"
#include "io/polyhedron_table.hpp"
#include "io/text_cursor.hpp"

namespace convexact {

bool is_v_representation(std::string_view bytes) {
  TextCursor cursor(bytes.substr(0, 4096), {.comment = '*'});
  while (cursor.next_line()) {
    const std::string_view token = cursor.token();
    if (token == "V-representation") return true;
    if (token == "H-representation" || token == "begin") return false;
  }
  return false;
}

Mesh read_ext(std::string_view bytes, const ReadOptions& options) {
  const PolyhedronTable table = read_polyhedron_table(bytes, options.decimal, Representation::V);
  std::vector<RationalPoint> points;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const auto& [kind, x, y, z] = table.rows[row];
    if (kind != 1 || table.is_linear(row)) {
      throw Error(ErrorCode::NoInterior,
                  "the polyhedron is unbounded: row " + std::to_string(row) +
                      " (counted from 0) is a " + (table.is_linear(row) ? "line" : "ray") +
                      "; a solid is the hull of points, rows that begin with 1");
    }
    points.emplace_back(x, y, z);
  }
  return {.points = PointSet(std::move(points)), .polygons = {}, .parts = {{"", 0, 0}}};
}

}  // namespace convexact
