// SPDX-License-Identifier: MIT
// decompose() on shapes whose parts and volumes are closed forms; and its promise, that every
// triangle lies in its owner, by the definition of a hull.
#include "convexact/decompose.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "assembled_meshes.hpp"
#include "cells.hpp"
#include "convexact/io.hpp"
#include "convexact/verify_parts.hpp"
#include "expect_error.hpp"
#include "supporting_planes.hpp"
#include "sweep.hpp"

using namespace convexact;
using namespace support;

namespace {

DecomposeRequest with_fractions() {
  DecomposeRequest request;
  request.exact_volumes = true;
  return request;
}

// ---- The promise, by definition

// Whether x lies in the convex polygon, segment or point.
bool is_in_flat(const std::vector<RationalPoint>& corners, const RationalPoint& x) {
  if (corners.size() == 1) return x == corners[0];
  if (corners.size() == 2) {
    const RationalVector3 along = corners[1] - corners[0], way = x - corners[0];
    return RationalVector3(along.cross(way)).isZero() && along.dot(way) >= 0 &&
           along.dot(way) <= along.dot(along);
  }
  const RationalVector3 normal =
      RationalVector3(corners[1] - corners[0]).cross(RationalVector3(corners[2] - corners[0]));
  if (normal.dot(RationalVector3(x - corners[0])) != 0) return false;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const RationalPoint& a = corners[k];
    const RationalVector3 side = corners[(k + 1) % corners.size()] - a;
    if (normal.dot(RationalVector3(side.cross(RationalVector3(x - a)))) < 0) return false;
  }
  return true;
}

// Every triangle has one owner, and its corners lie in the hull of the owner's stored points: in
// every halfspace that three of these span and that holds all of them.
void check_owners(const Decomposition& d) {
  REQUIRE(d.owner.size() == d.surface.triangles.size());
  // A cluster that became no part belongs to the part that it names.
  for (const InnerCluster& inner : d.inner) {
    REQUIRE(inner.part < d.parts.size());
    CHECK(d.owner[inner.lowest.index()] == inner.part);
  }
  CHECK(d.tested_triangles == d.surface.triangles.size());
  std::vector<std::size_t> times(d.owner.size(), 0);
  for (std::size_t k = 0; k < d.parts.size(); ++k) {
    const Part& part = d.parts[k];
    CHECK(std::is_sorted(part.owns.begin(), part.owns.end()));
    CHECK(std::includes(part.owns.begin(), part.owns.end(), part.cluster.begin(),
                        part.cluster.end()));
    const auto corners = points_in(part.mesh.points);
    const bool is_flat = part.form == PartForm::Flat;
    const auto planes = is_flat ? std::vector<Halfspace>() : supporting_planes(corners);
    if (!is_flat) {
      auto stored = part.halfspaces;
      std::sort(stored.begin(), stored.end());
      CHECK(stored == planes);
      CHECK(part.mesh.polygons.size() == planes.size());
    }
    std::size_t outside = 0;
    for (const TriangleId t : part.owns) {
      CHECK(d.owner[t.index()] == k);
      ++times[t.index()];
      for (const PointId id : d.surface.triangles[t.index()]) {
        const RationalPoint x = d.surface.points[id];
        const bool is_in = is_flat ? is_in_flat(corners, x)
                                   : std::all_of(planes.begin(), planes.end(),
                                                 [&](const Halfspace& h) { return h(x) <= 0; });
        outside += is_in ? 0 : 1;
      }
    }
    CHECK(outside == 0);
  }
  CHECK(std::all_of(times.begin(), times.end(), [](std::size_t n) { return n == 1; }));
}

// The oracle has no part in the decomposition.
void check_verdict(const Mesh& mesh, const Decomposition& d) {
  std::vector<NamedPart> parts;
  for (const Part& part : d.parts) parts.push_back({"part", part.mesh});
  const PartsVerdict verdict = verify_parts(mesh, parts);
  for (const Claim& claim : verdict.claims) {
    const std::string sentence = claim.sentence;
    CAPTURE(sentence);
    CHECK(claim.status != Status::Violated);
  }
  CHECK(verdict.holds());
}

Decomposition decomposed(const Mesh& mesh, const DecomposeRequest& request = with_fractions()) {
  auto outcome = decompose(mesh, request);
  REQUIRE(std::holds_alternative<Decomposition>(outcome));
  Decomposition d = std::get<Decomposition>(std::move(outcome));
  check_owners(d);
  return d;
}

void check_volumes(const Decomposition& d, const Rational& solid, const Rational& uncovered,
                   const Rational& excess) {
  REQUIRE(d.measures);
  CHECK(d.measures->solid_volume->exact == solid);
  CHECK(d.measures->uncovered_volume->exact == uncovered);
  CHECK(d.measures->excess_volume->exact == excess);
  CHECK(d.measures->union_volume->exact == Rational(solid - uncovered + excess));
  CHECK(d.measures->solid_volume->bounds.contains(solid));
}

bool ran(const Decomposition& d, const std::string& name) {
  return std::any_of(d.stages.begin(), d.stages.end(), [&](const Stage& stage) {
    return stage.name == name && stage.skipped.empty();
  });
}

// ---- Shapes

// Two unit squares at a right angle, their front sides facing each other.
Mesh folded_sheet() {
  return {PointSet(
              std::vector<Point>{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 1}, {0, 1, 1}}),
          {{0, 2, 3, 1}, {0, 1, 5, 4}},
          {{"", 0, 2}}};
}

const Box kUnit{{0, 0, 0}, {1, 1, 1}};

}  // namespace

