// SPDX-License-Identifier: MIT
// verify_parts() on shapes of unit cells, whose answers are closed forms.
#include "convexact/verify_parts.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "cells.hpp"
#include "expect_error.hpp"
#include "small_surfaces.hpp"
#include "sweep.hpp"
#include "wire/parts_verdict.hpp"

using namespace convexact;
using namespace support;
using enum ClaimCode;

namespace {

PartsRequest everything() {
  PartsRequest request;
  request.claims = {PartsReadable, PartsFinite, PartsSolid,    PartsConvex, CoversPoints,
                    CoversSurface, CoversSolid, PartsDisjoint, PartsNeeded};
  request.exact_volumes = true;
  return request;
}

PartsVerdict judged(const std::set<Cell>& cells, const std::vector<Box>& boxes,
                    const PartsRequest& request = everything()) {
  return verify_parts(mesh_of_cells(cells), parts_of_boxes(boxes), request);
}

// Every claim that was asked holds but for these.
void check_violated(const PartsVerdict& verdict, const std::vector<ClaimCode>& codes) {
  for (const Claim& claim : verdict.claims) {
    const std::string code = name_of(claim.code);
    CAPTURE(code);
    CAPTURE(claim.sentence);
    if (claim.status == Status::NotAsked) continue;
    const bool is_meant = std::find(codes.begin(), codes.end(), claim.code) != codes.end();
    CHECK(claim.status == (is_meant ? Status::Violated : Status::Holds));
  }
  CHECK(verdict.holds() == codes.empty());
}

const Box kBeside{{1, 0, 0}, {2, 1, 1}};

}  // namespace

TEST_CASE("verify_parts: cells hold what they make up") {
  for (const auto& cells : {l_cells(), ring_cells(), cross_cells()}) {
    const PartsVerdict verdict = judged(cells, boxes_of(cells));
    check_violated(verdict, {});
    REQUIRE(verdict.measures);
    const PartsMeasures& m = *verdict.measures;
    CHECK(m.solid_volume->exact == Rational(cells.size()));
    CHECK(m.union_volume->exact == Rational(cells.size()));
    CHECK(m.uncovered_volume->exact == Rational(0));
    CHECK(m.excess_volume->exact == Rational(0));
    CHECK(m.overlap_volume->exact == Rational(0));
    CHECK(m.uncovered_area.contains(0));
    CHECK(m.surface_area.contains(Rational(verdict.surface.triangles.size()) / 2));
  }
}

TEST_CASE("verify_parts: a cross without its middle cell has its surface covered") {
  std::set<Cell> arms = cross_cells();
  arms.erase({0, 0, 0});
  const PartsVerdict verdict = judged(cross_cells(), boxes_of(arms));
  check_violated(verdict, {CoversSolid});
  const Witness& witness = verdict[CoversSolid].witness;
  CHECK(witness.winding == 1);
  REQUIRE(witness.point);
  for (const Rational& x : *witness.point) {
    CHECK(x > 0);
    CHECK(x < 1);
  }
  CHECK(verdict.measures->uncovered_volume->exact == Rational(1));
  CHECK(verdict.measures->excess_volume->exact == Rational(0));
}

TEST_CASE("verify_parts: one hull for an L fills its notch") {
  const Box whole{{0, 0, 0}, {2, 2, 1}};
  const PartsVerdict verdict = judged(l_cells(), {whole});
  check_violated(verdict, {});
  CHECK(verdict.measures->excess_volume->exact == Rational(1));
}

TEST_CASE("verify_parts: a missing cell is found, with the farthest point") {
  const PartsVerdict verdict = judged(l_cells(), {box_of({0, 0, 0}), box_of({0, 1, 0})});
  check_violated(verdict, {CoversPoints, CoversSurface, CoversSolid});
  CHECK(verdict.points_outside == 4);
  const Witness& point = verdict[CoversPoints].witness;
  CHECK(point.squared_distance == Rational(1));
  CHECK((*point.point)[0] == 2);
  CHECK(verdict[CoversSurface].witness.squared_distance == Rational(1));
  CHECK(verdict.measures->uncovered_volume->exact == Rational(1));
  CHECK(verdict.measures->uncovered_area.contains(5));
  CHECK(verdict.measures->surface_to_union.contains(1));
}

