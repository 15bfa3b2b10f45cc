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

/// Lists of texts such as "1/3", or an array of doubles.
inline std::vector<std::vector<Rational>> rationals_of(const py::object& rows) {
  std::vector<std::vector<Rational>> all;
  if (py::isinstance<Doubles>(rows)) {
    for (const auto& row : rows.cast<std::vector<std::vector<double>>>()) {
      std::vector<Rational>& last = all.emplace_back();
      for (const double x : row) last.push_back(to_rational(x));
    }
    return all;
  }
  for (const auto& row : rows.cast<std::vector<std::vector<std::string>>>()) {
    std::vector<Rational>& last = all.emplace_back();
    for (const std::string& x : row) last.push_back(parse_rational(x));
  }
  return all;
}

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
  for (const auto& row : rationals_of(rows)) points.emplace_back(row[0], row[1], row[2]);
  return PointSet(std::move(points));
}

/// Rows n1, n2, n3, d, likewise.
inline HalfspaceList planes_of(const py::object& rows) {
  HalfspaceList list;
  for (const auto& row : rationals_of(rows)) list.add({row[0], row[1], row[2]}, row[3]);
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
