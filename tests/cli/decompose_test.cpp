// SPDX-License-Identifier: MIT
// convexact decompose: files, answers, refusals. Shapes of unit cells, whose volumes can be
// counted.
#include <doctest/doctest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "cells.hpp"
#include "convexact/number.hpp"
#include "json_schema.hpp"
#include "process.hpp"
#include "program_json.hpp"
#include "sweep.hpp"

using convexact::parse_rational;
using convexact::Rational;
using nlohmann::json;
using support::bytes_of;
using support::program_json;
using support::run_program;
using support::ScratchFolder;

namespace {

std::string obj_text(const support::Mesh& mesh, std::size_t first = 1,
                     const std::string& name = "") {
  std::ostringstream text;
  if (!name.empty()) text << "o " << name << "\n";
  for (const support::Point& p : mesh.points.doubles()) {
    text << "v " << p[0] << " " << p[1] << " " << p[2] << "\n";
  }
  for (const auto& polygon : mesh.polygons) {
    text << "f";
    for (const std::uint32_t corner : polygon) text << " " << corner + first;
    text << "\n";
  }
  return text.str();
}

std::string obj_of_cells(const std::set<support::Cell>& cells) {
  return obj_text(support::mesh_of_cells(cells));
}

// Two cubes that have no point in common, or only a corner, each an object.
std::string two_cubes(int apart) {
  return obj_text(support::box_mesh(support::box_of({0, 0, 0})), 1, "left") +
         obj_text(support::box_mesh(support::box_of({apart, apart, apart})), 9, "right");
}

std::string point_line(const std::string& x, const std::string& y, const std::string& z) {
  return "v " + x + " " + y + " " + z + "\n";
}

// Most of these tests are about clusters of triangles.
std::string by_clusters(const std::string& arguments) {
  const bool is_named = arguments.find("--method") != std::string::npos;
  return (is_named ? "" : "--method hacd ") + arguments;
}

json decomposed(const std::string& arguments) {
  return program_json("decompose " + by_clusters(arguments), "decompose");
}

json parts_document(const std::string& path) {
  const json document = json::parse(bytes_of(path));
  CHECK(schema_complaint("decompose", document) == "");
  return document;
}

bool is_accepted(const std::string& input, const std::string& parts,
                 const std::string& options = "") {
  const auto ran = run_program("verify " + input + " " + parts + " --union " + options);
  INFO(ran.out);
  INFO(ran.err);
  CHECK(ran.exit == 0);
  return ran.exit == 0;
}

Rational exact(const json& measured) {
  return parse_rational(measured["exact"].get<std::string>());
}

// Triangles that are joined by pairs of them: by triangle, the lowest one of its cluster.
struct Clusters {
  std::vector<std::size_t> lowest;

  explicit Clusters(std::size_t count) : lowest(count) {
    std::iota(lowest.begin(), lowest.end(), std::size_t(0));
  }
  void join(std::size_t a, std::size_t b) {
    const std::size_t low = std::min(lowest[a], lowest[b]), high = std::max(lowest[a], lowest[b]);
    for (std::size_t& each : lowest) {
      if (each == high) each = low;
    }
  }
};

struct Refusal {
  std::string options;
  int exit;
  std::string says;
};

}  // namespace

TEST_CASE("decompose: an L in two parts, in every kind of file, and verify accepts each") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("l.obj", obj_of_cells(support::l_cells()));
  const std::string one = scratch.file("one.obj"), list = scratch.file("one.json"),
                    folder = scratch.file("folder/");
  const json answer =
      decomposed(input + " --exact-volumes -o " + one + " -o " + list + " -o " + folder);
  CHECK(answer["parts"].size() == 2);
  CHECK(answer["eps_holds"] == true);
  CHECK(answer["stop"] == "concavity");
  CHECK(answer["covers"] == "surface");
  CHECK(answer["surface"]["triangles"] == 28);  // two for each of 14 squares
  CHECK(answer["verified"]["triangles"] == 28);
  CHECK(exact(answer["solid"]) == 3);
  CHECK(exact(answer["solid"]) + exact(answer["excess"]) ==
        exact(answer["union"]) + exact(answer["uncovered"]));
  CHECK(answer["parts"][1]["name"] == "part_001");
  CHECK_FALSE(answer["parts"][0].contains("owns"));
  for (const std::string& parts : {one, list, folder}) CHECK(is_accepted(input, parts));
  CHECK(std::filesystem::exists(folder + "part_000.obj"));
  CHECK(std::filesystem::exists(folder + "part_001.obj"));
  CHECK(bytes_of(one).find("o part_001\n") != std::string::npos);
  CHECK(parts_document(folder + "parts.json")["parts"][1]["file"] == "part_001.obj");
}

