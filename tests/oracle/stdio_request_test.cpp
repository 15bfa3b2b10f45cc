// SPDX-License-Identifier: MIT
// Requests and answers of verify --stdio, on a cube, where every distance has a closed form; both
// against docs/schema/stdio_request.schema.json by valijson.
#include "wire/stdio_request.hpp"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "json_schema.hpp"
#include "number/random.hpp"
#include "sweep.hpp"

using namespace convexact;
using nlohmann::json;

namespace {

// [0, 1]^3 and what encloses it.
json cube_points() {
  json points = json::array();
  for (int k = 0; k < 8; ++k) points.push_back({k & 1, k >> 1 & 1, k >> 2 & 1});
  return points;
}

json cube_planes(const json& top = -1) {
  return {{1, 0, 0, -1}, {-1, 0, 0, 0},  {0, 1, 0, -1},
          {0, -1, 0, 0}, {0, 0, 1, top}, {0, 0, -1, 0}};
}

json request(const json& candidate) {
  return {{"id", 7}, {"points", cube_points()}, {"candidate", candidate}};
}

json ask(const json& request) {
  CHECK(schema_complaint("stdio_request", request) == "");
  const std::string line = answer_request(request.dump());
  CHECK(line.find('\n') == std::string::npos);
  const json answer = json::parse(line);
  CHECK(schema_complaint("stdio_request", answer) == "");
  return answer;
}

json claim(const json& answer, const std::string& code) {
  for (const json& each : answer["claims"]) {
    if (each["code"] == code) return each;
  }
  return nullptr;
}

}  // namespace

TEST_CASE("stdio: a cube in itself holds, as planes and as vertices with faces") {
  json answer = ask(request({{"planes", cube_planes()}}));
  CHECK(answer["id"] == 7);
  CHECK(answer["verdict"] == "holds");
  CHECK(answer["outside"]["tested"] == 8);
  const json faces = {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3},
                      {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}};
  answer = ask(request({{"vertices", cube_points()}, {"faces", faces}}));
  CHECK(answer["verdict"] == "holds");
  CHECK(claim(answer, "mesh-planar")["status"] == "holds");
  CHECK_FALSE(answer.contains("tightness"));
}

TEST_CASE("stdio: a plane that cuts is violated, with point, row and exact distance") {
  // z <= 1 - 2^-60, spelled in three ways.
  for (const json& top :
       {json("-0x0.fffffffffffffff"), json("-1152921504606846975/1152921504606846976"),
        json("-0x1.ffffffffffffffep-1")}) {
    json asked = request({{"planes", cube_planes(top)}});
    asked["claims"] = {"contains-input"};
    const json answer = ask(asked);
    CHECK(answer["verdict"] == "violated");
    REQUIRE(answer["claims"].size() == 1);
    CHECK(answer["outside"]["points"] == 4);
    const json& witness = answer["claims"][0]["witness"];
    CHECK(witness["rows"] == json{4});
    CHECK(witness["input_point"] == 4);
    CHECK(witness["distance"]["squared"] == "1/1329227995784915872903807060280344576");  // 2^-120
  }
}

TEST_CASE("stdio: budgets, tolerance and tightness are as on the command line") {
  json asked = request({{"planes", cube_planes("-0.75")}});
  asked["max_facets"] = 5;
  asked["tolerance"] = "0.25";
  asked["tightness"] = true;
  json answer = ask(asked);
  CHECK(claim(answer, "contains-input")["status"] == "holds");
  CHECK(claim(answer, "max-facets")["status"] == "violated");
  CHECK(claim(answer, "max-facets")["witness"]["count"] == 6);
  CHECK(answer["tightness"]["volume_ratio"]["decimal"] == "0.75");
  asked["tolerance"] = "0.24";
  CHECK(claim(ask(asked), "contains-input")["status"] == "violated");
}

