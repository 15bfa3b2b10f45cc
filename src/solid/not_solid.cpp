// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "convexact/scene.hpp"
#include "number/text.hpp"

namespace convexact {
namespace {

std::string list_rows(const std::vector<Multiplier>& multipliers) {
  std::string rows;
  for (const Multiplier& m : multipliers) {
    rows += fmt::format("{}{} times halfspace {}", rows.empty() ? "" : " + ", in_sentence(m.value),
                        m.row);
  }
  return rows;
}

std::string list(const RationalVector3& v) {
  return fmt::format("({}, {}, {})", in_sentence(v[0]), in_sentence(v[1]), in_sentence(v[2]));
}

// "2 x - z + 5 = 0": of both signs of an equation, the one that begins without a minus.
std::string list(const Halfspace& plane) {
  std::string sum;
  const IntegerVector3& n = plane.normal();
  const bool is_turned = (n[0] != 0 ? n[0] : n[1] != 0 ? n[1] : n[2]) < 0;
  const auto add = [&](const Integer& of_plane, const std::string& name) {
    const Integer factor = is_turned ? Integer(-of_plane) : of_plane;
    if (factor == 0) return;
    const Integer magnitude = abs(factor);
    sum += sum.empty() ? (factor < 0 ? "-" : "") : (factor < 0 ? " - " : " + ");
    if (magnitude != 1 || name.empty())
      sum += in_sentence(Rational(magnitude)) + (name.empty() ? "" : " ");
    sum += name;
  };
  add(n[0], "x");
  add(n[1], "y");
  add(n[2], "z");
  add(plane.offset(), "");
  return sum + " = 0";
}

struct Description {
  std::string operator()(const FlatInput& flat) const {
    if (flat.dimension < 0) return "there are no points";
    std::string equations;
    for (const Halfspace& plane : flat.equations) {
      equations += (equations.empty() ? "" : " and ") + list(plane);
    }
    static constexpr const char* kWhere[] = {"are all the same point", "lie on one line",
                                             "lie in one plane"};
    return fmt::format("the points span no volume: they {}; every one satisfies {}",
                       kWhere[flat.dimension], equations);
  }
  std::string operator()(const EmptyProof& proof) const {
    return "no point lies in all halfspaces: " + list_rows(proof.farkas) +
           " says that a positive number is at most 0 (rows as typed, counted from 0)";
  }
  std::string operator()(const FlatProof& proof) const {
    return "the halfspaces have a point in common but no interior: " +
           list_rows(proof.multipliers) +
           " is 0 <= 0, so each of them holds with equality only (rows as typed, counted from 0)";
  }
  std::string operator()(const RecessionRay& ray) const {
    return "the halfspaces bound no finite volume: their intersection extends to infinity along " +
           list(ray.direction);
  }
};

}  // namespace

NotSolid of_typed_rows(NotSolid reason, const TypedRows& rows) {
  const auto rename = [&](std::vector<Multiplier>& multipliers) {
    if (rows.rows.empty()) return;
    for (Multiplier& m : multipliers) {
      m = {rows.rows[m.row], m.value * rows.scales[m.row]};
    }
  };
  if (auto* empty = std::get_if<EmptyProof>(&reason)) rename(empty->farkas);
  if (auto* flat = std::get_if<FlatProof>(&reason)) rename(flat->multipliers);
  return reason;
}

std::string describe(const NotSolid& reason) { return std::visit(Description{}, reason); }

}  // namespace convexact
