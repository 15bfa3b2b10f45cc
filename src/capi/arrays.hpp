// SPDX-License-Identifier: MIT
// arrays.hpp - converts points, planes and faces from and to the arrays and texts of the C
// interface.
#pragma once
#include <limits>
#include <string>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "convexact/io.hpp"

namespace convexact::capi {

/// @throws Error InvalidArgument for a null pointer, and for no or too many numbers.
inline void require_array(const char* what, const double* numbers, std::size_t count) {
  if (numbers == nullptr || count == 0 || count >= std::numeric_limits<std::uint32_t>::max()) {
    reject_argument(std::string("the array of ") + what + " is missing, empty or too long");
  }
}

/// @throws Error InvalidArgument as above; NotFinite.
inline PointSet to_points(const double* numbers, std::size_t count, const char* what = "points") {
  require_array(what, numbers, count);
  std::vector<Point> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    points[i] = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
  }
  return PointSet(std::move(points));
}

/// Rows n1, n2, n3, d. @throws Error as to_points.
inline HalfspaceList to_list(const double* numbers, std::size_t count) {
  require_array("planes", numbers, count);
  HalfspaceList list;
  for (std::size_t i = 0; i < count; ++i) {
    const double* row = numbers + 4 * i;
    list.add(to_rational(Vector3<double>(row[0], row[1], row[2])), to_rational(row[3]));
  }
  return list;
}

/// Faces one after another: face f has sizes[f] corners, indices below `vertices`.
/// @throws Error InvalidArgument for a null pointer, fewer than 3 corners and other indices.
inline std::vector<std::vector<std::uint32_t>> to_faces(const std::uint32_t* corners,
                                                        const std::size_t* sizes, std::size_t count,
                                                        std::size_t vertices) {
  if (count > 0 && (corners == nullptr || sizes == nullptr)) {
    reject_argument("the corners or sizes of faces are missing");
  }
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::size_t f = 0; f < count; ++f) {
    if (sizes[f] < 3) reject_argument("a face has fewer than 3 corners");
    for (const std::uint32_t corner : faces.emplace_back(corners, corners + sizes[f])) {
      if (corner >= vertices) reject_argument("a corner is not the index of a vertex");
    }
    corners += sizes[f];
  }
  return faces;
}

/// @throws Error InvalidArgument as to_faces(), and for too many.
inline std::vector<std::vector<std::uint32_t>> to_triangles(const std::uint32_t* corners,
                                                            std::size_t count,
                                                            std::size_t vertices) {
  if (count >= std::numeric_limits<std::uint32_t>::max()) {
    reject_argument("there are too many triangles");
  }
  const std::vector<std::size_t> sizes(count, 3);
  return to_faces(corners, sizes.data(), count, vertices);
}

/// A mesh of triangles, possibly none. @throws Error as to_points() and to_triangles().
inline Mesh to_mesh(const double* points, std::size_t point_count, const std::uint32_t* triangles,
                    std::size_t triangle_count) {
  Mesh mesh{to_points(points, point_count), {}, {}};
  mesh.polygons = to_triangles(triangles, triangle_count, point_count);
  return mesh;
}

/// Points and faces as the arrays that a caller borrows.
struct MeshArrays {
  std::vector<double> vertices;
  std::vector<std::size_t> face_sizes;
  std::vector<std::uint32_t> corners;

  /// From a mesh whose points are doubles.
  explicit MeshArrays(const Mesh& mesh) {
    for (const Point& p : mesh.points.doubles())
      vertices.insert(vertices.end(), p.begin(), p.end());
    for (const auto& polygon : mesh.polygons) {
      face_sizes.push_back(polygon.size());
      corners.insert(corners.end(), polygon.begin(), polygon.end());
    }
  }
};

inline std::string to_text(const Halfspace& h) {
  std::string text;
  for (const Integer& n : h.normal()) text += to_string(n) + " ";
  return text + to_string(h.offset());
}

}  // namespace convexact::capi