TEST_CASE("decompose: what is convex is one part, its hull bit for bit") {
  for (const Mesh& mesh : {box_mesh(kUnit), box_mesh({{0.1, 0.2, 0.3}, {0.7, 1e9, 0.5}}),
                           ball(Point(0.1, 0.2, 0.3), 30)}) {
    for (const int percent : {0, 3, 100}) {
      DecomposeRequest request = with_fractions();
      request.limit.value = Rational(percent, 100);
      const Decomposition d = decomposed(mesh, request);
      REQUIRE(d.parts.size() == 1);
      CHECK(d.parts[0].form == PartForm::Hull);
      CHECK(d.parts[0].concavity.squared == 0);
      CHECK(d.limit_holds);
      const auto hull = std::get<Hull>(convex_hull(mesh.points));
      auto corners = points_in(subset(mesh.points, hull.vertices));
      auto stored = points_in(d.parts[0].mesh.points);
      CHECK(d.parts[0].mesh.points.is_binary());
      const auto before = [](const RationalPoint& a, const RationalPoint& b) {
        return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
      };
      std::sort(corners.begin(), corners.end(), before);
      std::sort(stored.begin(), stored.end(), before);
      CHECK(corners == stored);
      check_volumes(d, volume(hull, mesh.points), 0, 0);
      CHECK(d.measures->overlap_volume->exact == Rational(0));
      CHECK(d.measures->overlap_volume->bounds.high() == 0);
    }
  }
}

TEST_CASE("decompose: unit cells are parted as they are made up") {
  const auto plus = [] {
    std::set<Cell> cells = cross_cells();
    cells.erase({0, 0, 1});
    cells.erase({0, 0, -1});
    return cells;
  }();
  const std::set<Cell> u = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}};
  struct Case {
    std::set<Cell> cells;
    std::size_t parts;
    int uncovered;
  };
  // The six arms of the cross hold its surface, and not its middle cell.
  for (const Case& c : {Case{l_cells(), 2, 0}, Case{u, 3, 0}, Case{plus, 3, 0},
                        Case{ring_cells(), 4, 0}, Case{cross_cells(), 6, 1}}) {
    const Mesh mesh = mesh_of_cells(c.cells);
    const Decomposition d = decomposed(mesh);
    CHECK(d.parts.size() == c.parts);
    CHECK(d.limit_holds);
    check_volumes(d, Rational(c.cells.size()), c.uncovered, 0);
    check_verdict(mesh, d);
    for (const Part& part : d.parts) {
      CHECK(part.form == PartForm::Hull);
      CHECK(part.is_within_limit);
      CHECK(part.concavity.squared <= d.squared_limit());
    }
  }
}

TEST_CASE("decompose: four balls are four parts" * sweep) {
  std::vector<Mesh> balls;
  Rational volumes = 0;
  for (const Point& center : {Point(0, 0, 0), Point(3, 0, 0), Point(0, 3, 0), Point(0, 0, 3)}) {
    balls.push_back(ball(center, 24));
    volumes += volume(std::get<Hull>(convex_hull(balls.back().points)), balls.back().points);
  }
  const Mesh mesh = joined(balls);
  const Decomposition d = decomposed(mesh);
  CHECK(d.parts.size() == 4);
  check_volumes(d, volumes, 0, 0);

  SUBCASE("with few faces each") {
    DecomposeRequest request = with_fractions();
    request.faces = 8;
    const Decomposition few = decomposed(mesh, request);
    REQUIRE(few.parts.size() == 4);
    for (const Part& part : few.parts) {
      CHECK(part.form == PartForm::Simplified);
      CHECK(part.faces == 8);
    }
    CHECK(*few.measures->excess_volume->exact > 0);
    CHECK(few.measures->uncovered_volume->exact == Rational(0));
    check_verdict(mesh, few);
  }
  SUBCASE("with few faces in all") {
    DecomposeRequest request = with_fractions();
    request.total_faces = 50;
    const Decomposition few = decomposed(mesh, request);
    std::size_t faces = 0;
    for (const Part& part : few.parts) faces += part.faces;
    CHECK(faces == 50);
    check_verdict(mesh, few);
  }
  SUBCASE("with more faces than they have") {
    DecomposeRequest request = with_fractions();
    request.total_faces = 1000;
    const Decomposition all = decomposed(mesh, request);
    for (const Part& part : all.parts) CHECK(part.form == PartForm::Hull);
    CHECK(!ran(all, stage::kSimplify));
  }
  SUBCASE("with too few parts allowed") {
    DecomposeRequest request;
    request.max_parts = 3;
    const Error error = error_of([&] { return decompose(mesh, request); });
    CHECK(error.code() == ErrorCode::InvalidArgument);
    CHECK(std::string(error.what()).find("4") != std::string::npos);
  }
  SUBCASE("with too few faces for them") {
    DecomposeRequest request;
    request.total_faces = 15;
    CHECK(error_of([&] { return decompose(mesh, request); }).code() == ErrorCode::InvalidArgument);
  }
}

TEST_CASE("decompose: a part may exceed the limit, which is said") {
  DecomposeRequest request = with_fractions();
  request.max_parts = 1;
  const Decomposition d = decomposed(mesh_of_cells(l_cells()), request);
  REQUIRE(d.parts.size() == 1);
  CHECK(!d.limit_holds);
  CHECK(!d.parts[0].is_within_limit);
  // From the middle of the notch straight to the long edge of the hull.
  check_volumes(d, 3, 0, Rational(1, 2));
}

