// SPDX-License-Identifier: MIT
// parts_stress.hpp - a sweep of solids that are hard to take apart: each is cut into parts in a
// process of its own, and the oracle judges what is said of them.
#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "convexact/decompose.hpp"
#include "lab/stress/child.hpp"

namespace convexact {

/// Solids that become stiff or extreme in a parameter.
struct PartsFamily {
  std::string name, description;  ///< One line.
  std::string parameter;
  std::vector<double> values;
  std::function<Mesh(double value)> make;
};

/// In a fixed order: thin walls, needles, far from the origin, huge and tiny, crossing shells,
/// keyholes, solids in one another.
[[nodiscard]] std::span<const PartsFamily> parts_families();

/// How one solid was cut.
struct PartsStressRun {
  std::string family, parameter;
  double value = 0;
  StressEnd end = StressEnd::Failed;  ///< Reached, or with an error.
  std::string why;                    ///< Of an error: of these, Unrepresentable is documented.
  std::size_t parts = 0;
  bool is_within = false;    ///< Whether all parts are within the distance, as decompose() says.
  double excess = 0;         ///< Of the union, as a share of the solid's volume; rounded up.
  double seconds = 0;        ///< Of processor time, until the parts are stored and proven.
  std::uint64_t memory = 0;  ///< Peak of its process, the judge's included.
  std::vector<std::string> faults;  ///< Promises that were not kept.
};

/// Cuts a solid at 3% of its diameter and asks the oracle: the parts are solids and convex; they
/// hold the surface and the solid; and no point of them is farther than the distance if, and only
/// if, decompose() says so.
[[nodiscard]] PartsStressRun cut_and_judge(const Mesh& mesh);

/// A run for each value of each family, in this order.
/// @param values  Instead of the families' own, if there are any.
/// @throws Error Stopped when the watch ends it.
[[nodiscard]] std::vector<PartsStressRun> stress_parts(std::span<const PartsFamily> families,
                                                       std::span<const double> values,
                                                       const StressLimits& limits,
                                                       const Watch& watch = {});

/// docs/schema/stress-parts.schema.json.
[[nodiscard]] Json parts_stress_json(std::span<const PartsStressRun> runs);
/// A line for each run, then the faults.
[[nodiscard]] std::string parts_stress_table(std::span<const PartsStressRun> runs);

}  // namespace convexact
