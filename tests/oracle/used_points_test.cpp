// SPDX-License-Identifier: MIT
// Points of the input that no face uses, asked or not. Expected values are closed forms: a unit
// cube with points beside it.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "cells.hpp"
#include "convexact/io.hpp"
#include "convexact/verify.hpp"
#include "convexact/verify_parts.hpp"
#include "expect_error.hpp"
#include "wire/stdio_request.hpp"

using namespace convexact;
using namespace support;
using nlohmann::json;
using enum ClaimCode;

namespace {

// The unit cube, with two points in front of its corners and one behind, at (0.5, 0.5, 7).
Mesh cube_with_loose_points() {
  Mesh mesh = box_mesh(box_of({0, 0, 0}));
  std::vector<Point> points = {{9, 9, 9}, {0.5, 0.5, 0.5}};
  for (const Point& p : mesh.points.doubles()) points.push_back(p);
  points.emplace_back(0.5, 0.5, 7);
  for (auto& polygon : mesh.polygons) {
    for (std::uint32_t& corner : polygon) corner += 2;
  }
  mesh.points = PointSet(points);
  return mesh;
}

Verdict judged(const Mesh& input, const Candidate& candidate, MeshPoints points,
               Asks asks = Asks::Enclosure) {
  VerifyRequest request;
  request.asks = asks;
  request.points = points;
  request.used = used_points(input.points.size(), input.polygons);
  return std::get<Verdict>(verify(input.points, candidate, request));
}

}  // namespace

TEST_CASE("used points: by the faces, and what is left of a mesh without the others") {
  Mesh mesh = cube_with_loose_points();
  const std::vector<bool> used = used_points(mesh.points.size(), mesh.polygons);
  CHECK(std::count(used.begin(), used.end(), true) == 8);
  CHECK_FALSE(used[0]);
  CHECK_FALSE(used[1]);
  CHECK_FALSE(used[10]);
  drop_unused_points(mesh);
  const Mesh cube = box_mesh(box_of({0, 0, 0}));
  CHECK(mesh.polygons == cube.polygons);
  REQUIRE(mesh.points.size() == 8);
  for (std::size_t p = 0; p < 8; ++p) {
    CHECK(mesh.points[PointId(p)] == cube.points[PointId(p)]);
  }
  Mesh cloud{cube.points, {}, {}};
  drop_unused_points(cloud);
  CHECK(cloud.points.size() == 8);
}

TEST_CASE("used points: the cube is the hull of the points that faces use, and not of all") {
  const Mesh input = cube_with_loose_points();
  const Mesh cube = box_mesh(box_of({0, 0, 0}));
  const Verdict used = judged(input, cube, MeshPoints::Used, Asks::Hull);
  CHECK(used.holds());
  CHECK(used.outside->tested == 8);
  REQUIRE(!used.notes.empty());
  CHECK(used.notes[0].starts_with("3 points of the input are used by no face, and not asked"));

  const Verdict all = judged(input, cube, MeshPoints::All, Asks::Hull);
  CHECK(all[ContainsInput].status == Status::Violated);
  CHECK(all[IsHull].status == Status::Violated);
  // (9, 9, 9) is 8 from (1, 1, 1) in each coordinate; the one in the middle is not outside.
  CHECK(all[ContainsInput].witness.input_point == 0);
  CHECK(all[ContainsInput].witness.squared_distance == 192);
  CHECK(all.outside->points == 2);
  CHECK(all.outside->unused == 2);
  CHECK(all.outside->tested == 11);
  REQUIRE(!all.notes.empty());
  CHECK(all.notes[0].starts_with("2 of the 2 points outside are used by no face"));
}