TEST_CASE("verify_parts: an ulp is found where it matters, and only there") {
  const double less = std::nextafter(2.0, 0.0);
  SUBCASE("at the end of an arm") {
    const PartsVerdict verdict =
        judged(l_cells(), {box_of({0, 0, 0}), {{1, 0, 0}, {less, 1, 1}}, box_of({0, 1, 0})});
    check_violated(verdict, {CoversPoints, CoversSurface, CoversSolid});
    const Rational ulp = Rational(2) - to_rational(less);
    CHECK(verdict[CoversPoints].witness.squared_distance == Rational(ulp * ulp));
    CHECK(verdict[CoversSurface].witness.squared_distance == Rational(ulp * ulp));
  }
  SUBCASE("within another part") {
    const PartsVerdict verdict =
        judged(l_cells(), {{{0, 0, 0}, {2, 1, 1}}, {{0, 0, 0}, {1, less, 1}}, box_of({0, 1, 0})});
    for (const ClaimCode code : {CoversPoints, CoversSurface, CoversSolid}) {
      CHECK(verdict[code].status == Status::Holds);
    }
  }
  SUBCASE("in a wall between two cells") {
    const double more = std::nextafter(1.0, 2.0);
    const PartsVerdict verdict =
        judged(l_cells(), {box_of({0, 0, 0}), {{more, 0, 0}, {2, 1, 1}}, box_of({0, 1, 0})});
    CHECK(verdict[CoversPoints].status == Status::Holds);
    CHECK(verdict[CoversSurface].status == Status::Violated);
    CHECK(verdict[CoversSolid].status == Status::Violated);
  }
}

TEST_CASE("verify_parts: a tolerance of just the distance lets it pass") {
  const std::vector<Box> boxes = {box_of({0, 0, 0}), {{1, 0, 0}, {1.75, 1, 1}}, box_of({0, 1, 0})};
  PartsRequest request;
  request.tolerance.value = Rational(1, 4);
  CHECK(judged(l_cells(), boxes, request).holds());
  request.tolerance.value -= Rational(1, 1000000000);
  check_violated(judged(l_cells(), boxes, request), {CoversPoints, CoversSurface});
  request.claims = {CoversSolid};
  CHECK(error_of([&] { return judged(l_cells(), boxes, request); }).code() ==
        ErrorCode::InvalidArgument);
}

TEST_CASE("verify_parts: a relative tolerance refers to the input") {
  // The diameter of the L is 3.
  const std::vector<Box> boxes = {box_of({0, 0, 0}), {{1, 0, 0}, {1.75, 1, 1}}, box_of({0, 1, 0})};
  PartsRequest request;
  request.tolerance = {Rational(1, 12), true};
  CHECK(judged(l_cells(), boxes, request).holds());
  request.tolerance.value -= Rational(1, 1000000000);
  CHECK_FALSE(judged(l_cells(), boxes, request).holds());
}

TEST_CASE("verify_parts: overlapping, equal and superfluous parts") {
  const std::vector<Box> boxes = {{{0, 0, 0}, {2, 1, 1}},
                                  {{0, 0, 0}, {1, 2, 1}},
                                  {{0, 0, 0}, {1, 1, 1}},
                                  {{0, 0, 0}, {1, 1, 1}}};
  const PartsVerdict verdict = judged(l_cells(), boxes);
  check_violated(verdict, {PartsDisjoint, PartsNeeded});
  CHECK(verdict[PartsDisjoint].witness.parts == std::vector<std::size_t>{0, 1});
  CHECK(verdict[PartsNeeded].witness.parts == std::vector<std::size_t>{2, 0});
  CHECK(verdict.measures->overlap_volume->exact == Rational(3));
  CHECK(verdict.measures->union_volume->exact == Rational(3));

  const PartsVerdict equal = judged({{0, 0, 0}}, {box_of({0, 0, 0}), box_of({0, 0, 0})});
  check_violated(equal, {PartsDisjoint, PartsNeeded});
  CHECK(equal[PartsNeeded].sentence.starts_with("1 part lies in another one"));
}