TEST_CASE("decompose: owners, forest and trace tell the same partition") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("cross.obj", obj_of_cells(support::cross_cells()));
  const std::string list = scratch.file("cross.json"), trace = scratch.file("trace.json");
  decomposed(input + " -o " + list + " --trace " + trace);
  const json document = parts_document(list);
  const std::size_t count = document["surface"]["triangles"];
  REQUIRE(count == 60);  // two for each of 6 times 5 squares
  std::vector<std::size_t> owner(count, count);
  for (std::size_t k = 0; k < document["parts"].size(); ++k) {
    for (const std::size_t t : document["parts"][k]["owns"]) {
      CHECK(owner[t] == count);
      owner[t] = k;
    }
  }
  CHECK(std::count(owner.begin(), owner.end(), count) == 0);
  // Two triangles of each face of the input.
  std::map<std::size_t, int> triangles_of;
  for (const std::size_t face : document["face_of"]) ++triangles_of[face];
  CHECK(triangles_of.size() == 30);
  // The forest: each triangle under one root, and that root names its owner.
  std::vector<std::size_t> seen(count);
  for (const json& node : document["tree"]) {
    if (!node.contains("triangles")) continue;
    json root = node;
    while (!root["parent"].is_null()) root = document["tree"][root["parent"].get<std::size_t>()];
    for (const std::size_t t : node["triangles"]) {
      ++seen[t];
      CHECK(root["part"] == owner[t]);
    }
  }
  CHECK(std::count(seen.begin(), seen.end(), std::size_t(1)) == std::ptrdiff_t(count));
  // The trace.
  const json merges = json::parse(bytes_of(trace));
  CHECK(schema_complaint("decompose-trace", merges) == "");
  CHECK(merges["triangles"].size() == count);
  const Rational limit = parse_rational(merges["concavity"]["squared"].get<std::string>());
  CHECK(limit == Rational(27 * 9, 10000));  // 3% of the diagonal of a cube of side 3
  Clusters clusters(count);
  for (const json& pair : merges["united"]) clusters.join(pair[0], pair[1]);
  for (const json& merge : merges["merges"]) {
    CHECK(clusters.lowest[merge["kept"]] == merge["kept"]);
    CHECK(clusters.lowest[merge["gone"]] == merge["gone"]);
    CHECK(parse_rational(merge["squared_concavity"].get<std::string>()) <= limit);
    CHECK(merge["cost"]["low"].get<double>() <= merge["cost"]["high"].get<double>());
    clusters.join(merge["kept"], merge["gone"]);
  }
  for (std::size_t s = 0; s < count; ++s) {
    for (std::size_t t = 0; t < s; ++t) {
      CHECK((clusters.lowest[s] == clusters.lowest[t]) == (owner[s] == owner[t]));
    }
  }
}

