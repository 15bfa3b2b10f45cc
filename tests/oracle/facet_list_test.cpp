// SPDX-License-Identifier: MIT
// Facet lists of other programs: planes computed and written in floating point name the facets that
// rounding explains, and no others.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "convexact/number.hpp"
#include "fast/engines.hpp"
#include "removal_orders.hpp"
#include "shapes/makers.hpp"
#include "sweep.hpp"
#include "wire/trace_verdict.hpp"

using namespace convexact;

namespace {

Halfspace plane_of_doubles(const std::array<double, 4>& x) {
  RationalVector3 normal;
  for (int k = 0; k < 3; ++k) normal[k] = to_rational(x[static_cast<std::size_t>(k)]);
  return Halfspace(normal, to_rational(x[3]));
}

// The facet's plane as other programs have it: the cross product of two edges, of length 1.
template <class Real>
std::array<double, 4> computed_plane(const DualHull& solid, HalfspaceId facet) {
  std::vector<Vector3<Real>> corners;
  for (const DualTriangle& t : solid.triangles) {
    if (std::count(t.begin(), t.end(), facet) == 0) continue;
    const auto& h = solid.halfspaces;
    const RationalPoint v = meet(h[t[0].index()], h[t[1].index()], h[t[2].index()]);
    Vector3<Real> corner;
    for (int k = 0; k < 3; ++k) corner[k] = Real(to_double(v[k], Rounding::Nearest));
    if (std::find(corners.begin(), corners.end(), corner) == corners.end()) {
      corners.push_back(corner);
    }
  }
  const Vector3<Real> first = corners[1] - corners[0], second = corners[2] - corners[0];
  Vector3<Real> normal = first.cross(second);
  normal /= normal.norm();
  RationalVector3 outward;
  for (int k = 0; k < 3; ++k) outward[k] = Rational(solid.halfspaces[facet.index()].normal()[k]);
  RationalVector3 found;
  for (int k = 0; k < 3; ++k) found[k] = to_rational(double(normal[k]));
  if (outward.dot(found) < 0) normal = -normal;
  return {double(normal[0]), double(normal[1]), double(normal[2]), double(-normal.dot(corners[0]))};
}

// The removals of `ids`, through a list of planes of one's own.
RemovalOrder order_by_list(const std::vector<Halfspace>& list,
                           const std::vector<HalfspaceId>& ids) {
  RemovalOrder order;
  order.facets.assign(list.begin(), list.end());
  order.has_list = true;
  for (const HalfspaceId id : ids) {
    order.steps.push_back(
        {order.steps.size() + 1, "the id '" + std::to_string(id.index()) + "'", {id}});
  }
  return order;
}

TraceVerdict judge_list(const DualHull& solid, const RemovalOrder& order, double unit = 0x1p-53) {
  JudgeOptions options;
  options.unit = unit;
  return judge_trace(solid, center_of(solid), order, options);
}

template <class Real>
std::vector<Halfspace> computed_list(const DualHull& solid) {
  std::vector<Halfspace> list;
  for (std::size_t i = 0; i < solid.halfspaces.size(); ++i) {
    list.push_back(plane_of_doubles(computed_plane<Real>(solid, HalfspaceId(i))));
  }
  return list;
}

std::vector<HalfspaceId> greedy_order(const DualHull& solid) {
  std::vector<HalfspaceId> ids;
  for (const Step& step : simplify_filtered(solid, center_of(solid)).steps) {
    ids.push_back(step.removed);
  }
  return ids;
}

}  // namespace

TEST_CASE("facet list: planes computed in doubles name their facets (#13)" * sweep) {
  std::vector<Point> far = shapes::on_sphere(40, 3);
  for (Point& p : far) p += Point(1000, -500, 70);
  std::vector<Point> thin = shapes::on_sphere(40, 5);
  for (Point& p : thin) p[2] *= 1e-5;
  for (const std::vector<Point>& points :
       {shapes::on_sphere(60, 7), far, thin, shapes::needle(20, 1e4, 1)}) {
    const DualHull solid = dual_of_doubles(points);
    const std::vector<Halfspace> list = computed_list<double>(solid);
    const TraceVerdict verdict = judge_list(solid, order_by_list(list, greedy_order(solid)));
    CHECK(verdict.rating == TraceRating::Greedy);
    CHECK(verdict.holds());
    std::size_t inexact = 0;
    for (std::size_t i = 0; i < list.size(); ++i) inexact += list[i] != solid.halfspaces[i];
    CHECK(inexact > list.size() / 2);
    CHECK(verdict.listed.rounded == inexact);
    CHECK(verdict.listed.unknown == 0);
    CHECK(sentence(verdict.listed).find(std::to_string(inexact) + " planes") == 0);
  }
}

