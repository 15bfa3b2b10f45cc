// SPDX-License-Identifier: MIT
// Requests and answers of decompose --stdio, on shapes of unit cells; both against
// docs/schema/decompose_request.schema.json, and the answers against decompose.schema.json.
#include "wire/decompose_request.hpp"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "cells.hpp"
#include "json_schema.hpp"
#include "number/random.hpp"
#include "wire/decompose_options.hpp"
#include "wire/stdio_request.hpp"

using namespace convexact;
using nlohmann::json;

namespace {

json request_of(const Mesh& mesh) {
  json points = json::array();
  for (const Point& p : mesh.points.doubles()) points.push_back({p[0], p[1], p[2]});
  return {{"id", 7}, {"points", points}, {"triangles", mesh.polygons}};
}

json l_request() { return request_of(support::mesh_of_cells(support::l_cells())); }

json answered(const std::string& line) {
  const std::string text = answer_decompose_request(line);
  CHECK(text.find('\n') == std::string::npos);
  json answer = json::parse(text);
  CHECK(schema_complaint("decompose_request", answer) == "");
  return answer;
}

json ask(const json& request) {
  CHECK(schema_complaint("decompose_request", request) == "");
  json answer = answered(request.dump());
  if (answer.contains("parts")) {
    json document = answer;
    document.erase("id");
    document.erase("tree_file");
    CHECK(schema_complaint("decompose", document) == "");
  }
  return answer;
}

json l_with(const std::string& key, const json& value) {
  json request = l_request();
  request[key] = value;
  return ask(request);
}

}  // namespace

TEST_CASE("decompose request: an L in two parts, with the request's id") {
  const json answer = l_with("exact_volumes", true);
  CHECK(answer["id"] == 7);
  CHECK(answer["parts"].size() == 2);
  CHECK(answer["parts"][1]["name"] == "part_001");
  CHECK(answer["eps_holds"] == true);
  CHECK(answer["solid"]["exact"] == "3");
  CHECK(answer["verified"]["triangles"] == 28);  // two for each of 14 squares
  json request = l_request();
  request.erase("id");
  CHECK_FALSE(ask(request).contains("id"));
  for (const char* id : {"123456789012345678901234567890", "1.50", "\"a\\u0000b\"", "null"}) {
    std::string line = request.dump();
    line = "{\"id\":" + std::string(id) + "," + line.substr(1);
    CHECK(answer_decompose_request(line).find("{\"id\":" + std::string(id) + ",") == 0);
  }
}

// With one part the L is its hull, whose volume is that of the square of side 2 less half a cell;
// the walls of the notch are 1 deep in it, and the diameter is 3.
TEST_CASE("decompose request: options are those of the command line") {
  json request = l_request();
  request.update({{"method", "hacd"}, {"max_parts", 1}, {"exact_volumes", true}});
  json answer = ask(request);
  CHECK(answer["parts"].size() == 1);
  CHECK(answer["eps_holds"] == false);
  CHECK(answer["stop"] == "max-parts");
  CHECK(answer["parts"][0]["concavity"]["squared"] == "1");
  CHECK(answer["union"]["exact"] == "7/2");
  for (const json& enough : {json("1"), json(1), json("34%"), json("0.34d"), json("1/3d")}) {
    CAPTURE(enough);
    CHECK(l_with("concavity", enough)["parts"].size() == 1);
  }
  // A number is taken as it is spelled, beyond the digits of a double.
  request = l_request();
  std::string line = request.dump();
  line = "{\"concavity\":0.99999999999999999999999," + line.substr(1);
  CHECK(answered(line)["parts"].size() == 2);
  CHECK(l_with("method", "acd")["method"] == "acd");
  CHECK(l_with("measure", "vertices")["measure"] == "vertices");
  CHECK(l_with("engine", "exact")["engine"] == "exact");
  CHECK(l_with("connect", "touching")["connect"] == "touching");
  CHECK(l_with("precision", 32)["precision"] == "binary32");
  CHECK_FALSE(l_with("no_measures", true).contains("union"));
  request = l_request();
  request.update({{"max_parts", 1}, {"faces", 6}});
  CHECK(ask(request)["parts"][0]["form"] == "simplified");
  request = l_request();
  request.update({{"method", "acd"}, {"bridge", "nearer"}, {"coplanar", "0.5"}});
  answer = ask(request);
  CHECK(answer["bridge"] == "nearer");
  CHECK(answer["coplanar"] == "1/2");
}