TEST_CASE("decompose: engines agree, and concavities are those of the definition" * sweep) {
  for (const auto& cells : {l_cells(), ring_cells(), cross_cells()}) {
    for (const ConcavityMeasure measure : {ConcavityMeasure::Surface, ConcavityMeasure::Vertices}) {
      DecomposeRequest request = with_fractions();
      request.measure = measure;
      const Decomposition filtered = decomposed(mesh_of_cells(cells), request);
      request.engine = Engine::Exact;
      const Decomposition exact = decomposed(mesh_of_cells(cells), request);
      REQUIRE(filtered.parts.size() == exact.parts.size());
      CHECK(filtered.owner == exact.owner);
      const ExactConcavity concavity(exact.surface, measure);
      for (std::size_t k = 0; k < exact.parts.size(); ++k) {
        const Part &a = filtered.parts[k], &b = exact.parts[k];
        const Concavity by_definition = concavity(a.cluster, a.hull);
        for (const Concavity& found : {a.concavity, b.concavity}) {
          CHECK(found.squared == by_definition.squared);
          CHECK(found.triangle == by_definition.triangle);
          CHECK((found.at - found.leaves).squaredNorm() == found.squared);
        }
        CHECK(a.halfspaces == b.halfspaces);
      }
    }
  }
}

// ---- Flat parts

TEST_CASE("decompose: flat parts are thickened, kept or merged") {
  const Mesh sheet = folded_sheet();
  DecomposeRequest request = with_fractions();
  const double diameter = std::sqrt(3.0);
  SUBCASE("thickened") {
    for (const FlatParts flat : {FlatParts::Auto, FlatParts::Thicken}) {
      request.flat = flat;
      const Decomposition d = decomposed(sheet, request);
      REQUIRE(d.parts.size() == 2);
      for (const Part& part : d.parts) {
        CHECK(part.form == PartForm::Thickened);
        CHECK(part.hull.dimension == 2);
        CHECK(part.mesh.points.size() == 8);
      }
      CHECK(!d.measures->solid_volume);
      CHECK(!d.measures->excess_volume);
      const double thickness = d.measures->union_volume->bounds.high_double() / 2;
      CHECK(thickness > diameter * 0x1p-20);
      CHECK(thickness < diameter * 0x1p-18);
      check_verdict(sheet, d);
    }
  }
  SUBCASE("kept") {
    request.flat = FlatParts::Keep;
    const Decomposition d = decomposed(sheet, request);
    REQUIRE(d.parts.size() == 2);
    for (const Part& part : d.parts) {
      CHECK(part.form == PartForm::Flat);
      CHECK(part.mesh.points.size() == 4);
      CHECK(part.mesh.polygons.size() == 1);
      CHECK(part.faces == 0);
    }
    CHECK(d.measures->union_volume->exact == Rational(0));
  }
  SUBCASE("merged") {
    request.flat = FlatParts::Merge;
    const Decomposition d = decomposed(sheet, request);
    REQUIRE(d.parts.size() == 1);
    CHECK(d.parts[0].form == PartForm::Hull);
    CHECK(d.flat_merged == std::vector<TriangleId>{TriangleId(0)});
    // From the fold along one square to the end of the other.
    CHECK(d.parts[0].concavity.squared == 1);
    CHECK(!d.limit_holds);
    CHECK(d.measures->union_volume->exact == Rational(1, 2));
  }
}

TEST_CASE("decompose: a flat part joins the neighbour with which it is least concave") {
  // A floor (its two triangles are the lowest) between a wall of height 2 and one of height 1/4:
  // with the one the concavity is 2, with the other 1, from wall to end of floor.
  const double q = 0.25;
  const Mesh mesh = mesh_of(
      {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, 1, 1}, {2, 0, 0}, {2, 0, 1}, {q, 1, 0}, {q, 1, 1}},
      {{0, 2, 3, 1}, {0, 1, 5, 4}, {3, 2, 6, 7}});
  DecomposeRequest request = with_fractions();
  CHECK(decomposed(mesh, request).parts.size() == 3);
  request.flat = FlatParts::Merge;
  const Decomposition d = decomposed(mesh, request);
  CHECK(d.parts.size() == 1);
  REQUIRE(d.flat_merged.size() == 2);
  CHECK(d.flat_merged[0] == TriangleId(0));
  // The high wall is left over, and joins the others next.
  for (const PointId id : d.surface.triangles[d.flat_merged[1].index()]) {
    CHECK(d.surface.points[id][1] == 0);
  }
  CHECK(d.parts[0].concavity.squared == 4);
}

TEST_CASE("decompose: a shape in a plane is a part only if that is wanted") {
  for (const auto& [x, y] : {std::pair(1.0, 1.0), std::pair(0.3, 0.7)}) {
    const Mesh square = mesh_of({{0, 0, 0}, {x, 0, y}, {x, 1, y}, {0, 1, 0}}, {{0, 1, 2, 3}});
    DecomposeRequest request = with_fractions();
    for (const FlatParts flat : {FlatParts::Auto, FlatParts::Merge}) {
      request.flat = flat;
      const auto outcome = decompose(square, request);
      REQUIRE(std::holds_alternative<NotSolid>(outcome));
      CHECK(std::get<FlatInput>(std::get<NotSolid>(outcome)).dimension == 2);
    }
    request.flat = FlatParts::Keep;
    CHECK(decomposed(square, request).parts[0].form == PartForm::Flat);
    request.flat = FlatParts::Thicken;
    const Decomposition d = decomposed(square, request);
    CHECK(d.parts[0].form == PartForm::Thickened);
    check_verdict(square, d);
  }
}

