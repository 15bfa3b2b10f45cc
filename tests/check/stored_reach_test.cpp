// SPDX-License-Identifier: MIT
// The report of convexact-check on stored planes: whether there are any, and how far they reach.
#include "checker.hpp"
#include "proof_text.hpp"
#include "proofs.hpp"
#include "shapes/makers.hpp"

using namespace convexact;

namespace {

// The cube [0, 1]^3 with nothing removed; `stored` are the lines from "stored" on.
std::string cube_proof(const std::string& stored) {
  std::string lines = "convexact-proof 1 greedy\n";
  for (int v = 0; v < 8; ++v) {
    lines += "point " + std::to_string(v & 1) + " " + std::to_string(v >> 1 & 1) + " " +
             std::to_string(v >> 2) + "\n";
  }
  return lines +
         "interior 1/2 1/2 1/2\nplane -1 0 0 0\nplane 0 -1 0 0\nplane 0 0 -1 0\n"
         "plane 0 0 1 -1\nplane 0 1 0 -1\nplane 1 0 0 -1\n"
         "triangle 0 2 1 0\ntriangle 5 1 2 1\ntriangle 4 2 0 2\ntriangle 5 2 4 3\n"
         "triangle 3 0 1 4\ntriangle 5 3 1 5\ntriangle 4 0 3 6\ntriangle 5 4 3 7\n"
         "survive 0 1 2 3 4 5\n" +
         stored + "end 0\n";
}

// A box: the planes of the cube, each moved out by this much.
std::string box(const std::array<std::string, 6>& outward) {
  const char* const normals[] = {"-1 0 0 ", "0 -1 0 ", "0 0 -1 ", "0 0 1 ", "0 1 0 ", "1 0 0 "};
  std::string lines = "stored\n";
  for (std::size_t i = 0; i < 6; ++i) lines += "halfspace " + (normals[i] + outward[i]) + " 1\n";
  return lines;
}

std::string said(const std::string& stored) {
  const CheckerVerdict verdict = check_proof(ProofText(cube_proof(stored)).text(true));
  CHECK_MESSAGE(verdict.exit_code == 0, verdict.said);
  return verdict.said;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("stored: a proof without the section claims nothing of it (#13)") {
  const std::string text = said("");
  CHECK(has(text, "proven: the 6 planes left are bounded and hold every point\n"));
  CHECK(has(text, "not claimed: anything about stored planes, as the proof has none\n"));
  CHECK_FALSE(has(text, "stored are"));
}

TEST_CASE("stored: how far it reaches, from above, in closed form (#13)") {
  CHECK(has(said(box({"0", "0", "0", "-1", "-1", "-1"})), "reach nowhere beyond the planes left"));
  // Every side out by t: the corners move by t sqrt(3), the diameter is sqrt(3).
  CHECK(has(said(box({"-1", "-1", "-1", "-2", "-2", "-2"})), "reach at most 1.0e0 of the points'"));
  CHECK(has(said(box({"-1/8", "-1/8", "-1/8", "-9/8", "-9/8", "-9/8"})), "at most 1.3e-1 of"));
  CHECK(
      has(said(box({"-1/1000000", "0", "0", "-1", "-1", "-1"})), "at most 5.8e-7 of"));  // 1/sqrt 3
  CHECK(has(said(box({"-99999", "-99999", "-99999", "-100000", "-100000", "-100000"})),
            "at most 1.0e5 of"));
  CHECK(has(said(box({"-0x1p-60", "0", "0", "-1", "-1", "-1"})), "at most 5.1e-19 of"));
}

TEST_CASE("stored: planes in another order bound the same, and nothing is said of how near (#13)") {
  std::string lines = "stored\n";
  for (const char* plane :
       {"1 0 0 -1", "0 1 0 -1", "0 0 1 -1", "0 0 -1 0", "0 -1 0 0", "-1 0 0 0"}) {
    lines += std::string("halfspace ") + plane + " 1\n";
  }
  CHECK(has(said(lines), "differ too much from the planes left for a bound"));
}

TEST_CASE("stored: in binary64 and binary32 within what these explain (#13)") {
  const Shape shape = PointSet(shapes::cut_cube(8, 0.1));
  for (const auto& [precision, unit] :
       {std::pair(Precision::Binary64, 1e-14), std::pair(Precision::Binary32, 1e-5)}) {
    const CheckerVerdict verdict = check_proof(proof_of(shape, Engine::Filtered, 9, precision));
    REQUIRE_MESSAGE(verdict.exit_code == 0, verdict.said);
    const std::size_t at = verdict.said.find("reach at most ");
    if (at == std::string::npos) {
      CHECK(has(verdict.said, "reach nowhere"));
    } else {
      CHECK(std::stod(verdict.said.substr(at + 14)) < unit);
    }
  }
}
