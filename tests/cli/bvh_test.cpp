// SPDX-License-Identifier: MIT
// convexact bvh, decompose --tree, and what query and verify say of trees: files, answers, and
// trees that are refused.
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cells.hpp"
#include "convexact/number.hpp"
#include "json_schema.hpp"
#include "process.hpp"
#include "program_json.hpp"

using convexact::Rational;
using nlohmann::json;
using support::bytes_of;
using support::data;
using support::program_json;
using support::Ran;
using support::run_program;
using support::ScratchFolder;

namespace {

std::string obj_with(const support::Mesh& mesh) {
  std::ostringstream text;
  for (const support::Point& p : mesh.points.doubles()) {
    text << "v " << p[0] << " " << p[1] << " " << p[2] << "\n";
  }
  for (const auto& polygon : mesh.polygons) {
    text << "f";
    for (const std::uint32_t corner : polygon) text << " " << corner + 1;
    text << "\n";
  }
  return text.str();
}

// Four steps, which are no less than four convex parts.
std::string stairs_obj() {
  std::set<support::Cell> cells;
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y <= x; ++y) cells.insert({x, y, 0});
  }
  return obj_with(support::mesh_of_cells(cells));
}

json tree_of(const std::string& path) {
  json document = json::parse(bytes_of(path));
  CHECK(schema_complaint("hull-tree", document) == "");
  return document;
}

json printed(const std::string& arguments, const char* schema, int exit = 0) {
  return program_json(arguments, schema, exit);
}

const json& claim_in(const json& verdict, const std::string& code) {
  for (const json& claim : verdict["claims"]) {
    if (claim["code"] == code) return claim;
  }
  FAIL("no claim " << code);
  return verdict;
}

// Six integer points around a unit cube.
std::string cube_at(int x) { return obj_with(support::box_mesh(support::box_of({x, 0, 0}))); }

}  // namespace

TEST_CASE("bvh: a tree of decomposed parts is accepted by the oracle, by either method") {
  const ScratchFolder scratch;
  const std::string mesh = scratch.write("stairs.obj", stairs_obj());
  const std::string tree = scratch.file("tree.json");
  for (const std::string method : {"hacd", "acd"}) {
    for (const std::string options :
         {"", " --faces 5", " --leaf-faces 5 --faces 4 --precision 32"}) {
      CAPTURE(method);
      CAPTURE(options);
      const json answer =
          printed("bvh " + mesh + " --concavity 1% --method " + method + options + " -o " + tree,
                  "hull-tree");
      const json file = tree_of(tree);
      CHECK(file["nodes"] == answer["nodes"]);
      CHECK(file["parts_from"] == method);
      CHECK(file["uncovered_pieces"] == 0);
      const std::size_t parts = file["parts"].size();
      CHECK(parts >= 4);
      CHECK(file["hull_tree"].size() == 2 * parts - 1);
      CHECK(file["joins"]["by_method"] == parts - 1);
      const json verdict = printed("verify " + mesh + " " + tree, "verdict");
      CHECK(claim_in(verdict, "tree-nested")["status"] == "holds");
      CHECK(claim_in(verdict, "covers-surface")["status"] == "holds");
    }
  }
}

TEST_CASE("bvh --join volume: parts of a decomposition, joined as those of a file") {
  const ScratchFolder scratch;
  const std::string mesh = scratch.write("stairs.obj", stairs_obj());
  const std::string parts = scratch.file("parts.obj"), tree = scratch.file("tree.json");
  REQUIRE(run_program("decompose --method hacd " + mesh + " --concavity 1% -o " + parts).exit == 0);
  const json from = [&] {
    (void)printed("bvh " + mesh + " --from " + parts + " -o " + tree, "hull-tree");
    return tree_of(tree);
  }();
  const json joined = [&] {
    (void)printed("bvh " + mesh + " --concavity 1% --join volume -o " + tree, "hull-tree");
    return tree_of(tree);
  }();
  CHECK(joined["joins"]["by_method"] == 0);
  REQUIRE(joined["hull_tree"].size() == from["hull_tree"].size());
  for (std::size_t i = 0; i < from["hull_tree"].size(); ++i) {
    for (const char* key : {"parent", "children", "part", "facets"}) {
      CHECK(joined["hull_tree"][i][key] == from["hull_tree"][i][key]);
    }
  }
  CHECK(joined["levels"] == from["levels"]);
  CHECK(run_program("bvh " + mesh + " --from " + parts + " --join volume").exit == 2);
}

