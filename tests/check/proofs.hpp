// SPDX-License-Identifier: MIT
// proofs.hpp - proofs of runs, as the program writes them.
#pragma once
#include <doctest/doctest.h>

#include <optional>
#include <string>
#include <utility>

#include "convexact/simplify.hpp"
#include "scene/result_json.hpp"

/// A run on a solid shape with what its proof needs.
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
  convexact::SimplifyOutcome outcome = convexact::simplify(shape, request);
  REQUIRE(std::holds_alternative<convexact::SimplifyResult>(outcome));
  auto result = std::get<convexact::SimplifyResult>(std::move(outcome));
  REQUIRE((result.run && result.start));
  return result;
}

/// The proof of a run on a solid shape, with planes in a format if one is given.
inline std::string proof_of(const convexact::Shape& shape, convexact::Engine engine,
                            std::size_t faces, std::optional<convexact::Precision> precision = {},
                            convexact::CostMeasure cost = convexact::CostMeasure::Volume) {
  const convexact::SimplifyResult result = recorded(shape, engine, faces, precision, cost);
  return convexact::write_proof(*result.start, *result.run, result.solid.points,
                                result.solid.planes);
}
