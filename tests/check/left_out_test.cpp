// SPDX-License-Identifier: MIT
// Forgeries by leaving out and by change: every line of a proof of every kind, all lines of one
// kind, every section, a run of lines of one kind; every number of a decomposition's proof. Right
// is, by the meaning of a proof: it is refused, or each sentence that is still proven was proven by
// the whole proof, too.
#include <algorithm>
#include <cstdlib>
#include <functional>
#include <set>
#include <sstream>

#include "checker.hpp"
#include "convexact/io.hpp"
#include "decompositions.hpp"
#include "proof_text.hpp"
#include "proofs.hpp"
#include "shapes/makers.hpp"

using namespace convexact;
using support::Cell;
using support::mesh_of_cells;

namespace {

std::string proof_of_clusters(const Mesh& mesh, ConcavityMeasure measure, FlatParts flat,
                              const Rational& limit = Rational(1, 100)) {
  DecomposeRequest request;
  request.limit = {limit, true};
  request.measure = measure;
  request.flat = flat;
  return proof_of_parts(mesh, request);
}

std::string proof_of_splits(const Mesh& mesh, const Rational& limit) {
  DecomposeRequest request;
  request.method = DecomposeMethod::Acd;
  request.limit = {limit, true};
  return proof_of_parts(mesh, request);
}

// A cell and, apart from it, a square: a flat part.
Mesh cell_and_square() {
  Mesh mesh = mesh_of_cells({{0, 0, 0}});
  std::vector<RationalPoint> points;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) points.push_back(mesh.points[PointId(i)]);
  const auto first = static_cast<std::uint32_t>(points.size());
  for (const auto& [x, y] : {std::pair(3, 0), {4, 0}, {4, 1}, {3, 1}}) points.emplace_back(x, y, 0);
  mesh.points = PointSet(points);
  mesh.polygons.push_back({first, first + 1, first + 2, first + 3});
  mesh.parts.clear();
  return mesh;
}

