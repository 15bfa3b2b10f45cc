// SPDX-License-Identifier: MIT
#include "checker.hpp"

#include <sstream>

#define main convexact_check_main
#include "../../src/check/convexact_check.cpp"
#undef main

CheckerVerdict check_proof(const std::string& text) {
  std::istringstream in(text);
  std::ostringstream said;
  std::streambuf* const before = std::cout.rdbuf(said.rdbuf());
  Proof proof(in);
  int exit_code = 0;
  try {
    proof.check();
  } catch (const Failure& failure) {
    exit_code = failure.first;
    said << "line " << proof.line << ": " << failure.second;
  }
  std::cout.rdbuf(before);
  return {exit_code, said.str()};
}
