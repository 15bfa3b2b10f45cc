// SPDX-License-Identifier: MIT
#include "convexact/oracle/support_program.hpp"

#include <algorithm>
#include <map>

#include "convexact/error.hpp"
#include "convexact/lp/seidel.hpp"
#include "convexact/number/rounding.hpp"

namespace convexact {
namespace {

Sign sign_of_determinant(const IntegerVector3& a, const IntegerVector3& b,
                         const IntegerVector3& c) {
  return sign_of(Integer(a.dot(b.cross(c))));
}

// In the direction of n, of a length that doubles hold.
Vector3<double> to_direction(const IntegerVector3& n) {
  std::size_t bits = 0;
  for (int k = 0; k < 3; ++k) bits = std::max(bits, bit_length(n[k]));
  Vector3<double> direction;
  for (int k = 0; k < 3; ++k) {
    direction[k] = to_double(scale_by_power_of_two(Rational(n[k]), -static_cast<long>(bits)),
                             Rounding::Nearest);
  }
  return direction;
}

Rational maximum_by_seidel(const Polytope& polytope, const IntegerVector3& n) {
  LinearProgram lp;
  const auto rows = static_cast<Eigen::Index>(polytope.planes.size());
  lp.normals.resize(rows, 3);
  lp.offsets.resize(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Halfspace& plane = polytope.planes[static_cast<std::size_t>(i)];
    for (int k = 0; k < 3; ++k) lp.normals(i, k) = Rational(plane.normal()[k]);
    lp.offsets[i] = Rational(plane.offset());
  }
  lp.objective = n.cast<Rational>();
  const LpOutcome outcome = maximise(lp);
  const auto* optimal = std::get_if<Optimal>(&outcome);
  if (optimal == nullptr) throw Error(ErrorCode::Internal, "a polytope has no largest point");
  return lp.objective.dot(optimal->x);
}

}  // namespace

SupportProgram::SupportProgram(const Polytope& polytope)
    : polytope_(polytope), around_(polytope.vertices.size()) {
  for (const RationalPoint& v : polytope.vertices) {
    Vector3<double> near;
    for (int k = 0; k < 3; ++k) near[k] = to_double(v[k], Rounding::Nearest);
    near_.push_back(near);
  }
  // The facet to the left of each directed edge, at its tail, and the one that follows there
  // counter-clockwise: the facet to the left of the facet's own edge into that corner, turned.
  struct Corner {
    std::uint32_t previous, next;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> left_of;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> previous_in;
  for (std::uint32_t f = 0; f < polytope.facets.size(); ++f) {
    const auto& corners = polytope.facets[f];
    for (std::size_t k = 0; k < corners.size(); ++k) {
      left_of[{corners[k], corners[(k + 1) % corners.size()]}] = f;
      previous_in[{f, corners[(k + 1) % corners.size()]}] = corners[k];
    }
  }
  for (std::uint32_t f = 0; f < polytope.facets.size(); ++f) {
    for (const std::uint32_t v : polytope.facets[f]) {
      if (!around_[v].empty()) continue;
      for (std::uint32_t g = f; around_[v].empty() || g != f;
           g = left_of.at({v, previous_in.at({g, v})})) {
        around_[v].push_back(g);
      }
    }
  }
}

Rational SupportProgram::maximum(const IntegerVector3& n) const {
  for (const std::size_t vertex : promising_vertices(n)) {
    if (is_optimal(vertex, n)) return polytope_.vertices[vertex].dot(n.cast<Rational>());
  }
  return maximum_by_seidel(polytope_, n);
}

// Those that doubles cannot tell from the best one: a candidate's plane often touches three or more
// vertices but for rounding. Only the time depends on how many there are.
std::vector<std::size_t> SupportProgram::promising_vertices(const IntegerVector3& n) const {
  constexpr double kNear = 0x1p-46;  // of the largest value
  const Vector3<double> direction = to_direction(n);
  std::vector<double> values;
  double largest = -std::numeric_limits<double>::infinity(), scale = 0;
  for (const Vector3<double>& v : near_) {
    values.push_back(direction.dot(v));
    largest = std::max(largest, values.back());
    scale = std::max(scale, std::abs(values.back()));
  }
  std::vector<std::size_t> promising;
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (values[v] >= largest - kNear * scale) promising.push_back(v);
  }
  return promising;
}

// The normals of the facets at a vertex, counter-clockwise, span the cone of the functionals that
// are largest there; it falls into the cones of a fan of triples.
bool SupportProgram::is_optimal(std::size_t vertex, const IntegerVector3& n) const {
  const auto normal = [&](std::size_t k) -> const IntegerVector3& {
    return polytope_.planes[around_[vertex][k]].normal();
  };
  for (std::size_t k = 1; k + 1 < around_[vertex].size(); ++k) {
    if (sign_of_determinant(normal(0), normal(k), n) != Sign::Negative &&
        sign_of_determinant(normal(k), normal(k + 1), n) != Sign::Negative &&
        sign_of_determinant(normal(k + 1), normal(0), n) != Sign::Negative) {
      return true;
    }
  }
  return false;
}

}  // namespace convexact