TEST_CASE("decompose --method acd: owners, tree and trace tell the same partition") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("cross.obj", obj_of_cells(support::cross_cells()));
  const std::string list = scratch.file("cross.json"), trace = scratch.file("trace.json"),
                    parts = scratch.file("cross.obj.parts.obj");
  const json answer = decomposed(input + " --method acd -o " + list + " -o " + parts + " --trace " +
                                 trace + " --picture " + scratch.file("x.html"));
  CHECK(is_accepted(input, parts));
  CHECK(answer["method"] == "acd");
  const json document = parts_document(list);
  const std::size_t count = document["surface"]["triangles"];
  std::vector<std::size_t> owner(count, count);
  for (std::size_t k = 0; k < document["parts"].size(); ++k) {
    for (const std::size_t t : document["parts"][k]["owns"]) owner[t] = k;
  }
  std::vector<std::size_t> seen(count);
  std::size_t leaves = 0;
  for (const json& node : document["tree"]) {
    CHECK(node.contains("triangles") != node.contains("children"));
    if (!node.contains("triangles")) continue;
    ++leaves;
    for (const std::size_t t : node["triangles"]) {
      ++seen[t];
      CHECK(node["part"] == owner[t]);
    }
  }
  CHECK(std::count(seen.begin(), seen.end(), std::size_t(1)) == std::ptrdiff_t(count));
  CHECK(leaves == answer["splits"]["count"].get<std::size_t>() + 1);
  const json splits = json::parse(bytes_of(trace));
  CHECK(schema_complaint("decompose-acd-trace", splits) == "");
  CHECK(splits["nodes"].size() == document["tree"].size());
  // A replay: what moved and the islands are the second child, counted down from the root.
  std::vector<std::size_t> triangles(splits["nodes"].size());
  triangles[0] = count;
  for (const json& split : splits["splits"]) {
    const std::size_t gone = split["moved"].size() + split["islands"].size();
    triangles[split["children"][1].get<std::size_t>()] = gone;
    triangles[split["children"][0].get<std::size_t>()] =
        triangles[split["node"].get<std::size_t>()] - gone;
    CHECK(splits["nodes"][split["node"].get<std::size_t>()]["notch"] == split["edge"][0]);
  }
  for (std::size_t n = 0; n < triangles.size(); ++n) {
    CHECK(splits["nodes"][n]["triangles"] == triangles[n]);
  }
  CHECK(bytes_of(scratch.file("x.html")).find("id=\"splits\"") != std::string::npos);
}

TEST_CASE("decompose: triangles without area begin in the cluster of a neighbour") {
  const ScratchFolder scratch;
  // A tetrahedron with a point in the middle of an edge, on which a sliver without area hangs: it
  // is united over its longest edge, 2 to 3.
  const std::string input = scratch.write("t.obj",
                                          "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nv 1 1 0\n"
                                          "f 1 3 2\nf 1 2 4\nf 2 5 4\nf 5 3 4\nf 3 1 4\nf 2 3 5\n");
  const std::string list = scratch.file("t.json"), trace = scratch.file("trace.json");
  decomposed(input + " -o " + list + " --trace " + trace);
  const json document = parts_document(list);
  CHECK(document["surface"]["flat_triangles"] == 1);
  const json united = json::parse(bytes_of(trace))["united"];
  REQUIRE(united.size() == 1);
  const std::size_t flat = united[0][0], over = united[0][1];
  CHECK(document["face_of"][flat] == 5);
  CHECK(document["face_of"][over] == 0);
  std::size_t leaves = 0;
  for (const json& node : document["tree"]) {
    if (!node.contains("triangles")) continue;
    ++leaves;
    if (node["triangles"].size() == 1) continue;
    CHECK(node["triangles"] == json::array({std::min(flat, over), std::max(flat, over)}));
  }
  CHECK(leaves == 5);
}

TEST_CASE("decompose: a convex input is one part, its hull") {
  const ScratchFolder scratch;
  const std::string input =
      scratch.write("cube.obj", obj_text(support::box_mesh(support::box_of({0, 0, 0}))));
  const json answer = decomposed(input + " --concavity 0 --exact-volumes");
  REQUIRE(answer["parts"].size() == 1);
  CHECK(answer["parts"][0]["corners"] == 8);
  CHECK(answer["parts"][0]["facets"] == 6);
  CHECK(answer["parts"][0]["form"] == "hull");
  CHECK(answer["parts"][0]["concavity"]["squared"] == "0");
  CHECK(exact(answer["solid"]) == 1);
  CHECK(exact(answer["excess"]) == 0);
  CHECK(exact(answer["uncovered"]) == 0);
  CHECK(exact(answer["overlap"]) == 0);
  // The same cube as halfspaces.
  const std::string rows =
      scratch.write("cube.txt", "1 0 0 -1\n-1 0 0 0\n0 1 0 -1\n0 -1 0 0\n0 0 1 -1\n0 0 -1 0\n");
  CHECK(decomposed(rows)["parts"].size() == 1);
  const std::string out = scratch.file("cube_parts.obj");
  decomposed(input + " -o " + out);
  CHECK(is_accepted(input, out));
}

