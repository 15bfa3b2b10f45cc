// SPDX-License-Identifier: MIT
// convexact verify --stdio as a process: a line for a line, blank lines, long lines, its end.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "number/random.hpp"
#include "process.hpp"
#include "sweep.hpp"

using nlohmann::json;
using support::run_program;
using support::ScratchFolder;

namespace {

const char* const kQuestion =
    R"("points": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], "candidate": {"planes": [[-1,0,0,0],[0,-1,0,0],[0,0,-1,0],[1,1,1,-1]]})";

std::vector<json> verdicts_of(const std::string& requests, const std::string& options = "") {
  const ScratchFolder scratch;
  const auto ran =
      run_program("verify --stdio " + options + " <" + scratch.write("requests", requests));
  CHECK(ran.exit == 0);
  std::vector<json> list;
  std::istringstream lines(ran.out);
  for (std::string line; std::getline(lines, line);) list.push_back(json::parse(line));
  return list;
}

}  // namespace

TEST_CASE("verify --stdio: a line for each request in its order; errors do not end it") {
  const std::string good = std::string(R"({"id": "a", )") + kQuestion + "}";
  const std::vector<json> list =
      verdicts_of(good + "\n\n  \t\r\nnonsense\n{\"id\": 2}\n" + good + "\r\n" + good);
  REQUIRE(list.size() == 5);
  CHECK(list[0]["verdict"] == "holds");
  CHECK(list[0]["id"] == "a");
  CHECK(list[1]["error"]["code"] == "malformed");
  CHECK(list[2]["id"] == 2);
  CHECK(list[3]["verdict"] == "holds");
  CHECK(list[4]["verdict"] == "holds");  // the last line has no end
}

TEST_CASE("verify --stdio: nothing in, nothing out; a line of a megabyte is one request" * sweep) {
  CHECK(verdicts_of("").empty());
  std::string points = "[0,0,0],[1,0,0],[0,1,0],[0,0,1]";
  for (int k = 0; k < 65000; ++k) points += ",[0.25,0.25,0.25]";
  const std::vector<json> list =
      verdicts_of(R"({"points": [)" + points +
                  R"(], "candidate": {"planes": [[-1,0,0,0],[0,-1,0,0],[0,0,-1,0],[1,1,1,-1]]}})"
                  "\n");
  REQUIRE(list.size() == 1);
  CHECK(list[0]["outside"]["tested"] == 65004);
}

TEST_CASE("verify --stdio: after a request of endless nesting the next ones are answered (#13)") {
  const std::string deep = std::string(300000, '[') + std::string(300000, ']');
  const std::string good = std::string(R"({"id": "after", )") + kQuestion + "}\n";
  std::string requests;
  for (const char* key : {"id", "claims", "decimal", "points", "tolerance", "unknown"}) {
    requests +=
        std::string(R"({"before": 0, ")") + key + "\": " + deep + ", " + kQuestion + "}\n" + good;
  }
  const std::vector<json> list = verdicts_of(requests);
  REQUIRE(list.size() == 12);
  for (std::size_t k = 0; k < list.size(); k += 2) {
    CHECK(list[k]["error"]["code"] == "malformed");
    CHECK(list[k + 1]["id"] == "after");
    CHECK(list[k + 1]["verdict"] == "holds");
  }
}

// Some 100 milliseconds of work.
std::string long_request(const std::string& fields) {
  convexact::Random random(13);
  std::string points;
  for (int k = 0; k < 6000; ++k) {
    std::string row;
    for (int i = 0; i < 3; ++i) row += (i == 0 ? "[" : ",") + std::to_string(random() % 1000000);
    points += (k == 0 ? "" : ",") + row + "]";
  }
  return "{" + fields + ", \"points\": [" + points +
         "], \"tightness\": true, \"candidate\": {\"vertices\": [" + points + "]}}\n";
}

TEST_CASE(
    "verify --stdio: beyond its time limit a request is an error, and the next one goes on (#13)") {
  const std::string good = std::string(R"({"id": "after", )") + kQuestion + "}\n";
  const std::string requests = long_request(R"("id": 1, "time_limit": 1e-3)") + good +
                               long_request(R"("id": 2, "time_limit": 900)");
  const auto check_stopped = [](const json& answer) {
    CHECK(answer["error"]["code"] == "stopped");
    CHECK(answer["error"]["exit"] == 6);
    CHECK(answer["error"]["message"] == "no verdict within the time limit of 0.001 s");
  };
  std::vector<json> list = verdicts_of(requests);
  REQUIRE(list.size() == 3);
  CHECK(list[0]["id"] == 1);
  check_stopped(list[0]);
  CHECK(list[1]["verdict"] == "holds");
  CHECK(list[2]["verdict"] == "holds");
  list =
      verdicts_of(long_request(R"("id": 3, "time_limit": 900)") + long_request(R"("id": 4)") + good,
                  "--time-limit 0.001");
  REQUIRE(list.size() == 3);
  check_stopped(list[0]);
  check_stopped(list[1]);
  CHECK(list[2]["id"] == "after");
  for (const char* limit : {"0", "-1", "\"1\"", "null", "1e7", "true"}) {
    const std::string request = "{\"time_limit\": " + std::string(limit) + ", " + kQuestion + "}\n";
    CHECK(verdicts_of(request)[0]["error"]["code"] == "malformed");
  }
  CHECK(run_program("verify --stdio --time-limit 0 </dev/null").exit == 2);
  CHECK(run_program("verify a.obj b.obj --time-limit 1").exit == 2);
}

TEST_CASE("verify --stdio: a closed pipe is exit 6, other arguments are wrong usage") {
  const ScratchFolder scratch;
  const std::string requests = scratch.write("requests", std::string("{") + kQuestion + "}\n");
  // The reader is gone before the first answer: standard output is a pipe that is closed at the
  // other end.
  const std::string script = scratch.write(
      "script", std::string("'") + std::getenv("CONVEXACT_PROGRAM") + "' verify --stdio <" +
                    requests + "; echo $? >" + scratch.file("exit") + "\n");
  (void)std::system(("(sleep 1; sh " + script + ") 2>" + scratch.file("err") + " | true").c_str());
  CHECK(support::bytes_of(scratch.file("exit")) == "6\n");
  CHECK(run_program("verify --stdio cube.obj </dev/null").exit == 2);
  CHECK(run_program("verify").exit == 2);
}