std::vector<std::string> proofs_of_every_kind() {
  const Mesh bend = mesh_of_cells({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const PointSet cut(shapes::cut_cube(2, 0.25));
  return {proof_of(cut, Engine::Exact, 6, Precision::Binary64),
          proof_of(cut, Engine::Float, 6, Precision::Binary32),
          proof_of(cut, Engine::Exact, 6, {}, CostMeasure::Area),
          proof_of(cut, Engine::Exact, 6, {}, CostMeasure::MeanWidth),
          proof_of_clusters(bend, ConcavityMeasure::Surface, FlatParts::Keep),
          proof_of_clusters(bend, ConcavityMeasure::Vertices, FlatParts::Keep),
          proof_of_clusters(dented_cube(), ConcavityMeasure::Surface, FlatParts::Keep),
          proof_of_clusters(bend, ConcavityMeasure::Surface, FlatParts::Keep, 1),
          proof_of_clusters(dented_cube(), ConcavityMeasure::Vertices, FlatParts::Keep, 1),
          proof_of_clusters(cell_and_square(), ConcavityMeasure::Surface, FlatParts::Keep),
          proof_of_clusters(cell_and_square(), ConcavityMeasure::Vertices, FlatParts::Thicken),
          proof_of_splits(bend, Rational(1, 100)),
          proof_of_splits(dented_cube(), Rational(1)),
          proof_of_splits(cell_and_square(), Rational(1))};
}

std::set<std::string> sentences(const std::string& said) {
  std::set<std::string> proven;
  std::istringstream lines(said);
  for (std::string line; std::getline(lines, line);) {
    // A cost that nobody needs may go: how many were found is no claim about the run.
    if (line.starts_with("proven")) proven.insert(line.substr(0, line.find(", by ")));
  }
  return proven;
}

// Leaves out the lines for which `is_gone` is true, and counts the rest again.
void check_without(const ProofText& proof, const std::set<std::string>& proven,
                   const std::function<bool(std::size_t line)>& is_gone) {
  ProofText rest = proof;
  rest.lines.clear();
  for (std::size_t l = 0; l < proof.lines.size(); ++l) {
    if (!is_gone(l)) rest.lines.push_back(proof.lines[l]);
  }
  if (rest.lines.empty()) return;
  const CheckerVerdict verdict = check_proof(rest.text(true));
  if (verdict.exit_code == 1 || verdict.exit_code == 3) return;
  CHECK(verdict.exit_code == 0);
  const std::set<std::string> still = sentences(verdict.said);
  CHECK_MESSAGE(std::includes(proven.begin(), proven.end(), still.begin(), still.end()),
                verdict.said);
}

}  // namespace

TEST_CASE("left out: a line, a kind of line or a section of a proof proves nothing more") {
  std::set<std::string> kinds;
  for (const std::string& text : proofs_of_every_kind()) {
    const CheckerVerdict whole = check_proof(text);
    REQUIRE_MESSAGE(whole.exit_code == 0, whole.said);
    const std::set<std::string> proven = sentences(whole.said);
    const ProofText proof(text);
    CAPTURE(text.substr(0, text.find('\n')));
    std::set<std::string> keywords;
    for (std::size_t l = 0; l < proof.lines.size(); ++l) {
      const std::string& keyword = proof.lines[l][0];
      INFO(keyword, " in line ", l + 1);
      keywords.insert(keyword);
      check_without(proof, proven, [&](std::size_t other) { return other == l; });
      if (l > 0 && proof.lines[l - 1][0] == keyword) continue;
      std::size_t end = l;
      while (end < proof.lines.size() && proof.lines[end][0] == keyword) ++end;
      check_without(proof, proven, [&](std::size_t other) { return l <= other && other < end; });
      // With the lines of other kinds that follow, up to the next such section.
      std::size_t next = end;
      while (next < proof.lines.size() && proof.lines[next][0] != keyword) ++next;
      check_without(proof, proven, [&](std::size_t other) {
        return l <= other && other < next && proof.lines[other][0] != "end";
      });
    }
    for (const std::string& keyword : keywords) {
      INFO("all of ", keyword);
      check_without(proof, proven,
                    [&](std::size_t line) { return proof.lines[line][0] == keyword; });
    }
    kinds.merge(keywords);
  }
  for (const char* needed : {"cluster", "facet", "part", "owns", "depth", "deepest", "within",
                             "apart", "corner", "evaluate", "remove", "stored", "survive"}) {
    CHECK_MESSAGE(kinds.count(needed) == 1, std::string(needed));
  }
}

// Another number there may prove the same: a stored corner farther out, another halfspace that
// holds the cluster, another plane that bounds a ray.
bool may_prove_the_same(const std::string& keyword) {
  return keyword == "corner" || keyword == "side" || keyword == "within";
}
// It is about another mesh or limit then, and says so: the file of the mesh differs.
bool is_of_the_question(const std::string& keyword) {
  return keyword == "point" || keyword == "triangle" || keyword == "limit";
}

TEST_CASE("changed: any number of a decomposition's proof") {
  for (const std::string& text : proofs_of_every_kind()) {
    if (text.find(" decomposition\n") == text.npos) continue;
    const std::set<std::string> proven = sentences(check_proof(text).said);
    const ProofText original(text);
    ProofText proof = original;
    for (std::size_t l = 1; l < proof.lines.size(); ++l) {
      const std::string& keyword = original.lines[l][0];
      for (std::size_t w = 1; w < original.lines[l].size(); ++w) {
        for (const char* word : {"0", "1", "2", "7", "1/3", "-1"}) {
          if (original.lines[l][w] == word) continue;
          INFO(keyword, ", line ", l + 1, ", word ", w, ": ", std::string(word));
          proof.lines[l][w] = word;
          const CheckerVerdict verdict = check_proof(proof.text());
          if (verdict.exit_code == 1 || verdict.exit_code == 3) continue;
          CHECK(verdict.exit_code == 0);
          if (is_of_the_question(keyword)) continue;
          CHECK_MESSAGE(may_prove_the_same(keyword), verdict.said);
          CHECK(sentences(verdict.said) == proven);
        }
        proof.lines[l] = original.lines[l];
      }
    }
  }
}

// The corner (1, 1, 1) of a dented cube is 1 away from every facet of the hull. The limit is 0.
TEST_CASE("left out: without its facets a cluster would be flat, and no point deep in it") {
  const char* folder = std::getenv("CONVEXACT_TEST_DATA");
  REQUIRE(folder != nullptr);
  const CheckerVerdict verdict =
      check_proof(read_bytes(std::string(folder) + "/dent_forged.proof"));
  CHECK(verdict.exit_code == 1);
  CHECK_MESSAGE(verdict.said.find("not flat") != std::string::npos, verdict.said);
}
