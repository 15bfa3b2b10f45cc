// SPDX-License-Identifier: MIT
// Decompositions that stay near the solid. That they do is judged by points whose distance is known
// by hand, by the oracle's covers-surface, and by exact engines.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>

#include "assembled_meshes.hpp"
#include "cells.hpp"
#include "convexact/decompose.hpp"
#include "convexact/io.hpp"
#include "convexact/verify_parts.hpp"
#include "expect_error.hpp"
#include "sweep.hpp"

using namespace convexact;
using namespace support;

namespace {

Mesh case_mesh(const std::string& name) {
  return read_mesh(std::string(std::getenv("CONVEXACT_TEST_DATA")) + "/cases/" + name + ".obj");
}

DecomposeRequest guarded(const char* limit = "3/100") {
  DecomposeRequest request;
  request.guard = ReachUse::Reach;
  request.distance = ConcavityLimit{parse_rational(limit), true};
  request.measures = PartMeasures::All;
  return request;
}

DecomposeRequest merging(const char* limit = "3/100") {
  DecomposeRequest request = guarded(limit);
  request.guard = ReachUse::None;
  request.merge = ReachUse::Reach;
  return request;
}

Decomposition made_of(const Mesh& mesh, const DecomposeRequest& request) {
  return std::get<Decomposition>(decompose(mesh, request));
}

bool any_holds(const Decomposition& made, const RationalPoint& x) {
  return std::any_of(made.parts.begin(), made.parts.end(), [&](const Part& part) {
    return std::all_of(part.halfspaces.begin(), part.halfspaces.end(),
                       [&](const Halfspace& h) { return h(x) <= 0; });
  });
}

// What holds of every decomposition, by other code than made it.
void check_promises(const Mesh& mesh, const Decomposition& made, const DecomposeRequest& request) {
  std::vector<NamedPart> parts;
  for (const Part& part : made.parts) parts.push_back({"part", part.mesh});
  PartsRequest asked;
  asked.claims = {ClaimCode::CoversPoints, ClaimCode::CoversSurface};
  asked.distance = Tolerance{request.distance->value, request.distance->is_share};
  asked.measures = PartMeasures::None;
  const PartsVerdict verdict = verify_parts(mesh, parts, asked);
  CHECK(verdict[ClaimCode::CoversSurface].status == Status::Holds);
  REQUIRE(made.reach);
  CHECK(made.reach->farther.empty());
  CHECK(verdict[ClaimCode::WithinSolid].status == Status::Holds);
  std::size_t clusters = made.inner.size() + made.parts.size();
  for (const Part& part : made.parts) clusters += part.merged.size();
  CHECK(clusters == made.clusters().size());
  for (const Part& part : made.parts) {
    for (const TriangleId t : part.merged)
      CHECK(made.owner[t.index()] == made.owner[part.owns[0].index()]);
  }
}

bool is_small(const std::optional<Measured>& volume, const char* most) {
  return volume && volume->bounds.high() <= parse_rational(most);
}

}  // namespace

namespace {

// Points in cavities, far from every wall.
std::vector<RationalPoint> cavity_of(const std::string& name) {
  const auto at = [](const char* x, const char* y, const char* z) {
    return RationalPoint(parse_rational(x), parse_rational(y), parse_rational(z));
  };
  if (name == "bin") return {at("1/2", "1/2", "1/2"), at("1/5", "1/5", "9/10")};
  if (name == "cup") return {at("0", "0", "1/10"), at("0", "0", "1/20")};
  if (name == "tube") return {at("0", "0", "1/10"), at("1/100", "0", "1/100")};
  return {at("1", "1", "1"), at("5", "1", "2"), at("2", "9/2", "2")};  // house
}

}  // namespace

TEST_CASE("decompose --guard reach: cavities stay open" * sweep) {
  // 20% of the cup's 0.002634; the bin's sheets are thickened if nothing merges with them.
  const std::pair<const char*, const char*> cases[] = {
      {"bin", "0.00001"}, {"cup", "0.000526"}, {"tube", "0.0008"}, {"house", "0.00001"}};
  for (const auto& each : cases) {
    const char *name = each.first, *most_excess = each.second;
    const std::vector<RationalPoint> open = cavity_of(name);
    CAPTURE(name);
    const Mesh mesh = case_mesh(name);
    const Decomposition published = made_of(mesh, {});
    CHECK(any_holds(published, open[0]));
    for (const DecomposeRequest& request : {guarded(), merging()}) {
      const Decomposition made = made_of(mesh, request);
      for (const RationalPoint& x : open) CHECK_FALSE(any_holds(made, x));
      CHECK(is_small(made.measures->excess_volume, most_excess));
      check_promises(mesh, made, request);
    }
  }
}