TEST_CASE("verify_parts: touching parts are disjoint") {
  const PartsVerdict verdict =
      judged({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}}, boxes_of({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}}));
  check_violated(verdict, {});
}

TEST_CASE("verify_parts: a flat part is no solid, and covers its own face") {
  const std::vector<Box> boxes = {box_of({0, 0, 0}), {{1, 0, 0}, {1, 1, 1}}};
  const PartsVerdict verdict = judged({{0, 0, 0}}, boxes);
  check_violated(verdict, {PartsSolid, PartsNeeded});
  CHECK(verdict[PartsSolid].witness.parts == std::vector<std::size_t>{1});
  CHECK(verdict.hulls[1].dimension == 2);

  // Six flat parts cover the surface of a cube, and not the cube.
  std::vector<Box> sides;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double at : {0.0, 1.0}) {
      Box side{{0, 0, 0}, {1, 1, 1}};
      side.low[axis] = side.high[axis] = at;
      sides.push_back(side);
    }
  }
  check_violated(judged({{0, 0, 0}}, sides), {PartsSolid, CoversSolid});
  sides.pop_back();
  check_violated(judged({{0, 0, 0}}, sides), {PartsSolid, CoversSurface, CoversSolid});
}

TEST_CASE("verify_parts: a part that is not convex as its faces are") {
  const std::vector<NamedPart> parts = {{"l", mesh_of_cells(l_cells())}};
  const PartsVerdict verdict = verify_parts(mesh_of_cells(l_cells()), parts, everything());
  check_violated(verdict, {PartsConvex});
  CHECK(verdict[PartsConvex].witness.parts == std::vector<std::size_t>{0});
  // Points alone stand for their hull.
  Mesh points = mesh_of_cells(l_cells());
  points.polygons.clear();
  check_violated(
      verify_parts(mesh_of_cells(l_cells()), std::vector<NamedPart>{{"l", points}}, everything()),
      {});
}

TEST_CASE("verify_parts: budgets of the parts") {
  PartsRequest request;
  request.max_parts = 3;
  request.max_facets = 6;
  request.max_vertices = 8;
  request.max_facet_vertices = 4;
  CHECK(judged(l_cells(), boxes_of(l_cells()), request).holds());
  request.max_parts = 2;
  request.max_facets = 5;
  request.max_vertices = 7;
  request.max_facet_vertices = 3;
  const PartsVerdict verdict = judged(l_cells(), boxes_of(l_cells()), request);
  check_violated(verdict, {MaxParts, MaxPartFacets, MaxPartVertices, MaxPartFacetVertices});
  CHECK(verdict[MaxParts].witness.count == std::size_t(3));
  CHECK(verdict[MaxPartVertices].witness.count == std::size_t(8));
}

// Points (k, k^2, 0) are the corners of a polygon, each of them.
TEST_CASE("verify_parts: budgets of flat parts count their polygon, segment or point") {
  const auto judge_flat = [](const std::vector<Point>& points, std::size_t vertices,
                             std::size_t facets, std::size_t corners) {
    PartsRequest request;
    request.claims = {MaxPartVertices, MaxPartFacets, MaxPartFacetVertices};
    request.max_vertices = vertices;
    request.max_facets = facets;
    request.max_facet_vertices = corners;
    return verify_parts(mesh_of_cells(l_cells()),
                        std::vector<NamedPart>{{"flat", {PointSet(points), {}, {}}}}, request);
  };
  std::vector<Point> parabola;
  for (int k = 0; k < 40; ++k) parabola.emplace_back(k, k * k, 0);
  CHECK(judge_flat(parabola, 40, 2, 40).holds());
  check_violated(judge_flat(parabola, 39, 1, 39),
                 {MaxPartVertices, MaxPartFacets, MaxPartFacetVertices});
  CHECK(judge_flat(parabola, 4, 2, 40)[MaxPartVertices].witness.count == std::size_t(40));
  const std::vector<Point> segment{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}};
  CHECK(judge_flat(segment, 2, 0, 0).holds());
  check_violated(judge_flat(segment, 1, 0, 0), {MaxPartVertices});
  CHECK(judge_flat({{1, 2, 3}, {1, 2, 3}}, 1, 0, 0).holds());
  check_violated(judge_flat({{1, 2, 3}}, 0, 0, 0), {MaxPartVertices});
}

