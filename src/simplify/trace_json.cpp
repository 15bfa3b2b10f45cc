// SPDX-License-Identifier: MIT
#include "simplify/trace_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "convexact/number.hpp"
#include "io/json.hpp"
#include "number/precision.hpp"

namespace convexact {
namespace {

using nlohmann::ordered_json;

ordered_json to_json(const std::vector<HalfspaceId>& ids) {
  ordered_json list = ordered_json::array();
  for (const HalfspaceId id : ids) list.push_back(id.value);
  return list;
}

// The number without loss: a fraction, or the terms of a sum.
void add_exactly(ordered_json& object, const Cost& cost) {
  ordered_json terms = ordered_json::array();
  switch (cost.measure()) {
    case CostMeasure::Volume:
      object["exact"] = to_string(cost.rational());
      return;
    case CostMeasure::Area: {
      const RootSum sum = cost.area().normalized();
      for (const RootTerm& term : sum.terms()) {
        terms.push_back({to_string(term.factor), to_string(term.radicand)});
      }
      object["roots"] = std::move(terms);
      return;
    }
    case CostMeasure::MeanWidth:
      for (const AngleTerm& term : cost.angles().terms()) {
        terms.push_back({to_string(term.factor), to_string(term.squared_length),
                         to_string(term.squared_cross), to_string(term.dot)});
      }
      object["edges"] = std::move(terms);
  }
}

ordered_json to_json(const Cost& cost) {
  constexpr int kDigits = 17;
  const Rational near =
      cost.measure() == CostMeasure::Volume ? cost.rational() : cost.enclose(kMeasureBits).low();
  const double value = to_double(near, Rounding::Nearest);
  ordered_json object = {{"value", std::isfinite(value) ? ordered_json(value) : ordered_json()},
                         {"decimal", cost.decimal(kDigits)}};
  add_exactly(object, cost);
  return object;
}

ordered_json to_json(const Step& step) {
  ordered_json triangles = ordered_json::array();
  for (const auto& [a, b, c] : step.triangles) triangles.push_back({a.value, b.value, c.value});
  ordered_json object = {{"removed", step.removed.value},     {"cost", to_json(step.cost.value())},
                         {"tie", to_json(step.tie)},          {"ring", to_json(step.ring)},
                         {"triangles", std::move(triangles)}, {"left", step.left}};
  const TieEvidence& evidence = step.tie_evidence;
  if (evidence.proof) object["tie_proof"] = name_of(*evidence.proof);
  if (evidence.proof == TieProof::Undecided) object["bits"] = evidence.bits;
  return object;
}

}  // namespace

std::string write_trace_json(const Run& run) {
  ordered_json halfspaces = ordered_json::array(), steps = ordered_json::array();
  for (const Halfspace& halfspace : run.halfspaces) halfspaces.push_back(plane_json(halfspace));
  for (const Step& step : run.steps) steps.push_back(to_json(step));
  const ordered_json document = {{"version", kTraceVersion},
                                 {"measure", name_of(run.measure)},
                                 {"halfspaces", std::move(halfspaces)},
                                 {"steps", std::move(steps)},
                                 {"stop", name_of(run.stop)}};
  return write_json(document) + "\n";
}

}  // namespace convexact
