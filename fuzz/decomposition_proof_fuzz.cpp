// SPDX-License-Identifier: MIT
// Property of decomposition_proof: convexact-check accepts the proof of every decomposition; a
// proof that is changed in a few words or lines is refused, or its claims are still true by the
// definition. Property of decomposition_text: for any bytes of such a proof the checker ends with
// a documented exit code, and any proof that it accepts is true by the definition.
#include "../tests/check/checker.hpp"
#include "changed_proof.hpp"
#include "convexact/decompose.hpp"
#include "definitional_decomposition.hpp"
#include "fuzz_check.hpp"
#include "fuzz_target.hpp"
#include "proof/decomposition_proof.hpp"

using namespace convexact;

namespace {

Mesh triangles_of(FuzzInput& in) {
  Mesh mesh;
  const std::vector<Point> points = in.grid_points(in.rarely() ? 12 : 7, 3);
  if (points.empty()) return mesh;
  mesh.points = PointSet(points);
  for (std::size_t count = 1 + in.below(8); count > 0; --count) {
    auto& polygon = mesh.polygons.emplace_back();
    for (std::size_t corners = in.rarely() ? 4 : 3; corners > 0; --corners) {
      polygon.push_back(static_cast<std::uint32_t>(in.below(points.size())));
    }
  }
  return mesh;
}

// The proof of some decomposition; empty if there is none.
std::string proof_of_some_decomposition(FuzzInput& in) {
  DecomposeRequest request;
  request.engine = std::array{Engine::Exact, Engine::Filtered, Engine::Float}[in.below(3)];
  request.measure = in.below(2) == 0 ? ConcavityMeasure::Surface : ConcavityMeasure::Vertices;
  request.limit = {Rational(in.below(9), 8), in.below(2) == 0};
  request.limit.is_share = request.limit.is_share && request.limit.value <= 1;
  request.orient = in.below(2) == 0 ? Orient::Auto : Orient::Keep;
  request.flat = std::array{FlatParts::Thicken, FlatParts::Keep, FlatParts::Merge}[in.below(3)];
  request.keep_inner = in.below(2) == 0;
  if (in.below(4) == 0) request.faces = 4 + in.below(3);
  if (in.below(4) == 0) request.precision = Precision::Binary32;
  if (in.below(8) == 0) request.connect = Connect::Touching;
  request.measures = PartMeasures::None;
  const Mesh mesh = triangles_of(in);
  if (mesh.polygons.empty()) return "";
  const DecomposeOutcome outcome = decompose(mesh, request);
  const auto* made = std::get_if<Decomposition>(&outcome);
  return made == nullptr ? "" : write_decomposition_proof(*made, request);
}

constexpr const char* kDecompositionWords[] = {
    "0",      "1",    "2",     "-1",     "1/2",  "0/0",   "-",     "nan",       "hull",
    "stored", "flat", "edges", "within", "part", "facet", "share", "unclaimed", "99999999999"};

void check_decomposition_claims(const std::string& proof) {
  const CheckerVerdict verdict = check_proof(proof);
  FUZZ_CHECK(verdict.exit_code == 0 || verdict.exit_code == 1 || verdict.exit_code == 3);
  FUZZ_CHECK(!verdict.said.empty());
  if (verdict.exit_code != 0 || verdict.said.find("clusters") == verdict.said.npos) return;
  const definition::DecompositionClaims claims(proof);
  if (claims.size() > 40) return;  // the definition is slow
  FUZZ_CHECK(claims.are_true());
}

void hold_decomposition_proof(FuzzInput& in) {
  const std::string proof = proof_of_some_decomposition(in);
  if (proof.empty()) return;
  FUZZ_CHECK(check_proof(proof).exit_code == 0);
  if (in.rarely()) check_decomposition_claims(proof);
  for (std::size_t rounds = in.below(5); rounds > 0 && !in.empty(); --rounds) {
    ProofText changed(proof);
    const bool is_renumbered = in.below(4) > 0;
    for (std::size_t count = 1 + in.below(3); count > 0; --count)
      change_proof(changed, kDecompositionWords, in);
    check_decomposition_claims(changed.text(is_renumbered));
  }
}

void hold_decomposition_text(FuzzInput& in) { check_decomposition_claims(std::string(in.rest())); }

const FuzzTarget kDecompositionProof("decomposition_proof", hold_decomposition_proof);
const FuzzTarget kDecompositionText("decomposition_text", hold_decomposition_text);

}  // namespace