TEST_CASE("facet list: binary32 explains planes of binary32, binary64 does not (#13)") {
  const DualHull solid = dual_of_doubles(shapes::on_sphere(40, 7));
  const std::vector<Halfspace> list = computed_list<float>(solid);
  const RemovalOrder order = order_by_list(list, greedy_order(solid));
  CHECK(judge_list(solid, order, 0x1p-24).holds());
  const TraceVerdict verdict = judge_list(solid, order);
  CHECK(violated(verdict) == Codes{"trace-plane-unknown"});
  CHECK(verdict.listed.unknown > list.size() / 2);
  const TraceWitness blame = witness(verdict, "trace-plane-unknown");
  CHECK(blame.found.find(", in the facet list the plane ") != std::string::npos);
  CHECK(blame.expected.find("the nearest, of facet " +
                            std::to_string(greedy_order(solid)[0].index())) != std::string::npos);
  CHECK(blame.expected.find("rounding explains") != std::string::npos);
}

TEST_CASE("facet list: what is off by more than rounding, or faces inward, is no facet (#13)") {
  // The side x = 4 of [0, 4]^3: c is 4, the diagonal is D = 4 sqrt 2 and h = D / 2, so that 2^-46
  // is explained. The corners miss (1, 0, 0, -4 - t) by t.
  const DualHull solid = cut_box({Rational(1)});
  const HalfspaceId side = id_of(solid, cube_sides()[0]);
  const auto verdict_of = [&](const Halfspace& plane) {
    return judge_list(solid, order_by_list({plane}, {HalfspaceId(0)}));
  };
  const auto moved = [](const Rational& t) {
    return Halfspace(RationalVector3(1, 0, 0), Rational(-4) - t);
  };
  const Rational limit(1, Integer(1) << 46);
  const TraceVerdict within = verdict_of(moved(limit));
  REQUIRE(within.steps.size() == 1);
  CHECK(within.steps[0].removed == side);
  CHECK(within.listed.rounded == 1);
  CHECK(within.listed.squared_distance == limit * limit);
  CHECK(verdict_of(moved(-limit)).steps.size() == 1);
  CHECK(violated(verdict_of(moved(limit * Rational(1001, 1000)))) == Codes{"trace-plane-unknown"});
  CHECK(violated(verdict_of(Halfspace(RationalVector3(-1, 0, 0), Rational(4)))) ==
        Codes{"trace-plane-unknown"});
}

TEST_CASE("facet list: of planes that nearly agree the exact one is taken (#13)") {
  // A second cut of the same corner, one unit of 2^-60 beyond: redundant in the solid, so in a list
  // it is the cut up to rounding; the cut itself stays what it is.
  const DualHull solid = cut_box({Rational(1), Rational(3, 2)});
  const HalfspaceId cut = id_of(solid, corner_cut(0, Rational(1)));
  const std::vector<Halfspace> list = {corner_cut(0, Rational(1) - Rational(1, Integer(1) << 60)),
                                       corner_cut(1, Rational(3, 2))};
  const TraceVerdict verdict =
      judge_list(solid, order_by_list(list, {HalfspaceId(0), HalfspaceId(1)}));
  CHECK(verdict.holds());
  CHECK(verdict.steps[0].removed == cut);
  CHECK(verdict.listed.rounded == 1);
}

TEST_CASE("facet list: a facet that it lacks is said to be missing there (#13)") {
  const DualHull solid = cut_box({Rational(1, 2), Rational(1)});
  const TraceVerdict verdict =
      judge_list(solid, order_by_list({corner_cut(1, Rational(1))}, {HalfspaceId(0)}));
  REQUIRE(verdict.never_removed.has_value());
  CHECK(verdict.never_removed->unlisted == 1);
  CHECK(sentence(*verdict.never_removed, verdict).find("(not in the facet list)") !=
        std::string::npos);
}