TEST_CASE("used points: a witness has the number that its point has in the file") {
  const Mesh input = cube_with_loose_points();
  // 4 x <= 3: the four corners at x = 1 are outside, each by a quarter.
  const Candidate cut = read_candidate_bytes(
      "4 0 0 -3\n-1 0 0 0\n0 1 0 -1\n0 -1 0 0\n0 0 1 -1\n0 0 -1 0\n", "cut.txt");
  const Verdict verdict = judged(input, cut, MeshPoints::Used);
  CHECK(verdict.outside->points == 4);
  CHECK(verdict.outside->unused == 0);
  const Witness& witness = verdict[ContainsInput].witness;
  REQUIRE(witness.input_point);
  CHECK(input.points[PointId(*witness.input_point)] == witness.point.value());
  CHECK(witness.point.value()[0] == 1);
  const std::string number = "point " + std::to_string(*witness.input_point) + " is worst";
  CHECK(verdict[ContainsInput].sentence.find(number) != std::string::npos);
}

TEST_CASE("used points: faces in a plane are flat, whatever lies beside them") {
  Mesh flat = cube_with_loose_points();
  flat.polygons = {flat.polygons[0]};
  VerifyRequest request;
  request.used = used_points(flat.points.size(), flat.polygons);
  const Mesh cube = box_mesh(box_of({0, 0, 0}));
  CHECK(std::holds_alternative<Verdict>(verify(flat.points, cube, request)));
  request.points = MeshPoints::Used;
  const auto outcome = verify(flat.points, cube, request);
  REQUIRE(std::holds_alternative<NotSolid>(outcome));
  // The basis has the numbers of the file: points of the face.
  for (const PointId p : std::get<FlatInput>(std::get<NotSolid>(outcome)).basis) {
    CHECK(request.used[p.index()]);
  }
  request.used.pop_back();
  CHECK(error_of([&] { (void)verify(flat.points, cube, request); }).code() ==
        ErrorCode::InvalidArgument);
}

TEST_CASE("used points: those of parts") {
  const Mesh input = cube_with_loose_points();
  const auto parts = parts_of_boxes({box_of({0, 0, 0})});
  const PartsVerdict all = verify_parts(input, parts);
  CHECK(all[CoversPoints].status == Status::Violated);
  CHECK(all[CoversPoints].witness.input_point == 0);
  CHECK(all[CoversPoints].witness.squared_distance == 192);
  CHECK(all.points == 11);
  CHECK(all.points_outside == 2);
  CHECK(all.unused_outside == 2);
  PartsRequest request;
  request.points = MeshPoints::Used;
  const PartsVerdict used = verify_parts(input, parts, request);
  CHECK(used.holds());
  CHECK(used.points == 8);
  REQUIRE(used.notes.size() == 1);
  CHECK(used.notes[0].starts_with("3 points of the input are used by no face, and not asked"));
}

TEST_CASE("used points: in requests by line") {
  const Mesh input = cube_with_loose_points();
  json request = {{"triangles", input.polygons}, {"points", json::array()}};
  for (const Point& p : input.points.doubles()) request["points"].push_back({p[0], p[1], p[2]});
  const Mesh cube = box_mesh(box_of({0, 0, 0}));
  json& vertices = request["candidate"]["vertices"] = json::array();
  for (const Point& p : cube.points.doubles()) vertices.push_back({p[0], p[1], p[2]});
  request["asks"] = "hull";
  const auto ask = [&] { return json::parse(answer_request(request.dump())); };
  json answer = ask();
  CHECK(answer["verdict"] == "violated");
  CHECK(answer["outside"] == json({{"points", 2},
                                   {"tested", 11},
                                   {"used_by_no_face", 2},
                                   {"worst_relative", answer["outside"]["worst_relative"]}}));
  request["judge_points"] = "used";
  CHECK(ask()["verdict"] == "holds");
  request["judge_points"] = "some";
  CHECK(ask()["error"]["code"] == "malformed");
  // Without faces, the input is its points.
  request["judge_points"] = "used";
  request.erase("triangles");
  CHECK(ask()["verdict"] == "violated");
}
