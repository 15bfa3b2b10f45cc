// SPDX-License-Identifier: MIT
// Requests and answers of hull --stdio and simplify --stdio, on a cube and a square pyramid; both
// against docs/schema/solid_request.schema.json.
#include "wire/solid_request.hpp"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "convexact/io.hpp"
#include "io/base64.hpp"
#include "json_schema.hpp"
#include "pages/answers.hpp"

using namespace convexact;
using nlohmann::json;

namespace {

json cube_points() {
  json points = json::array();
  for (int k = 0; k < 8; ++k) points.push_back({k & 1, k >> 1 & 1, k >> 2});
  return {{"points", points}};
}

// A cube of edge 2 less the corner beyond x + y + z = 2.
json cut_cube() {
  return json::parse(R"({"planes": [[1,0,0,-1],[-1,0,0,-1],[0,1,0,-1],[0,-1,0,-1],[0,0,1,-1],
      [0,0,-1,-1],["1/2",0.5,"0x1p-1",-1]]})");
}

json answered(const char* kind, const std::string& line) {
  const std::string text = answer_line_of(kind, line);
  CHECK(text.find('\n') == std::string::npos);
  json answer = json::parse(text);
  CHECK(schema_complaint("solid_request", answer) == "");
  return answer;
}

json ask(const char* kind, json request, const json& options) {
  request.update(options);
  CHECK(schema_complaint("solid_request", request) == "");
  return answered(kind, request.dump());
}

std::string message(const char* kind, const std::string& line) {
  return answered(kind, line).at("error").at("message");
}

}  // namespace

TEST_CASE("hull request: a cube, its id and the measures that are asked for") {
  const json all = ask("hull", cube_points(), {{"id", "a"}, {"exact_values", true}});
  CHECK(all["id"] == "a");
  CHECK(all["planes"].size() == 6);
  CHECK(all["vertices"].size() == 8);
  CHECK(all["edges"] == 12);
  CHECK(all["volume"]["exact"] == "1");
  CHECK(all["mean_width"]["value"] == 1.5);
  CHECK_FALSE(all.contains("stages"));
  const json area = ask("hull", cube_points(), {{"measures", {"area"}}, {"digits", 3}});
  CHECK(area["area"]["decimal"] == "6");
  CHECK_FALSE(area.contains("volume"));
}

TEST_CASE("simplify request: halfspaces, read exactly, lose the cut") {
  const json found = ask("simplify", cut_cube(), {{"faces", 6}, {"exact_values", true}});
  // The corner that was cut off is a tetrahedron with three edges of length 1 at its right angle.
  CHECK(found["volume"]["input"]["exact"] == "47/6");
  CHECK(found["volume"]["output"]["exact"] == "8");
  const json limited = ask("simplify", cut_cube(), {{"max_growth", "2%"}});
  CHECK(limited["output"]["halfspaces"] == 7);  // the cut is 1/47 of the volume
  CHECK(ask("simplify", cut_cube(), {{"max_growth", "2.2%"}})["output"]["halfspaces"] == 6);
}

TEST_CASE("solid request: files are those of the command line, and hold every point") {
  const json found =
      ask("simplify", cube_points(), {{"faces", 6}, {"files", {"a.obj", "b.ine", "c.proof"}}});
  const Mesh mesh = read_mesh_bytes(found["files"]["a.obj"].get<std::string>());
  CHECK(mesh.polygons.size() == 6);
  CHECK(found["files"]["b.ine"].get<std::string>().starts_with("H-representation"));
  CHECK(found["files"]["c.proof"].get<std::string>().starts_with("convexact"));
  CHECK(found["files"].size() == 3);
  CHECK(ask("hull", cube_points(), {{"picture", true}, {"name", "<i>"}})["picture"]
            .get<std::string>()
            .find("&lt;i&gt;") != std::string::npos);
}

TEST_CASE("solid request: STL and GLB are in base64, alone or with numbers in binary32") {
  const json found = ask("hull", cube_points(), {{"files", {"a.stl", "b.glb"}}});
  const auto bytes_of = [](const json& file) {
    return from_base64(file["base64"].get<std::string>());
  };
  const std::string stl = bytes_of(found["files"]["a.stl"]);
  CHECK(stl.size() == 84 + 12 * 50);  // two triangles for each side, by the format
  CHECK(read_mesh_bytes(stl).polygons.size() == 12);
  CHECK(bytes_of(found["files"]["b.glb"]).starts_with("glTF"));
  const json both = {{"files", {"a.obj", "b.glb"}}};
  CHECK(ask("simplify", cube_points(), {{"faces", 6}, {"precision", 32}, {"files", both["files"]}})
            .at("files")
            .size() == 2);
  json request = cube_points();
  request.update(both);
  CHECK(message("hull", request.dump())
            .starts_with("expected precision 32 with b.glb, which holds binary32 only"));
}

TEST_CASE("simplify request: the cut is kept, and a side goes") {
  // A cap of 25/48 in units of the cube, whose edge is 2: 47/6 + 25/6.
  for (const char* selector : {"plane:1,1,1,-2", "normal:1,1,1"}) {
    const json found =
        ask("simplify", cut_cube(), {{"faces", 6}, {"keep", {selector}}, {"exact_values", true}});
    CHECK(found["kept"]["ids"].size() == 1);
    CHECK(found["volume"]["output"]["exact"] == "12");
  }
  json request = cut_cube();
  request.update({{"faces", 6}, {"keep", {"group:a"}}});
  CHECK(message("simplify", request.dump()).starts_with("expected keep as texts id:N"));
  request["keep"] = {"id:7"};
  CHECK(message("simplify", request.dump()).starts_with("keep id:7: "));
}