TEST_CASE("bvh --from: parts of a file, joined by volume; what they leave uncovered is said") {
  const ScratchFolder scratch;
  const std::string mesh = scratch.write("mesh.obj", stairs_obj());
  const std::string tree = scratch.file("tree.json");
  const std::string parts =
      scratch.write("parts.obj", "o low\n" + cube_at(0) +
                                     "o high\nv 2 0 0\nv 3 0 0\nv 2 1 0\nv 2 0 1\n"
                                     "f 9 11 10\nf 9 10 12\nf 9 12 11\nf 10 11 12\n");
  const json file = [&] {
    const json answer = printed("bvh " + mesh + " --from " + parts + " -o " + tree, "hull-tree");
    CHECK(answer["uncovered_pieces"] > 0);
    CHECK(answer["joins"]["by_volume"] == 1);
    return tree_of(tree);
  }();
  CHECK(file["parts"][0]["name"] == "low");
  CHECK(file["hull_tree"][0]["children"] == json({1, 2}));
  // The union does not hold the mesh, but the tree is one.
  const json verdict = printed("verify " + mesh + " " + tree, "verdict", 1);
  CHECK(claim_in(verdict, "tree-nested")["status"] == "holds");
  CHECK(claim_in(verdict, "covers-surface")["status"] == "violated");
  const Ran text = run_program("bvh " + mesh + " --from " + parts);
  CHECK(text.exit == 0);
  CHECK(text.out.find("by the least volume of the common hull") != std::string::npos);
  CHECK(text.out.find("not all:") != std::string::npos);
  CHECK(text.out.find("nothing; -o tree.json keeps the tree") != std::string::npos);
}

TEST_CASE("bvh --from: a sheet in the plane of the root's facet is thickened") {
  const ScratchFolder scratch;
  const std::string mesh = scratch.write("mesh.obj", stairs_obj());
  const std::string tree = scratch.file("tree.json");
  const std::string parts = scratch.write(
      "parts.obj", "o box\n" + cube_at(0) + "o sheet\nv 3 0 1\nv 4 0 1\nv 4 1 1\nf 9 10 11\n");
  const json answer = printed("bvh " + mesh + " --from " + parts + " -o " + tree, "hull-tree");
  double top = 0;
  const json file = tree_of(tree);
  for (const json& vertex : file["hull_tree"][0]["vertices"]) {
    top = std::max(top, vertex[2].get<double>());
  }
  CHECK(top > 1);  // the root sticks out of the hull of the input
  const json verdict = printed("verify " + mesh + " " + tree + " --claims tree-nested", "verdict");
  CHECK(claim_in(verdict, "tree-nested")["status"] == "holds");
}

TEST_CASE("decompose --tree: the tree is over the parts that the same run writes") {
  const ScratchFolder scratch;
  const std::string mesh = scratch.write("stairs.obj", stairs_obj());
  const std::string tree = scratch.file("tree.json"), parts = scratch.file("parts.json");
  const Ran ran =
      run_program("decompose --method hacd " + mesh + " --concavity 1% --total-faces 40 --tree " +
                  tree + " --tree-faces 5 -o " + parts);
  REQUIRE_MESSAGE(ran.exit == 0, ran.err);
  CHECK(ran.out.find(tree) != std::string::npos);
  const json file = tree_of(tree), list = json::parse(bytes_of(parts));
  REQUIRE(file["parts"].size() == list["parts"].size());
  for (std::size_t k = 0; k < list["parts"].size(); ++k) {
    CHECK(file["parts"][k]["name"] == list["parts"][k]["name"]);
    CHECK(file["parts"][k]["vertices"] == list["parts"][k]["vertices"]);
  }
  CHECK(printed("verify " + mesh + " " + tree, "verdict")["verdict"] == "holds");
}