TEST_CASE("decompose: a budget that leads beyond the concavity allowed is said") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("l.obj", obj_of_cells(support::l_cells()));
  const std::string out = scratch.file("out.obj");
  const json answer = decomposed(input + " --max-parts 1 --exact-volumes -o " + out);
  CHECK(answer["parts"].size() == 1);
  CHECK(answer["eps_holds"] == false);
  CHECK(answer["stop"] == "max-parts");
  CHECK(answer["merges"]["beyond_eps"] == 1);
  CHECK(answer["parts"][0]["status"] == "beyond-eps");
  CHECK(exact(answer["union"]) == Rational(7, 2));  // a square of side 2 without a corner of 1/2
  CHECK(exact(answer["excess"]) == Rational(1, 2));
  CHECK(is_accepted(input, out));
  const auto text = run_program("decompose --method hacd " + input + " --max-parts 1");
  CHECK(text.exit == 0);
  CHECK(text.out.find("limit       not held: 1 of 1 part is more concave than 3%") !=
        std::string::npos);
  // A budget that holds anyway changes nothing.
  const json two = decomposed(input + " --max-parts 2");
  CHECK(two["eps_holds"] == true);
  CHECK(two["merges"]["beyond_eps"] == 0);
  // As much concavity as there is: one part.
  CHECK(decomposed(input + " --concavity 100%")["eps_holds"] == true);
  CHECK(decomposed(input + " --concavity 100%")["parts"].size() == 1);
}

TEST_CASE("decompose: JSON measures everything, unless it is told not to") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("l.obj", obj_of_cells(support::l_cells()));
  const std::string file = scratch.file("parts.json");
  REQUIRE(run_program("decompose --method hacd " + input + " -o " + file).exit == 0);
  for (const json& document : std::array{decomposed(input), json::parse(bytes_of(file))}) {
    for (const char* name : {"solid", "uncovered", "excess", "union", "overlap"}) {
      CAPTURE(name);
      CHECK(document.contains(name));
    }
  }
  const json some = decomposed(input + " --measures uncovered");
  CHECK(some.contains("uncovered"));
  CHECK_FALSE(some.contains("excess"));
  CHECK_FALSE(decomposed(input + " --measures none").contains("uncovered"));
}

TEST_CASE("decompose: the text for people") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("l.obj", obj_of_cells(support::l_cells()));
  const auto ran = run_program("decompose --method hacd " + input);
  REQUIRE(ran.exit == 0);
  for (const char* text :
       {"28 triangles on 16 points, 1 component, closed: it bounds a solid", "parts       2, of at",
        "limit       holds: no cluster is more concave than 3% of the diameter, a length of 0.09",
        "covers      surface: each of 28 triangles lies in the part that owns it, tested exactly",
        "hollow      nothing: the parts hold the solid", "reach       not limited: --method cut",
        "left out    excess, and volume and overlap of the parts",
        "2 with corners of the input, bit by bit", "nothing; -o parts.obj keeps the parts"}) {
    CAPTURE(text);
    CHECK(ran.out.find(text) != std::string::npos);
  }
  CHECK(ran.out.find("contain") == std::string::npos);
  const auto length =
      run_program("decompose --method hacd --measures none --concavity 0.3 " + input);
  CHECK(length.out.find("a length of 0.3, 10% of the diameter") != std::string::npos);
  CHECK(length.out.find("hollow") == std::string::npos);
  CHECK(length.out.find("left out    all volumes") != std::string::npos);
  const auto all = run_program("decompose --method hacd --measures all " + input);
  CHECK(all.out.find("of the parts is outside of the solid") != std::string::npos);
  CHECK(all.out.find("the parts overlap by") != std::string::npos);
  CHECK(all.out.find("left out") == std::string::npos);
  // An open surface encloses nothing that could be uncovered.
  const std::string open =
      scratch.write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\n");
  const json answer = decomposed(open);
  CHECK(answer["surface"]["closed"] == false);
  CHECK(answer["solid"].is_null());
  CHECK(answer["uncovered"].is_null());
  CHECK(run_program("decompose --method hacd " + open).out.find("not closed: it bounds no solid") !=
        std::string::npos);
}

