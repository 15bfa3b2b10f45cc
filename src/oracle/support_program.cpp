// SPDX-License-Identifier: MIT
#include "convexact/oracle/support_program.hpp"

#include <algorithm>
#include <utility>

#include "convexact/error.hpp"
#include "convexact/lp/seidel.hpp"
#include "convexact/number/rounding.hpp"

namespace convexact {
namespace {

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
  // Counter-clockwise around a vertex, a facet is followed by the one that leaves the vertex along
  // the edge by which the facet itself enters it.
  struct Corner {
    std::uint32_t vertex, next, previous, facet;
  };
  std::vector<Corner> corners;
  for (std::uint32_t f = 0; f < polytope.facets.size(); ++f) {
    const auto& around = polytope.facets[f];
    for (std::size_t k = 0, n = around.size(); k < n; ++k) {
      corners.push_back({around[k], around[(k + 1) % n], around[(k + n - 1) % n], f});
    }
  }
  const auto place = [](const Corner& c) { return std::pair(c.vertex, c.next); };
  std::sort(corners.begin(), corners.end(),
            [&](const Corner& a, const Corner& b) { return place(a) < place(b); });
  for (const Corner& start : corners) {
    const std::uint32_t v = start.vertex;
    if (!around_[v].empty()) continue;
    const Corner* at = &start;
    do {
      around_[v].push_back(at->facet);
      const std::pair wanted(v, at->previous);
      const auto found =
          std::lower_bound(corners.begin(), corners.end(), wanted,
                           [&](const Corner& c, const auto& key) { return place(c) < key; });
      CONVEXACT_ASSERT(found != corners.end() && place(*found) == wanted);
      at = &*found;
    } while (at != &start);
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
// are largest there; it falls into the cones of a fan of triples (0, k, k + 1). Of the three signs
// that place n in one of them, det(k + 1, 0, n) is the first sign of the next one, turned around.
bool SupportProgram::is_optimal(std::size_t vertex, const IntegerVector3& n) const {
  const auto normal = [&](std::size_t k) -> const IntegerVector3& {
    return polytope_.planes[around_[vertex][k]].normal();
  };
  IntegerVector3 turned = normal(1).cross(n);
  Sign from_first = sign_of(Integer(normal(0).dot(turned)));  // of det(0, k, n)
  for (std::size_t k = 1; k + 1 < around_[vertex].size(); ++k) {
    turned = normal(k + 1).cross(n);
    const Sign from_next = sign_of(Integer(normal(0).dot(turned)));
    if (from_first != Sign::Negative && from_next != Sign::Positive &&
        sign_of(Integer(normal(k).dot(turned))) != Sign::Negative) {
      return true;
    }
    from_first = from_next;
  }
  return false;
}

}  // namespace convexact
