// SPDX-License-Identifier: MIT
// Point clouds as plain text: x y z in each line, and further numbers that are not used.
#include <array>

#include "io/mesh_readers.hpp"
#include "io/point_collector.hpp"

namespace convexact {

Mesh read_xyz(std::string_view bytes, Decimal decimal) {
  TextCursor cursor(bytes, {.comment = '#'});
  PointCollector points(decimal);
  while (cursor.next_line()) {
    std::array<std::string_view, 3> coordinates;
    for (auto& coordinate : coordinates) coordinate = cursor.expect_token("three coordinates");
    points.add(coordinates, cursor);
    for (auto token = cursor.token(); !token.empty(); token = cursor.token()) {
      (void)cursor.to_number(token);
    }
  }
  Mesh mesh;
  mesh.points = points.finish();
  mesh.parts.push_back({"", 0, 0});
  return mesh;
}

}  // namespace convexact
