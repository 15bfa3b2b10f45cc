// SPDX-License-Identifier: MIT
// promise.hpp - what a program promises of its outputs, and so what they are judged by.
#pragma once
#include <cstddef>
#include <optional>
#include <string>

#include "convexact/number/precision.hpp"
#include "convexact/oracle/tolerance.hpp"

namespace convexact {

/// What is asked of a program.
enum class Asks {
  Enclosure,  ///< A convex solid that contains the input.
  Hull,       ///< The same, and each of its corners is a point of the input.
  Inner,      ///< A convex solid inside the hull of the input.
  Simplify,   ///< An enclosure of at most so many facets.
};
/// "enclosure" and the like.
[[nodiscard]] const char* name_of(Asks asks);

struct Promise {
  Asks asks = Asks::Simplify;
  /// What the numbers of inputs and outputs are. Inputs are rounded to them before they are
  /// written; a decimal in an output means the nearest one.
  Precision numbers = Precision::Binary64;
  Tolerance tolerance = {};  ///< Violations up to this distance pass.
  bool allow_flat = false;   ///< Inputs without volume may be accepted.
  std::optional<std::size_t> max_facets = {}, max_vertices = {}, max_facet_vertices = {};
};

/// A promise that is known by a name, such as that of an engine.
struct Profile {
  std::string name, title;
  Promise promise;
};

}  // namespace convexact