TEST_CASE("verify: a tree that is none is refused, and the claim says which node or part") {
  const ScratchFolder scratch;
  const std::string mesh = scratch.write("stairs.obj", stairs_obj());
  const std::string tree = scratch.file("tree.json"), bad = scratch.file("bad.json");
  REQUIRE(run_program("bvh " + mesh + " --concavity 1% -o " + tree).exit == 0);
  const json good = tree_of(tree);
  const std::size_t last = good["hull_tree"].size() - 1;  // a leaf
  const auto damaged = [&](const std::function<void(json&)>& damage, const std::string& sentence,
                           const json& nodes) {
    json file = good;
    damage(file);
    scratch.write("bad.json", file.dump());
    const json verdict = printed("verify " + mesh + " " + bad, "verdict", 1);
    const json& claim = claim_in(verdict, "tree-nested");
    CHECK(claim["status"] == "violated");
    CHECK_MESSAGE(claim["sentence"].get<std::string>().find(sentence) != std::string::npos,
                  claim["sentence"]);
    const json witness = claim.value("witness", json::object());
    if (!nodes.is_null()) CHECK(witness.value("nodes", json::array()) == nodes);
    const Ran asked = run_program("query overlap " + bad + " " + mesh);
    CHECK(asked.exit == 3);
    CHECK_MESSAGE(asked.err.find(sentence) != std::string::npos, asked.err);
    return claim;
  };
  // A corner of the root, moved inward by one unit in the last place.
  const json claim = damaged(
      [](json& file) {
        for (json& vertex : file["hull_tree"][0]["vertices"]) {
          if (vertex == json({4.0, 4.0, 1.0})) vertex[0] = std::nextafter(4.0, 0.0);
        }
      },
      "node 0 does not hold its child", nullptr);
  CHECK(claim["witness"]["nodes"][0] == 0);
  CHECK(claim["witness"].contains("plane"));
  CHECK(claim["witness"]["point"].size() == 3);
  CHECK(claim["witness"].contains("distance"));
  const std::size_t parent = good["hull_tree"][last]["parent"];
  damaged([&](json& file) { file["hull_tree"][last]["parent"] = 0; },
          "node " + std::to_string(parent) + " names node " + std::to_string(last), {parent, last});
  damaged([&](json& file) { file["hull_tree"][0]["parent"] = 0; }, "no node is the root", {0});
  damaged([&](json& file) { file["parts"].push_back(file["parts"][0]); }, "is missing: no leaf",
          json::array());
  damaged([&](json& file) { file["hull_tree"] = json::array(); }, "there is no node",
          json::array());
}

TEST_CASE("verify: tree-nested by name needs a tree; a broken one cannot be read") {
  const ScratchFolder scratch;
  const std::string mesh = scratch.write("stairs.obj", stairs_obj());
  const std::string parts = scratch.file("parts.obj"), tree = scratch.file("tree.json");
  REQUIRE(
      run_program("decompose --method hacd " + mesh + " -o " + parts + " --tree " + tree).exit ==
      0);
  const json verdict =
      printed("verify " + mesh + " " + parts + " --union --claims tree-nested", "verdict", 1);
  CHECK(claim_in(verdict, "tree-nested")["status"] == "not-applicable");
  const json good = tree_of(tree);
  const std::pair<std::function<void(json&)>, const char*> cases[] = {
      {[](json& node) { node["parent"] = -1; }, "the parent of node"},
      {[](json& node) { node["parent"] = "0"; }, "the parent of node"},
      {[](json& node) { node["children"] = 3; }, "the children of node"},
      {[](json& node) { node["children"] = {0.5}; }, "the children of node"},
      {[](json& node) { node["node"] = 77; }, "in its place"},
      {[](json& node) {
         node["vertices"] = json::array({{1, 2}});
       },
       "vertex 0"},
      {[](json& node) { node.erase("vertices"); }, "with a part or with vertices"},
      {[](json& node) { node = 5; }, "as an object"}};
  for (const auto& [damage, expected] : cases) {
    json file = good;
    damage(file["hull_tree"][0]);
    const std::string bad = scratch.write("bad.json", file.dump());
    const json refused = printed("verify " + mesh + " " + bad, "verdict", 1);
    const std::string sentence = claim_in(refused, "parts-readable")["sentence"];
    CHECK_MESSAGE(sentence.find(expected) != std::string::npos, sentence);
    CHECK(run_program("query overlap " + bad + " " + mesh).exit == 3);
  }
}