TEST_CASE("verify_parts: budgets say nothing where there is no part") {
  PartsRequest request;
  request.claims = {MaxParts, MaxPartVertices, MaxPartFacets, MaxPartFacetVertices};
  request.max_parts = request.max_vertices = request.max_facets = request.max_facet_vertices = 9;
  const PartsVerdict verdict =
      verify_parts(mesh_of_cells(l_cells()), std::vector<NamedPart>{}, request);
  CHECK_FALSE(verdict.holds());
  for (const ClaimCode code : request.claims) {
    CHECK(verdict[code].status == Status::NotApplicable);
  }
}

TEST_CASE("verify_parts: an open surface bounds no solid") {
  Mesh open = box_mesh(box_of({0, 0, 0}));
  open.polygons.pop_back();
  const std::vector<NamedPart> parts = parts_of_boxes({box_of({0, 0, 0})});
  PartsRequest request;
  CHECK(verify_parts(open, parts, request).holds());
  request.claims = {CoversSolid};
  const PartsVerdict verdict = verify_parts(open, parts, request);
  CHECK(verdict[CoversSolid].status == Status::NotApplicable);
  CHECK_FALSE(verdict.holds());
  CHECK_FALSE(verdict.measures->solid_volume);
}

TEST_CASE("verify_parts: points without faces") {
  Mesh points = mesh_of_cells(l_cells());
  points.polygons.clear();
  CHECK(verify_parts(points, parts_of_boxes(boxes_of(l_cells()))).holds());
  const PartsVerdict missing = verify_parts(points, parts_of_boxes({box_of({0, 0, 0}), kBeside}));
  CHECK(missing[CoversPoints].status == Status::Violated);
  CHECK(missing[CoversSurface].status == Status::NotApplicable);
  CHECK(missing.points_outside == 4);
  PartsRequest request;
  request.claims = {CoversSurface};
  CHECK_FALSE(verify_parts(points, parts_of_boxes(boxes_of(l_cells())), request).holds());
}

TEST_CASE("verify_parts: distances are no share of a diameter where the input is one point") {
  Mesh point;
  point.points = PointSet(std::vector<Point>{{0.5, 0.5, 0.5}});
  std::vector<Point> corners = box_corners(box_of({0, 0, 0}));
  corners.back() *= 1.25;
  Mesh bent = box_mesh(box_of({0, 0, 0}));
  bent.points = PointSet(corners);
  const PartsVerdict verdict = verify_parts(point, std::vector<NamedPart>{{"bent", bent}});
  const Claim& claim = verdict[PartsConvex];
  CHECK(claim.status == Status::Violated);
  CHECK(claim.sentence.find("diameter") == std::string::npos);
  CHECK(verdict[CoversPoints].status == Status::Holds);
}

TEST_CASE("verify_parts: no parts, no points, and requests without sense") {
  const Mesh cube = box_mesh(box_of({0, 0, 0}));
  const PartsVerdict none = verify_parts(cube, std::vector<NamedPart>{}, everything());
  for (const ClaimCode code : {PartsSolid, CoversPoints, CoversSurface, CoversSolid}) {
    CHECK(none[code].status == Status::Violated);
  }
  const auto parts = parts_of_boxes({box_of({0, 0, 0})});
  CHECK(error_of([&] { return verify_parts(Mesh{}, parts); }).code() == ErrorCode::NoInterior);
  const auto refused = [&](const PartsRequest& request) {
    return error_of([&] { return verify_parts(cube, parts, request); }).code() ==
           ErrorCode::InvalidArgument;
  };
  CHECK(refused({.claims = {ContainsInput}}));
  CHECK(refused({.claims = {MaxParts}}));
  CHECK(refused({.tolerance = {Rational(-1), false}}));
}