TEST_CASE("decompose request: fractions and hexadecimal floats are exact") {
  json request = l_request();
  for (json& row : request["points"]) {
    for (json& x : row) x = std::to_string(x.get<int>()) + "/3";
  }
  request["exact_volumes"] = true;
  const json answer = ask(request);
  CHECK(answer["solid"]["exact"] == "1/9");
  CHECK(answer["parts"][0]["form"] == "rounded");
  for (json& row : request["points"]) {
    for (json& x : row) x = x == "0/3" ? "0x0p0" : x == "1/3" ? "0x1p-1" : "0x1p0";
  }
  CHECK(ask(request)["solid"]["exact"] == "3/8");
}

TEST_CASE("decompose request: whatever is wrong with it is an error with its id") {
  const auto code = [](const json& answer) {
    CHECK_FALSE(answer.contains("parts"));
    return answer["error"]["code"].get<std::string>();
  };
  CHECK(code(answered("what")) == "malformed");
  CHECK(code(answered("[]")) == "malformed");
  CHECK(code(answered("{\"id\": 1}")) == "malformed");
  CHECK(code(answered(std::string(100000, '['))) == "malformed");
  const std::vector<std::pair<const char*, json>> malformed = {
      {"points", 3},           {"points", {{1, 2}}},
      {"triangles", {{0, 1}}}, {"triangles", {{0, 1, 99}}},
      {"method", "vhacd"},     {"method", 1},
      {"measure", "volume"},   {"flat", "round"},
      {"max_parts", -1},       {"max_parts", "2"},
      {"keep_inner", 1},       {"precision", 16},
      {"precision", "64"},     {"seed", -1},
      {"decimal", "rough"},    {"concavity", nullptr},
      {"time_limit", 0},       {"names", "part_%d"},
      {"max-parts", 2},        {"id", {1}}};
  for (const auto& [key, value] : malformed) {
    json request = l_request();
    request[key] = value;
    CAPTURE(request.dump());
    const json answer = answered(request.dump());
    CHECK(code(answer) == "malformed");
    CHECK(answer.contains("id") == (std::string(key) != "id"));
  }
  const std::vector<json> wrong = {{{"concavity", "much"}},
                                   {{"concavity", "101%"}},
                                   {{"concavity", -1}},
                                   {{"coplanar", "0"}},
                                   {{"max_parts", 0}},
                                   {{"faces", 3}},
                                   {{"faces", 8}, {"total_faces", 8}},
                                   {{"method", "acd"}, {"measure", "vertices"}},
                                   {{"bridge", "nearer"}}};
  for (const json& options : wrong) {
    json request = l_request();
    request.update(options);
    CAPTURE(options.dump());
    const json answer = answered(request.dump());
    CHECK(code(answer) == "invalid-argument");
    CHECK(answer["error"]["exit"] == 2);
    CHECK(answer["id"] == 7);
  }
  json both = l_request();
  both.update({{"exact_volumes", true}, {"no_measures", true}});
  CHECK(code(answered(both.dump())) == "malformed");
  json infinite = l_request();
  infinite["points"][0][0] = "1e999";
  CHECK(code(answered(infinite.dump())) == "not-finite");
}

TEST_CASE("decompose request: a flat mesh is refused with its proof, or made solid") {
  json flat = {{"points", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}},
               {"triangles", {{0, 1, 2}, {2, 1, 3}}}};
  json answer = ask(flat);
  CHECK(answer["error"]["code"] == "no-interior");
  CHECK(answer["error"]["exit"] == 4);
  CHECK(answer["error"].contains("proof"));
  flat["flat"] = "thicken";
  CHECK(ask(flat)["parts"][0]["form"] == "thickened");
  flat["triangles"] = json::array();
  CHECK(ask(flat)["error"]["code"] == "no-interior");
}

