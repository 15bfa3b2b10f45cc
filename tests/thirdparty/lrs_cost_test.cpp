// SPDX-License-Identifier: MIT
// Runs by area and by mean width against lrs [Avis2000] and 80 digits of MPFR, third-party truth.
// lrs gets the planes that are left and finds the vertices; areas are polygons around their
// centroids, mean widths are lengths times angles between planes, both from the definition.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/mpfr.hpp>

#include "convexact/dual.hpp"
#include "convexact/hull.hpp"
#include "convexact/io.hpp"
#include "convexact/linear_program.hpp"
#include "convexact/shapes.hpp"
#include "fast/engines.hpp"
#include "lrs.hpp"
#include "shapes/makers.hpp"
#include "shipped_meshes.hpp"
using namespace convexact;

namespace {

using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<80> >;
using Vector = std::array<Real, 3>;

Real dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Real length(const Vector& a) { return sqrt(dot(a, a)); }
template <class From>
Vector to_reals(const From& x) {
  return {Real(x[0]), Real(x[1]), Real(x[2])};
}

// The polytope in three halfspaces or more, as lrs sees it.
class Solid {
 public:
  Solid(const Lrs& lrs, const std::vector<Halfspace>& planes) {
    std::vector<RationalPoint> found = lrs.vertices(planes);
    const auto before = [](const RationalPoint& a, const RationalPoint& b) {
      return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
    };
    std::sort(found.begin(), found.end(), before);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    for (const RationalPoint& p : found) points_.push_back(to_reals(p));
    for (const Halfspace& plane : planes) {
      normals_.push_back(to_reals(plane.normal()));
      auto& on = corners_.emplace_back();
      for (std::size_t i = 0; i < found.size(); ++i) {
        if (plane(found[i]) == 0) on.push_back(i);
      }
    }
  }

  Real measure(CostMeasure measure) const {
    return measure == CostMeasure::Area ? area() : mean_width();
  }

 private:
  Real area() const {
    Real sum = 0;
    for (std::size_t f = 0; f < normals_.size(); ++f) {
      Vector center{0, 0, 0};
      for (const std::size_t i : corners_[f]) {
        for (int k = 0; k < 3; ++k) center[k] += points_[i][k] / corners_[f].size();
      }
      const Vector x = minus(points_[corners_[f][0]], center), y = cross(normals_[f], x);
      std::vector<std::pair<Real, Vector> > around;
      for (const std::size_t i : corners_[f]) {
        const Vector p = minus(points_[i], center);
        around.emplace_back(atan2(dot(y, p) / length(y), dot(x, p) / length(x)), p);
      }
      std::sort(around.begin(), around.end(),
                [](const auto& a, const auto& b) { return a.first < b.first; });
      for (std::size_t i = 0; i < around.size(); ++i) {
        sum += length(cross(around[i].second, around[(i + 1) % around.size()].second)) / 2;
      }
    }
    return sum;
  }

  Real mean_width() const {
    Real sum = 0;
    for (std::size_t f = 0; f < normals_.size(); ++f) {
      for (std::size_t g = 0; g < f; ++g) {
        std::vector<std::size_t> shared;
        std::set_intersection(corners_[f].begin(), corners_[f].end(), corners_[g].begin(),
                              corners_[g].end(), std::back_inserter(shared));
        if (shared.size() != 2) continue;
        const Real angle =
            atan2(length(cross(normals_[f], normals_[g])), dot(normals_[f], normals_[g]));
        sum += length(minus(points_[shared[0]], points_[shared[1]])) * angle;
      }
    }
    return sum / (4 * boost::math::constants::pi<Real>());
  }

  std::vector<Vector> points_, normals_;
  std::vector<std::vector<std::size_t> > corners_;  // of each plane, ascending
};

Run run_of(const PointSet& points, CostMeasure measure, std::size_t faces) {
  const Hull hull = std::get<Hull>(convex_hull(points));
  const DualHull dual = dual_of(hull, points);
  RationalPoint center = RationalPoint::Zero();
  for (const PointId id : hull.certificate.simplex) center += points[id] / Rational(4);
  return simplify_filtered(dual, center,
                           {.faces = faces, .cost = measure, .verify = VerifyLevel::None});
}

// To 60 of the 80 digits: a facet that is nearly a point, or an angle near 0, costs some of them.
void check_same(const Enclosure& ours, const Real& theirs, const Real& scale) {
  const Real low(ours.low()), high(ours.high());
  CHECK(abs(low - theirs) < scale * Real("1e-60"));
  CHECK(abs(high - theirs) < scale * Real("1e-60"));
}

// Costs of the steps between two numbers of halfspaces, against two solids from scratch.
void check_costs(const Lrs& lrs, const Run& run, CostMeasure measure, std::size_t from,
                 std::size_t to) {
  std::vector<Cost> costs;
  for (const Step& step : run.steps) {
    if (step.left < from && step.left >= to) costs.push_back(step.cost.value());
  }
  REQUIRE(costs.size() == from - to);
  const auto left = [&](std::size_t faces) {
    return Solid(lrs, left_after(run, run.halfspaces.size() - faces)).measure(measure);
  };
  const Real before = left(from), after = left(to);
  REQUIRE(before < after);
  check_same(sum_of(costs).enclose(256), after - before, after);
}

}  // namespace

TEST_CASE("costs by area and by mean width: shipped meshes agree with lrs and MPFR") {
  const Lrs lrs("costs");
  for (const std::string& path : shipped_meshes()) {
    const PointSet points = read_mesh(path).points;
    for (const CostMeasure measure : {CostMeasure::Area, CostMeasure::MeanWidth}) {
      CAPTURE(path);
      CAPTURE(static_cast<int>(measure));
      const Run run = run_of(points, measure, 6);
      REQUIRE(run.stop == StopReason::Reached);
      check_costs(lrs, run, measure, 60, 18);
      check_costs(lrs, run, measure, 18, 17);
      check_costs(lrs, run, measure, 18, 6);
    }
  }
}

TEST_CASE("costs by area and by mean width: every step on lattice points agrees with lrs") {
  const Lrs lrs("lattice_costs");
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    CAPTURE(seed);
    const PointSet points(shapes::lattice(14, 4, seed));
    for (const CostMeasure measure : {CostMeasure::Area, CostMeasure::MeanWidth}) {
      const Run run = run_of(points, measure, 4);
      for (const Step& step : run.steps) {
        check_costs(lrs, run, measure, step.left + 1, step.left);
      }
    }
  }
}
