// SPDX-License-Identifier: MIT
// Requests to the oracle, and requests that it refuses. Expected values are closed forms of
// the cube [-1, 1]^3, and the definition of a maximum.
#include <doctest/doctest.h>

#include <algorithm>

#include "convexact/verify.hpp"
#include "expect_error.hpp"
#include "oracle/solid/second_way.hpp"
#include "polytope_by_definition.hpp"
#include "shapes/makers.hpp"

using namespace convexact;
using enum ClaimCode;

namespace {

const std::string kCubeRows = "1 0 0 -1\n-1 0 0 -1\n0 1 0 -1\n0 -1 0 -1\n0 0 1 -1\n0 0 -1 -1\n";

Verdict verdict_of(const std::string& bytes, const char* name, const VerifyRequest& request = {}) {
  return std::get<Verdict>(
      verify(PointSet(shapes::cube()), read_candidate_bytes(bytes, name), request));
}

}  // namespace

TEST_CASE("claims: each is found by its name, and each status has its own") {
  for (const ClaimCode code : kAllClaims) {
    CAPTURE(name_of(code));
    CHECK(claim_of_name(name_of(code)) == code);
  }
  CHECK_FALSE(claim_of_name("").has_value());
  CHECK_FALSE(claim_of_name("mesh-close").has_value());
  std::vector<std::string> names;
  for (const Status status :
       {Status::Holds, Status::Violated, Status::NotAsked, Status::NotApplicable}) {
    names.emplace_back(name_of(status));
  }
  CHECK(names == std::vector<std::string>{"holds", "violated", "not-asked", "not-applicable"});
}

TEST_CASE("verify: a negative tolerance is refused") {
  VerifyRequest request;
  request.tolerance.value = -1;
  CHECK(error_of([&] { return verdict_of(kCubeRows, "c.txt", request); }).code() ==
        ErrorCode::InvalidArgument);
}

TEST_CASE("verify: whether halfspaces contain the input does not need their vertices") {
  VerifyRequest request;
  request.tightness = false;
  for (const ClaimCode also : {ContainsInput, CandidateSolid, CandidateBounded}) {
    CAPTURE(name_of(also));
    request.claims = {ContainsInput, also};
    const Verdict verdict = verdict_of(kCubeRows, "c.txt", request);
    CHECK(verdict.holds());
    CHECK(verdict[ContainsInput].status == Status::Holds);
    const auto skipped = std::any_of(
        verdict.stages.begin(), verdict.stages.end(),
        [](const auto& s) { return s.name == "candidate's vertices" && !s.skipped.empty(); });
    CHECK(skipped == (also == ContainsInput));
    CHECK(verdict.size.vertices.has_value() == (also != ContainsInput));
  }
}

TEST_CASE("verify: a budget is not for what has no bounded solid to count on") {
  VerifyRequest request;
  request.max_facets = request.max_vertices = request.max_facet_vertices = 4;
  const std::string open = kCubeRows.substr(0, kCubeRows.rfind("0 0 -1"));
  const Verdict verdict = verdict_of(open, "c.txt", request);
  for (const ClaimCode code : {MaxFacets, MaxVertices, MaxFacetVertices}) {
    CHECK(verdict[code].status == Status::NotApplicable);
  }
}

TEST_CASE("verify: a claim that was named and does not apply is no success (#13)") {
  const std::string hole =
      "v -2 -2 -2\nv 9 -2 -2\nv -2 9 -2\nv -2 -2 9\nf 1 3 2\nf 1 2 4\nf 1 4 3\n";
  VerifyRequest request;
  request.tightness = false;
  request.claims = {MeshOriented};
  CHECK(verdict_of(hole, "c.obj", request)[MeshOriented].status == Status::NotApplicable);
  CHECK_FALSE(verdict_of(hole, "c.obj", request).holds());
  request.claims = {MeshClosed};
  const std::string points = hole.substr(0, hole.find('f'));
  CHECK_FALSE(verdict_of(points, "c.obj", request).holds());
  CHECK_FALSE(verdict_of(kCubeRows, "c.txt", request).holds());
  request.claims = {};
  CHECK(verdict_of(points, "c.obj", request).holds());
  request.max_facets = 6;
  const std::string open = kCubeRows.substr(0, kCubeRows.rfind("0 0 -1"));
  request.claims = {ContainsInput};
  CHECK_FALSE(verdict_of(open, "c.txt", request).holds());
  request.max_facets.reset();
  CHECK(verdict_of(open, "c.txt", request).holds());
}

TEST_CASE("verify: a budget that is named without a number asks nothing (#13)") {
  for (const ClaimCode code : {MaxFacets, MaxVertices, MaxFacetVertices}) {
    VerifyRequest request;
    request.claims = {ContainsInput, code};
    CHECK(error_of([&] { return verdict_of(kCubeRows, "c.txt", request); }).code() ==
          ErrorCode::InvalidArgument);
    request.max_facets = request.max_vertices = request.max_facet_vertices = 8;
    CHECK(verdict_of(kCubeRows, "c.txt", request).holds());
  }
}

TEST_CASE("least_tolerance: the least decimal of three digits that is not below the root (#13)") {
  CHECK(least_tolerance(4) == "2e0");
  CHECK(least_tolerance(2) == "1.42e0");
  CHECK(least_tolerance(Rational(1, 4)) == "5e-1");
  CHECK(least_tolerance(parse_rational("0.99900000000000001")) == "1e0");
  for (const char* squared : {"1e-700", "7.3e-31", "1e600", "998001", "998002", "1/3", "3e-5"}) {
    CAPTURE(squared);
    const Rational square = parse_rational(squared);
    const Tolerance least = parse_tolerance(least_tolerance(square));
    CHECK(least.allows(square, 1));
    CHECK_FALSE(Tolerance{least.value * Rational(989, 1000)}.allows(square, 1));
  }
}