TEST_CASE("decompose: segments and points") {
  const Mesh mesh =
      joined({box_mesh(kUnit), mesh_of({{0, 0, 5}, {0.1, 0.2, 5}, {0.2, 0.4, 5}}, {{0, 1, 2}}),
              mesh_of({{3, 3, 3}}, {{0, 0, 0}})});
  DecomposeRequest request = with_fractions();
  SUBCASE("thickened") {
    const Decomposition d = decomposed(mesh, request);
    REQUIRE(d.parts.size() == 3);
    check_verdict(mesh, d);
  }
  SUBCASE("kept") {
    request.flat = FlatParts::Keep;
    const Decomposition d = decomposed(mesh, request);
    REQUIRE(d.parts.size() == 3);
    std::vector<int> dimensions;
    for (const Part& part : d.parts) dimensions.push_back(part.hull.dimension);
    std::sort(dimensions.begin(), dimensions.end());
    CHECK(dimensions == std::vector<int>{0, 1, 3});
  }
  SUBCASE("without a neighbour to merge with") {
    request.flat = FlatParts::Merge;
    const Decomposition d = decomposed(mesh, request);
    CHECK(d.parts.size() == 3);
    CHECK(d.flat_merged.empty());
  }
}

TEST_CASE("decompose: a thickened part obeys its number of faces") {
  std::vector<Point> corners;
  std::vector<std::uint32_t> polygon;
  for (std::uint32_t k = 0; k < 20; ++k) {
    corners.emplace_back(k, k * k, 0);
    polygon.push_back(k);
  }
  DecomposeRequest request = with_fractions();
  request.flat = FlatParts::Thicken;
  request.faces = 7;
  const Mesh mesh = mesh_of(corners, {polygon});
  const Decomposition d = decomposed(mesh, request);
  REQUIRE(d.parts.size() == 1);
  CHECK(d.parts[0].form == PartForm::Thickened);
  CHECK(d.parts[0].faces == 7);
}

TEST_CASE("decompose: thin far away, and thick enough for the format") {
  const double far = 0x1p30;
  const Mesh square =
      mesh_of({{far, far, far}, {far + 1, far, far + 1}, {far, far + 1, far}}, {{0, 1, 2}});
  DecomposeRequest request = with_fractions();
  request.flat = FlatParts::Thicken;
  check_verdict(square, decomposed(square, request));
  request.precision = Precision::Binary32;
  const Mesh near = mesh_of({{1, 1, 1}, {1.1, 1.3, 1.7}, {1.9, 1.2, 1.4}}, {{0, 1, 2}});
  const Decomposition d = decomposed(near, request);
  for (const Point& p : d.parts[0].mesh.points.doubles()) {
    for (const double x : p) CHECK(double(float(x)) == x);
  }
}

TEST_CASE("decompose: thickened parts hold polygons, segments and points anywhere" * sweep) {
  std::mt19937_64 random(5);
  const auto coordinate = [&] { return std::ldexp(double(random() >> 11), -52) - 1; };
  for (int round = 0; round < 120; ++round) {
    // Some far from the origin, some huge or tiny; three points, the same one twice or three times.
    const Point center = std::ldexp(1.0, int(random() % 30)) * Point(coordinate(), coordinate(), 1);
    const double scale = std::ldexp(1.0, int(random() % 160) - 80);
    std::vector<Point> points;
    for (int k = 0; k < 3; ++k) {
      points.push_back(scale * (center + Point(coordinate(), coordinate(), coordinate())));
    }
    if (round % 4 == 1) points[2] = points[1];
    if (round % 4 == 2) points[2] = points[1] = points[0];
    DecomposeRequest request = with_fractions();
    request.flat = FlatParts::Thicken;
    const Mesh mesh = mesh_of(points, {{0, 1, 2}});
    const Decomposition d = decomposed(mesh, request);
    REQUIRE(d.parts.size() == 1);
    CHECK(d.parts[0].form == PartForm::Thickened);
    // A power of two more or less changes nothing else.
    for (Point& p : points) p *= 0x1p20;
    const Decomposition larger = decomposed(mesh_of(points, {{0, 1, 2}}), request);
    REQUIRE(larger.parts.size() == 1);
    const PointSet &small = d.parts[0].mesh.points, &large = larger.parts[0].mesh.points;
    REQUIRE(small.size() == large.size());
    for (std::size_t k = 0; k < small.size(); ++k) {
      CHECK(large.doubles()[k] == Point(0x1p20 * small.doubles()[k]));
    }
    request.precision = Precision::Binary32;
    for (Point& p : points) p *= 0x1p-20;
    const Decomposition rounded = decomposed(mesh_of(points, {{0, 1, 2}}), request);
    for (const Point& p : rounded.parts[0].mesh.points.doubles()) {
      for (const double x : p) CHECK(double(float(x)) == x);
    }
  }
}

// ---- Inner parts

TEST_CASE("decompose: a part in another one is dropped, and its triangles change owner") {
  const Mesh mesh =
      joined({box_mesh({{0.25, 0.25, 0.25}, {0.5, 0.5, 1}}), box_mesh(kUnit),
              mesh_of({{0.1, 0.1, 0.5}, {0.2, 0.1, 0.5}, {0.1, 0.2, 0.5}}, {{0, 1, 2}})});
  for (const FlatParts flat : {FlatParts::Auto, FlatParts::Keep, FlatParts::Merge}) {
    DecomposeRequest request = with_fractions();
    request.flat = flat;
    const Decomposition d = decomposed(mesh, request);
    REQUIRE(d.parts.size() == 1);
    CHECK(d.parts[0].owns.size() == d.surface.triangles.size());
    CHECK(d.parts[0].cluster.size() == 12);
    CHECK(d.inner.size() == 2);
    CHECK(d.limit_holds);
    check_verdict(mesh, d);
    request.keep_inner = true;
    const Decomposition all = decomposed(mesh, request);
    CHECK(all.parts.size() == 3);
    CHECK(all.inner.empty());
    CHECK(all.measures->overlap_volume->bounds.low_double() >= 3.0 / 64);
  }
}

