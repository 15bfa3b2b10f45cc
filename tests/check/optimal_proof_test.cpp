// SPDX-License-Identifier: MIT
// Proofs that no other planes, as many, bound a smaller volume: accepted for what branch and bound
// finds, refused where the tree leaves something out or the planes are not those of the least.
#include <string>

#include "checker.hpp"
#include "proof_text.hpp"
#include "proofs.hpp"
#include "shapes/makers.hpp"
#include "sweep.hpp"

using namespace convexact;

namespace {

SimplifyRequest optimal_request(std::size_t faces, Engine engine) {
  SimplifyRequest request;
  request.engine = engine;
  request.faces = faces;
  request.record = true;
  request.search = {SearchKind::Optimal, 0};
  return request;
}

std::string optimal_proof(const std::vector<Point>& points, std::size_t faces,
                          Engine engine = Engine::Filtered) {
  return proof_of(points, optimal_request(faces, engine));
}

// A hull of 12 facets, all different.
std::vector<Point> small_hull() { return shapes::on_sphere(8, 3); }

// Where the block of a branch ends: after the close that belongs to it.
std::size_t end_of_branch(const ProofText& proof, std::size_t branch) {
  std::size_t depth = 0;
  for (std::size_t l = branch;; ++l) {
    depth += proof.lines[l][0] == "branch";
    if (proof.lines[l][0] == "close" && --depth == 0) return l + 1;
  }
}

}  // namespace

TEST_CASE("proof of an optimum: accepted, of both engines, down to four planes") {
  for (const auto& points : {small_hull(), shapes::octahedron(), shapes::cube()}) {
    for (const Engine engine : {Engine::Exact, Engine::Filtered}) {
      for (const std::size_t faces : {4u, 5u, 6u, 7u, 9u}) {
        const std::string text = optimal_proof(points, faces, engine);
        const CheckerVerdict verdict = check_proof(text);
        CAPTURE(faces);
        CHECK_MESSAGE(verdict.exit_code == 0, verdict.said);
        CHECK_MESSAGE(verdict.said.find(" planes bound a smaller volume, by ") != std::string::npos,
                      verdict.said);
        CHECK(ProofText(text).lines[0] ==
              std::vector<std::string>{"convexact-proof", "5", "optimal"});
      }
    }
  }
}

TEST_CASE("proof of an optimum: planes that are kept are in every choice") {
  SimplifyRequest request = optimal_request(6, Engine::Filtered);
  request.keep = {{KeepIds{{HalfspaceId(2)}}, "this"}};
  const ProofText proof(proof_of(small_hull(), request));
  const CheckerVerdict verdict = check_proof(proof.text());
  CHECK_MESSAGE(verdict.exit_code == 0, verdict.said);
  CHECK_MESSAGE(verdict.said.find("planes, 1 of them kept, bound") != std::string::npos,
                verdict.said);
  // Without it there are other choices, and the tree says nothing of them.
  ProofText free = proof;
  free.lines.erase(free.lines.begin() + static_cast<std::ptrdiff_t>(proof.all("keep")[0]));
  CHECK(check_proof(free.text(true)).exit_code == 1);
}

TEST_CASE("proof of an optimum: without a proof it claims the volumes of the removals only") {
  SimplifyRequest request = optimal_request(6, Engine::Filtered);
  request.search.nodes = 1;
  const ProofText proof(proof_of(small_hull(), request));
  CHECK(proof.lines[0] == std::vector<std::string>{"convexact-proof", "2", "costs"});
  const CheckerVerdict verdict = check_proof(proof.text());
  CHECK_MESSAGE(verdict.exit_code == 0, verdict.said);
  CHECK(verdict.said.find("smaller") == std::string::npos);
}