TEST_CASE("stdio: whatever is wrong with the candidate is a verdict") {
  const auto violated = [](const json& candidate) {
    const json answer = ask(request(candidate));
    CHECK(answer["verdict"] == "violated");
    json codes = json::array();
    for (const json& each : answer["claims"]) {
      if (each["status"] == "violated") codes.push_back(each["code"]);
    }
    return codes;
  };
  CHECK(violated({{"vertices", cube_points()}, {"faces", {{0, 1, 8}}}}) ==
        json{"candidate-readable"});
  CHECK(violated({{"planes", {{1, 0, 0, "1e999"}}}}) == json{"candidate-finite"});
  CHECK(violated({{"vertices", {{0, 0, 0}, {1, 0, 0}}}})[0] == "candidate-solid");
  CHECK(violated({{"planes", {{0, 0, 1, -1}}}}) == json{"candidate-bounded"});
  const json answer = json::parse(answer_request(
      R"({"points": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], "candidate": {"planes": [[1, "x", 0, 0]]}})"));
  CHECK(answer["claims"][0]["status"] == "violated");
}

TEST_CASE(
    "stdio: whatever is wrong with a request is an error with its id, and nothing is thrown") {
  const auto error = [](const std::string& line) {
    const json answer = json::parse(answer_request(line));
    CHECK(schema_complaint("stdio_request", answer) == "");
    return answer;
  };
  CHECK(error("what")["error"]["code"] == "malformed");
  CHECK_FALSE(error("what").contains("id"));
  CHECK(error("[]")["error"]["code"] == "malformed");
  CHECK_FALSE(error(R"({"id": [1]})").contains("id"));
  CHECK(error("\xff{\"id\": \"\xff\"}")["error"]["code"] == "malformed");
  CHECK(error(std::string("{\"id\": 1, \0}", 12))["error"]["code"] == "malformed");
  CHECK(error(std::string(100000, '['))["error"]["code"] == "malformed");
  const json base = request({{"planes", cube_planes()}});
  const std::vector<std::pair<std::string, json>> wrong = {
      {"points", 3},
      {"points", {1, 2, 3}},
      {"points", {{1, 2}}},
      {"points", {{1, 2, "x"}}},
      {"points", {{1, 2, nullptr}}},
      {"candidate", json::array()},
      {"candidate", json::object()},
      {"candidate", {{"planes", json::array()}, {"vertices", json::array()}}},
      {"candidate", {{"planes", json::array()}, {"faces", json::array()}}},
      {"claims", "contains-input"},
      {"claims", {"contains"}},
      {"claims", {3}},
      {"tolerance", 1},
      {"tolerance", "-1"},
      {"tolerance", "wide"},
      {"tightness", 1},
      {"decimal", "rough"},
      {"max_facets", -1},
      {"max_facets", 1.5},
      {"maximum", 3}};
  for (const auto& [key, value] : wrong) {
    json asked = base;
    asked[key] = value;
    CAPTURE(asked.dump());
    const json answer = error(asked.dump());
    CHECK(answer["id"] == 7);
    CHECK(answer.contains("error"));
  }
  json binary32 = base;
  binary32["numbers"] = "binary32";
  binary32["decimal"] = "exact";
  CHECK(error(binary32.dump()).contains("error"));
  json flat = base;
  flat["points"] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  CHECK(error(flat.dump())["error"]["code"] == "no-interior");
  CHECK(error(flat.dump())["error"].contains("proof"));
  json infinite = base;
  infinite["points"][0][0] = "1e999";
  CHECK(error(infinite.dump())["error"]["code"] == "not-finite");
}

TEST_CASE("stdio: with numbers in binary32 every coordinate means the nearest one (#13)") {
  // The last coordinate of each is 0.7f: as a decimal that rounds to it, as %.9g prints it, as a
  // hexadecimal float of the double 0.7, and as a fraction.
  for (const char* top : {"0.7", "0.699999988", "\"0x1.6666666666666p-1\"", "\"7/10\""}) {
    CAPTURE(top);
    const std::string request =
        R"({"points": [[0,0,0],[1,0,0],[0,1,0],[0,0,0.7]], "claims": ["contains-input"],)"
        R"("candidate": {"vertices": [[0,0,0],[1,0,0],[0,1,0],[0,0,)" +
        std::string(top) + "]]}";
    CHECK(json::parse(answer_request(request + R"(, "numbers": "binary32"})"))["verdict"] ==
          "holds");
  }
  const std::string beyond =
      R"({"points": [[0,0,0],[1,0,0],[0,1,0],[0,0,1e39]], "numbers": "binary32",)"
      R"("candidate": {"vertices": []}})";
  CHECK(json::parse(answer_request(beyond))["error"]["code"] == "not-finite");
}

