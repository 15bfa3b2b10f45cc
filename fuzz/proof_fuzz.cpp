// SPDX-License-Identifier: MIT
// Property of proof: convexact-check accepts the proof of every run; a proof that is changed in a
// few words or lines is refused, or its claims are still true by the definition. Property of
// proof_text: for any bytes of a proof, the checker ends with a documented exit code, and any proof
// that it accepts is true by the definition.
#include "../tests/check/checker.hpp"
#include "changed_proof.hpp"
#include "convexact/simplify.hpp"
#include "definitional_proof.hpp"
#include "fuzz_check.hpp"
#include "fuzz_target.hpp"
#include "proof/proof.hpp"

using namespace convexact;

namespace {

// Halfspaces that bound a box, cut somewhere.
std::vector<Halfspace> cut_box(FuzzInput& in) {
  std::vector<Halfspace> list;
  for (int k = 0; k < 6; ++k) {
    IntegerVector3 normal = IntegerVector3::Zero();
    normal[k / 2] = k % 2 == 0 ? 1 : -1;
    list.emplace_back(normal, Integer(-2 - static_cast<int>(in.below(2))));
  }
  for (std::size_t count = in.below(4); count > 0; --count) {
    IntegerVector3 normal;
    for (Integer& n : normal) n = static_cast<int>(in.below(5)) - 2;
    if (normal == IntegerVector3::Zero()) normal[0] = 1;
    list.emplace_back(normal, Integer(-1 - static_cast<int>(in.below(8))));
  }
  return list;
}

Shape shape_of(FuzzInput& in) {
  if (in.below(4) == 0) return cut_box(in);
  return PointSet(in.grid_points(in.rarely() ? 12 : 6, 2));
}

// The proof of some run; empty if there is none, because the shape is no solid.
std::string proof_of_some_run(FuzzInput& in) {
  SimplifyRequest request;
  request.engine = std::array{Engine::Exact, Engine::Filtered, Engine::Float}[in.below(3)];
  request.faces = 4 + in.below(4);
  request.record = true;
  const std::size_t precision = in.below(3);
  if (precision == 1) request.store.planes = Precision::Binary64;
  if (precision == 2) request.store.planes = Precision::Binary32;
  const Shape shape = shape_of(in);
  if (request.engine != Engine::Float) {
    request.cost = std::array{CostMeasure::Volume, CostMeasure::Area, CostMeasure::MeanWidth,
                              CostMeasure::Area}[in.below(4)];
  }
  const SimplifyOutcome outcome = simplify(shape, request);
  const auto* result = std::get_if<SimplifyResult>(&outcome);
  if (result == nullptr) return "";
  return write_proof(result->start.value(), result->run.value(), result->solid.points,
                     result->solid.planes);
}

constexpr const char* kRunWords[] = {
    "0",   "1",         "2",    "-1",   "1/2", "0/0", "-",        "0x1p0",       "0x1p9",
    "nan", "unbounded", "cost", "ring", "tie", "end", "evaluate", "99999999999", "triangles"};

void check_claims(const std::string& proof, const std::string& original) {
  const CheckerVerdict verdict = check_proof(proof);
  FUZZ_CHECK(verdict.exit_code == 0 || verdict.exit_code == 1 || verdict.exit_code == 3);
  FUZZ_CHECK(!verdict.said.empty());
  if (verdict.exit_code != 0) return;
  if (verdict.said.find(" clusters") != verdict.said.npos) return;  // of a decomposition
  const definition::ProofClaims claims(proof);
  if (!original.empty() && claims == definition::ProofClaims(original)) return;
  if (claims.points.size() > 16 || claims.planes.size() > 24) return;  // the definition is slow
  FUZZ_CHECK(claims.are_true());
}

void hold_proof(FuzzInput& in) {
  const std::string proof = proof_of_some_run(in);
  if (proof.empty()) return;
  FUZZ_CHECK(check_proof(proof).exit_code == 0);
  if (in.rarely()) check_claims(proof, "");
  for (std::size_t rounds = in.below(5); rounds > 0 && !in.empty(); --rounds) {
    ProofText changed(proof);
    const bool is_renumbered = in.below(4) > 0;
    for (std::size_t count = 1 + in.below(3); count > 0; --count)
      change_proof(changed, kRunWords, in);
    check_claims(changed.text(is_renumbered), proof);
  }
}

void hold_proof_text(FuzzInput& in) { check_claims(std::string(in.rest()), ""); }

const FuzzTarget kProof("proof", hold_proof);
const FuzzTarget kProofText("proof_text", hold_proof_text);

}  // namespace