TEST_CASE("verify_parts: faces that look inward are turned, or kept") {
  Mesh cube = box_mesh(box_of({0, 0, 0}));
  for (auto& polygon : cube.polygons) std::reverse(polygon.begin(), polygon.end());
  const auto parts = parts_of_boxes({box_of({0, 0, 0})});
  PartsRequest request = everything();
  const PartsVerdict turned = verify_parts(cube, parts, request);
  check_violated(turned, {});
  CHECK(turned.notes.size() == 1);
  // The solid is where the winding number is not 0, so -1 will do.
  request.orient = Orient::Keep;
  check_violated(verify_parts(cube, parts, request), {});
  CHECK(verify_parts(cube, parts, request).measures->solid_volume->exact == Rational(1));
}

TEST_CASE("verify_parts: with exact facets, faces that only rounding bent count each") {
  // The cube with one corner too high by a bit: its top is two triangles, and five sides stay.
  Mesh bent = box_mesh(box_of({0, 0, 0}));
  std::vector<Point> corners(bent.points.doubles().begin(), bent.points.doubles().end());
  const auto top = std::find(corners.begin(), corners.end(), Point(1, 1, 1));
  REQUIRE(top != corners.end());
  top->z() = 1 + 0x1p-52;
  const Mesh points{PointSet(corners), {}, {}};
  PartsRequest request;
  request.claims = {MaxPartFacets};
  request.max_facets = 6;
  const std::vector<NamedPart> parts{{"bent", points}};
  CHECK(verify_parts(box_mesh(box_of({0, 0, 0})), parts, request).holds());
  request.exact_facets = true;
  const PartsVerdict exact = verify_parts(box_mesh(box_of({0, 0, 0})), parts, request);
  CHECK(exact[MaxPartFacets].status == Status::Violated);
  CHECK(*exact.parts[0].size.facets > 6);
}

TEST_CASE("verify_parts: the pieces of a face that is cut in two are added up") {
  // A slab through the cube leaves two faces, and three quarters of the other four, in two pieces.
  const PartsVerdict verdict = judged({{0, 0, 0}}, {{{0.25, -1, -1}, {0.5, 2, 2}}});
  REQUIRE(verdict.measures);
  CHECK(verdict.measures->uncovered_area.contains(5));
  CHECK(verdict.measures->uncovered_area.high() - verdict.measures->uncovered_area.low() <
        Rational(1, 1000000));
  CHECK(verdict.measures->surface_area.contains(6));
}

TEST_CASE("verify_parts: a flat part in a face of a solid one is not needed, in each of the six") {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double at : {0.0, 1.0}) {
      Box flat{{0.25, 0.25, 0.25}, {0.75, 0.75, 0.75}};
      flat.low[axis] = flat.high[axis] = at;
      CAPTURE(axis);
      CAPTURE(at);
      for (const bool is_first : {true, false}) {
        std::vector<Box> boxes = {box_of({0, 0, 0}), flat};
        if (is_first) std::swap(boxes[0], boxes[1]);
        const PartsVerdict verdict = judged({{0, 0, 0}}, boxes);
        CHECK(verdict[PartsNeeded].status == Status::Violated);
        CHECK(verdict[PartsNeeded].witness.parts.front() == (is_first ? 0 : 1));
      }
    }
  }
}

// ---- within-solid

namespace {

PartsVerdict within(const std::set<Cell>& cells, const std::vector<Box>& boxes,
                    const Tolerance& distance) {
  PartsRequest request;
  request.distance = distance;
  request.measures = PartMeasures::None;
  return verify_parts(mesh_of_cells(cells), parts_of_boxes(boxes), request);
}

}  // namespace

TEST_CASE("verify_parts: a distance asks about both directions") {
  // The box of an L adds a cell whose far corner is at (2, 2): 1 from both arms along the axes.
  const std::vector<Box> box{{{0, 0, 0}, {2, 2, 1}}};
  check_violated(within(l_cells(), box, {Rational(11, 10), false}), {});
  const PartsVerdict verdict = within(l_cells(), box, {Rational(9, 10), false});
  check_violated(verdict, {WithinSolid});
  const Witness& witness = verdict[WithinSolid].witness;
  CHECK(witness.parts == std::vector<std::size_t>{0});
  REQUIRE(witness.point);
  const RationalPoint& x = *witness.point;
  CHECK(x[0] > 1);
  CHECK(x[1] > 1);
  const Rational least = std::min<Rational>(x[0] - 1, x[1] - 1);
  CHECK(*witness.squared_distance == least * least);
  CHECK(least > Rational(9, 10));
  // What the parts leave out is told, too.
  check_violated(within(l_cells(), {box_of({0, 0, 0})}, {Rational(1, 2), true}),
                 {CoversPoints, CoversSurface, CoversSolid});
}