TEST_CASE(
    "decompose --merge reach: an inner cluster stays in its part when parts before it merge") {
  // Two boxes with a narrow gap, one with a box inside, and one far away.
  const Mesh mesh =
      joined({box_mesh({{0, 0, 0}, {1, 1, 1}}), box_mesh({{1.25, 0, 0}, {2, 1, 1}}),
              box_mesh({{10, 10, 10}, {14, 14, 14}}), box_mesh({{11, 11, 11}, {12, 12, 12}}),
              box_mesh({{20, 20, 20}, {21, 21, 21}})});
  const Decomposition made = made_of(mesh, merging());
  CHECK(made.reach->merged == 1);
  REQUIRE(made.parts.size() == 3);
  REQUIRE(made.inner.size() == 1);
  CHECK(holds(made.parts[made.inner[0].part].hull, RationalPoint(12, 12, 12)));
}

TEST_CASE("decompose --merge reach: few parts, and the bin is exact") {
  const Decomposition bin = made_of(case_mesh("bin"), merging());
  CHECK(bin.parts.size() == 5);
  CHECK(is_small(bin.measures->excess_volume, "1e-30"));
  CHECK(is_small(bin.measures->uncovered_volume, "1e-30"));
}

TEST_CASE("decompose --guard reach: acd splits what reaches too far") {
  for (const char* name : {"bin", "cup", "tube", "house"}) {
    const Mesh mesh = case_mesh(name);
    DecomposeRequest request = guarded();
    request.method = DecomposeMethod::Acd;
    const Decomposition made = made_of(mesh, request);
    CAPTURE(name);
    for (const RationalPoint& x : cavity_of(name)) CHECK_FALSE(any_holds(made, x));
    check_promises(mesh, made, request);
  }
}

TEST_CASE("decompose --guard reach: the engines make the same merges" * sweep) {
  const std::set<Cell> slot = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 1}, {2, 0, 1}};
  for (const auto& cells : {l_cells(), ring_cells(), cross_cells(), slot}) {
    const Mesh mesh = mesh_of_cells(cells);
    for (const char* limit : {"1/20", "1/5"}) {
      DecomposeRequest request = guarded(limit);
      request.limit.value = Rational(1, 2);
      const Decomposition filtered = made_of(mesh, request);
      request.engine = Engine::Exact;
      const Decomposition exact = made_of(mesh, request);
      const auto& a = std::get<Clustering>(filtered.origin);
      const auto& b = std::get<Clustering>(exact.origin);
      CHECK(a.merges == b.merges);
      CHECK(a.clusters == b.clusters);
      CHECK(a.refused == b.refused);
    }
  }
}

TEST_CASE("decompose: what guards and distances refuse, and what exceeds them is told") {
  const Mesh mesh = mesh_of_cells(l_cells());
  DecomposeRequest request;
  request.distance = ConcavityLimit{Rational(1, 100), true};
  CHECK(error_of([&] { return decompose(mesh, request); }).code() == ErrorCode::InvalidArgument);
  request.guard = ReachUse::Reach;
  request.distance->value = 0;
  CHECK(error_of([&] { return decompose(mesh, request); }).code() == ErrorCode::InvalidArgument);
  // One part is asked for, so the box of the L it is; its corner is 1 from both arms.
  request.distance->value = Rational(1, 100);
  request.max_parts = 1;
  const Decomposition made = made_of(mesh, request);
  REQUIRE(made.reach->farther.size() == 1);
  const PartReach& reach = made.reach->farther[0].reach;
  CHECK(reach.reach == Reach::Beyond);
  CHECK(reach.witness->squared > made.reach->squared_distance);
  // The diagonal of the hull of an L passes the corner that lacks at 1/2 from both arms.
  CHECK(reach.witness->squared <= Rational(1, 4));
}

