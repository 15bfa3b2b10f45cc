// SPDX-License-Identifier: MIT
// decompose --method cut. Numbers of parts and volumes are closed forms, or were given with the
// method; what is promised of parts is judged by the oracle.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "cells.hpp"
#include "convexact/decompose.hpp"
#include "convexact/hull_tree.hpp"
#include "convexact/io.hpp"
#include "convexact/reach.hpp"
#include "convexact/verify_parts.hpp"
#include "expect_error.hpp"
#include "near/frame.hpp"
#include "number/random.hpp"
#include "parts/merge_by_reach.hpp"
#include "proof/decomposition_proof.hpp"
#include "sweep.hpp"

using namespace convexact;
using namespace support;

namespace {

Mesh shipped(const std::string& name) {
  return read_mesh(std::string(std::getenv("CONVEXACT_TEST_DATA")) + "/" + name + ".obj");
}

DecomposeRequest cutting(const char* share = "3/100") {
  DecomposeRequest request;
  request.method = DecomposeMethod::Cut;
  request.distance = ConcavityLimit{parse_rational(share), true};
  request.measures = PartMeasures::All;
  request.exact_volumes = true;
  return request;
}

Decomposition cut_of(const Mesh& mesh, const DecomposeRequest& request) {
  return std::get<Decomposition>(decompose(mesh, request));
}

std::vector<NamedPart> named(const Decomposition& made) {
  std::vector<NamedPart> parts;
  for (const Part& part : made.parts) parts.push_back({"part", part.mesh});
  return parts;
}

// The guarantee: both directions, by the oracle.
void check_guarantee(const Mesh& mesh, const Decomposition& made, const DecomposeRequest& request) {
  PartsRequest asked;
  asked.claims = {ClaimCode::CoversSurface, ClaimCode::CoversSolid, ClaimCode::PartsSolid};
  asked.distance = Tolerance{request.distance->value, request.distance->is_share};
  asked.measures = PartMeasures::None;
  asked.close = made.caps > 0 ? Close::Auto : Close::Never;
  const PartsVerdict verdict = verify_parts(mesh, named(made), asked);
  CHECK(verdict[ClaimCode::PartsSolid].status == Status::Holds);
  CHECK(verdict[ClaimCode::CoversSurface].status == Status::Holds);
  if (made.surface.is_closed) CHECK(verdict[ClaimCode::CoversSolid].status == Status::Holds);
  REQUIRE(made.reach);
  CHECK(made.reach->farther.empty());
  CHECK(made.limit_holds);
  CHECK(verdict[ClaimCode::WithinSolid].status == Status::Holds);
  // Each leaf has one part, and triangles with one owner lie in it.
  std::vector<int> seen(std::get<Partition>(made.origin).leaves.size(), 0);
  for (const Part& part : made.parts) {
    for (const std::uint32_t leaf : part.leaves) ++seen[leaf];
    for (const TriangleId t : part.owns) CHECK(&made.parts[made.owner[t.index()]] == &part);
  }
  CHECK(std::count(seen.begin(), seen.end(), 1) == static_cast<long>(seen.size()));
}

std::set<Cell> block_without(const std::set<Cell>& gone) {
  std::set<Cell> cells;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) {
      for (int z = 0; z < 3; ++z) {
        if (!gone.contains({x, y, z})) cells.insert({x, y, z});
      }
    }
  }
  return cells;
}

}  // namespace