TEST_CASE("decompose: a part that only the simplified solid of another holds is dropped, too") {
  // A pyramid without its top of 2 x 2 x 2, and a box where that would be.
  const Mesh mesh = joined(
      {mesh_of(
           {{-2, -2, 0},
            {2, -2, 0},
            {2, 2, 0},
            {-2, 2, 0},
            {-1, -1, 2},
            {1, -1, 2},
            {1, 1, 2},
            {-1, 1, 2}},
           {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}),
       box_mesh({{-0.25, -0.25, 2.25}, {0.25, 0.25, 2.75}})});
  DecomposeRequest request = with_fractions();
  CHECK(decomposed(mesh, request).parts.size() == 2);
  request.faces = 5;
  const Decomposition d = decomposed(mesh, request);
  REQUIRE(d.parts.size() == 1);
  CHECK(d.parts[0].form == PartForm::Simplified);
  REQUIRE(d.inner.size() == 1);
  CHECK(d.inner[0].part == 0);
  CHECK(d.measures->union_volume->exact == Rational(64, 3));
  request.keep_inner = true;
  CHECK(decomposed(mesh, request).parts.size() == 2);
}

TEST_CASE("decompose: of two equal parts one stays") {
  // The same corners, but no common edge: a box, and the same box as its two diagonal rectangles.
  const Mesh mesh = joined({box_mesh(kUnit), mesh_of(box_corners(kUnit), {{0, 4, 7, 3}}),
                            mesh_of(box_corners(kUnit), {{1, 5, 6, 2}})});
  const Decomposition d = decomposed(mesh);
  CHECK(d.parts.size() == 1);
}

TEST_CASE("decompose: parts that lie in others, of which some are dropped after them") {
  const char* folder = std::getenv("CONVEXACT_TEST_DATA");
  REQUIRE(folder != nullptr);
  for (const char* file : {"sliver.obj", "tiny.obj"}) {
    const Mesh mesh = read_mesh(std::string(folder) + "/faults/" + file);
    for (const Precision precision : {Precision::Binary64, Precision::Binary32}) {
      for (const Rational& limit : {Rational(0), Rational(3, 100)}) {
        DecomposeRequest request;
        request.precision = precision;
        request.limit.value = limit;
        check_owners(decomposed(mesh, request));
      }
    }
  }
}

TEST_CASE("decompose: of two parts that are equal as stored the first one stays") {
  // Two tetrahedra that binary32 can hold in the same box only.
  const char* folder = std::getenv("CONVEXACT_TEST_DATA");
  REQUIRE(folder != nullptr);
  DecomposeRequest request;
  request.precision = Precision::Binary32;
  const Decomposition d = decomposed(read_mesh(std::string(folder) + "/faults/tiny.obj"), request);
  check_owners(d);
  REQUIRE(d.parts.size() == 1);
  CHECK(d.parts[0].cluster.front().index() == 0);
  REQUIRE(d.inner.size() == 1);
  CHECK(d.inner[0].lowest.index() == 4);
}

// ---- Formats

TEST_CASE("decompose: binary32 rounds outward only what it cannot hold") {
  DecomposeRequest request = with_fractions();
  request.precision = Precision::Binary32;
  CHECK(decomposed(box_mesh(kUnit), request).parts[0].form == PartForm::Hull);
  const Mesh mesh = box_mesh({{0.1, 0.2, 0.3}, {0.7, 1.1, 0.9}});
  const Decomposition d = decomposed(mesh, request);
  CHECK(d.parts[0].form == PartForm::Rounded);
  CHECK(d.parts[0].faces == 6);
  for (const Point& p : d.parts[0].mesh.points.doubles()) {
    for (const double x : p) CHECK(double(float(x)) == x);
  }
  CHECK(*d.measures->excess_volume->exact > 0);
  check_verdict(mesh, d);
  request.faces = 5;
  const Decomposition few = decomposed(ball(Point(0.1, 0.2, 0.3), 20), request);
  CHECK(few.parts[0].form == PartForm::Simplified);
  CHECK(few.parts[0].faces == 5);
  for (const Point& p : few.parts[0].mesh.points.doubles()) {
    for (const double x : p) CHECK(double(float(x)) == x);
  }
}

TEST_CASE("decompose: fractions are rounded outward") {
  std::vector<RationalPoint> points;
  for (const Point& p : box_corners(kUnit)) points.push_back(to_rational(p) / Rational(3));
  const Mesh mesh{PointSet(points), box_faces(), {{"", 0, 6}}};
  DecomposeRequest request = with_fractions();
  const Decomposition d = decomposed(mesh, request);
  CHECK(d.parts[0].form == PartForm::Rounded);
  CHECK(d.measures->solid_volume->exact == Rational(1, 27));
  CHECK(d.measures->uncovered_volume->exact == Rational(0));
  CHECK(*d.measures->excess_volume->exact > 0);
  const Mesh triangle{PointSet(std::vector<RationalPoint>{points[0], points[3], points[5]}),
                      {{0, 1, 2}},
                      {{"", 0, 1}}};
  request.flat = FlatParts::Thicken;
  CHECK(decomposed(triangle, request).parts[0].form == PartForm::Thickened);
  request.flat = FlatParts::Keep;
  CHECK(error_of([&] { return decompose(triangle, request); }).code() ==
        ErrorCode::Unrepresentable);
}