TEST_CASE("verify_parts: a distance of 0 is decided by volumes" * sweep) {
  check_violated(within(cross_cells(), boxes_of(cross_cells()), {0, false}), {});
  const PartsVerdict verdict =
      within(l_cells(), {{{0, 0, 0}, {2, 1, 1}}, {{0, 0, 0}, {1, 2, 1.0625}}}, {0, true});
  check_violated(verdict, {WithinSolid});
  CHECK(verdict[WithinSolid].witness.parts == std::vector<std::size_t>{1});
  // By so little that no cell shows a point: but there is a volume.
  const PartsVerdict little =
      within(l_cells(), {{{0, 0, 0}, {2, 1, 1}}, {{0, 0, 0}, {1, 2, 1 + 0x1p-40}}}, {0, true});
  CHECK(little[WithinSolid].status == Status::Violated);
  CHECK_FALSE(little[WithinSolid].witness.point);
  CHECK_FALSE(little.holds());
}

TEST_CASE("verify_parts: within-solid needs a distance, and faces") {
  PartsRequest request;
  request.claims = {WithinSolid};
  const Mesh mesh = mesh_of_cells(l_cells());
  const CandidateParts parts = parts_of_boxes(boxes_of(l_cells()));
  CHECK(error_of([&] { return verify_parts(mesh, parts, request); }).code() ==
        ErrorCode::InvalidArgument);
  request.distance = Tolerance{-1, false};
  CHECK(error_of([&] { return verify_parts(mesh, parts, request); }).code() ==
        ErrorCode::InvalidArgument);
  request.distance = Tolerance{1, false};
  CHECK(verify_parts(mesh, parts, request).holds());
  const PartsVerdict cloud = verify_parts({mesh.points, {}, {}}, parts, request);
  CHECK(cloud[WithinSolid].status == Status::NotApplicable);
  CHECK_FALSE(cloud.holds());
  // An open surface has no inside: the middle of a cube is 1/2 from its faces.
  Mesh open = mesh_of_cells({{0, 0, 0}});
  open.polygons.pop_back();
  open.parts.clear();
  const CandidateParts cube = parts_of_boxes({box_of({0, 0, 0})});
  request.claims = {};
  request.distance = Tolerance{Rational(51, 100), false};
  CHECK(verify_parts(open, cube, request).holds());
  request.distance = Tolerance{Rational(49, 100), false};
  CHECK(verify_parts(open, cube, request)[WithinSolid].status == Status::Violated);
}

TEST_CASE("verify_parts: the same verdict and measures for any number of threads") {
  std::mt19937 random(55);
  for (unsigned round = 0; round < 8; ++round) {
    const std::set<Cell> cells = random_cells(8, random);
    std::vector<Box> boxes = boxes_of(cells);
    // Of two rounds one covers all; the other leaves gaps, reaches out, and overlaps.
    for (Box& box : boxes) {
      for (int k = 0; k < 3 && round % 2 == 1; ++k) box.high[k] += double(random() % 5) / 8 - 0.25;
    }
    PartsRequest request = everything();
    request.exact_volumes = round % 4 < 2;
    request.distance = Tolerance{Rational(1, 10)};  // no part reaches just so far
    request.claims.push_back(WithinSolid);
    const auto told = [&](std::size_t jobs) {
      request.jobs = jobs;
      return write_json(parts_verdict_json(judged(cells, boxes, request)), 1);
    };
    const std::string alone = told(1);
    for (const std::size_t jobs : {2u, 3u, 8u}) CHECK(told(jobs) == alone);
  }
  PartsRequest request;
  request.jobs = 0;
  CHECK(error_of([&] { return judged(l_cells(), boxes_of(l_cells()), request); }).code() ==
        ErrorCode::InvalidArgument);
}
