// SPDX-License-Identifier: MIT
// Every engine's proof of every shipped mesh at 18 planes, and of every family of solids; proofs of
// the decompositions of the shipped meshes.
#include "checker.hpp"
#include "convexact/io.hpp"
#include "convexact/shapes.hpp"
#include "decompositions.hpp"
#include "proofs.hpp"
#include "shipped_meshes.hpp"

using namespace convexact;

namespace {

void check_engines(const PointSet& points, std::size_t faces,
                   std::optional<Precision> precision = {}) {
  for (const Engine engine : {Engine::Exact, Engine::Filtered, Engine::Float}) {
    CAPTURE(static_cast<int>(engine));
    const CheckerVerdict verdict = check_proof(proof_of(points, engine, faces, precision));
    CHECK_MESSAGE(verdict.exit_code == 0, verdict.said);
    if (engine == Engine::Float) continue;
    for (const CostMeasure cost : {CostMeasure::Area, CostMeasure::MeanWidth}) {
      const CheckerVerdict metric = check_proof(proof_of(points, engine, faces, {}, cost));
      CHECK_MESSAGE(metric.exit_code == 0, metric.said);
    }
  }
}

}  // namespace

TEST_CASE("proof: shipped meshes, by every engine") {
  for (const std::string& path : shipped_meshes()) {
    CAPTURE(path);
    check_engines(read_mesh(path).points, 18, Precision::Binary32);
  }
}

TEST_CASE("proof: every family of solids, by every engine") {
  for (const shapes::Family& family : shapes::families()) {
    if (family.dimension < 3) continue;
    CAPTURE(family.name);
    check_engines(PointSet(shapes::generate(family, shapes::usual_values(family))), 6);
  }
}

TEST_CASE("proof: the parts of shipped meshes, by both measures") {
  for (const std::string& path : shipped_meshes()) {
    CAPTURE(path);
    for (const auto measure : {ConcavityMeasure::Surface, ConcavityMeasure::Vertices}) {
      DecomposeRequest request;
      request.measure = measure;
      const CheckerVerdict verdict = check_proof(proof_of_parts(read_mesh(path), request), path);
      CHECK_MESSAGE(verdict.exit_code == 0, verdict.said);
    }
  }
}