TEST_CASE("decompose: components, and what may be joined") {
  const ScratchFolder scratch;
  const std::string apart = scratch.write("apart.obj", two_cubes(2)),
                    corner = scratch.write("corner.obj", two_cubes(1)),
                    out = scratch.file("out.obj");
  for (const std::string& input : {apart, corner}) {
    const auto ran = run_program("decompose --method hacd --max-parts 1 " + input + " -o " + out);
    CHECK(ran.exit == 2);
    CHECK(ran.err.find("2") != std::string::npos);
    CHECK(ran.err.find("; connect touching also") != std::string::npos);
    CHECK_FALSE(std::filesystem::exists(out));
  }
  const json joined =
      decomposed("--max-parts 1 --connect touching --exact-volumes " + corner + " -o " + out);
  CHECK(joined["parts"].size() == 1);
  CHECK(joined["eps_holds"] == false);
  CHECK(exact(joined["solid"]) == 2);
  CHECK(exact(joined["union"]) == 4);  // the sum of a cube and its diagonal: four dets of 1
  CHECK(is_accepted(corner, out));
}

TEST_CASE("decompose --parts: each object on its own, under its name") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("cubes.obj", two_cubes(3)), out = scratch.file("out.obj"),
                    list = scratch.file("out.json"), folder = scratch.file("out/");
  const json answer =
      decomposed("--parts " + input + " -o " + out + " -o " + list + " -o " + folder);
  CHECK(answer["objects"].size() == 2);
  REQUIRE(answer["parts"].size() == 2);
  CHECK(answer["parts"][0]["name"] == "left_part_000");
  CHECK(answer["parts"][1]["name"] == "right_part_000");
  CHECK(answer["parts"][1]["object"] == 1);
  for (const std::string& parts : {out, list, folder}) CHECK(is_accepted(input, parts));
  CHECK(std::filesystem::exists(folder + "right_part_000.obj"));
  CHECK(parts_document(list)["objects"][1]["tree"].size() == 23);  // 12 triangles in one part
  CHECK(
      run_program("decompose --method hacd --parts " + input + " --trace " + scratch.file("t.json"))
          .exit == 2);
}

TEST_CASE("decompose: fewer faces, fewer bits: the parts hold what they own" * sweep) {
  const ScratchFolder scratch;
  const std::string input = support::data("spot.obj"), out = scratch.file("out.obj"),
                    list = scratch.file("out.json");
  const std::string few = "--concavity 20% --measures none " + input + " -o " + out + " -o " + list;
  for (const char* options : {"--faces 8", "--total-faces 60", "--precision 32"}) {
    CAPTURE(options);
    const json answer = decomposed(std::string(options) + " " + few);
    for (const json& part : answer["parts"]) {
      if (std::string(options) == "--faces 8") CHECK(part["facets"] <= 8);
    }
    for (const std::string& parts : {out, list}) {
      CHECK(is_accepted(input, parts, "--no-tightness"));
    }
  }
  const json last = parts_document(list);  // in binary32
  for (const json& part : last["parts"]) {
    for (const json& vertex : part["vertices"]) {
      for (const double x : vertex) CHECK(double(float(x)) == x);
    }
  }
}

TEST_CASE("decompose: an input with fractions") {
  const ScratchFolder scratch;
  // A cube of side 1/10 with a corner at 1/10: none of its corners but one is a double.
  std::string text;
  for (const char* z : {"0.1", "0.2"}) {
    for (const char* y : {"0.1", "0.2"}) {
      for (const char* x : {"0.1", "0.2"}) text += point_line(x, y, z);
    }
  }
  for (const auto& face : support::box_faces()) {
    text += "f";
    for (const std::uint32_t corner : face) text += " " + std::to_string(corner + 1);
    text += "\n";
  }
  const std::string input = scratch.write("cube.obj", text), list = scratch.file("out.json");
  const json answer = decomposed("--decimal exact --exact-volumes " + input + " -o " + list);
  CHECK(answer["parts"][0]["form"] == "rounded");
  CHECK(exact(answer["solid"]) == Rational(1, 1000));
  CHECK(exact(answer["excess"]) > 0);
  CHECK(exact(answer["uncovered"]) == 0);
  CHECK(parts_document(list)["parts"][0]["vertices"][0][0].is_string());
  CHECK(is_accepted(input, list, "--decimal exact"));
}

