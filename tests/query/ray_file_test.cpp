// SPDX-License-Identifier: MIT
// Files of rays: what they spell, and where they are refused.
#include <doctest/doctest.h>

#include "convexact/query.hpp"
#include "expect_error.hpp"
#include "process.hpp"
using namespace convexact;

TEST_CASE("ray files: comments, blank lines, fractions, and decimals of either meaning") {
  const std::string text =
      "# origin, direction\n\n0 -1/3 5. 1 +2 -3e-1  # the first\r\n  \t\n.5 0 0 0 0 0x1p0\r"
      "1 2 3 0 0 1";
  CHECK(error_of([&] { return read_rays_bytes(text); }).line() == 5);
  const std::string two =
      "# origin, direction\n\n0 -1/3 5. 1 +2 -3e-1  # the first\r\n\n1 2 3 0 0 1";
  const std::vector<Ray> rays = read_rays_bytes(two);
  REQUIRE(rays.size() == 2);
  CHECK(rays[0].origin == RationalPoint(0, Rational(-1, 3), 5));
  CHECK(rays[0].direction == RationalVector3(1, 2, to_rational(-0.3)));
  CHECK(rays[1].origin == RationalPoint(1, 2, 3));
  CHECK(rays[1].direction == RationalVector3(0, 0, 1));
  CHECK(read_rays_bytes(two, Decimal::Exact)[0].direction[2] == Rational(-3, 10));
  // Too small for a double is zero only where it means the nearest one.
  CHECK(read_rays_bytes("0 0 0 1e-400 0 0", Decimal::Exact)[0].direction[0] > 0);
  CHECK(error_of([] { return read_rays_bytes("0 0 0 1e-400 0 0"); }).code() ==
        ErrorCode::Malformed);
}

TEST_CASE("ray files: each kind of malformed line is refused with its number") {
  struct Broken {
    const char* text;
    std::size_t line;
    ErrorCode code;
  };
  for (const auto& [text, line, code] :
       std::initializer_list<Broken>{{"", 1, ErrorCode::Malformed},
                                     {"# nothing\n", 2, ErrorCode::Malformed},
                                     {"1 2 3 4 5\n", 1, ErrorCode::Malformed},
                                     {"1 2 3 4 5 # 6\n", 1, ErrorCode::Malformed},
                                     {"1 2 3 4 5 6 7\n", 1, ErrorCode::Malformed},
                                     {"1 2 3 4 5 6\n1 2 3 4 5 six\n", 2, ErrorCode::Malformed},
                                     {"1 2 3 4 5 6\n\n1,2,3,4,5,6\n", 3, ErrorCode::Malformed},
                                     {"1 2 3 4 5 6/0\n", 1, ErrorCode::Malformed},
                                     {"\n1 2 3 0 0 0\n", 2, ErrorCode::Malformed},
                                     {"1 2 3 0/7 -0 0.0\n", 1, ErrorCode::Malformed},
                                     {"1 2 3 4 5 nan\n", 1, ErrorCode::NotFinite},
                                     {"inf 2 3 4 5 6\n", 1, ErrorCode::NotFinite},
                                     {"1 2 3 4 5 1e999\n", 1, ErrorCode::NotFinite}}) {
    const std::string bytes = text;
    CAPTURE(bytes);
    const Error error = error_of([&] { return read_rays_bytes(bytes); });
    const bool same_code = error.code() == code;
    CHECK(same_code);
    const bool same_line = error.line() == line;
    CHECK_MESSAGE(same_line, error.what());
    CHECK(exit_code(error.code()) == 3);
  }
}

TEST_CASE("ray files: an error names the file; one that is not there is unreadable") {
  const support::ScratchFolder scratch;
  const std::string path = scratch.write("rays.txt", "0 0 0 1 0 0\n0 0 0 0 0 0\n");
  const Error error = error_of([&] { return read_rays(path); });
  CHECK(std::string(error.what()).starts_with(path + ":2: "));
  CHECK(error_of([&] { return read_rays(scratch.file("none.txt")); }).code() ==
        ErrorCode::Unreadable);
}
