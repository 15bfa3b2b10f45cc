// SPDX-License-Identifier: MIT
#include "convexact/pipeline/not_solid.hpp"

#include <fmt/format.h>

namespace convexact {
namespace {

std::string list_rows(const std::vector<Multiplier>& multipliers) {
  std::string rows;
  for (const Multiplier& m : multipliers) {
    rows += fmt::format("{}{} times halfspace {}", rows.empty() ? "" : " + ", to_string(m.value),
                        m.row);
  }
  return rows;
}

std::string list(const RationalVector3& v) {
  return fmt::format("({}, {}, {})", to_string(v[0]), to_string(v[1]), to_string(v[2]));
}

std::string list(const Halfspace& plane) {
  return fmt::format("{} x + {} y + {} z + {} = 0", to_string(plane.normal()[0]),
                     to_string(plane.normal()[1]), to_string(plane.normal()[2]),
                     to_string(plane.offset()));
}

struct Description {
  std::string operator()(const FlatInput& flat) const {
    if (flat.dimension < 0) return "the input has no points";
    std::string equations;
    for (const Halfspace& plane : flat.equations) {
      equations += (equations.empty() ? "" : " and ") + list(plane);
    }
    static constexpr const char* kWhere[] = {"are all the same point", "lie on one line",
                                             "lie in one plane"};
    return fmt::format("the input spans no volume: its points {}; every one satisfies {}",
                       kWhere[flat.dimension], equations);
  }
  std::string operator()(const EmptyProof& proof) const {
    return "no point lies in all halfspaces: " + list_rows(proof.farkas) +
           " says that a positive number is at most 0";
  }
  std::string operator()(const FlatProof& proof) const {
    return "the halfspaces have a point in common but no interior: " +
           list_rows(proof.multipliers) + " is 0 <= 0, so each of them holds with equality only";
  }
  std::string operator()(const RecessionRay& ray) const {
    return "the halfspaces bound no finite volume: their intersection extends to infinity along " +
           list(ray.direction);
  }
};

}  // namespace

std::string describe(const NotSolid& reason) { return std::visit(Description{}, reason); }

}  // namespace convexact
