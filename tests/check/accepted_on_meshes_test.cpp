// SPDX-License-Identifier: MIT
// Every engine's proof of every shipped mesh at 18 planes, and of every family of solids, there by
// area and mean width, too; proofs of the decompositions of the shipped meshes.
#include "checker.hpp"
#include "convexact/io.hpp"
#include "convexact/shapes.hpp"
#include "decompositions.hpp"
#include "proofs.hpp"
#include "shipped_meshes.hpp"

using namespace convexact;

namespace {

constexpr Engine kAllEngines[] = {Engine::Exact, Engine::Filtered, Engine::Float};

void check_one(const PointSet& points, Engine engine, std::size_t faces,
               std::optional<Precision> precision, CostMeasure cost = CostMeasure::Volume) {
  CAPTURE(static_cast<int>(engine));
  CAPTURE(static_cast<int>(cost));
  const CheckerVerdict verdict = check_proof(proof_of(points, engine, faces, precision, cost));
  CHECK_MESSAGE(verdict.exit_code == 0, verdict.said);
}

}  // namespace

TEST_CASE("proof: shipped meshes, by every engine") {
  for (const std::string& path : shipped_meshes()) {
    CAPTURE(path);
    const PointSet points = read_mesh(path).points;
    for (const Engine engine : kAllEngines) check_one(points, engine, 18, Precision::Binary32);
    // The exact engine takes half a minute for these, and its proofs are made in the same way.
    for (const CostMeasure cost : {CostMeasure::Area, CostMeasure::MeanWidth}) {
      check_one(points, Engine::Filtered, 18, {}, cost);
    }
  }
}

TEST_CASE("proof: every family of solids, by every engine") {
  for (const shapes::Family& family : shapes::families()) {
    if (family.dimension < 3) continue;
    CAPTURE(family.name);
    const PointSet points(shapes::generate(family, shapes::usual_values(family)));
    for (const Engine engine : kAllEngines) check_one(points, engine, 6, {});
    for (const Engine engine : {Engine::Exact, Engine::Filtered}) {
      check_one(points, engine, 6, {}, CostMeasure::Area);
      check_one(points, engine, 6, {}, CostMeasure::MeanWidth);
    }
  }
}

TEST_CASE("proof: the parts of shipped meshes, by both measures") {
  // Of larger ones by the usual measure only: the other takes as long again, and shows nothing
  // else.
  constexpr std::size_t kLarge = 20'000;
  for (const std::string& path : shipped_meshes()) {
    CAPTURE(path);
    const Mesh mesh = read_mesh(path);
    for (const auto measure : {ConcavityMeasure::Surface, ConcavityMeasure::Vertices}) {
      if (measure != ConcavityMeasure::Surface && mesh.polygons.size() > kLarge) continue;
      DecomposeRequest request;
      request.measure = measure;
      const CheckerVerdict verdict = check_proof(proof_of_parts(mesh, request), path);
      CHECK_MESSAGE(verdict.exit_code == 0, verdict.said);
    }
  }
}
