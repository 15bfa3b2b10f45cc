// SPDX-License-Identifier: MIT
// Property of stdio: for any line, the answer is one line of JSON, an object with either a
// verdict or an error of a documented kind (6 beyond its time limit); a verdict has the request's
// id; the oracle's two ways agree. Property of decompose_stdio: the same, with the parts of the
// mesh in place of the verdict, and the oracle finds that they cover the mesh. Property of
// test_vectors: every text is read, or refused with an Error of exit code 3.
#include <nlohmann/json.hpp>

#include "convexact/conform.hpp"
#include "fuzz_target.hpp"
#include "unless_refused.hpp"
#include "wire/decompose_request.hpp"
#include "wire/stdio_request.hpp"

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

void hold_decompose_stdio(FuzzInput& in) {
  const std::string_view line = in.rest();
  if (line.size() > 4096) return;
  const std::string answer = answer_decompose_request(line, 20.0);
  FUZZ_CHECK(answer.find('\n') == std::string::npos);
  const json object = json::parse(answer);
  FUZZ_CHECK(object.contains("error") != object.contains("parts"));
  if (object.contains("error")) {
    const int exit_code = object["error"].at("exit").get<int>();
    FUZZ_CHECK(exit_code >= 2 && exit_code <= 6);
    return;
  }
  const json request = json::parse(line);
  FUZZ_CHECK(object.contains("id") == request.contains("id"));
  // Decimals are read as doubles here; with these keys they would have another meaning.
  if (request.contains("decimal") || request.contains("numbers")) return;
  const json judged = {{"points", request["points"]},
                       {"triangles", request["triangles"]},
                       {"claims", {"covers-surface"}},
                       {"candidate", object}};
  const json verdict = json::parse(answer_request(judged.dump(), 20.0));
  FUZZ_CHECK(verdict.contains("error") ? verdict["error"].at("exit") == 6
                                       : verdict.at("verdict") == "holds");
}

void hold_test_vectors(FuzzInput& in) {
  const std::string_view text = in.rest();
  // A vector may name a file outside of the project; an escape may spell the word.
  if (text.find("file") != text.npos || text.find('\\') != text.npos) return;
  const auto vectors =
      unless_refused([&] { return read_test_vectors_bytes(text, "no-such-folder"); });
  if (!vectors) return;
  FUZZ_CHECK(vectors->size() <= text.size());
}

const FuzzTarget kStdio("stdio", hold_stdio);
const FuzzTarget kDecomposeStdio("decompose_stdio", hold_decompose_stdio);
const FuzzTarget kTestVectors("test_vectors", hold_test_vectors);

}  // namespace