TEST_CASE("decompose: what the format cannot hold is refused") {
  DecomposeRequest request;
  request.precision = Precision::Binary32;
  CHECK(error_of([&] {
          return decompose(box_mesh({{0, 0, 0}, {1e300, 1e300, 1e300}}), request);
        }).code() == ErrorCode::Unrepresentable);
}

TEST_CASE("decompose: a part that is too small for its format becomes a box") {
  // Between neighbouring numbers of binary32, which are 2 apart here.
  const double far = 0x1p24;
  const Mesh mesh = joined({mesh_of({{far + 0.5, far + 0.5, far + 0.5},
                                     {far + 1, far + 0.5, far + 0.5},
                                     {far + 0.5, far + 1, far + 0.5},
                                     {far + 0.5, far + 0.5, far + 1}},
                                    {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}),
                            box_mesh(kUnit)});
  DecomposeRequest request = with_fractions();
  request.precision = Precision::Binary32;
  const Decomposition d = decomposed(mesh, request);
  REQUIRE(d.parts.size() == 2);
  CHECK(d.parts[0].form == PartForm::Hull);
  CHECK(d.parts[1].form == PartForm::Rounded);
  CHECK(d.parts[1].faces == 6);
  check_volumes(d, 1 + Rational(1, 48), 0, 8 - Rational(1, 48));
}

// ---- Whatever the input is

TEST_CASE("decompose: solids are those of winding numbers") {
  const auto reversed = [](Mesh mesh) {
    for (auto& polygon : mesh.polygons) std::reverse(polygon.begin(), polygon.end());
    return mesh;
  };
  const Mesh crossing =
      joined({box_mesh({{0, 0, 0}, {2, 2, 2}}), box_mesh({{1, 1, 1}, {3, 3, 3}})});
  const Mesh hollow =
      joined({box_mesh({{0, 0, 0}, {3, 3, 3}}), reversed(box_mesh({{1, 1, 1}, {2, 2, 2}}))});
  for (const bool is_turned : {false, true}) {
    const Mesh cubes = is_turned ? reversed(crossing) : crossing;
    const Decomposition two = decomposed(cubes);
    CHECK(two.parts.size() == 2);
    check_volumes(two, 15, 0, 0);
    CHECK(two.measures->overlap_volume->exact == Rational(1));
    check_verdict(cubes, two);
    // The six walls of the cavity look at each other, and lie in the hull of the box.
    const Mesh shell = is_turned ? reversed(hollow) : hollow;
    const Decomposition filled = decomposed(shell);
    CHECK(filled.parts.size() == 1);
    CHECK(filled.inner.size() == 6);
    check_volumes(filled, 26, 0, 1);
    DecomposeRequest request = with_fractions();
    request.keep_inner = true;
    const Decomposition all = decomposed(shell, request);
    CHECK(all.parts.size() == 7);
    CHECK(std::count_if(all.parts.begin(), all.parts.end(),
                        [](const Part& part) { return part.form == PartForm::Thickened; }) == 6);
  }
}

TEST_CASE("decompose: surfaces that bound nothing, or badly") {
  const std::vector<std::vector<std::uint32_t>> faces = box_faces();
  const std::vector<std::vector<std::uint32_t>> no_lid(faces.begin(), faces.end() - 1);
  const Mesh tetrahedron = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                   {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
  const Mesh opposite = mesh_of({{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
                                {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}});
  const double thin = 1e-16;
  struct Case {
    const char* name;
    Mesh mesh;
    bool is_closed;
  };
  const std::vector<Case> cases = {
      {"Moebius strip",
       mesh_of({{0, 0, 0}, {4, 0, 1}, {5, 3, 0}, {2, 5, 2}, {-1, 3, 1}},
               {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}}),
       false},
      {"box without a lid", mesh_of(box_corners(kUnit), no_lid), false},
      {"two tetrahedra at a point", joined({tetrahedron, opposite}), true},
      {"the same box twice", joined({box_mesh(kUnit), box_mesh(kUnit)}), true},
      {"four triangles at an edge",
       mesh_of({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}},
               {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {0, 1, 5}}),
       false},
      {"slivers",
       mesh_of({{0, 0, 0}, {1, 0, 0}, {1, thin, 0}, {0, 0, 1}, {1, 0, thin}},
               {{0, 1, 2}, {0, 1, 4}, {1, 2, 4}, {0, 2, 3}}),
       false},
      {"a T-junction",
       mesh_of({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 0, 0}, {1, 0, 2}, {0, 0, 2}},
               {{0, 1, 2}, {0, 5, 3}, {3, 4, 1}}),
       false},
  };
  for (const Case& c : cases) {
    CAPTURE(c.name);
    for (const FlatParts flat : {FlatParts::Auto, FlatParts::Keep, FlatParts::Merge}) {
      DecomposeRequest request = with_fractions();
      request.flat = flat;
      const Decomposition d = decomposed(c.mesh, request);
      CHECK(d.surface.is_closed == c.is_closed);
      CHECK(d.measures->solid_volume.has_value() == c.is_closed);
      CHECK(d.measures->uncovered_volume.has_value() == c.is_closed);
      CHECK(d.measures->excess_volume.has_value() == c.is_closed);
      const bool has_flat = std::any_of(d.parts.begin(), d.parts.end(), [](const Part& part) {
        return part.form == PartForm::Flat;
      });
      if (!has_flat) check_verdict(c.mesh, d);
      if (flat != FlatParts::Keep) CHECK(!has_flat);
    }
  }
}

