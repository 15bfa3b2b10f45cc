// SPDX-License-Identifier: MIT
// Every engine's proof of every shipped mesh at 18 planes.
#include "checker.hpp"
#include "convexact/io/read_mesh.hpp"
#include "proofs.hpp"
#include "shipped_meshes.hpp"

using namespace convexact;

TEST_CASE("proof: shipped meshes, by every engine") {
  for (const std::string& path : shipped_meshes()) {
    CAPTURE(path);
    const PointSet points = read_mesh(path).points;
    for (const Engine engine : {Engine::Exact, Engine::Filtered, Engine::Float}) {
      CAPTURE(static_cast<int>(engine));
      const CheckerVerdict verdict = check_proof(proof_of(points, engine, 18, Precision::Binary32));
      CHECK_MESSAGE(verdict.exit_code == 0, verdict.said);
    }
  }
}
