// SPDX-License-Identifier: MIT
// The question whether a candidate is the input's hull. Expected values are closed forms of boxes
// with corners in {-1, 1}, of their cut corners, and of the definition: both directed distances.
#include <doctest/doctest.h>

#include <algorithm>

#include "convexact/verify.hpp"
#include "expect_error.hpp"
#include "shapes/makers.hpp"

using namespace convexact;
using enum ClaimCode;

namespace {

std::vector<RationalPoint> box(const Rational& top) {
  std::vector<RationalPoint> corners;
  for (int i = 0; i < 8; ++i) {
    corners.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? top : Rational(-1));
  }
  return corners;
}

Mesh points_only(const std::vector<RationalPoint>& points) { return {PointSet(points), {}, {}}; }

Verdict judged(const Candidate& candidate, const Tolerance& tolerance = {}) {
  VerifyRequest request;
  request.asks = Asks::Hull;
  request.tolerance = tolerance;
  return std::get<Verdict>(verify(PointSet(box(1)), candidate, request));
}

}  // namespace

TEST_CASE("is-hull: a hull may be spelled in many ways") {
  CHECK(judged(points_only(box(1))).holds());
  std::vector<RationalPoint> more = box(1);
  more.emplace_back(0, 0, 1);  // on a facet
  more.emplace_back(0, 0, 0);  // inside
  more.push_back(more[3]);
  CHECK(judged(points_only(more)).holds());
  const std::string rows =
      "1 0 0 -1\n-1 0 0 -1\n0 1 0 -1\n0 -1 0 -1\n0 0 2 -2\n0 0 -1 -1\n1 1 1 -4\n";
  const Verdict planes = judged(read_candidate_bytes(rows, "c.txt"));
  CHECK(planes.holds());
  CHECK(planes[IsHull].status == Status::Holds);
}

TEST_CASE("is-hull: a box that is too high encloses the input and is not its hull") {
  const Verdict verdict = judged(points_only(box(3)));
  CHECK(verdict[ContainsInput].status == Status::Holds);
  const Claim& claim = verdict[IsHull];
  CHECK(claim.status == Status::Violated);
  CHECK_FALSE(claim.witness.input_point.has_value());
  const RationalPoint point = claim.witness.point.value(), nearest = claim.witness.nearest.value();
  CHECK(point[2] == 3);
  CHECK(nearest == RationalPoint(point[0], point[1], 1));
  CHECK(claim.witness.squared_distance == 4);
  CHECK(verdict.smallest_tolerance.value().decimal == "2e0");
  CHECK(judged(points_only(box(3)), {2, false}).holds());
  CHECK_FALSE(judged(points_only(box(3)), {Rational(199, 100), false}).holds());
}

TEST_CASE("is-hull: of a solid that misses a corner, that corner is the witness") {
  std::vector<RationalPoint> cut = box(1);
  cut.pop_back();  // (1, 1, 1), which is beyond x + y + z = 1
  const Verdict verdict = judged(points_only(cut));
  CHECK(verdict[ContainsInput].status == Status::Violated);
  const Claim& claim = verdict[IsHull];
  CHECK(claim.status == Status::Violated);
  CHECK(claim.witness.input_point == 7);
  CHECK(claim.witness.nearest == RationalPoint(Rational(1, 3), Rational(1, 3), Rational(1, 3)));
  CHECK(claim.witness.squared_distance == Rational(4, 3));
}

TEST_CASE("is-hull: the worse of both directions is the witness") {
  std::vector<RationalPoint> both = box(1);
  both.pop_back();
  both.emplace_back(0, 0, -4);  // 3 below, where the corner misses by less
  const Claim claim = judged(points_only(both))[IsHull];
  CHECK(claim.witness.point == RationalPoint(0, 0, -4));
  CHECK(claim.witness.squared_distance == 9);
}

TEST_CASE("is-hull: what is no bounded solid is not the hull, at any tolerance") {
  const Tolerance large{1000, false};
  CHECK(judged(points_only({}), large)[IsHull].status == Status::Violated);
  CHECK(judged(points_only({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), large)[IsHull].status ==
        Status::Violated);
  CHECK(judged(read_candidate_bytes("1 0 0 -1\n", "c.txt"), large)[IsHull].status ==
        Status::Violated);
  CHECK(judged(read_candidate_bytes("1 0 0 1\n-1 0 0 1\n", "c.txt"), large)[IsHull].status ==
        Status::Violated);
}

TEST_CASE("is-hull: corners of halfspaces that are beyond the largest double") {
  // x, y, z >= -1 and x / 2^1030 + y + z <= 3: a corner where x is 5 2^1030.
  const Integer power = Integer(1) << 1030;
  const std::string p = to_string(power), three = to_string(Integer(-3 * power));
  const Candidate candidate = read_candidate_bytes(
      R"({"halfspaces": [["-1","0","0","-1"],["0","-1","0","-1"],["0","0","-1","-1"],["1",")" + p +
          "\",\"" + p + "\",\"" + three + "\"]]}",
      "c.json");
  const Verdict verdict = judged(candidate);
  CHECK(verdict[ContainsInput].status == Status::Holds);
  const Rational far = 5 * Rational(power);
  const auto check = [&](const Claim& claim) {
    CHECK(claim.status == Status::Violated);
    CHECK(claim.witness.point.value() == RationalPoint(far, -1, -1));
    CHECK(claim.witness.nearest.value() == RationalPoint(1, -1, -1));
    CHECK(claim.witness.squared_distance == Rational((far - 1) * (far - 1)));
  };
  check(verdict[IsHull]);
  VerifyRequest inner;
  inner.asks = Asks::Inner;
  const Verdict inside = std::get<Verdict>(verify(PointSet(box(1)), candidate, inner));
  check(inside[InsideInput]);
  CHECK((*inside[InsideInput].witness.plane)(RationalPoint(1, 0, 0)) == 0);
}

TEST_CASE("asks: a claim of another question, and a simplification to no number, are refused") {
  const auto code_of = [](const VerifyRequest& request) {
    return error_of([&] {
             return std::get<Verdict>(verify(PointSet(box(1)), points_only(box(1)), request));
           })
        .code();
  };
  VerifyRequest request;
  request.claims = {IsHull};
  CHECK(code_of(request) == ErrorCode::InvalidArgument);
  request.asks = Asks::Inner;
  CHECK(code_of(request) == ErrorCode::InvalidArgument);
  request.claims = {};
  request.asks = Asks::Simplify;
  CHECK(code_of(request) == ErrorCode::InvalidArgument);
  request.max_facets = 6;
  CHECK(std::get<Verdict>(verify(PointSet(box(1)), points_only(box(1)), request)).holds());
}

TEST_CASE("mesh-oriented: faces that all look inward are one fault") {
  Mesh inward = points_only(box(1));
  inward.polygons = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                     {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
  const Verdict turned = judged(inward);
  for (const Claim& claim : turned.claims) {
    CAPTURE(name_of(claim.code));
    const bool is_the_fault = claim.code == MeshOriented;
    CHECK((claim.status == Status::Violated) == is_the_fault);
  }
  CHECK(turned[MeshConvex].status == Status::Holds);
  for (auto& polygon : inward.polygons) std::reverse(polygon.begin(), polygon.end());
  CHECK(judged(inward).holds());
}
