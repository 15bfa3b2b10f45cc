// SPDX-License-Identifier: MIT
// input.hpp - the inputs of a sweep: families of shapes, each varied over one parameter.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "convexact/scene.hpp"

namespace convexact {

/// One input of a sweep.
struct StressInput {
  std::string family;
  std::string parameter;
  double value = 0;
  std::uint64_t seed = 1;  ///< Of the shape, and of every random order of the engines.
  std::size_t faces = 4;   ///< Halfspaces to keep.
  std::function<Shape()> make;
};

struct SweepOptions {
  std::uint32_t points = 50;   ///< Of shapes that take a number of points, if that is not varied.
  std::uint64_t seed = 1;      ///< The first one.
  std::uint32_t seeds = 1;     ///< How many seeds, one after another, for each value.
  std::vector<double> values;  ///< Instead of the family's own, if there are any.
  std::size_t faces = 4;       ///< Halfspaces to keep, >= 4.
  bool large = false;          ///< Includes the values that take minutes.
};

/// A family in the form that a sweep uses.
struct StressFamily {
  std::string name;
  std::string description;  ///< One line.
  std::string parameter;    ///< The parameter that is varied; empty if there is none.
  std::vector<double> values;
  std::vector<double> large_values;  ///< Only with SweepOptions::large.
  std::function<Shape(double value, std::uint32_t points, std::uint64_t seed)> make;
};

/// Every family, in a fixed order: the families of shapes, each with a sweep over its most
/// significant parameter, and those that only stress has.
[[nodiscard]] std::span<const StressFamily> stress_families();

/// @throws Error InvalidArgument if there is none of that name.
[[nodiscard]] const StressFamily& stress_family(const std::string& name);

/// A mesh scaled to diameters from 1e-6 to 1e9, each at its place and moved by 1e8 along every axis
/// (values below 0, of which the diameter is the absolute value). Coordinates are rounded.
[[nodiscard]] StressFamily mesh_family(const std::string& name, std::vector<Point> points);

/// The inputs of a family. @throws Error InvalidArgument for a value that it does not take.
[[nodiscard]] std::vector<StressInput> inputs_of(const StressFamily& family,
                                                 const SweepOptions& options);

}  // namespace convexact
