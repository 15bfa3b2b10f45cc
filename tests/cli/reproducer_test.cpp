// SPDX-License-Identifier: MIT
// The file that a failed verification leaves: expected contents are the inputs of the test.
#include "cli/reproducer.hpp"

#include <doctest/doctest.h>

#include "process.hpp"

using convexact::cli::Reproducer;
using convexact::cli::write_reproducer;

TEST_CASE("reproducer: command, failure and inputs, and never over an older one") {
  const support::ScratchFolder scratch;
  const Reproducer reproducer{{"convexact", "hull", "a.obj"},
                              "it broke",
                              {{"a.obj", std::make_shared<const std::string>("v 1 2 3")}}};
  const std::string first = write_reproducer(reproducer, scratch.file("."));
  const std::string second = write_reproducer(reproducer, scratch.file("."));
  CHECK(first != second);
  const std::string text = support::bytes_of(first);
  CHECK(text == support::bytes_of(second));
  for (const char* part : {"convexact hull a.obj", "it broke", "input a.obj, 7 bytes:\nv 1 2 3"}) {
    CAPTURE(part);
    CHECK(text.find(part) != std::string::npos);
  }
}

TEST_CASE("reproducer: a folder that cannot be written to is not another failure") {
  CHECK(write_reproducer({}, "/no/such/folder").empty());
}