TEST_CASE("decompose: coordinates at the ends of the formats") {
  const ScratchFolder scratch;
  const auto tetrahedron = [&](const std::string& side) {
    return scratch.write("t.obj", "v 0 0 0\nv " + side + " 0 0\nv 0 " + side + " 0\nv 0 0 " + side +
                                      "\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  };
  const std::string out = scratch.file("out.json");
  for (const char* side : {"1.7e308", "5e-324"}) {
    CAPTURE(side);
    const std::string input = tetrahedron(side);
    CHECK(decomposed(input + " -o " + out)["parts"].size() == 1);
    CHECK(parts_document(out)["parts"][0]["form"] == "hull");
    CHECK(is_accepted(input, out));
    CHECK(run_program("decompose --method hacd " + input).out.find("inf") == std::string::npos);
  }
  const auto narrow = run_program("decompose --method hacd --precision 32 " + tetrahedron("1e39"));
  CHECK(narrow.exit == 5);
  CHECK(narrow.err.find("binary32 cannot hold the result") != std::string::npos);
  CHECK(narrow.err.find("--precision 64") != std::string::npos);
  CHECK(narrow.err.find("exact integers") == std::string::npos);
}

TEST_CASE("decompose: every engine proves its parts; exact and filtered have the same ones") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("ring.obj", obj_of_cells(support::ring_cells()));
  std::map<std::string, json> documents;
  for (const char* engine : {"exact", "filtered", "float"}) {
    const std::string out = scratch.file(std::string(engine) + ".json");
    decomposed(input + " --engine " + engine + " -o " + out);
    CHECK(is_accepted(input, out));
    documents[engine] = parts_document(out);
  }
  CHECK(documents["exact"]["parts"] == documents["filtered"]["parts"]);
  CHECK(documents["exact"]["tree"] == documents["filtered"]["tree"]);
  CHECK(documents["exact"]["merges"]["ties"] == documents["filtered"]["merges"]["ties"]);
}

TEST_CASE("decompose: flat clusters that stay flat") {
  const ScratchFolder scratch;
  // Two triangles of a square, a segment, and a point, in planes of their own.
  const std::string input = scratch.write("flat.obj",
                                          "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"
                                          "v 0 0 5\nv 1 0 5\nv 2 0 5\nf 5 6 7\nv 0 0 7\nf 8 8 8\n");
  const std::string out = scratch.file("out.obj"), list = scratch.file("out.json");
  const json answer = decomposed("--flat keep " + input + " -o " + out + " -o " + list);
  REQUIRE(answer["parts"].size() == 3);
  for (std::size_t k = 0; k < 3; ++k) CHECK(answer["parts"][k]["form"] == "flat");
  for (const std::string& parts : {out, list}) {
    CHECK(is_accepted(input, parts, "--claims covers-points,covers-surface"));
  }
  const json thick = decomposed("--flat thicken " + input + " -o " + out);
  CHECK(is_accepted(input, out));
  for (const json& part : thick["parts"]) CHECK(part["form"] == "thickened");
}

TEST_CASE("decompose -o folder/: what stays in it, and what goes") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("l.obj", obj_of_cells(support::l_cells()));
  const std::string folder = scratch.file("parts");
  REQUIRE(run_program("decompose --method hacd " + input + " -o " + folder + "/").exit == 0);
  scratch.write("parts/notes.txt", "mine");
  scratch.write("parts/mine.obj", "v 0 0 0\n");
  // A run with fewer parts takes the others away, and says what else looks like a part.
  const auto fewer =
      run_program("decompose --method hacd " + input + " --max-parts 1 -o " + folder);
  REQUIRE(fewer.exit == 0);
  CHECK(fewer.out.find("removed     " + folder + "/part_001.obj") != std::string::npos);
  CHECK(fewer.out.find("mine.obj is not one of these parts") != std::string::npos);
  CHECK(std::filesystem::exists(folder + "/part_000.obj"));
  CHECK_FALSE(std::filesystem::exists(folder + "/part_001.obj"));
  CHECK(bytes_of(folder + "/notes.txt") == "mine");
  CHECK(bytes_of(folder + "/mine.obj") == "v 0 0 0\n");
  // A run that fails changes nothing: neither the parts that are there, nor the folders.
  const std::string before = bytes_of(folder + "/part_000.obj");
  const auto failed =
      run_program("decompose --method hacd " + input + " --names 'x%d' -o " + folder + " -o " +
                  scratch.file("new/") + " -o " + scratch.file("none/x.obj"));
  CHECK(failed.exit == 5);
  CHECK(bytes_of(folder + "/part_000.obj") == before);
  CHECK_FALSE(std::filesystem::exists(folder + "/x0.obj"));
  CHECK_FALSE(std::filesystem::exists(scratch.file("new")));
  CHECK(scratch.count() == 2);
  // The same where only the summary cannot be written.
  const auto full = std::system((std::string("'") + std::getenv("CONVEXACT_PROGRAM") +
                                 "' decompose " + input + " --names 'x%d' -o " + folder + " -o " +
                                 scratch.file("new/") + " >/dev/full 2>/dev/null")
                                    .c_str());
  CHECK(WEXITSTATUS(full) == 5);
  CHECK(bytes_of(folder + "/part_000.obj") == before);
  CHECK_FALSE(std::filesystem::exists(folder + "/x0.obj"));
  CHECK_FALSE(std::filesystem::exists(scratch.file("new")));
}

