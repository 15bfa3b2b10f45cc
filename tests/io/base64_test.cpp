// SPDX-License-Identifier: MIT
// Bytes as text, in base64.
#include "io/base64.hpp"

#include <doctest/doctest.h>

#include <array>
#include <utility>

using namespace convexact;

TEST_CASE("base64: the vectors of RFC 4648, sec. 10, in both directions") {
  constexpr std::array<std::pair<const char*, const char*>, 7> kVectors = {
      {{"", ""},
       {"f", "Zg=="},
       {"fo", "Zm8="},
       {"foo", "Zm9v"},
       {"foob", "Zm9vYg=="},
       {"fooba", "Zm9vYmE="},
       {"foobar", "Zm9vYmFy"}}};
  for (const auto& [bytes, text] : kVectors) {
    CHECK(to_base64(bytes) == text);
    CHECK(from_base64(text) == bytes);
  }
}

TEST_CASE("base64: bytes beyond 127 and all digits") {
  const std::string bytes = {0, '\x10', '\x83', '\x10', '\x51', '\x87', '\xff', '\xfe', '\xfd'};
  CHECK(to_base64(bytes) == "ABCDEFGH//79");
  CHECK(from_base64("ABCDEFGH//79") == bytes);
}
