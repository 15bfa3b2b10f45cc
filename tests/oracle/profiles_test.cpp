// SPDX-License-Identifier: MIT
// Named promises as texts: valid ones are read, and invalid ones are refused with the name of the
// profile.
#include <doctest/doctest.h>

#include "convexact/conform.hpp"
#include "expect_error.hpp"

using namespace convexact;

namespace {

std::vector<Profile> profiles_with(const std::string& entry) {
  return read_profiles_bytes(R"({"profiles": {"mine": {"title": "x", )" + entry + "}}}");
}

}  // namespace

TEST_CASE("profiles: a promise as spelled, the rest by default (#13)") {
  const Profile full = profiles_with(R"("asks": "hull", "numbers": "binary32", "tolerance": "1e-3d",
      "allow_flat": true, "max_facets": 10, "max_vertices": 11, "max_facet_vertices": 12)")[0];
  CHECK(full.name == "mine");
  CHECK(full.promise.asks == Asks::Hull);
  CHECK(full.promise.numbers == Precision::Binary32);
  CHECK(full.promise.tolerance.value == Rational(1, 1000));
  CHECK(full.promise.tolerance.relative);
  CHECK(full.promise.allow_flat);
  CHECK(full.promise.max_facets == 10);
  CHECK(full.promise.max_vertices == 11);
  CHECK(full.promise.max_facet_vertices == 12);
  const Promise plain = profiles_with(R"("asks": "inner")")[0].promise;
  CHECK(plain.asks == Asks::Inner);
  CHECK(plain.numbers == Precision::Binary64);
  CHECK(plain.tolerance.value == 0);
  CHECK_FALSE(plain.allow_flat);
  CHECK_FALSE(plain.max_vertices.has_value());
}

TEST_CASE("profiles: what is none is malformed, by the name of the profile (#13)") {
  for (const char* entry :
       {R"("asks": "hulls")", R"("asks": 3)", R"("numbers": "binary64")",
        R"("asks": "hull", "numbers": "binary16")", R"("asks": "hull", "tolerance": "1e-3x")",
        R"("asks": "hull", "tolerance": "-1")", R"("asks": "hull", "max_facets": -1)",
        R"("asks": "hull", "max_facets": 1.5)", R"("asks": "hull", "allow_flat": "no")",
        R"("asks": "hull", "max_faces": 3)"}) {
    CAPTURE(std::string(entry));
    const Error error = error_of([&] { (void)profiles_with(entry); });
    CHECK(error.code() == ErrorCode::Malformed);
    CHECK(std::string(error.what()).find("profile mine") != std::string::npos);
  }
  CHECK(error_of([] { (void)read_profiles_bytes("{}"); }).code() == ErrorCode::Malformed);
  CHECK(error_of([] { (void)read_profiles_bytes("{"); }).code() == ErrorCode::Malformed);
}

TEST_CASE("profiles: an unknown name is wrong usage, with the list (#13)") {
  const std::vector<Profile> profiles = profiles_with(R"("asks": "hull")");
  CHECK(profile_of_name(profiles, "mine").title == "x");
  const Error error = error_of([&] { (void)profile_of_name(profiles, "yours"); });
  CHECK(error.code() == ErrorCode::InvalidArgument);
  CHECK(std::string(error.what()).find("one of mine") != std::string::npos);
}