TEST_CASE("proof of an optimum: branches left out and early ends are refused" * sweep) {
  const ProofText proof(optimal_proof(small_hull(), 6));
  const std::vector<std::size_t> branches = proof.all("branch");
  REQUIRE(branches.size() > 3);
  std::size_t refused = 0;  // the others are covered by the bound of the state
  for (const std::size_t branch : branches) {
    ProofText without = proof;
    const auto at = [&](std::size_t l) {
      return without.lines.begin() + static_cast<std::ptrdiff_t>(l);
    };
    without.lines.erase(at(branch), at(end_of_branch(proof, branch)));
    refused += check_proof(without.text(true)).exit_code == 1;
  }
  CHECK(2 * refused > branches.size());
  // The first state closes at once.
  ProofText early = proof;
  const auto first = early.lines.begin() + static_cast<std::ptrdiff_t>(proof.all("least")[0]) + 1;
  const auto last = early.lines.begin() + static_cast<std::ptrdiff_t>(proof.all("close").back());
  early.lines.erase(first, last);
  check_refused(early, 1, "a choice of removals may add less");
}

TEST_CASE("proof of an optimum: another least volume is refused") {
  const ProofText proof(optimal_proof(small_hull(), 6));
  const std::size_t least = proof.all("least")[0];
  for (const char* volume : {"0", "1000"}) {
    ProofText other = proof;
    other.lines[least][2] = volume;
    CHECK(check_proof(other.text(true)).exit_code == 1);
  }
  ProofText less = proof;  // true of the tree, and not of the planes that are left
  less.lines[least][2] = "0";
  check_refused(less, 1, "the removals add another volume than the least");
  ProofText count = proof;
  count.lines[least][1] = "7";
  CHECK(check_proof(count.text(true)).exit_code == 1);
}

TEST_CASE("proof of an optimum: what does not belong to a tree is malformed or refused") {
  const ProofText proof(optimal_proof(small_hull(), 6));
  ProofText none = proof;
  none.lines.erase(none.lines.begin() + static_cast<std::ptrdiff_t>(proof.all("least")[0]));
  check_refused(none, 3, "least");
  ProofText old = proof;
  old.lines[0][1] = "3";
  check_refused(old, 3, "a claim");
  ProofText greedy = proof;
  greedy.lines[0][2] = "greedy";
  check_refused(greedy, 3, "a claim");
  ProofText stale = proof;  // of a plane that is not evaluated
  stale.lines.insert(stale.lines.begin() + static_cast<std::ptrdiff_t>(proof.all("least")[0]) + 1,
                     {"branch", "0"});
  check_refused(stale, 1, "it is not evaluated in this state");
  ProofText open = proof;  // the last state never ends
  open.lines.erase(open.lines.begin() + static_cast<std::ptrdiff_t>(proof.all("close").back()));
  check_refused(open, 1, "it is kept");
  ProofText word = proof;
  word.lines[proof.all("close").back()][0] = "survive";
  check_refused(word, 3, "evaluate, branch or close");
}

TEST_CASE("proof of an optimum: a branch beyond the removals to go is refused") {
  ProofText proof(optimal_proof(small_hull(), 6));
  proof.lines[proof.all("least")[0]][1] = "12";  // all planes
  check_refused(proof, 1, "no more removals are to go");
}

// A greedy run that is not optimal, under the tree of the optimum.
TEST_CASE("proof of an optimum: other planes than the least are refused" * sweep) {
  const auto ico = shapes::icosahedron();
  const ProofText proof(optimal_proof(ico, 6));
  ProofText other = proof;
  const std::vector<std::size_t> removals = proof.all("remove");
  REQUIRE(removals.size() == 14);
  // The last removal is left out, with its evaluation and its vertices.
  std::size_t evaluation = removals.back();
  while (other.lines[evaluation][0] != "evaluate") --evaluation;
  const auto at = [&](std::size_t l) {
    return other.lines.begin() + static_cast<std::ptrdiff_t>(l);
  };
  other.lines.erase(at(evaluation), at(proof.all("survive")[0]));
  check_refused(other, 1, "another number of planes is left than the tree is about");
}
