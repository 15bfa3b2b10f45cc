// SPDX-License-Identifier: MIT
// proofs.hpp - proofs of runs, as the program writes them.
#pragma once
#include <doctest/doctest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "checker.hpp"
#include "convexact/simplify.hpp"
#include "proof/proof.hpp"
#include "proof_text.hpp"

/// A run on a solid shape with what its proof needs. Precondition: the request says to record it.
inline convexact::SimplifyResult recorded(const convexact::Shape& shape,
                                          const convexact::SimplifyRequest& request) {
  convexact::SimplifyOutcome outcome = convexact::simplify(shape, request);
  REQUIRE(std::holds_alternative<convexact::SimplifyResult>(outcome));
  auto result = std::get<convexact::SimplifyResult>(std::move(outcome));
  REQUIRE((result.run && result.start));
  return result;
}
inline convexact::SimplifyResult recorded(
    const convexact::Shape& shape, convexact::Engine engine, std::size_t faces,
    std::optional<convexact::Precision> precision = {},
    convexact::CostMeasure cost = convexact::CostMeasure::Volume) {
  convexact::SimplifyRequest request;
  request.engine = engine;
  request.faces = faces;
  request.cost = cost;
  request.record = true;
  request.store.planes = precision;
  return recorded(shape, request);
}

inline std::string proof_of(const convexact::SimplifyResult& result) {
  return convexact::write_proof(*result.start, *result.run, result.solid.points,
                                result.solid.planes);
}
inline std::string proof_of(const std::vector<convexact::Point>& points,
                            const convexact::SimplifyRequest& request) {
  return proof_of(recorded(convexact::PointSet(points), request));
}
/// The proof of a run on a solid shape, with planes in a format if one is given.
inline std::string proof_of(const convexact::Shape& shape, convexact::Engine engine,
                            std::size_t faces, std::optional<convexact::Precision> precision = {},
                            convexact::CostMeasure cost = convexact::CostMeasure::Volume) {
  return proof_of(recorded(shape, engine, faces, precision, cost));
}

/// The checker refuses a proof, with its last line counted again, and says why.
inline void check_refused(const ProofText& proof, int exit_code, const std::string& why) {
  const CheckerVerdict verdict = check_proof(proof.text(true));
  CHECK(verdict.exit_code == exit_code);
  CHECK_MESSAGE(verdict.said.find(why) != std::string::npos, verdict.said);
}
