// SPDX-License-Identifier: MIT
// Property of stdio: for any line, the answer is one line of JSON, an object with either a
// verdict or an error of a documented kind (6 beyond its time limit); a verdict has the request's
// id; the oracle's two ways agree. Property of test_vectors: every text is read, or refused with an
// Error of exit code 3.
#include <nlohmann/json.hpp>

#include "convexact/conform.hpp"
#include "fuzz_target.hpp"
#include "oracle/stdio_request.hpp"
#include "unless_refused.hpp"

using namespace convexact;
using nlohmann::json;

namespace {

void hold_stdio(FuzzInput& in) {
  const std::string_view line = in.rest();
  const std::string answer = answer_request(line);
  FUZZ_CHECK(answer.find('\n') == std::string::npos);
  const json object = json::parse(answer);
  FUZZ_CHECK(object.is_object());
  FUZZ_CHECK(object.contains("error") != object.contains("claims"));
  if (object.contains("error")) {
    const int exit_code = object["error"].at("exit").get<int>();
    FUZZ_CHECK(exit_code == 2 || exit_code == 3 || exit_code == 4 || exit_code == 6);
  }
  if (object.contains("error")) return;
  const json request = json::parse(line);
  FUZZ_CHECK(object.contains("id") == request.contains("id"));
  if (request.contains("id")) FUZZ_CHECK(object["id"] == request["id"]);
}

void hold_test_vectors(FuzzInput& in) {
  const std::string_view text = in.rest();
  // A vector may name a file that is none of ours; an escape may spell the word.
  if (text.find("file") != text.npos || text.find('\\') != text.npos) return;
  const auto vectors =
      unless_refused([&] { return read_test_vectors_bytes(text, "no-such-folder"); });
  if (!vectors) return;
  FUZZ_CHECK(vectors->size() <= text.size());
}

const FuzzTarget stdio("stdio", hold_stdio);
const FuzzTarget test_vectors("test_vectors", hold_test_vectors);

}  // namespace