TEST_CASE("query: rays and solids against a tree, answers by hand") {
  const ScratchFolder scratch;
  const std::string mesh = scratch.write("stairs.obj", stairs_obj());
  const std::string parts =
      scratch.write("parts.obj", "o a\n" + cube_at(0) +
                                     "o b\nv 2 0 0\nv 3 0 0\nv 2 1 0\nv 2 0 1\nf 9 11 10\n"
                                     "f 9 10 12\nf 9 12 11\nf 10 11 12\n");
  const std::string tree = scratch.file("tree.json");
  REQUIRE(run_program("bvh " + mesh + " --from " + parts + " -o " + tree).exit == 0);
  const std::string rays = scratch.write(
      "rays.txt", "-1 1/4 1/4 1 0 0\n9 1/4 1/4 -2 0 0\n-1 9 9 1 0 0\n1/2 1/2 1/2 0 0 1\n");
  const json answer = printed("query rays " + tree + " " + rays, "query");
  CHECK(answer["hits"] == 3);
  CHECK(answer["rays"][0]["t"]["exact"] == "1");
  CHECK(answer["rays"][0]["parts"] == json::array({0}));
  CHECK(answer["rays"][1]["t"]["exact"] == "13/4");  // x + y + z = 3 at x = 5/2
  CHECK(answer["rays"][1]["parts"] == json({1}));
  CHECK(answer["rays"][2] ==
        json({{"hit", false}, {"parts", json::array()}, {"visited", json::array({0})}}));
  CHECK(answer["rays"][3]["t"]["exact"] == "0");
  CHECK(answer["visited"] == 3 + 3 + 1 + 3);
  const Ran text = run_program("query rays " + tree + " " + rays);
  CHECK(text.out.find("miss   1 node visited") != std::string::npos);

  const std::string touching = scratch.write("touching.obj", cube_at(1));
  const json overlap = printed("query overlap " + tree + " " + touching, "query");
  CHECK(overlap["parts"] == json({0, 1}));  // it touches both
  CHECK(overlap["visited"].size() == 3);
  const std::string away = scratch.write("away.obj", cube_at(7));
  const json apart = printed("query overlap " + tree + " " + away, "query");
  CHECK(apart["overlap"] == false);
  REQUIRE(apart["visited"].size() == 1);
  CHECK(apart["visited"][0].contains("separating_plane"));
  CHECK(run_program("query overlap " + tree + " " + away).out.find("apart:") != std::string::npos);
}

TEST_CASE("bvh: wrong usage, wrong files, flat input; nothing is written") {
  const ScratchFolder scratch;
  const std::string mesh = scratch.write("stairs.obj", stairs_obj());
  const std::string tree = scratch.file("tree.json");
  const std::string flat =
      scratch.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n");
  const auto refused = [&](const std::string& arguments, int exit, const std::string& expected) {
    const Ran ran = run_program("bvh " + arguments);
    CAPTURE(arguments);
    CHECK(ran.exit == exit);
    CHECK_MESSAGE(ran.err.find(expected) != std::string::npos, ran.err);
    CHECK_FALSE(std::filesystem::exists(tree));
  };
  refused(mesh + " -o tree.obj", 2, "ends in .json");
  refused(mesh + " --faces 3 -o " + tree, 2, "--faces");
  refused(mesh + " --leaf-faces 3 -o " + tree, 2, "--leaf-faces");
  refused(mesh + " --from x.obj --method acd -o " + tree, 2, "--from");
  refused(mesh + " --from " + scratch.file("none.obj") + " -o " + tree, 3, "none.obj");
  refused(mesh + " --from " + scratch.write("empty.obj", "") + " -o " + tree, 4, "no part");
  refused(
      mesh + " --from " + scratch.write("nan.obj", "v 0 0 nan\nv 1 0 0\nf 1 2 2\n") + " -o " + tree,
      3, "nan.obj:1");
  refused(scratch.file("none.obj") + " -o " + tree, 3, "none.obj");
  refused(flat + " -o " + tree, 4, "");
  const std::string points = scratch.write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n");
  refused(mesh + " -o " + scratch.file("no/such/tree.json"), 5, "tree.json");
  const Ran decompose = run_program("decompose --method hacd " + mesh + " --tree-faces 8");
  CHECK(decompose.exit == 2);
  CHECK(decompose.err.find("--tree") != std::string::npos);
  CHECK(run_program("decompose --method hacd " + mesh + " --tree tree.obj").exit == 2);
}
