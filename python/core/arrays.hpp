// SPDX-License-Identifier: MIT
// arrays.hpp - points, faces and planes from and to Python: arrays of doubles, or lists of exact
// numbers as texts. The package has checked shapes; indices are checked here.
#pragma once
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "convexact/io.hpp"

namespace convexact::python {

namespace py = pybind11;
using Doubles = py::array_t<double, py::array::c_style>;
using Faces = std::vector<std::vector<std::uint32_t>>;

/// An array (n, 3) of doubles, or n lists of three texts such as "1/3".
/// @throws Error NotFinite, naming the row; Malformed for a text that is no number.
inline PointSet points_of(const py::object& rows) {
  if (py::isinstance<Doubles>(rows)) {
    const auto array = rows.cast<Doubles>().unchecked<2>();
    std::vector<Point> points;
    points.reserve(static_cast<std::size_t>(array.shape(0)));
    for (py::ssize_t i = 0; i < array.shape(0); ++i) {
      points.emplace_back(array(i, 0), array(i, 1), array(i, 2));
    }
    return PointSet(std::move(points));
  }
  std::vector<RationalPoint> points;
  for (const auto& row : rows.cast<std::vector<std::vector<std::string>>>()) {
    points.emplace_back(parse_rational(row[0]), parse_rational(row[1]), parse_rational(row[2]));
  }
  return PointSet(std::move(points));
}

/// Rows n1, n2, n3, d, likewise.
inline HalfspaceList planes_of(const py::object& rows) {
  HalfspaceList list;
  if (py::isinstance<Doubles>(rows)) {
    const auto array = rows.cast<Doubles>().unchecked<2>();
    for (py::ssize_t i = 0; i < array.shape(0); ++i) {
      const Vector3<double> normal(array(i, 0), array(i, 1), array(i, 2));
      list.add(to_rational(normal), to_rational(array(i, 3)));
    }
    return list;
  }
  for (const auto& row : rows.cast<std::vector<std::vector<std::string>>>()) {
    list.add({parse_rational(row[0]), parse_rational(row[1]), parse_rational(row[2])},
             parse_rational(row[3]));
  }
  return list;
}

inline Mesh mesh_of(const py::object& points, Faces faces) {
  Mesh mesh{points_of(points), std::move(faces), {}};
  for (std::size_t f = 0; f < mesh.polygons.size(); ++f) {
    for (const std::uint32_t corner : mesh.polygons[f]) {
      if (corner < mesh.points.size()) continue;
      throw Error(ErrorCode::InvalidArgument, "face " + std::to_string(f) +
                                                  ": expected indices of " +
                                                  std::to_string(mesh.points.size()) +
                                                  " points, found " + std::to_string(corner));
    }
  }
  mesh.parts = {{"", 0, mesh.polygons.size()}};
  return mesh;
}

/// (n, 3).
inline Doubles array_of(std::span<const Point> points) {
  Doubles array({points.size(), std::size_t{3}});
  auto view = array.mutable_unchecked<2>();
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int k = 0; k < 3; ++k) view(py::ssize_t(i), k) = points[i][k];
  }
  return array;
}

/// (n, 4).
inline Doubles array_of(const std::vector<std::array<double, 4>>& planes) {
  Doubles array({planes.size(), std::size_t{4}});
  auto view = array.mutable_unchecked<2>();
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t k = 0; k < 4; ++k) view(py::ssize_t(i), py::ssize_t(k)) = planes[i][k];
  }
  return array;
}

}  // namespace convexact::python