TEST_CASE("decompose: the order of points, faces and corners does not matter") {
  const Mesh mesh = joined({mesh_of_cells(ring_cells()), ball(Point(8, 0, 0), 20)});
  const Decomposition first = decomposed(mesh);
  std::mt19937_64 random(3);
  for (int round = 0; round < 5; ++round) {
    std::vector<std::uint32_t> place(mesh.points.size());
    for (std::uint32_t k = 0; k < place.size(); ++k) place[k] = k;
    for (std::size_t k = place.size(); k-- > 1;) std::swap(place[k], place[random() % (k + 1)]);
    std::vector<Point> points(place.size());
    for (std::size_t k = 0; k < place.size(); ++k) points[place[k]] = mesh.points.doubles()[k];
    auto polygons = mesh.polygons;
    for (auto& polygon : polygons) {
      for (auto& corner : polygon) corner = place[corner];
      std::rotate(polygon.begin(), polygon.begin() + std::ptrdiff_t(random() % polygon.size()),
                  polygon.end());
    }
    for (std::size_t k = polygons.size(); k-- > 1;) {
      std::swap(polygons[k], polygons[random() % (k + 1)]);
    }
    const Decomposition again = decomposed(mesh_of(points, polygons));
    REQUIRE(again.parts.size() == first.parts.size());
    CHECK(again.owner == first.owner);
    for (std::size_t k = 0; k < first.parts.size(); ++k) {
      CHECK(again.parts[k].halfspaces == first.parts[k].halfspaces);
    }
  }
}

// Up to 7 triangles on 6 points of a grid.
Mesh random_soup(std::mt19937_64& random) {
  std::vector<Point> points;
  for (int k = 0; k < 6; ++k) {
    const std::uint64_t bits = random();
    points.emplace_back(bits % 4, (bits >> 8) % 4, (bits >> 16) % 4);
  }
  std::vector<std::vector<std::uint32_t>> triangles;
  const std::size_t count = 1 + random() % 7;
  while (triangles.size() < count) {
    const std::uint64_t bits = random();
    triangles.push_back(
        {std::uint32_t(bits % 6), std::uint32_t((bits >> 8) % 6), std::uint32_t((bits >> 16) % 6)});
  }
  return mesh_of(points, triangles);
}

TEST_CASE("decompose: every triangle of a random soup lies in its owner" * sweep) {
  std::mt19937_64 random(11);
  for (int round = 0; round < 300; ++round) {
    const Mesh mesh = random_soup(random);
    for (const FlatParts flat : {FlatParts::Thicken, FlatParts::Keep, FlatParts::Merge}) {
      DecomposeRequest request = with_fractions();
      request.flat = flat;
      request.keep_inner = round % 2 == 0;
      if (round % 3 == 0) request.faces = 5;
      if (round >= 150) {
        request.method = DecomposeMethod::Acd;
        request.bridge = BridgeChoice(round % 3);
      }
      const auto outcome = decompose(mesh, request);
      if (std::holds_alternative<NotSolid>(outcome)) {
        CHECK(flat == FlatParts::Merge);
        continue;
      }
      const auto& d = std::get<Decomposition>(outcome);
      check_owners(d);
      for (const Part& part : d.parts) {
        // Nothing can be removed from a thickened segment: a parallelepiped.
        if (request.faces) CHECK((part.faces <= 5 || part.form == PartForm::Thickened));
        CHECK(part.is_within_limit == (part.concavity.squared <= d.squared_limit()));
        if (part.is_unsplittable) CHECK(!part.is_within_limit);
        if (part.least_squared_concavity) {
          CHECK(*part.least_squared_concavity <= part.concavity.squared);
        }
      }
      std::size_t owned = d.inner.size();
      for (const InnerCluster& inner : d.inner) {
        CHECK(d.owner[inner.lowest.index()] == inner.part);
      }
      owned += d.parts.size() + d.flat_merged.size();
      CHECK(owned == d.clusters().size());
    }
  }
}

// ---- Splitting

TEST_CASE("decompose: an L is split at its notch, which lies a half deep, squared") {
  const Mesh l = mesh_of_cells(l_cells());
  DecomposeRequest request = with_fractions();
  request.method = DecomposeMethod::Acd;
  request.max_parts = 1;
  const Decomposition whole = decomposed(l, request);
  REQUIRE(whole.parts.size() == 1);
  // From the corner (1, 1) to the line between (2, 1) and (1, 2).
  CHECK(whole.parts[0].concavity.squared == Rational(1, 2));
  // The corner is also one of the bottom, or of the top, and these are facets of the hull.
  CHECK(whole.parts[0].least_squared_concavity == Rational(0));
  CHECK(!whole.parts[0].is_within_limit);
  CHECK(!whole.parts[0].is_unsplittable);
  CHECK(whole.stopped_by_count());
  CHECK(!whole.limit_holds);
  check_volumes(whole, 3, 0, Rational(1, 2));
  request.max_parts.reset();
  const Decomposition split = decomposed(l, request);
  CHECK(split.limit_holds);
  CHECK(split.parts.size() >= 2);
  CHECK(std::get<SplitTree>(split.origin).splits.size() + 1 == split.clusters().size());
  check_verdict(l, split);
}