TEST_CASE("stdio: nesting without end is an error with the id that came before (#13)") {
  constexpr int kDepth = 200000;
  const std::string deep = std::string(kDepth, '[') + std::string(kDepth, ']');
  std::string objects;
  for (int k = 0; k < kDepth; ++k) objects += "{\"a\":";
  objects += "1" + std::string(kDepth, '}');
  const std::string rest =
      R"(, "points": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], "candidate": {"planes": []}})";
  for (const std::string& value : {deep, objects}) {
    for (const char* key : {"points", "candidate", "claims", "tolerance", "decimal", "other"}) {
      CAPTURE(key);
      const json answer = json::parse(
          answer_request("{\"id\": \"x\", \"" + std::string(key) + "\": " + value + rest));
      CHECK(answer["id"] == "x");
      CHECK(answer["error"]["code"] == "malformed");
      CHECK(schema_complaint("stdio_request", answer) == "");
    }
    const json answer = json::parse(answer_request("{\"id\": " + value + rest));
    CHECK_FALSE(answer.contains("id"));
    CHECK(answer["error"]["code"] == "malformed");
  }
  // What is within the depth is refused for what it is, in a message of bounded length.
  const std::string name = "\"" + std::string(1 << 20, 'x') + "\"";
  const std::string answer = answer_request("{\"id\": 1, \"claims\": [[" + name + "]]" + rest);
  CHECK(json::parse(answer)["id"] == 1);
  CHECK(answer.size() < 500);
}

TEST_CASE("stdio: an id comes back as it was spelled (#13)") {
  for (const std::string id : {"7", "-0", "18446744073709551616", "-9223372036854775809", "1e2",
                               "1.0", "123456789012345678901234567890.50",
                               "\"18446744073709551616\"", "null", "true", "\"\"", "\"a\\nb\""}) {
    const std::string start = "{\"id\":" + id + ",";
    CHECK(answer_request("{\"id\" : " + id + " }").starts_with(start));
    CHECK(answer_request("{\"maximum\": [{\"points\": 3}], \"id\":" + id + "}").starts_with(start));
    CHECK(answer_request("{\"id\":" + id + ", \"points\": [[").starts_with(start));
  }
  for (const char* id : {"[7]", "{\"a\": 7}", "[]"}) {
    const json answer = json::parse(answer_request(std::string("{\"id\":") + id + "}"));
    CHECK_FALSE(answer.contains("id"));
    CHECK(answer["error"]["message"] ==
          "expected an id that is a number, a string, true, false or null");
  }
  CHECK_FALSE(json::parse(answer_request("{\"id\": what")).contains("id"));
  CHECK(json::parse(answer_request(R"({"id": 1, "id": 2})"))["error"]["code"] == "malformed");
}

