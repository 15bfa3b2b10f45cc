// SPDX-License-Identifier: MIT
// bindings.hpp - what the parts of convexact._core share: options by name, and numbers as texts.
#pragma once
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "convexact/decompose.hpp"
#include "convexact/scene.hpp"
#include "interruptible.hpp"
#include "io/names.hpp"
#include "wire/field.hpp"

namespace convexact::python {

// Each adds its classes and functions to the module.
void add_errors(py::module_& module);
void add_hulls(py::module_& module);
void add_verdicts(py::module_& module);
void add_parts(py::module_& module);
void add_queries(py::module_& module);

/// A decomposition and what it was made from, which a tree over it needs.
struct Decomposed {
  Decomposition result;
  DecomposeRequest request;
};

/// By the names of the command line, with values spelled as there.
using Options = std::vector<std::pair<std::string, std::string>>;

template <class Request>
void apply(const Options& options, const Fields<Request>& fields, Request& request) {
  for (const auto& [name, text] : options) {
    const auto field = std::find_if(fields.begin(), fields.end(),
                                    [&, wanted = name](const auto& f) { return f.name == wanted; });
    if (field == fields.end()) {
      throw Error(ErrorCode::InvalidArgument, "there is no option " + name);
    }
    field->read(request, name, text);
  }
}

/// Those of one table, which are removed from the list.
template <class Request>
Options taken(Options& options, const Fields<Request>& fields) {
  const auto rest = std::stable_partition(options.begin(), options.end(), [&](const auto& option) {
    return std::none_of(fields.begin(), fields.end(),
                        [&](const auto& field) { return field.name == option.first; });
  });
  const Options of_table(rest, options.end());
  options.erase(rest, options.end());
  return of_table;
}

/// Integers and fractions, such as "-3" and "1/3".
inline std::array<std::string, 3> text_of(const RationalPoint& p) {
  return {to_string(p[0]), to_string(p[1]), to_string(p[2])};
}

inline std::array<std::string, 4> text_of(const Halfspace& h) {
  return {to_string(h.normal()[0]), to_string(h.normal()[1]), to_string(h.normal()[2]),
          to_string(h.offset())};
}

inline std::string text_of(const Rational& x) { return to_string(x); }

template <class Values>
auto texts_of(const Values& values) {
  std::vector<decltype(text_of(values[0]))> rows;
  for (const auto& value : values) rows.push_back(text_of(value));
  return rows;
}

inline std::optional<std::string> text_if(const std::optional<Rational>& x) {
  return x ? std::optional(to_string(*x)) : std::nullopt;
}

/// Doubles below and above.
inline std::optional<std::pair<double, double>> pair_of(const std::optional<Measured>& measured) {
  if (!measured) return {};
  return std::pair{measured->bounds.low_double(), measured->bounds.high_double()};
}

/// Of points, or unless they are None of planes.
/// @throws Error NoInterior for a plane that no point satisfies.
inline Shape shape_of(const py::object& points, const py::object& planes) {
  if (planes.is_none()) return points_of(points);
  HalfspaceList list = planes_of(planes);
  if (list.impossible_row) {
    throw Error(ErrorCode::NoInterior, "halfspace " + std::to_string(*list.impossible_row) +
                                           " has a zero normal and holds nowhere");
  }
  return std::move(list.halfspaces);
}

inline std::size_t size_of(const Shape& shape) {
  return std::visit([](const auto& x) { return x.size(); }, shape);
}

}  // namespace convexact::python