TEST_CASE("cut parts: solids of cells are taken apart exactly" * sweep) {
  std::set<Cell> stairs;
  for (int x = 0; x < 4; ++x) {
    for (int z = 0; z <= x; ++z) stairs.insert({x, 0, z});
  }
  const struct {
    const char* name;
    std::set<Cell> cells;
    std::size_t parts;
  } shapes[] = {
      {"L", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 2},
      {"U", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}}, 3},
      {"plus", {{1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {1, 2, 0}}, 2},  // bars that overlap
      {"ring",
       {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}, {0, 2, 0}, {1, 2, 0}, {2, 2, 0}},
       4},
      {"stairs", stairs, 4},
      {"cavity", block_without({{1, 1, 1}}), 6},
      {"bin", block_without({{1, 1, 1}, {1, 1, 2}}), 5},
      {"cross", {{1, 1, 1}, {0, 1, 1}, {2, 1, 1}, {1, 0, 1}, {1, 2, 1}, {1, 1, 0}, {1, 1, 2}}, 3}};
  // (At 1%: tests/reproduce/cut.py.)
  for (const auto& shape : shapes) {
    CAPTURE(shape.name);
    const Mesh mesh = mesh_of_cells(shape.cells);
    const DecomposeRequest request = cutting();
    const Decomposition made = cut_of(mesh, request);
    CHECK(made.parts.size() == shape.parts);
    CHECK(*made.measures->excess_volume->exact == 0);
    check_guarantee(mesh, made, request);
    for (const Part& part : made.parts) CHECK(part.form == PartForm::Hull);
  }
}

TEST_CASE("cut parts: at a distance of 0 solids without inner walls are filled exactly" * sweep) {
  Random random(48);
  const auto below = [&](std::uint64_t n) { return static_cast<int>(uniform_below(random, n)); };
  int tested = 0;
  for (int world = 0; world < 40; ++world) {
    std::set<Cell> cells;
    for (int k = 0; k < 20; ++k) cells.insert({below(3), below(3), below(3)});
    const Mesh mesh = mesh_of_cells(cells);
    const DecomposeRequest request = cutting("0");
    // Walls inside of the solid, as around a cavity that counts as filled, would take many cells.
    const Surface surface = make_surface(mesh);
    const Winding winding(surface);
    const Rational half(1, 2);
    bool has_walls = false;
    for (const auto& [x, y, z] : block_without({})) {
      has_walls = has_walls || *winding(RationalPoint(x + half, y + half, z + half)) !=
                                   (cells.contains({x, y, z}) ? 1 : 0);
    }
    if (has_walls) continue;
    CAPTURE(world);
    ++tested;
    const Decomposition made = cut_of(mesh, request);
    CHECK(made.reach->squared_distance == 0);
    CHECK(made.limit_holds);
    CHECK(*made.measures->union_volume->exact == static_cast<long>(cells.size()));
    check_guarantee(mesh, made, request);
  }
  CHECK(tested > 10);
}

TEST_CASE("cut parts: rounded outward, parts are not within 0") {
  DecomposeRequest request = cutting("0");
  const Decomposition made = cut_of(shipped("cases/tube"), request);
  CHECK_FALSE(made.limit_holds);
  CHECK(*made.measures->excess_volume->exact > 0);
  REQUIRE(made.reach->farther.size() > 0);
  for (const auto& [part, found] : made.reach->farther) {
    CHECK(found.reach == Reach::Undecided);
    CHECK(found.bracket->low == 0);
    CHECK(found.bracket->high <= made.squared_diameter() * 4 * kLeastReach * kLeastReach);
  }
}

