// SPDX-License-Identifier: MIT
// arrays.hpp - converts points, planes, faces and options from and to the arrays, structs and texts
// of the C interface.
#pragma once
#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "convexact/io.hpp"

namespace convexact::capi {

/// The value of an enumeration of the interface. @throws Error InvalidArgument if it has none.
template <class Value, std::size_t N>
Value chosen(const Value (&values)[N], int number) {
  if (number < 0 || static_cast<std::size_t>(number) >= N) {
    throw Error(ErrorCode::InvalidArgument, "an option has no such value");
  }
  return values[number];
}

/// @throws Error InvalidArgument for a null pointer, and for no or too many numbers.
inline void require_array(const double* numbers, std::size_t count) {
  if (numbers == nullptr || count == 0 || count >= std::numeric_limits<std::uint32_t>::max()) {
    throw Error(ErrorCode::InvalidArgument, "an array is missing, empty or too long");
  }
}

/// @throws Error InvalidArgument as above; NotFinite.
inline PointSet to_points(const double* numbers, std::size_t count) {
  require_array(numbers, count);
  std::vector<Point> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    points[i] = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
  }
  return PointSet(std::move(points));
}

/// Rows n1, n2, n3, d. @throws Error as to_points.
inline HalfspaceList to_list(const double* numbers, std::size_t count) {
  require_array(numbers, count);
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
    throw Error(ErrorCode::InvalidArgument, "the corners or sizes of faces are missing");
  }
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::size_t f = 0; f < count; ++f) {
    if (sizes[f] < 3) throw Error(ErrorCode::InvalidArgument, "a face has fewer than 3 corners");
    for (const std::uint32_t corner : faces.emplace_back(corners, corners + sizes[f])) {
      if (corner >= vertices) {
        throw Error(ErrorCode::InvalidArgument, "a corner is not the index of a vertex");
      }
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
    throw Error(ErrorCode::InvalidArgument, "there are too many triangles");
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

/// 32, or 64 or 0 for doubles. @throws Error InvalidArgument for any other number.
inline Precision to_precision(int bits) {
  if (bits == 32) return Precision::Binary32;
  if (bits == 0 || bits == 64) return Precision::Binary64;
  throw Error(ErrorCode::InvalidArgument, "a precision of neither 64 nor 32 bits");
}

/// The options that a caller gave, or all defaults. Fields of later versions must be 0.
/// @throws Error InvalidArgument for a size that no version has, and for later fields.
template <class Options>
Options to_options(const Options* given) {
  constexpr std::size_t kLargest = 4096;
  if (given == nullptr) return {};
  const auto* bytes = reinterpret_cast<const unsigned char*>(given);
  if (given->size < sizeof(Options) || given->size > kLargest ||
      std::any_of(bytes + sizeof(Options), bytes + given->size, [](auto b) { return b != 0; })) {
    throw Error(ErrorCode::InvalidArgument, "options of another size");
  }
  return *given;
}

/// A count among options: 0 means none.
inline std::optional<std::size_t> to_limit(std::size_t count) {
  return count == 0 ? std::nullopt : std::optional(count);
}

inline std::string to_text(const Halfspace& h) {
  std::string text;
  for (const Integer& n : h.normal()) text += to_string(n) + " ";
  return text + to_string(h.offset());
}

}  // namespace convexact::capi