TEST_CASE("decompose: an option of the other method is refused") {
  const Mesh box = box_mesh(kUnit);
  const auto code = [&](const auto& change) {
    DecomposeRequest request;
    change(request);
    return error_of([&] { return decompose(box, request); }).code();
  };
  const auto invalid = ErrorCode::InvalidArgument;
  CHECK(code([](DecomposeRequest& r) { r.bridge = BridgeChoice::Nearer; }) == invalid);
  CHECK(code([](DecomposeRequest& r) { r.coplanar = 1; }) == invalid);
  CHECK(code([](DecomposeRequest& r) {
          r.method = DecomposeMethod::Acd;
          r.measure = ConcavityMeasure::Vertices;
        }) == invalid);
  CHECK(code([](DecomposeRequest& r) {
          r.method = DecomposeMethod::Acd;
          r.engine = Engine::Exact;
        }) == invalid);
  CHECK(code([](DecomposeRequest& r) {
          r.method = DecomposeMethod::Acd;
          r.coplanar = 0;
        }) == invalid);
}

// ---- Refusals and stages

TEST_CASE("decompose: what cannot be is refused") {
  const Mesh box = box_mesh(kUnit);
  const auto code = [&](const auto& change, const Mesh& mesh) {
    DecomposeRequest request;
    change(request);
    return error_of([&] { return decompose(mesh, request); }).code();
  };
  const auto invalid = ErrorCode::InvalidArgument;
  CHECK(code([](DecomposeRequest& r) { r.max_parts = 0; }, box) == invalid);
  CHECK(code([](DecomposeRequest& r) { r.faces = 3; }, box) == invalid);
  CHECK(code([](DecomposeRequest& r) { r.total_faces = 3; }, box) == invalid);
  CHECK(code([](DecomposeRequest& r) { r.faces = r.total_faces = 8; }, box) == invalid);
  CHECK(code([](DecomposeRequest& r) { r.limit.value = Rational(101, 100); }, box) == invalid);
  CHECK(code([](DecomposeRequest& r) { r.limit.value = -1; }, box) == invalid);
  CHECK(code([](DecomposeRequest&) {}, {box.points, {}, {}}) == ErrorCode::NoInterior);
  const std::atomic<bool> stop = true;
  CHECK(code([&](DecomposeRequest& r) { r.watch.stop = &stop; }, box) == ErrorCode::Stopped);
}

TEST_CASE("decompose: only the stages that are needed run") {
  DecomposeRequest request;
  request.measures = PartMeasures::None;
  request.keep_inner = true;
  const Decomposition d = decomposed(box_mesh(kUnit), request);
  CHECK(!d.measures);
  for (const char* name : {"union's volume", "solid's volumes", "inner parts", "flat clusters"}) {
    CHECK(!ran(d, name));
  }
  for (const char* name : {"surface", "clusters", "concavities", "coverage by owners"}) {
    CHECK(ran(d, name));
  }
  for (const Stage& stage : d.stages) CHECK((stage.seconds > 0) == stage.skipped.empty());
}

TEST_CASE("decompose: a point that no face uses goes to the part that is nearest") {
  // Two unit cubes at x in [0, 1] and [4, 5]. (3, .5, .5) is one from the second and two from the
  // first: a pyramid of height 1 on a unit square, of volume 1/3, is added to it. (.5, .5, .5) lies
  // in the first.
  const std::set<Cell> cells{{0, 0, 0}, {4, 0, 0}};
  Mesh mesh = mesh_of_cells(cells);
  std::vector<Point> points(mesh.points.doubles().begin(), mesh.points.doubles().end());
  points.insert(points.end(), {{3, 0.5, 0.5}, {0.5, 0.5, 0.5}});
  mesh.points = PointSet(points);
  const auto made = std::get<Decomposition>(decompose(mesh, with_fractions()));
  check_owners(made);
  REQUIRE(made.parts.size() == 2);
  const std::size_t near = made.parts[0].is_widened ? 0 : 1;
  const Part &widened = made.parts[near], &other = made.parts[1 - near];
  CHECK(widened.is_widened);
  CHECK(widened.loose.size() == 1);
  CHECK(widened.mesh.points.size() == 9);
  CHECK_FALSE(other.is_widened);
  CHECK(other.loose.size() == 1);
  CHECK(made.measures->union_volume->exact == Rational(7, 3));
  DecomposeRequest request;
  request.loose = LoosePoints::Refuse;
  CHECK(error_of([&] { (void)decompose(mesh, request); }).code() == ErrorCode::InvalidArgument);
}

TEST_CASE("decompose: a part that a loose point widens may hold another one") {
  // (-2, 2, 2) is 2 from the cube of edge 4 and farther from the small one, which lies in the
  // pyramid that it adds: at x = -1/8 that reaches from 1/8 to 31/8.
  Mesh mesh = box_mesh({{0, 0, 0}, {4, 4, 4}});
  const Mesh small = box_mesh({{-0.125, 0.25, 0.25}, {-0.0625, 0.375, 0.375}});
  std::vector<Point> points(mesh.points.doubles().begin(), mesh.points.doubles().end());
  const auto first = static_cast<std::uint32_t>(points.size());
  points.insert(points.end(), small.points.doubles().begin(), small.points.doubles().end());
  for (auto polygon : small.polygons) {
    for (std::uint32_t& corner : polygon) corner += first;
    mesh.polygons.push_back(std::move(polygon));
  }
  points.emplace_back(-2, 2, 2);
  mesh.points = PointSet(points);
  const auto made = std::get<Decomposition>(decompose(mesh, with_fractions()));
  check_owners(made);
  REQUIRE(made.parts.size() == 1);
  CHECK(made.inner.size() == 1);
  CHECK(made.measures->union_volume->exact == Rational(64) + Rational(32, 3));
}