TEST_CASE("cut parts: distances that are refused") {
  const Mesh mesh = mesh_of_cells({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  DecomposeRequest request = cutting("1/10000000");
  CHECK(error_of([&] { (void)decompose(mesh, request); }).code() == ErrorCode::InvalidArgument);
  request = cutting("0");
  Mesh open = mesh;
  open.polygons.pop_back();
  CHECK(error_of([&] { (void)decompose(open, request); }).code() == ErrorCode::InvalidArgument);
  request.method = DecomposeMethod::Hacd;
  request.guard = ReachUse::Reach;
  CHECK(error_of([&] { (void)decompose(mesh, request); }).code() == ErrorCode::InvalidArgument);
}

// The numbers of parts of the specification, with its slack.
TEST_CASE("cut parts: bin, cup, tube and house") {
  const std::pair<const char*, std::size_t> cases[] = {
      {"bin", 5}, {"cup", 12}, {"tube", 10}, {"house", 10}};
  for (const auto& each : cases) {
    const char* name = each.first;
    const std::size_t most = each.second;
    CAPTURE(name);
    const Mesh mesh = shipped("cases/" + std::string(name));
    const DecomposeRequest request = cutting();
    const Decomposition made = cut_of(mesh, request);
    CHECK(made.parts.size() <= most);
    check_guarantee(mesh, made, request);
  }
}

TEST_CASE("cut parts: spot" * sweep) {
  const Mesh mesh = shipped("spot");
  DecomposeRequest request = cutting();
  request.exact_volumes = false;
  const Decomposition made = cut_of(mesh, request);
  CHECK(made.parts.size() <= 12);
  check_guarantee(mesh, made, request);
}

TEST_CASE("cut parts: the exact engine makes the same parts") {
  for (const auto& gone : {std::set<Cell>{{1, 1, 1}}, std::set<Cell>{{1, 1, 1}, {1, 1, 2}}}) {
    DecomposeRequest request = cutting("1/20");
    const Mesh mesh = mesh_of_cells(block_without(gone));
    const Decomposition filtered = cut_of(mesh, request);
    request.engine = Engine::Exact;
    const Decomposition exact = cut_of(mesh, request);
    REQUIRE(filtered.parts.size() == exact.parts.size());
    for (std::size_t k = 0; k < exact.parts.size(); ++k) {
      CHECK(filtered.parts[k].leaves == exact.parts[k].leaves);
      CHECK(filtered.parts[k].hull.vertices == exact.parts[k].hull.vertices);
    }
  }
}

TEST_CASE("cut parts: a number of parts, beyond the distance and below the components") {
  std::set<Cell> cells = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  DecomposeRequest request = cutting();
  const Mesh mesh = mesh_of_cells(cells);
  CHECK(cut_of(mesh, request).parts.size() == 3);
  for (const std::size_t most : {2, 1}) {
    request.max_parts = most;
    const Decomposition made = cut_of(mesh, request);
    CHECK(made.parts.size() == most);
    CHECK(!made.limit_holds);
    CHECK(!made.reach->farther.empty());
    CHECK(*made.measures->uncovered_volume->exact == 0);
    PartsRequest asked;
    asked.claims = {ClaimCode::CoversSolid};
    CHECK(verify_parts(mesh, named(made), asked)[ClaimCode::CoversSolid].status == Status::Holds);
  }
}

TEST_CASE("cut parts: an excess that is allowed is not exceeded" * sweep) {
  const Mesh mesh = shipped("cases/cup");
  std::size_t before = 0;
  for (const char* most : {"2/5", "1/20"}) {
    DecomposeRequest request = cutting();
    request.max_excess = parse_rational(most);
    const Decomposition made = cut_of(mesh, request);
    check_guarantee(mesh, made, request);
    CHECK(*made.measures->excess_volume->exact <=
          *request.max_excess * *made.measures->solid_volume->exact);
    REQUIRE(made.excess);
    CHECK(made.excess->holds);
    CHECK(made.excess->share.high() <= *request.max_excess);
    CHECK(made.parts.size() > before);
    before = made.parts.size();
  }
}

TEST_CASE("cut parts: an excess that no way was found to keep is told") {
  // Flat facets of convex parts cannot follow a round hole, nor one part a cell that is missing.
  DecomposeRequest request = cutting();
  request.max_excess = Rational(0);
  const Mesh tube = shipped("cases/tube");
  const Decomposition round = cut_of(tube, request);
  REQUIRE(round.excess);
  CHECK(!round.excess->holds);
  CHECK(round.excess->share.low() > 0);
  CHECK(round.limit_holds);
  const Mesh l = mesh_of_cells({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  request.max_parts = 1;
  const Decomposition joined = cut_of(l, request);
  CHECK(!joined.excess->holds);
  CHECK(joined.excess->share.contains(Rational(1, 6)));  // half a cell of three
}

TEST_CASE("cut parts: regions that are too large for the excess allowed still merge" * sweep) {
  // A hollow cube of cells, turned by a matrix of integers and scaled, so that corners are rounded.
  std::set<Cell> cells;
  for (int k = 0; k < 27; ++k) cells.insert({k % 3, k / 3 % 3, k / 9});
  cells.erase({1, 1, 1});
  Mesh mesh = mesh_of_cells(cells);
  std::vector<Point> points;
  for (const Point& x : mesh.points.doubles()) {
    points.emplace_back(0.1 * (2 * x[0] + x[1]), 0.1 * (2 * x[1] + x[2] - x[0]),
                        0.1 * (2 * x[2] - x[1]));
  }
  mesh.points = PointSet(points);
  DecomposeRequest request = cutting();
  request.max_excess = parse_rational("1/1000000000000");
  const Decomposition made = cut_of(mesh, request);
  CHECK(made.parts.size() <= 5 * cut_of(mesh, cutting()).parts.size());  // it was 30 times
}

TEST_CASE("cut parts: an excess of exactly as much as allowed holds") {
  const Mesh l = mesh_of_cells({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  DecomposeRequest request = cutting();
  for (const char* most : {"0", "1/6"}) {
    request.max_excess = parse_rational(most);
    if (*request.max_excess > 0) request.distance = ConcavityLimit{Rational(1), false};
    const Decomposition made = cut_of(l, request);
    REQUIRE(made.excess);
    CHECK(made.excess->holds);
    CHECK(made.excess->share.contains(*request.max_excess));
    CHECK(made.parts.size() == (*request.max_excess > 0 ? 1 : 2));
  }
}

TEST_CASE("cut parts: a tube takes no more parts than the method was given with" * sweep) {
  const Mesh mesh = shipped("cases/tube");
  const DecomposeRequest request = cutting("1/100");
  const Decomposition made = cut_of(mesh, request);
  check_guarantee(mesh, made, request);
  CHECK(made.parts.size() <= 12);  // the aim of --effort high; 14 without
}

TEST_CASE("merge by reach: parts exchange pieces, as a matching grows by an augmenting path") {
  // A bent bar of six pieces that span these angles of an inner radius of 1. Over two of them with
  // angles a and b the chord is 2 sin(a/2) sin(b/2) away from the corner between: at most 0.025 for
  // neighbours; over three it is at least 0.036. Those of 8 and 12 degrees add the least volume,
  // and leave one at either end.
  const double degrees[] = {0, 20, 28, 40, 52, 60, 80};
  std::vector<Point> points;
  Mesh mesh;
  for (const double degree : degrees) {
    const double angle = degree * std::acos(-1.0) / 180;
    for (const double radius : {1.0, 1.5}) {
      for (const double z : {0.0, 1.0}) {
        points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
      }
    }
  }
  mesh.points = PointSet(points);
  for (std::uint32_t at = 0; at < 24; at += 4) {  // inner and outer below and above, then the next
    mesh.polygons.push_back({at, at + 4, at + 6, at + 2});
    mesh.polygons.push_back({at + 1, at + 3, at + 7, at + 5});
    mesh.polygons.push_back({at, at + 1, at + 5, at + 4});
    mesh.polygons.push_back({at + 2, at + 6, at + 7, at + 3});
  }
  mesh.polygons.push_back({0, 2, 3, 1});
  mesh.polygons.push_back({24, 25, 27, 26});
  const Surface surface = make_surface(mesh, {});
  REQUIRE(surface.is_closed);
  const Winding winding(surface);
  ReachLimit limit(surface, &winding, Rational(9, 10000));
  std::vector<std::vector<Point>> pieces(6);
  for (std::size_t k = 0; k < 6; ++k) {
    for (std::size_t p = 4 * k; p < 4 * k + 8; ++p) pieces[k].push_back(limit.frame()(points[p]));
  }
  const auto parts = [&](std::size_t exchanges) {
    return merge_by_reach(pieces, limit, {.exchanges = exchanges}, {}).parts.size();
  };
  CHECK(parts(0) == 4);
  CHECK(parts(4) == 3);
}

TEST_CASE("cut parts: finer triangles are the same solid") {
  for (const std::set<Cell>& cells :
       {std::set<Cell>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}},
        {{1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {1, 2, 0}}}) {
    const Mesh mesh = mesh_of_cells(cells);
    Mesh finer = mesh;
    finer.polygons.clear();
    const auto given = mesh.points.doubles();
    std::vector<Point> points(given.begin(), given.end());
    for (const auto& square : mesh.polygons) {  // points in the middles of edges are not shared
      const auto middle = static_cast<std::uint32_t>(points.size());
      Point sum = Point::Zero();
      for (const std::uint32_t corner : square) sum += given[corner];
      points.emplace_back(sum / 4);
      for (std::size_t k = 0; k < 4; ++k) {
        points.emplace_back((given[square[k]] + given[square[(k + 1) % 4]]) / 2);
      }
      for (std::uint32_t k = 0; k < 4; ++k) {
        finer.polygons.push_back({square[k], middle + 1 + k, middle, middle + 1 + (k + 3) % 4});
      }
    }
    finer.points = PointSet(points);
    const Decomposition made = cut_of(finer, cutting());
    check_guarantee(finer, made, cutting());
    CHECK(made.parts.size() == cut_of(mesh, cutting()).parts.size());
  }
}

TEST_CASE("cut parts: an open surface has no volume that an excess could be a share of") {
  Mesh open = box_mesh({{0, 0, 0}, {1, 1, 1}});
  open.polygons.pop_back();
  DecomposeRequest request = cutting();
  request.close = Close::Never;
  request.max_excess = Rational(1, 10);
  CHECK(error_of([&] { return decompose(open, request); }).code() == ErrorCode::InvalidArgument);
  for (std::size_t k = open.polygons.size(); k-- > 0;) {  // each face from both sides
    auto turned = open.polygons[k];
    std::reverse(turned.begin(), turned.end());
    open.polygons.push_back(std::move(turned));
  }
  CHECK(error_of([&] { return decompose(open, request); }).code() == ErrorCode::InvalidArgument);
}

TEST_CASE("cut parts: disjoint parts, but for roundings" * sweep) {
  for (const char* name : {"cases/cup", "cases/house", "cases/bin"}) {
    CAPTURE(name);
    const Mesh mesh = shipped(name);
    DecomposeRequest request = cutting();
    request.disjoint = true;
    const Decomposition made = cut_of(mesh, request);
    check_guarantee(mesh, made, request);
    REQUIRE(made.apart);
    const std::size_t count = made.parts.size();
    CHECK(made.apart->planes.size() == count * (count - 1) / 2);
    // As rounding does: 2^-40 of the diameter is far more.
    const Rational rounding = made.squared_diameter() / Rational(Integer(1) << 80);
    CHECK(made.apart->squared_push <= rounding);
    CHECK(made.measures->overlap_volume->exact < *made.measures->solid_volume->exact / 1000000);
    for (const auto& [first, second, plane] : made.apart->planes) {
      const auto hull = [&](std::size_t k) { return convex_part(made.parts[k].mesh.points); };
      CHECK(plane_between(hull(first), hull(second), plane.direction).squared <=
            made.apart->squared_push);
    }
    // The oracle, which finds its own planes.
    PartsRequest asked;
    asked.claims = {ClaimCode::PartsDisjoint};
    asked.measures = PartMeasures::None;
    asked.tolerance = {Rational(1, 1000000000000), true};
    CHECK(verify_parts(mesh, named(made), asked)[ClaimCode::PartsDisjoint].status == Status::Holds);
    request.disjoint = false;
    const Decomposition plain = cut_of(mesh, request);
    CHECK(!plain.apart);
    CHECK(plain.parts.size() <= count);
    if (std::string(name) != "cases/cup") continue;
    // These overlap by far more.
    CHECK(verify_parts(mesh, named(plain), asked)[ClaimCode::PartsDisjoint].status ==
          Status::Violated);
  }
}

TEST_CASE("cut parts: parts that are simplified stay within the distance") {
  const Mesh mesh = shipped("cases/tube");
  DecomposeRequest request = cutting();
  request.faces = 12;
  const Decomposition made = cut_of(mesh, request);
  check_guarantee(mesh, made, request);
  for (const Part& part : made.parts) CHECK(part.faces <= 12);
}

TEST_CASE("cut parts: binary32 and fractions") {
  const Mesh mesh = shipped("cases/cup");
  DecomposeRequest request = cutting();
  request.precision = Precision::Binary32;
  const Decomposition narrow = cut_of(mesh, request);
  check_guarantee(mesh, narrow, request);
  for (const Part& part : narrow.parts) {
    for (const Point& x : part.mesh.points.doubles()) {
      for (const double y : x) CHECK(static_cast<double>(static_cast<float>(y)) == y);
    }
  }
  std::vector<RationalPoint> thirds;
  const Mesh cells = mesh_of_cells(block_without({{1, 1, 1}, {1, 1, 2}}));
  for (std::size_t k = 0; k < cells.points.size(); ++k) {
    thirds.push_back(cells.points[PointId(k)] / Rational(3));
  }
  Mesh exact = cells;
  exact.points = PointSet(thirds);
  const DecomposeRequest plain = cutting();
  const Decomposition made = cut_of(exact, plain);
  CHECK(made.parts.size() == 5);
  check_guarantee(exact, made, plain);
}

TEST_CASE("cut parts: open, flat and loose") {
  Mesh open = box_mesh({{0, 0, 0}, {4, 4, 4}});
  open.polygons.pop_back();
  DecomposeRequest request = cutting();
  request.close = Close::Never;
  const Decomposition made = cut_of(open, request);
  CHECK(made.parts.size() == 5);
  for (const Part& part : made.parts) CHECK(part.form != PartForm::Flat);
  check_guarantee(open, made, request);

  Mesh square = box_mesh({{0, 0, 0}, {4, 4, 4}});
  square.polygons = {square.polygons[0]};
  CHECK(std::holds_alternative<NotSolid>(decompose(square, cutting())));
  request.flat = FlatParts::Thicken;
  CHECK(cut_of(square, request).parts.size() == 1);

  // A point far away widens the part that takes it, and the result says so.
  const Mesh box = box_mesh({{0, 0, 0}, {4, 4, 4}});
  std::vector<Point> points(box.points.doubles().begin(), box.points.doubles().end());
  points.emplace_back(9, 9, 9);
  Mesh loose = box;
  loose.points = PointSet(points);
  const Decomposition widened = cut_of(loose, cutting());
  CHECK(widened.parts.size() == 1);
  CHECK(widened.reach->farther.size() == 1);
  CHECK(!widened.limit_holds);
}

TEST_CASE("cut parts: what does not apply is refused") {
  const Mesh mesh = box_mesh({{0, 0, 0}, {1, 1, 1}});
  const auto refuses = [&](auto&& change) {
    DecomposeRequest request = cutting();
    change(request);
    CHECK(error_of([&] { return decompose(mesh, request); }).code() == ErrorCode::InvalidArgument);
  };
  refuses([](DecomposeRequest& r) { r.limit.value = Rational(1, 10); });
  refuses([](DecomposeRequest& r) { r.guard = ReachUse::Reach; });
  refuses([](DecomposeRequest& r) { r.merge = ReachUse::Reach; });
  refuses([](DecomposeRequest& r) { r.measure = ConcavityMeasure::Vertices; });
  refuses([](DecomposeRequest& r) { r.connect = Connect::Touching; });
  refuses([](DecomposeRequest& r) { r.flat = FlatParts::Merge; });
  refuses([](DecomposeRequest& r) { r.distance->value = -1; });
  refuses([](DecomposeRequest& r) { r.max_excess = Rational(-1); });
  refuses([](DecomposeRequest& r) {
    r.method = DecomposeMethod::Hacd;
    r.distance.reset();
    r.effort = CutEffort::High;
  });
  refuses([](DecomposeRequest& r) {
    r.method = DecomposeMethod::Hacd;
    r.distance.reset();
    r.disjoint = true;
  });
  Mesh point = mesh;
  point.points = PointSet(std::vector<Point>(8, Point(1, 2, 3)));
  DecomposeRequest request = cutting();
  request.flat = FlatParts::Thicken;
  CHECK(error_of([&] { return decompose(point, request); }).code() == ErrorCode::NoInterior);
}

TEST_CASE("cut parts: the tree of the cuts becomes a tree of hulls") {
  const Mesh mesh = shipped("cases/house");
  const Decomposition made = cut_of(mesh, cutting());
  const std::vector<Join> joins = joins_of(made);
  CHECK(joins.size() == made.parts.size() - 1);
}
