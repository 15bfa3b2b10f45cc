// SPDX-License-Identifier: MIT
// The public documents: each follows the schema of what the program prints; numbers in them are
// closed forms of a cube.
#include "convexact/json.hpp"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "cells.hpp"
#include "json_schema.hpp"

using namespace convexact;
using nlohmann::json;

namespace {

const PointSet& cube() {
  static const PointSet points(std::vector<Point>{
      {0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {0, 0, 2}, {2, 0, 2}, {0, 2, 2}, {2, 2, 2}});
  return points;
}

json parsed(const std::string& text, const char* schema) {
  json document = json::parse(text);
  CHECK(schema_complaint(schema, document) == "");
  return document;
}

// What the program says of its files, which the library has not.
json with_names(json document) {
  document["input"] = "in.obj";
  document["file"] = "out.obj";
  return document;
}

}  // namespace

TEST_CASE("to_json: results of simplify and of an inner run") {
  const auto result = require_solid(simplify(cube(), {.faces = 6}));
  const json document = parsed(to_json(result), "result");
  CHECK(document["output"]["halfspaces"] == 6);
  CHECK(document["volume"]["output"]["value"] == 8.0);
  CHECK(document["engine"] == name_of(Engine::Filtered));
  CHECK(to_json(result, -1).find('\n') == std::string::npos);
  const auto inner = require_solid(simplify_inner(cube(), {.vertices = 8}));
  CHECK(parsed(to_json(inner), "inner")["output"]["vertices"] == 8);
}

TEST_CASE("to_json: a hull") {
  const auto hull = require_solid(measure_hull(cube()));
  const json document = json::parse(to_json(hull, 10));
  CHECK(document["edges"] == 12);
  CHECK(document["area"]["decimal"] == "24");
  CHECK_FALSE(document["stages"].empty());
}

TEST_CASE("to_json: verdicts on a solid, on parts and on an order") {
  Mesh candidate{cube(), {}, {}};
  const auto verdict =
      require_solid(verify(cube(), candidate, {.claims = {ClaimCode::ContainsInput}}));
  const json one = with_names(json::parse(to_json(verdict)));
  CHECK(schema_complaint("verdict", one) == "");
  CHECK(one["verdict"] == "holds");

  const Mesh solid = support::mesh_of_cells({{0, 0, 0}});
  const PartsVerdict of_parts = verify_parts(solid, std::vector<NamedPart>{{"all", solid}}, {});
  const json several = with_names(json::parse(to_json(of_parts)));
  CHECK(schema_complaint("verdict", several) == "");
  CHECK(several["verdict"] == "holds");

  const auto order = require_solid(verify_order(cube(), {.bytes = "9\n"}));
  const json judged = parsed(to_json(order), "trace_verdict");
  CHECK(judged["holds"] == false);
}

TEST_CASE("to_json: a decomposition") {
  const DecomposeRequest request;
  const auto made = require_solid(decompose(support::mesh_of_cells(support::l_cells()), request));
  const json document = json::parse(to_json(made, request));
  CHECK(document["decomposition"] == 1);
  CHECK(document["parts"].size() == made.parts.size());
  CHECK(document["parts"][0]["name"] == "part_000");
  CHECK(document["method"] == name_of(DecomposeMethod::Hacd));
}

TEST_CASE("verify_order: rows of ids, of planes, and what cannot be read") {
  // A cube without a corner: the cut is facet 6 of the canonical order, the only one whose removal
  // is cheap, 1/48 of volume against an unbounded solid.
  std::vector<Point> points;
  for (const double x : {0.0, 1.0})
    for (const double y : {0.0, 1.0})
      for (const double z : {0.0, 1.0})
        if (x + y + z < 3) points.push_back({x, y, z});
  for (const Point& p : {Point(0.5, 1, 1), Point(1, 0.5, 1), Point(1, 1, 0.5)}) points.push_back(p);
  const PointSet cut(points);
  const auto judged = [&](const OrderText& text) { return require_solid(verify_order(cut, text)); };
  CHECK(judged({.bytes = "6\n"}).holds());
  CHECK(judged({.bytes = "2 2 2 -5\n"}).holds());
  CHECK(judged({.bytes = "6\n"}).steps[0].cost->rational() == Rational(1, 48));
  CHECK_FALSE(judged({.bytes = "0\n"}).holds());
  const TraceVerdict unreadable = judged({.bytes = "six\n"});
  CHECK_FALSE(unreadable.holds());
  CHECK(unreadable.claims[0].status == Status::Violated);
  CHECK(judged({.bytes = "0\n", .facets = "1 1 1 -2.5\n", .facets_path = "facets.txt"}).holds());
  CHECK(judged({.bytes = "6\n"}).stages.size() >= 3);
  CHECK(
      std::holds_alternative<NotSolid>(verify_order(PointSet(std::vector<Point>{{0, 0, 0}}), {})));
}