TEST_CASE("decompose: an interrupt leaves nothing behind") {
  const ScratchFolder scratch;
  const auto ran =
      support::run_interrupted("decompose --method hacd " + support::data("bunny.obj") +
                                   " --engine exact -o " + scratch.file("parts/"),
                               "INT", "1");
  CHECK(ran.exit == 6);
  CHECK(scratch.count() == 0);
}

TEST_CASE("decompose: a picture and a proof, with the other files or not at all") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("l.obj", obj_of_cells(support::l_cells()));
  const std::string page = scratch.file("l.html"), proof = scratch.file("l.proof"),
                    trace = scratch.file("l.json"), cubes = scratch.write("c.obj", two_cubes(3));
  decomposed(input + " --picture " + page + " --proof " + proof);
  CHECK(bytes_of(page).find("<html") != std::string::npos);
  CHECK(bytes_of(proof).find("decomposition") != std::string::npos);
  CHECK(run_program("decompose --method hacd " + input + " --picture l.png").exit == 2);
  for (const std::string& option : {"--picture " + page, "--proof " + proof, "--trace " + trace}) {
    CAPTURE(option);
    CHECK(run_program("decompose --method hacd --parts " + cubes + " " + option).exit == 2);
    CHECK(run_program("decompose --method hacd " + input + " " + option + " -o " +
                      scratch.file("no/x.obj"))
              .exit == 5);
  }
  CHECK_FALSE(std::filesystem::exists(trace));
}

TEST_CASE("decompose: names of parts") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("l.obj", obj_of_cells(support::l_cells()));
  const auto names = [&](const std::string& pattern) {
    return decomposed(input + " --measures none --names '" + pattern + "'")["parts"][1]["name"];
  };
  CHECK(names("UCX_bunny_%02d") == "UCX_bunny_01");
  CHECK(names("%d") == "1");
  CHECK(names("a%03db") == "a001b");
  for (const char* pattern : {"part", "", "%", "%s", "%5d", "%00d", "%-3d", "%012d", "%d%d", "%d%%",
                              "a/%d", "a\\\\%d", ".%d", " %d", "%d ", "#%d"}) {
    CAPTURE(pattern);
    const auto ran = run_program("decompose --method hacd " + input + " --names '" + pattern + "'");
    CHECK(ran.exit == 2);
    CHECK(ran.err.find("--names: expected") != std::string::npos);
  }
}