namespace {

// A cube of 4 x 4 x 4 cells, without so many squares of the middle of its top.
Mesh cube_with_hole(int width) {
  std::set<Cell> cells;
  for (int k = 0; k < 64; ++k) cells.insert({k & 3, k >> 2 & 3, k >> 4});
  Mesh mesh = mesh_of_cells(cells);
  std::erase_if(mesh.polygons, [&](const auto& polygon) {
    return std::all_of(polygon.begin(), polygon.end(), [&](std::uint32_t corner) {
      const Point& p = mesh.points.doubles()[corner];
      return p[2] == 4 && p[0] >= 1 && p[0] <= 1 + width && p[1] >= 1 && p[1] <= 1 + width;
    });
  });
  mesh.parts.clear();
  return mesh;
}

}  // namespace

TEST_CASE("decompose --close: small borders get caps, and the solid is what they close") {
  // The hole is sqrt(2) wide, the cube 4 sqrt(3): a fifth.
  const Mesh mesh = cube_with_hole(1);
  const Decomposition closed = made_of(mesh, guarded());
  CHECK(closed.caps == 1);
  CHECK(closed.squared_largest_cap == 2);
  CHECK(closed.surface.is_closed);
  CHECK(closed.parts.size() == 1);
  CHECK(closed.measures->solid_volume->bounds.contains(64));
  CHECK(closed.reach->farther.empty());
  DecomposeRequest never = guarded();
  never.close = Close::Never;
  const Decomposition open = made_of(mesh, never);
  CHECK(open.caps == 0);
  CHECK_FALSE(open.surface.is_closed);
  CHECK(open.parts.size() > 1);  // walls alone
  CHECK(made_of(cube_with_hole(2), guarded()).caps == 0);
  // Without a guard surfaces are taken as they are.
  CHECK(made_of(mesh, {}).caps == 0);
  // The judge asks the same question of the surface with caps, and of that without.
  const std::vector<NamedPart> parts{{"part", closed.parts[0].mesh}};
  PartsRequest asked;
  asked.distance = Tolerance{Rational(1, 100), true};
  asked.measures = PartMeasures::None;
  const PartsVerdict as_given = verify_parts(mesh, parts, asked);
  CHECK(as_given[ClaimCode::WithinSolid].status == Status::Violated);
  REQUIRE(as_given.notes.size() > 0);
  CHECK(as_given.notes[0].find("--close auto") != std::string::npos);
  asked.close = Close::Auto;
  const PartsVerdict verdict = verify_parts(mesh, parts, asked);
  CHECK(verdict.holds());
  CHECK(verdict[ClaimCode::CoversSolid].status == Status::Holds);
  REQUIRE(verdict.notes.size() > 0);
  CHECK(verdict.notes[0].find("closed by 1 cap") != std::string::npos);
}

TEST_CASE("decompose --close: borders that touch at a point, and a middle that no part holds") {
  // Two squares of the top that meet in a corner are two borders through one point.
  Mesh mesh = cube_with_hole(1);
  std::erase_if(mesh.polygons, [&](const auto& polygon) {
    return std::all_of(polygon.begin(), polygon.end(), [&](std::uint32_t corner) {
      const Point& p = mesh.points.doubles()[corner];
      return p[2] == 4 && p[0] >= 2 && p[0] <= 3 && p[1] >= 2 && p[1] <= 3;
    });
  });
  const Decomposition closed = made_of(mesh, guarded());
  CHECK(closed.caps == 2);
  CHECK(closed.parts.size() == 1);
  PartsRequest asked;
  asked.close = Close::Auto;
  const PartsVerdict verdict = verify_parts(mesh, parts_of_boxes({{{0, 0, 0}, {4, 4, 3}}}), asked);
  CHECK(verdict[ClaimCode::CoversPoints].status == Status::Violated);
}

TEST_CASE("decompose --merge reach: a loose point far away widens a part, which is told") {
  Mesh mesh = mesh_of_cells(l_cells());
  std::vector<Point> points(mesh.points.doubles().begin(), mesh.points.doubles().end());
  points.emplace_back(100, 0, 0);
  mesh.points = PointSet(points);
  for (const DecomposeRequest& request : {guarded(), merging()}) {
    const Decomposition made = made_of(mesh, request);
    REQUIRE(made.reach->farther.size() == 1);
    CHECK(made.reach->farther[0].reach.reach == Reach::Beyond);
    CHECK(made.reach->farther[0].reach.witness->squared > 1);
  }
}
