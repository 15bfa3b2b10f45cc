// SPDX-License-Identifier: MIT
// Proofs of runs that keep planes: on a cube with a corner cut off at x + y + z <= 5/2, where a
// side at 1 goes at 25/48 if the cut is kept, though the cut alone would cost 1/48.
#include <algorithm>
#include <string>
#include <vector>

#include "checker.hpp"
#include "proof_text.hpp"
#include "proofs.hpp"
#include "shapes/makers.hpp"
#include "sweep.hpp"

using namespace convexact;

namespace {

// The corner at (1, 1, 1) is cut off in canonical order last: plane 6.
std::vector<Point> cut_cube() {
  std::vector<Point> points;
  for (int v = 0; v < 7; ++v) points.emplace_back(v & 1, v >> 1 & 1, v >> 2);
  points.insert(points.end(), {{0.5, 1, 1}, {1, 0.5, 1}, {1, 1, 0.5}});
  return points;
}

SimplifyRequest keeping(Engine engine, std::size_t faces, CostMeasure cost, KeepIds keep) {
  SimplifyRequest request;
  request.engine = engine;
  request.faces = faces;
  request.cost = cost;
  request.record = true;
  request.keep = {{std::move(keep), "these"}};
  return request;
}

std::string cut_cube_proof(KeepIds keep = {{HalfspaceId(6)}}) {
  return proof_of(cut_cube(), keeping(Engine::Exact, 6, CostMeasure::Volume, std::move(keep)));
}

}  // namespace

TEST_CASE("proof of a run that keeps a plane: accepted, and it says so") {
  const std::string text = cut_cube_proof();
  const ProofText proof(text);
  CHECK(proof.lines[0] == std::vector<std::string>{"convexact-proof", "3", "greedy"});
  REQUIRE(proof.all("keep").size() == 1);
  CHECK(proof.lines[proof.all("keep")[0]][1] == "6");
  const CheckerVerdict verdict = check_proof(text);
  CHECK(verdict.exit_code == 0);
  CHECK_MESSAGE(verdict.said.find("proven: each was the cheapest but for 1 planes to be kept, 1 of "
                                  "them tied") != std::string::npos,
                verdict.said);
}

TEST_CASE("proofs of runs that keep planes: every engine and measure" * sweep) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    for (const Engine engine : {Engine::Exact, Engine::Filtered, Engine::Float}) {
      for (const CostMeasure cost :
           {CostMeasure::Volume, CostMeasure::Area, CostMeasure::MeanWidth}) {
        const std::string text = proof_of(
            shapes::on_sphere(40, seed),
            keeping(engine, 10, cost, {{HalfspaceId(0), HalfspaceId(9), HalfspaceId(30)}}));
        CHECK(ProofText(text).all("keep").size() == 3);
        const CheckerVerdict verdict = check_proof(text);
        CHECK_MESSAGE(verdict.exit_code == 0, verdict.said);
      }
    }
  }
}

TEST_CASE("wrong proof: what is kept is not left out of the claim by itself") {
  // Without the line the cut is in the queue, and was never evaluated.
  ProofText proof(cut_cube_proof());
  proof.lines.erase(proof.lines.begin() + std::ptrdiff_t(proof.all("keep")[0]));
  check_refused(proof, 1, "it is not evaluated");
  // Nor does it help to say so later, or in an older version.
  proof = ProofText(cut_cube_proof());
  std::rotate(proof.lines.begin() + std::ptrdiff_t(proof.all("keep")[0]),
              proof.lines.begin() + std::ptrdiff_t(proof.all("keep")[0]) + 1,
              proof.lines.begin() + std::ptrdiff_t(proof.all("evaluate")[1]));
  check_refused(proof, 3, "");
  proof = ProofText(cut_cube_proof());
  proof.lines[0][1] = "2";
  check_refused(proof, 3, "");
}

TEST_CASE("wrong proof: a kept plane in a tie, evaluated, removed, or kept twice") {
  const std::string right = cut_cube_proof({{HalfspaceId(4), HalfspaceId(6)}});
  CHECK(check_proof(right).exit_code == 0);
  ProofText proof(right);
  std::vector<std::string>& removal = proof.lines[proof.all("remove")[0]];
  REQUIRE(removal == std::vector<std::string>{"remove", "3", "tie", "3", "5"});
  removal = {"remove", "3", "tie", "3", "4", "5"};
  check_refused(proof, 1, "the tie is another one");

  // The evaluation of plane 4 as a run without that selector has it.
  const ProofText free(cut_cube_proof());
  std::vector<std::string> evaluation;
  for (const std::size_t l : free.all("evaluate")) {
    if (free.lines[l][1] == "4" && evaluation.empty()) evaluation = free.lines[l];
  }
  proof = ProofText(right);
  proof.lines.insert(proof.lines.begin() + std::ptrdiff_t(proof.all("evaluate")[0]), evaluation);
  check_refused(proof, 1, "it is kept");

  // The run as it is if only the cut is kept removes plane 3; the same with 3 kept.
  proof = free;
  proof.lines.insert(proof.lines.begin() + std::ptrdiff_t(proof.all("keep")[0]), {"keep", "3"});
  check_refused(proof, 1, "it is kept");

  proof = free;
  proof.lines.insert(proof.lines.begin() + std::ptrdiff_t(proof.all("keep")[0]), {"keep", "6"});
  check_refused(proof, 1, "it is kept already");
}
