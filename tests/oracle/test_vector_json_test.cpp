// SPDX-License-Identifier: MIT
// Conformance vectors as texts: numbers that are none of the schema's are refused. The contents of
// the shipped vectors are tested where they are run.
#include <doctest/doctest.h>

#include "convexact/conform.hpp"
#include "expect_error.hpp"

using namespace convexact;

namespace {

std::string vector_text(const std::string& level, const std::string& corner,
                        const std::string& facets) {
  return R"({"vectors": [{"id": "x", "title": "x", "level": )" + level +
         R"(, "required": true, "flags": [], "input": {"points": [[0, 0, 0]]},
         "question": {"ask": "verify", "max_facets": )" +
         facets + R"(, "candidate": {"points": [[0, 0, 0], [1, 0, 0], [0, 1, 0]],
         "faces": [[0, 1, )" +
         corner + R"(]]}}, "expected": {"claims": {"mesh-closed": "violated"}}}]})";
}

ErrorCode refusal(const std::string& level, const std::string& corner, const std::string& facets) {
  return error_of([&] { return read_test_vectors_bytes(vector_text(level, corner, facets), ""); })
      .code();
}

}  // namespace

TEST_CASE("test vectors: counts and indices are integers within their bounds") {
  const auto vectors = read_test_vectors_bytes(vector_text("3", "2", "0"), "");
  REQUIRE(vectors.size() == 1);
  CHECK(vectors[0].level == 3);
  // Beyond the ids and levels, but a budget like any other, as in requests.
  CHECK(refusal("18446744073709551615", "2", "0") == ErrorCode::Malformed);
  CHECK(refusal("1", "18446744073709551615", "0") == ErrorCode::Malformed);
  CHECK(read_test_vectors_bytes(vector_text("1", "2", "18446744073709551615"), "").size() == 1);
  for (const char* const number : {"-1", "1.0", "1e99", "18446744073709551616", "null", "\"2\""}) {
    CAPTURE(number);
    CHECK(refusal(number, "2", "0") == ErrorCode::Malformed);
    CHECK(refusal("1", number, "0") == ErrorCode::Malformed);
    CHECK(refusal("1", "2", number) == ErrorCode::Malformed);
  }
  CHECK(refusal("4", "2", "0") == ErrorCode::Malformed);
  CHECK(refusal("1", "3", "0") == ErrorCode::Malformed);
  const std::string no_points =
      R"({"vectors": [{"id": "x", "title": "x", "level": 1, "required": true, "flags": [],
      "input": {"points": []}, "question": {"ask": "verify", "candidate": {"points": [],
      "faces": [[0, 0, 0]]}}, "expected": {"claims": {}}}]})";
  CHECK(error_of([&] { return read_test_vectors_bytes(no_points, ""); }).code() ==
        ErrorCode::Malformed);
}

TEST_CASE("test vectors: an exponent that no integer negates is refused like any other") {
  const std::string text =
      R"({"vectors": [{"id": "x", "title": "x", "level": 1, "required": true, "flags": [],
      "input": {"halfspaces": [["1*2^-2147483648", "0", "0", "1"]]}, "question": {"ask": "refuse"},
      "expected": {"error": "no-interior"}}]})";
  CHECK(error_of([&] { return read_test_vectors_bytes(text, ""); }).code() == ErrorCode::Malformed);
}
