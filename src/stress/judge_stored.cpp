// SPDX-License-Identifier: MIT
// Results as bytes: read back, then judged by the oracle.
#include <fmt/format.h>

#include "convexact/verify.hpp"
#include "stress/judge.hpp"

namespace convexact {
namespace {

bool is_of(Precision precision, const Rational& x) {
  return to_rational(round_to(precision, x, Rounding::Nearest)) == x;
}

// Whether every number is of the precision. Planes are read as primitive integers, so only their
// directions and offsets up to a common factor are left of the numbers: a mesh contains more.
bool is_of_precision(const Candidate& candidate, Precision precision) {
  const auto* mesh = std::get_if<Mesh>(&candidate);
  if (mesh == nullptr) return true;
  for (const Point& p : mesh->points.doubles()) {
    for (const double x : p) {
      if (!is_of(precision, to_rational(x))) return false;
    }
  }
  return true;
}

void find_fault(const Verdict& verdict, StressStored& found) {
  for (const ClaimCode code :
       {ClaimCode::CandidateReadable, ClaimCode::CandidateFinite, ClaimCode::CandidateSolid,
        ClaimCode::CandidateBounded, ClaimCode::ContainsInput, ClaimCode::MeshClosed,
        ClaimCode::MeshOriented, ClaimCode::MeshConvex}) {
    const Claim& claim = verdict[code];
    if (claim.status != Status::Violated) continue;
    found.outcome = StressStored::Outcome::Wrong;
    found.why = fmt::format("{}: {}", name_of(code), claim.sentence);
    return;
  }
}

}  // namespace

StressStored judge_stored(const Shape& shape, const StoredBytes& kept) {
  StressStored found = kept.stored;
  if (found.outcome == StressStored::Outcome::Refused) return found;
  const bool planes = found.form == StressStored::Form::Planes;
  const Candidate candidate = read_candidate_bytes(kept.bytes, planes ? "a.json" : "a.obj");
  VerifyRequest request;
  request.tightness = false;
  const VerifyOutcome outcome = verify(shape, candidate, request);
  const auto* verdict = std::get_if<Verdict>(&outcome);
  if (verdict == nullptr) {
    found.outcome = StressStored::Outcome::Wrong;
    found.why = "the oracle finds no volume in the input";
    return found;
  }
  find_fault(*verdict, found);
  if (verdict->outside) found.violations = verdict->outside->points;
  if (found.outcome == StressStored::Outcome::Holds &&
      !is_of_precision(candidate, found.precision)) {
    found.outcome = StressStored::Outcome::Wrong;
    found.why = "a coordinate is no number of the format";
  }
  return found;
}

}  // namespace convexact