TEST_CASE("simplify request: a trace has the step and its exact cost") {
  const json trace = ask("simplify", cut_cube(), {{"faces", 6}, {"trace", true}})["trace"];
  CHECK(schema_complaint("trace", trace) == "");
  CHECK(trace["steps"].size() == 1);
  CHECK(trace["steps"][0]["cost"]["exact"] == "1/6");  // the corner
  CHECK_FALSE(ask("simplify", cut_cube(), {{"faces", 6}}).contains("trace"));
}

TEST_CASE("simplify request: an inner run of a cube loses a corner, 1/6") {
  const json options = {{"inner", true},
                        {"exact_values", true},
                        {"picture", true},
                        {"trace", true},
                        {"files", {"a.obj", "a.ine"}}};
  for (json limit : {json{{"vertices", 7}}, json{{"max_loss", "17%"}}, json{{"max_loss", 0.17}}}) {
    limit.update(options);
    const json found = ask("simplify", cube_points(), limit);
    CHECK(found["volume"]["output"]["exact"] == "5/6");
    CHECK(found["output"]["vertices"] == 7);
    CHECK(read_mesh_bytes(found["files"]["a.obj"].get<std::string>()).points.size() == 7);
    CHECK(found["trace"]["steps"][0]["cost"]["exact"] == "1/6");
    CHECK(found["picture"].get<std::string>().starts_with("<!DOCTYPE html>"));
  }
}

TEST_CASE("simplify request: an inner run has no halfspaces, no binary32 and no proof") {
  const auto says = [](json request, const json& options, const char* beginning) {
    request.update({{"inner", true}, {"vertices", 7}});
    request.update(options);
    CHECK(message("simplify", request.dump()).starts_with(beginning));
  };
  says(cut_cube(), json::object(), "expected points for an inner run");
  says(cube_points(), {{"keep", {"id:0"}}}, "expected keep without inner only");
  says(cube_points(), {{"precision", 32}}, "expected no precision with inner");
  says(cube_points(), {{"files", {"a.proof"}}}, "expected a proof of removals of halfspaces only");
  says(cube_points(), {{"files", {"a.stl"}}}, "a.stl: STL and GLB hold binary32");
  says(cube_points(), {{"cost", "area"}}, "--cost does not apply to an inner run");
  says(cube_points(), {{"inner", false}}, "expected vertices with inner only");
}

TEST_CASE("solid request: faults name what was expected") {
  CHECK(message("hull", "{}") == "expected a request with 'points' or with 'planes'");
  CHECK(message("hull", R"({"points": [], "planes": []})") ==
        "expected a request with 'points' or with 'planes'");
  CHECK(message("hull", R"({"points": [], "faces": 4})") ==
        "expected only known keys in the request, found 'faces'");
  CHECK(message("hull", R"({"points": [], "measures": ["width"]})")
            .starts_with("expected measures out of volume, area, mean-width and inertia"));
  // Of two faults in a row, the first.
  CHECK(message("hull", R"({"planes": [["a", "b", "c", "d"]]})").ends_with("found 'a'"));
  CHECK(message("hull", R"({"points": [["a", "b", "c"]]})").ends_with("found 'a'"));
  CHECK(message("hull", R"({"points": [], "digits": 0})") == "expected digits from 1 to 10000");
  for (const char* jobs : {"0", "257"}) {
    const std::string request = R"({"points": [], "faces": 4, "jobs": )" + std::string(jobs) + "}";
    CHECK(message("simplify", request) ==
          "jobs: expected a whole number from 1 to 256, found '" + std::string(jobs) + "'");
  }
  CHECK(message("hull", R"({"points": [], "jobs": 257})") == "expected jobs from 1 to 256");
  CHECK(message("simplify", R"({"points": [], "files": ["a.fbx"], "faces": 4})")
            .starts_with("expected files as names that end in"));
  CHECK(message("simplify", R"({"points": [], "precision": 16, "faces": 4})") ==
        "expected precision as 64 or 32");
  CHECK(message("hull", R"({"planes": [], "triangles": []})") ==
        "expected triangles with 'points' only");
  CHECK(
      json::parse(answer_hull_request(R"({"points": [], "picture": true})"))["error"]["message"] ==
      "expected no picture here");
}

TEST_CASE("solid request: an input without volume is proven to have none") {
  const json flat = answered("hull", R"({"points": [[0,0,0],[1,0,0],[0,1,0],[1,1,0]]})");
  CHECK(flat["error"]["code"] == "no-interior");
  CHECK(flat["error"].contains("proof"));
  const json open = answered("simplify", R"({"planes": [[1,0,0,-1]], "faces": 4})");
  CHECK(open["error"]["code"] == "no-interior");
  const json empty = answered("hull", R"({"planes": [[0,0,0,1]]})");
  CHECK(empty["error"]["message"].get<std::string>().starts_with("the input is empty"));
}