// Integers beyond 2^53: a coordinate is the nearest double, as in a mesh; a plane is exact, as in a
// list of halfspaces. Neither the other entries nor quotes make a difference.
TEST_CASE("stdio: a number means what its text does, whatever stands beside it (#13)") {
  const std::string two53 = "9007199254740992", above = "9007199254740993";
  const auto violated = [&](const std::string& x, const std::string& other, const std::string& d,
                            const std::string& decimal) {
    const std::string answer =
        answer_request(R"({"claims": ["contains-input"], "decimal": ")" + decimal +
                       R"(", "points": [[0,0,0],[)" + x + ",0,0],[0," + other + ",0],[0,0,1]], " +
                       R"("candidate": {"planes": [[1,0,0,)" + d + "],[0,1,0," + "-2]]}}");
    const json document = json::parse(answer);
    REQUIRE_MESSAGE(document.contains("verdict"), answer);
    return document["verdict"] == "violated";
  };
  const auto quoted = [](const std::string& text) { return "\"" + text + "\""; };
  for (const std::string& other :
       {std::string("1"), std::string("1.0"), quoted("1"), quoted("0x1p0"), quoted("1/3")}) {
    CAPTURE(other);
    for (const bool is_quoted : {false, true}) {
      const std::string x = is_quoted ? quoted(above) : above;
      const std::string d = is_quoted ? quoted("-" + above) : "-" + above;
      const std::string d_even = is_quoted ? quoted("-" + two53) : "-" + two53;
      // The nearest double to 2^53 + 1 is 2^53.
      CHECK_FALSE(violated(x, other, d_even, "nearest"));
      CHECK(violated(x, other, d_even, "exact"));
      CHECK_FALSE(violated(x, other, d, "exact"));
      // 2^53 + 2 is a double; planes at 2^53 + 1 and at 2^64 + 1 are exact in both modes.
      for (const char* decimal : {"nearest", "exact"}) {
        CHECK(violated("9007199254740994", other, d, decimal));
        CHECK_FALSE(violated("18446744073709551616", other, "-18446744073709551617", decimal));
        CHECK(violated("18446744073709551616", other, "-18446744073709551615", decimal));
      }
      // Decimals in planes go by `decimal`, too: 0.1 as a double is larger than a tenth.
      CHECK_FALSE(violated(quoted("1/10"), other, "-0.1", "nearest"));
      CHECK(violated("0.1", other, quoted("-1/10"), "nearest"));
      CHECK_FALSE(violated("0.1", other, quoted("-1/10"), "exact"));
      CHECK_FALSE(violated(quoted("0.1"), other, "-1e-1", "exact"));
    }
  }
}

TEST_CASE("stdio: a corrupted request has an answer that is one line of JSON, as the schema says" *
          sweep) {
  const json faces = {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3},
                      {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}};
  json exact = request({{"planes", cube_planes("-0x1p0")}});
  exact["tolerance"] = "1e-9d";
  exact["max_facets"] = 6;
  exact["tightness"] = true;
  const std::string good[] = {request({{"vertices", cube_points()}, {"faces", faces}}).dump(),
                              exact.dump()};
  Random random(2604);
  std::size_t verdicts = 0, violated = 0;
  for (int repeat = 0; repeat < 2000; ++repeat) {
    std::string bytes = good[repeat % 2];
    for (std::uint64_t k = uniform_below(random, 3) + 1; k > 0; --k) {
      // Mostly a digit for a digit: most other changes leave no JSON.
      const auto is_digit = [&](std::size_t i) { return bytes[i] >= '0' && bytes[i] <= '9'; };
      std::size_t at = uniform_below(random, bytes.size());
      const bool wants_digit = random() % 8 != 0;
      while (wants_digit && !is_digit(at)) at = (at + 1) % bytes.size();
      bytes[at] = static_cast<char>(wants_digit ? '0' + uniform_below(random, 10) : random() % 256);
    }
    CAPTURE(bytes);
    const std::string line = answer_request(bytes);
    REQUIRE(line.find('\n') == std::string::npos);
    const json answer = json::parse(line);
    REQUIRE(schema_complaint("stdio_request", answer) == "");
    verdicts += answer.contains("verdict");
    violated += answer.value("verdict", "") == "violated";
  }
  CHECK(verdicts > 500);
  CHECK(violated > 200);
}

TEST_CASE("stdio: a claim that was named and does not apply is undecided (#13)") {
  const json points = cube_points();
  const auto answer = [&](json request) {
    request["points"] = points;
    request["candidate"] = {{"vertices", points}};
    const json line = json::parse(answer_request(request.dump()));
    CHECK(schema_complaint("stdio_request", line) == "");
    return line;
  };
  CHECK(answer({{"claims", {"mesh-closed"}}})["verdict"] == "undecided");
  CHECK(answer({{"claims", {"contains-input"}}})["verdict"] == "holds");
  CHECK(answer({{"claims", {"max-facets"}}})["error"]["exit"] == 2);
  CHECK(answer({{"claims", {"max-facets"}}, {"max_facets", 6}})["verdict"] == "holds");
}

