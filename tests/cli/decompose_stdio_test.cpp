// SPDX-License-Identifier: MIT
// convexact decompose --stdio as a process: a line for a line, limits of time, wrong usage.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "cells.hpp"
#include "json_schema.hpp"
#include "process.hpp"

using nlohmann::json;
using support::run_program;
using support::ScratchFolder;

namespace {

std::string request_of(const std::set<support::Cell>& cells, const json& options) {
  const support::Mesh mesh = support::mesh_of_cells(cells);
  json request = options;
  for (const support::Point& p : mesh.points.doubles()) {
    request["points"].push_back({p[0], p[1], p[2]});
  }
  request["triangles"] = mesh.polygons;
  return request.dump() + "\n";
}

std::vector<json> answers(const std::string& requests, const std::string& options = "") {
  const ScratchFolder scratch;
  const auto ran =
      run_program("decompose --stdio " + options + " <" + scratch.write("requests", requests));
  CHECK(ran.exit == 0);
  CHECK(ran.err == "");
  std::vector<json> list;
  std::istringstream lines(ran.out);
  for (std::string line; std::getline(lines, line);) {
    list.push_back(json::parse(line));
    CHECK(schema_complaint("decompose_request", list.back()) == "");
  }
  return list;
}

// A board of so many cells with every fourth one raised: some 100 milliseconds of work or more.
std::set<support::Cell> board(int side) {
  std::set<support::Cell> cells;
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      cells.insert({x, y, 0});
      if (x % 2 == 0 && y % 2 == 0) cells.insert({x, y, 1});
    }
  }
  return cells;
}

}  // namespace

TEST_CASE("decompose --stdio: a line for each request in its order; errors do not end it") {
  const std::string good = request_of(support::l_cells(), {{"id", "a"}});
  const std::string flat =
      R"({"id": 3, "points": [[0,0,0],[1,0,0],[0,1,0]], "triangles": [[0,1,2]]})";
  const std::vector<json> list = answers(good + "\n \t\r\nnonsense\n{\"id\": 2}\n" + flat + "\n" +
                                         R"({"id": 4, "max-parts": 3})" + "\n" + good);
  REQUIRE(list.size() == 6);
  CHECK(list[0]["id"] == "a");
  CHECK(list[0]["parts"].size() == 2);
  CHECK(list[1]["error"]["code"] == "malformed");
  CHECK(list[2]["id"] == 2);
  CHECK(list[2]["error"]["exit"] == 3);
  CHECK(list[3]["id"] == 3);
  CHECK(list[3]["error"]["exit"] == 4);
  CHECK(list[4]["error"]["message"].get<std::string>().find("max-parts") != std::string::npos);
  CHECK(list[5] == list[0]);
  CHECK(answers("").empty());
}

TEST_CASE("decompose --stdio: an answer is the file that -o writes") {
  const ScratchFolder scratch;
  const support::Mesh mesh = support::mesh_of_cells(support::cross_cells());
  std::ostringstream obj;
  for (const support::Point& p : mesh.points.doubles()) {
    obj << "v " << p[0] << " " << p[1] << " " << p[2] << "\n";
  }
  for (const auto& polygon : mesh.polygons) {
    obj << "f";
    for (const std::uint32_t corner : polygon) obj << " " << corner + 1;
    obj << "\n";
  }
  const std::string out = scratch.file("parts.json");
  REQUIRE(run_program("decompose --method hacd --concavity 5% --exact-volumes " +
                      scratch.write("cross.obj", obj.str()) + " -o " + out)
              .exit == 0);
  const auto list =
      answers(request_of(support::cross_cells(), {{"concavity", "5%"}, {"exact_volumes", true}}));
  REQUIRE(list.size() == 1);
  CHECK(list[0] == json::parse(support::bytes_of(out)));
}

TEST_CASE("decompose --stdio: beyond its time limit a request is an error, and the next goes on") {
  const std::string good = request_of(support::l_cells(), {{"id", "after"}});
  const std::vector<json> list =
      answers(request_of(board(16), {{"id", 1}, {"time_limit", 0.001}}) + good);
  REQUIRE(list.size() == 2);
  CHECK(list[0]["id"] == 1);
  CHECK(list[0]["error"]["code"] == "stopped");
  CHECK(list[0]["error"]["exit"] == 6);
  CHECK(list[0]["error"]["message"] == "no parts within the time limit of 0.001 s");
  CHECK(list[1]["parts"].size() == 2);
  const std::vector<json> all =
      answers(request_of(board(16), {{"time_limit", 900}}) + good, "--time-limit 0.001");
  REQUIRE(all.size() == 2);
  CHECK(all[0]["error"]["code"] == "stopped");
  CHECK(all[1]["id"] == "after");
}

TEST_CASE("decompose --stdio: other arguments are wrong usage") {
  for (const char* arguments :
       {"decompose", "decompose --stdio l.obj", "decompose --stdio -o parts.json",
        "decompose --stdio --max-parts 3", "decompose --stdio --time-limit 0",
        "decompose l.obj --time-limit 1", "verify --stdio --max-facets 8",
        "verify --stdio --inner"}) {
    CAPTURE(arguments);
    CHECK(run_program(std::string(arguments) + " </dev/null").exit == 2);
  }
  const auto named = run_program("decompose --stdio --flat merge </dev/null");
  CHECK(named.err.find("--flat") != std::string::npos);
  CHECK(run_program("decompose --stdio --max-memory 1GB --json </dev/null").exit == 0);
}