TEST_CASE("verify: with the smallest tolerance named, every claim holds (#13)") {
  // x <= 0.75 misses corners by 1/4; x <= 1 - 2^-53 by what rounding explains.
  const std::string rest = "-1 0 0 -1\n0 1 0 -1\n0 -1 0 -1\n0 0 1 -1\n0 0 -1 -1\n";
  for (const auto& [row, is_rounding] :
       {std::pair("1 0 0 -0.75\n", false), std::pair("1 0 0 -0.99999999999999988897\n", true)}) {
    const Verdict verdict = verdict_of(row + rest, "c.txt");
    REQUIRE(verdict.smallest_tolerance.has_value());
    CHECK(verdict.smallest_tolerance->is_rounding == is_rounding);
    VerifyRequest request;
    request.tolerance = parse_tolerance(verdict.smallest_tolerance->decimal);
    const Verdict again = verdict_of(row + rest, "c.txt", request);
    CHECK(again.holds());
    CHECK_FALSE(again.smallest_tolerance.has_value());
  }
  CHECK_FALSE(verdict_of(kCubeRows, "c.txt").smallest_tolerance.has_value());
  // A hole is none of a distance.
  CHECK_FALSE(verdict_of("v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 3 2\n", "c.obj")
                  .smallest_tolerance.has_value());
}

TEST_CASE("verify: halfspaces that leave a square are no solid, and say which and where") {
  const std::string square = "1 0 0 0\n-1 0 0 0\n0 1 0 -1\n0 -1 0 -1\n0 0 1 -1\n0 0 -1 -1\n";
  const Verdict verdict = verdict_of(square, "c.txt");
  const Claim& claim = verdict[CandidateSolid];
  CHECK(claim.status == Status::Violated);
  CHECK(claim.witness.rows == std::vector<std::size_t>{0, 1});
  REQUIRE(claim.witness.point.has_value());
  CHECK(claim.witness.point->x() == 0);
  CHECK(abs(claim.witness.point->y()) <= 1);
  CHECK(abs(claim.witness.point->z()) <= 1);
  CHECK(verdict[CandidateBounded].status == Status::NotApplicable);
  CHECK(verdict.outside->points == 8);
}

TEST_CASE("verify: two coverings of the cube that share no edge are closed, but not its surface") {
  // One of squares between the corners 1 to 8, one of octagons by way of the midpoints of edges.
  std::string text;
  for (const int x : {-1, 1}) {
    for (const int y : {-1, 1}) {
      for (const int z : {-1, 1}) {
        text += "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
      }
    }
  }
  const int squares[6][4] = {{1, 2, 4, 3}, {5, 7, 8, 6}, {1, 5, 6, 2},
                             {3, 4, 8, 7}, {1, 3, 7, 5}, {2, 6, 8, 4}};
  const auto corner = [](int id, int axis) { return (id - 1) >> (2 - axis) & 1 ? 1 : -1; };
  std::string faces, middles;
  int count = 8;
  for (const auto& square : squares) {
    faces += "f";
    for (const int id : square) faces += " " + std::to_string(id);
    faces += "\nf";
    for (int k = 0; k < 4; ++k) {
      const int a = square[k], b = square[(k + 1) % 4];
      middles += "v";
      for (int axis = 0; axis < 3; ++axis) {
        middles += " " + std::to_string((corner(a, axis) + corner(b, axis)) / 2);
      }
      middles += "\n";
      faces += " " + std::to_string(a) + " " + std::to_string(++count);
    }
    faces += "\n";
  }
  const Verdict verdict = verdict_of(text + middles + faces, "c.obj");
  CHECK(verdict[MeshClosed].status == Status::Holds);
  CHECK(verdict[MeshOriented].status == Status::Holds);
  CHECK(verdict[MeshPlanar].status == Status::Holds);
  CHECK(verdict[MeshConvex].status == Status::Violated);
  CHECK(verdict[MeshConvex].sentence.find("do not cover it once") != std::string::npos);
  CHECK(verdict[ContainsInput].status == Status::Holds);
}

TEST_CASE("SupportProgram: of vertices beyond doubles a linear program finds the largest") {
  const Rational scale = scale_by_power_of_two(Rational(1), 1100);
  for (const auto& points : {shapes::cube(), shapes::icosahedron(), shapes::prism(7)}) {
    Polytope polytope = polytope_by_definition(PointSet(points));
    for (RationalPoint& v : polytope.vertices) v *= scale;
    for (Halfspace& plane : polytope.planes) {
      plane = Halfspace(plane.normal().cast<Rational>(), Rational(plane.offset()) * scale);
    }
    oracle::SupportProgram program(polytope);
    for (int x = -2; x <= 2; ++x) {
      for (int y = -2; y <= 2; ++y) {
        const IntegerVector3 n(x, y, 1);
        Rational most = polytope.vertices[0].dot(n.cast<Rational>());
        for (const RationalPoint& v : polytope.vertices) {
          most = std::max(most, Rational(v.dot(n.cast<Rational>())));
        }
        CHECK(program.maximum(n) == most);
      }
    }
  }
}

TEST_CASE("verify: an empty mesh is inside of nothing") {
  VerifyRequest request;
  request.asks = Asks::Inner;
  request.claims = {InsideInput};
  const Verdict verdict =
      std::get<Verdict>(verify(PointSet(shapes::cube()), Mesh{PointSet(), {}, {}}, request));
  CHECK(verdict[InsideInput].status == Status::NotApplicable);
  CHECK_FALSE(verdict.holds());
}