TEST_CASE("decompose request: an answer is a candidate of the oracle as it is") {
  const json request = l_request();
  const json judged = {{"points", request["points"]},
                       {"triangles", request["triangles"]},
                       {"candidate", ask(request)},
                       {"claims", {"covers-surface", "parts-convex", "max-parts"}},
                       {"max_parts", 2}};
  CHECK(schema_complaint("stdio_request", judged) == "");
  CHECK(json::parse(answer_request(judged.dump()))["verdict"] == "holds");
  json moved = judged;
  for (json& row : moved["candidate"]["parts"][0]["vertices"]) row[2] = row[2].get<double>() + 1;
  CHECK(json::parse(answer_request(moved.dump()))["verdict"] == "violated");
}

// The root over the two parts of the L is its hull, a pentagonal prism; with six halfspaces that of
// the square.
TEST_CASE("decompose request: a tree over the parts, which the oracle takes as it is") {
  json request = l_request();
  request["tree"] = true;
  for (const std::size_t corners : {10, 8}) {
    if (corners == 8) request["tree_faces"] = 6;
    const json answer = ask(request);
    CHECK(schema_complaint("hull-tree", answer["tree_file"]) == "");
    const json& nodes = answer["tree_file"]["hull_tree"];
    REQUIRE(nodes.size() == 3);
    CHECK(nodes[0]["vertices"].size() == corners);
    const json judged = {{"points", request["points"]},
                         {"triangles", request["triangles"]},
                         {"candidate", answer["tree_file"]},
                         {"claims", {"covers-surface", "tree-nested"}}};
    CHECK(schema_complaint("stdio_request", judged) == "");
    CHECK(json::parse(answer_request(judged.dump()))["verdict"] == "holds");
  }
  request.erase("tree");
  CHECK(ask(request)["error"]["code"] == "malformed");
  CHECK_FALSE(ask(l_request()).contains("tree_file"));
}

TEST_CASE("decompose request: a corrupted one has an answer on one line, as the schema says") {
  json request = l_request();
  request["method"] = "hacd";  // the quickest: this is about reading
  const std::string good = request.dump();
  Random random(1806);
  std::size_t parts = 0;
  for (int repeat = 0; repeat < 300; ++repeat) {
    std::string bytes = good;
    for (std::uint64_t k = uniform_below(random, 3) + 1; k > 0; --k) {
      // Mostly a digit for a digit: most other changes leave no JSON.
      const auto is_digit = [&](std::size_t i) { return bytes[i] >= '0' && bytes[i] <= '9'; };
      std::size_t at = uniform_below(random, bytes.size());
      const bool wants_digit = random() % 8 != 0;
      while (wants_digit && !is_digit(at)) at = (at + 1) % bytes.size();
      bytes[at] = static_cast<char>(wants_digit ? '0' + uniform_below(random, 4) : random() % 256);
    }
    CAPTURE(bytes);
    parts += answered(bytes).contains("parts");
  }
  CHECK(parts > 100);
}

TEST_CASE("concavities and cosines: what their texts mean, exactly") {
  const auto limit = [](const char* text) { return parse_concavity("x", text); };
  for (const char* share : {"3%", "0.03d", "3/100d", "+3.00%"}) {
    CAPTURE(share);
    CHECK(limit(share).value == Rational(3, 100));
    CHECK(limit(share).is_share);
  }
  CHECK(limit("0.05").value == Rational(1, 20));
  CHECK_FALSE(limit("7").is_share);
  CHECK(limit("100%").value == 1);
  CHECK(limit("0").value == 0);
  CHECK(parse_cosine("x", "0.99") == Rational(99, 100));
  CHECK(parse_cosine("x", "1") == 1);
  for (const char* text : {"", "%", "d", "-1", "-1%", "100.1%", "1.1d", "3 %", "3%d", "nan"}) {
    CAPTURE(text);
    try {
      (void)limit(text);
      FAIL("no error");
    } catch (const Error& error) {
      CHECK(error.code() == ErrorCode::InvalidArgument);
      CHECK(std::string(error.what()).starts_with("x: expected a share"));
    }
  }
  for (const char* text : {"", "0", "-0.5", "1.01", "60deg"}) {
    CAPTURE(text);
    CHECK_THROWS_AS((void)parse_cosine("x", text), Error);
  }
}