TEST_CASE("decompose: refusals, each with a sentence") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("l.obj", obj_of_cells(support::l_cells()));
  const std::string share = "--concavity: expected a share of the diameter from 0 to 1";
  for (const Refusal& refusal : std::vector<Refusal>{
           {"--concavity 101%", 2, share},
           {"--concavity 1.01d", 2, share},
           {"--concavity -1", 2, share},
           {"--concavity=-3%", 2, share},
           {"--concavity nan", 2, share},
           {"--concavity 3%%", 2, share},
           {"--concavity ''", 2, "found an empty text"},
           {"--method best", 2, "--method"},
           {"--method cut --concavity 5%", 2, "apply to hacd and acd"},
           {"--method cut --engine float", 2, "applies to hacd only"},
           {"--max-excess 20", 2, "--max-excess: expected a share"},
           {"--max-excess 20%", 2, "apply to cut only"},
           {"--effort best", 2, "--effort"},
           {"--effort high", 2, "apply to cut only"},
           {"--method acd --engine float", 2, "the engine applies to hacd only"},
           {"--method acd --measure vertices", 2, "the measure applies to hacd only"},
           {"--method acd --coplanar 1.5", 2, "--coplanar: expected the cosine"},
           {"--method acd --coplanar x", 2, "--coplanar: expected the cosine"},
           {"--bridge nearer", 2, "apply to acd only"},
           {"--max-parts 0", 2, "--max-parts: expected a whole number"},
           {"--faces 3", 2, "--faces: expected a whole number from 4"},
           {"--faces 8 --total-faces 8", 2, "name one"},
           {"--exact-volumes --measures none", 2, "name one"},
           {"--precision 16", 2, "--precision"},
           {"-o x.stl", 2, "expected an extension .obj"},
           {"-o x", 2, "or a folder (a name that ends in /)"},
           {"-o " + input, 2, "this file is an input"},
           {"--trace " + input, 2, "this file is an input"},
           {"--names l%d -o " + scratch.file("none") + "/x.obj", 5, "x.obj"}}) {
    CAPTURE(refusal.options);
    const auto ran = run_program("decompose " + input + " " + by_clusters(refusal.options));
    CAPTURE(ran.err);
    CHECK(ran.exit == refusal.exit);
    CHECK(ran.err.find(refusal.says) != std::string::npos);
    CHECK(ran.out == "");
  }
  // The input lies in the folder, and is called as a part of the result is.
  const std::string part = scratch.write("part_007.obj", bytes_of(input));
  const auto same = run_program("decompose --method hacd " + part + " -o " + scratch.file("."));
  CHECK(same.exit == 2);
  CHECK(same.err.find("the input is in this folder") != std::string::npos);
  CHECK(scratch.count() == 2);
}

TEST_CASE("decompose: inputs that are no surface of a solid") {
  const ScratchFolder scratch;
  const auto exit_of = [&](const std::string& bytes, const std::string& options = "") {
    const std::string out = scratch.file("out/");
    const auto ran = run_program("decompose --method hacd " + scratch.write("in.obj", bytes) +
                                 " -o " + out + " " + options);
    CAPTURE(ran.err);
    if (ran.exit != 0) {
      CHECK(ran.err.find("in.obj") != std::string::npos);
      CHECK_FALSE(std::filesystem::exists(out));
    }
    return ran.exit;
  };
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  CHECK(exit_of("") == 4);
  CHECK(exit_of(square + "f 1 2 3 4\n") == 4);
  CHECK(exit_of("v 0 0 0\nf 1 1 1\n") == 4);
  CHECK(exit_of("v 0 0 nan\nf 1 1 1\n") == 3);
  CHECK(exit_of("v 0 0 0\nf 1 2 3\n") == 3);
  CHECK(exit_of(square + "f 1 2 3 4\n", "--flat merge") == 4);
  CHECK(exit_of(square + "f 1 2 3 4\n", "--flat thicken") == 0);
  CHECK(run_program("decompose --method hacd " + scratch.file("missing.obj")).exit == 3);
  const auto json_error = run_program("decompose --method hacd --json " +
                                      scratch.write("flat.obj", square + "f 1 2 3 4\n"));
  CHECK(json_error.exit == 4);
  const json document = json::parse(json_error.out);
  CHECK(schema_complaint("decompose", document) == "");
  CHECK(document["error"]["proof"]["kind"] == "flat-points");
}
