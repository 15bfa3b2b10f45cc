// SPDX-License-Identifier: MIT
// The files of parts, their document, and what the proof of their bytes notices.
#include "wire/written_parts.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "cells.hpp"
#include "convexact/error.hpp"
#include "convexact/verify_parts.hpp"
#include "expect_error.hpp"
#include "io/json_document.hpp"
#include "wire/decompose_report.hpp"

using namespace convexact;

namespace {

// An L of three cells in two parts.
struct TwoParts {
  DecomposeRequest request;
  Decomposition made =
      std::get<Decomposition>(decompose(support::mesh_of_cells(support::l_cells()), request));

  std::vector<WrittenPart> written() const {
    return {{"a", &made.parts[0], &made.surface}, {"b", &made.parts[1], &made.surface}};
  }
  std::string obj() const { return proven_parts_mesh(written(), MeshFormat::Obj, "x.obj"); }
  std::string json() const {
    const std::vector<std::string> names = {"a", "b"};
    return proven_parts_json(decomposition_json(made, request, names, DecompositionDetail::All),
                             written(), "x.json");
  }
  // A corner of a part, somewhat towards its middle.
  void move_corner() {
    std::vector<Point> points(made.parts[1].mesh.points.doubles().begin(),
                              made.parts[1].mesh.points.doubles().end());
    Point middle = Point::Zero();
    for (const Point& p : points) middle += p / static_cast<double>(points.size());
    points[0] += (middle - points[0]) / 1024;
    made.parts[1].mesh.points = PointSet(points);
  }
};

template <class Action>
bool is_noticed(Action&& action) {
  return error_of(action).code() == ErrorCode::Internal;
}

}  // namespace

TEST_CASE("written parts: the bytes are what a reader of parts reads") {
  const TwoParts l;
  REQUIRE(l.made.parts.size() == 2);
  for (const auto& [bytes, path] : {std::pair(l.obj(), "x.obj"), std::pair(l.json(), "x.json")}) {
    const auto read = std::get<std::vector<NamedPart>>(read_parts_bytes(bytes, path));
    REQUIRE(read.size() == 2);
    CHECK(read[1].name == "b");
    for (std::size_t k = 0; k < 2; ++k) {
      const auto found = read[k].mesh.points.doubles(),
                 kept = l.made.parts[k].mesh.points.doubles();
      CHECK(std::is_permutation(found.begin(), found.end(), kept.begin(), kept.end()));
    }
  }
}

TEST_CASE("written parts: a corner moved inward is noticed in every file") {
  TwoParts l;
  l.move_corner();
  CHECK(is_noticed([&] { return l.obj(); }));
  CHECK(is_noticed([&] { return l.json(); }));
}

TEST_CASE("written parts: halfspaces that miss an owned triangle are noticed in JSON") {
  TwoParts l;
  auto& halfspaces = l.made.parts[0].halfspaces;
  halfspaces[0] = Halfspace(halfspaces[0].normal(), halfspaces[0].offset() + 1);
  CHECK(is_noticed([&] { return l.json(); }));
  halfspaces.clear();
  CHECK(is_noticed([&] { return l.json(); }));
}

TEST_CASE("written parts: an owner of too much, and parts that a reader would take for one") {
  TwoParts l;
  std::swap(l.made.parts[0].owns, l.made.parts[1].owns);
  CHECK(is_noticed([&] { return l.obj(); }));
  const TwoParts same;
  std::vector<WrittenPart> parts = same.written();
  parts[1].name = parts[0].name;
  CHECK(is_noticed([&] { return proven_parts_mesh(parts, MeshFormat::Obj, "x.obj"); }));
}

TEST_CASE("written parts: of several objects, their documents and all parts together") {
  const TwoParts l;
  const std::vector<DecomposedObject> objects = {{"left", l.made, {"a", "b"}, l.request},
                                                 {"right", l.made, {"c", "d"}, l.request}};
  const auto document = decomposition_json(objects, DecompositionDetail::All);
  REQUIRE(document["objects"].size() == 2);
  CHECK(document["objects"][1]["name"] == "right");
  CHECK_FALSE(document["objects"][1].contains("parts"));
  CHECK(document["eps_holds"] == true);
  REQUIRE(document["parts"].size() == 4);
  CHECK(document["parts"][2]["name"] == "c");
  CHECK(document["parts"][2]["object"] == 1);
  const auto bytes = proven_parts_json(document, written_parts(objects), "x.json");
  CHECK(std::get<std::vector<NamedPart>>(read_parts_bytes(bytes, "x.json")).size() == 4);
  CHECK(decomposition_json(std::span(objects).first(1), DecompositionDetail::All) ==
        decomposition_json(l.made, l.request, objects[0].part_names, DecompositionDetail::All));
}
