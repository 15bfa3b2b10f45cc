// SPDX-License-Identifier: MIT
// proofs.hpp - proofs of runs, as the program writes them.
#pragma once
#include <doctest/doctest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "convexact/simplify.hpp"
#include "scene/result_json.hpp"

/// The proof of a run on a solid shape, with planes in a format if one is given.
inline std::string proof_of(const convexact::Shape& shape, convexact::Engine engine,
                            std::size_t faces, std::optional<convexact::Precision> precision = {}) {
  convexact::SimplifyRequest request;
  request.engine = engine;
  request.faces = faces;
  request.record = true;
  request.store.planes = precision;
  const convexact::SimplifyOutcome outcome = convexact::simplify(shape, request);
  REQUIRE(std::holds_alternative<convexact::SimplifyResult>(outcome));
  const auto& result = std::get<convexact::SimplifyResult>(outcome);
  REQUIRE((result.run && result.start));
  return convexact::write_proof(*result.start, *result.run, result.solid.points,
                                result.solid.planes);
}