TEST_CASE("stdio: facets as meant, and exactly (#13)") {
  json points = cube_points();
  points.back()[2] = 1 + 0x1p-52;  // the top is two triangles now
  json request = {{"points", cube_points()}, {"candidate", {{"vertices", points}}}};
  request["max_facets"] = 6;
  const json meant = json::parse(answer_request(request.dump()));
  CHECK(meant["verdict"] == "holds");
  CHECK(meant["candidate"]["facets_as_meant"] == 6);
  CHECK(meant["candidate"]["u"]["ulps"] == 0.5);
  request["exact_facets"] = true;
  CHECK(json::parse(answer_request(request.dump()))["verdict"] == "violated");
  request.erase("max_facets");
  CHECK(json::parse(answer_request(request.dump()))["error"]["exit"] == 3);
}

TEST_CASE("stdio: an inner solid is judged by inside-input") {
  // Half of the cube lies inside of it. The cube twice as wide reaches out by 1, beyond x <= 1.
  json half = cube_planes();
  half[0] = {2, 0, 0, -1};
  json asked = request({{"planes", half}});
  CHECK(ask(asked)["verdict"] == "violated");  // it misses points
  asked["inner"] = true;
  json answer = ask(asked);
  CHECK(answer["verdict"] == "holds");
  CHECK(claim(answer, "inside-input")["status"] == "holds");
  CHECK(claim(answer, "contains-input") == nullptr);
  json wide = cube_planes();
  wide[0] = {1, 0, 0, -2};
  asked = request({{"planes", wide}});
  CHECK(ask(asked)["verdict"] == "holds");
  asked["inner"] = true;
  answer = ask(asked);
  CHECK(answer["verdict"] == "violated");
  const json witness = claim(answer, "inside-input")["witness"];
  CHECK(witness["distance"]["squared"] == "1");
  CHECK(witness["plane"] == json({"1", "0", "0", "-1"}));
  asked["tolerance"] = "1";
  CHECK(ask(asked)["verdict"] == "holds");
  asked["inner"] = "yes";
  CHECK(json::parse(answer_request(asked.dump())).contains("error"));
}

TEST_CASE("stdio: of parts, triangles may stay as they are, and volumes be fractions") {
  json asked = request({{"parts", {{{"vertices", cube_points()}}}}});
  asked["triangles"] = {{1, 5, 7, 3}, {0, 2, 6, 4}, {2, 3, 7, 6},
                        {0, 4, 5, 1}, {4, 6, 7, 5}, {0, 1, 3, 2}};  // clockwise from outside
  CHECK(ask(asked)["surface"]["reversed_components"] == 1);
  asked["orient"] = "keep";
  CHECK(ask(asked)["surface"]["reversed_components"] == 0);
  asked["exact_volumes"] = true;
  CHECK(ask(asked)["error"]["code"] == "malformed");
  asked["tightness"] = true;
  CHECK(ask(asked)["measures"]["union_volume"]["exact"] == "1");
  asked["orient"] = "turn";
  CHECK(json::parse(answer_request(asked.dump()))["error"]["message"] ==
        "expected orient as auto or keep");
  json single = request({{"planes", cube_planes()}});
  single["orient"] = "keep";
  CHECK(ask(single)["error"]["code"] == "malformed");
}

// The cube in halves, under a root that is the cube, or too small.
TEST_CASE("stdio: parts under a tree of hulls") {
  json left = cube_points(), right = left;
  for (json& row : left) row[0] = row[0] == 0 ? 0 : 0.5;
  for (json& row : right) row[0] = row[0] == 0 ? 0.5 : 1;
  const auto judged = [&](const json& root) {
    const json nodes = {{{"parent", nullptr}, {"children", {1, 2}}, {"vertices", root}},
                        {{"parent", 0}, {"part", 0}},
                        {{"parent", 0}, {"part", 1}}};
    return ask(
        request({{"parts", {{{"vertices", left}}, {{"vertices", right}}}}, {"hull_tree", nodes}}));
  };
  const json good = judged(cube_points());
  CHECK(good["verdict"] == "holds");
  CHECK(claim(good, "tree-nested")["status"] == "holds");
  const json bad = judged(left);
  CHECK(bad["verdict"] == "violated");
  CHECK(claim(bad, "tree-nested")["witness"]["nodes"] == json{0, 2});
  const json malformed = request({{"parts", {{{"vertices", left}}}}, {"hull_tree", {3}}});
  CHECK(claim(ask(malformed), "parts-readable")["status"] == "violated");
}
