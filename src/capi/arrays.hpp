// SPDX-License-Identifier: MIT
// arrays.hpp - points and planes from and to the arrays and texts of the C interface.
#pragma once
#include <limits>
#include <string>

#include "convexact/error.hpp"
#include "convexact/halfspace.hpp"
#include "convexact/point_set.hpp"

namespace convexact::capi {

/// @throws Error InvalidArgument for a null pointer or none or too many of them.
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

inline std::string to_text(const Halfspace& h) {
  std::string text;
  for (const Integer& n : h.normal()) text += to_string(n) + " ";
  return text + to_string(h.offset());
}

}  // namespace convexact::capi
