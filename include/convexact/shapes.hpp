// SPDX-License-Identifier: MIT
// shapes.hpp - families of shapes and of malformed files, by name and seed.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "convexact/geometry.hpp"

namespace convexact::shapes {

/// A number that a family takes, least <= value <= most.
struct Parameter {
  std::string_view name;
  std::string_view meaning;
  double least;
  double most;
  double usual;  ///< The default.
  bool whole;    ///< Integers only.
};

struct Family {
  std::string_view name;         ///< lower-case, words joined by '-'.
  std::string_view description;  ///< One line.
  int dimension;                 ///< Affine dimension with the usual parameters.
  std::vector<Parameter> parameters;
  /// One value per parameter, within its range; the seed is ignored where nothing is random.
  std::function<std::vector<Point>(std::span<const double> values, std::uint64_t seed)> make;
};

/// All families, in a fixed order.
[[nodiscard]] std::span<const Family> families();

/// @throws Error InvalidArgument if there is none of that name.
[[nodiscard]] const Family& family(std::string_view name);

/// A family and a value for each of its parameters.
struct AnyFamily {
  const Family* family;
  std::vector<double> values;
};

/// A random family with random parameters, of at most some thousand points: the same for the same
/// seed, on every platform. Some spans no volume.
[[nodiscard]] AnyFamily any_family(std::uint64_t seed);

/// The usual value of each parameter.
[[nodiscard]] std::vector<double> usual_values(const Family& family);

/// The family's points: the same doubles for the same values and seed, on every platform.
/// @throws Error InvalidArgument, naming the parameter, if their number or one of them is wrong.
[[nodiscard]] std::vector<Point> generate(const Family& family, std::span<const double> values,
                                          std::uint64_t seed = 1);

struct MalformedFile {
  std::string name;         ///< "malformed-", the format, "-", the mistake.
  std::string description;  ///< One line.
  std::string bytes;        ///< The whole file.
  bool not_finite = false;  ///< Spelled correctly, but NaN, infinite or beyond the largest double.

  /// The file's extension: obj, off, ply, stl, xyz, json, ine or txt. The last three list
  /// halfspaces.
  [[nodiscard]] std::string_view extension() const;
};

/// All of them, in a fixed order. Each is a small valid file with one mistake in it (or empty, or
/// noise), so a reader that refuses it has found that mistake. OBJ and XYZ have no header and no
/// counts: their truncated files end within a line, and an empty one is valid, but without points.
[[nodiscard]] std::span<const MalformedFile> malformed_files();

}  // namespace convexact::shapes
