// SPDX-License-Identifier: MIT
#include "simplify/trace_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "convexact/error.hpp"
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

}  // namespace

ordered_json cost_json(const Cost& cost) {
  constexpr int kCertainDigits = 17;
  const Rational near =
      cost.measure() == CostMeasure::Volume ? cost.rational() : cost.enclose(kMeasureBits).low();
  const double value = to_double(near, Rounding::Nearest);
  ordered_json object = {{"value", std::isfinite(value) ? ordered_json(value) : ordered_json()},
                         {"decimal", cost.decimal(kCertainDigits)}};
  add_exactly(object, cost);
  return object;
}

namespace {

[[noreturn]] void reject(const char* expected) {
  throw Error(ErrorCode::Malformed, std::string("expected ") + expected);
}

// An entry of a term; `expected` describes the whole term.
Rational number_in(const nlohmann::json& entry, const char* expected) {
  if (!entry.is_string()) reject(expected);
  try {
    return parse_rational(entry.get_ref<const std::string&>());
  } catch (const Error&) {
    reject(expected);
  }
}

Integer integer_in(const nlohmann::json& entry, const char* expected) {
  const Rational x = number_in(entry, expected);
  if (denominator(x) != 1) reject(expected);
  return numerator(x);
}

RootSum roots_in(const nlohmann::json& list) {
  constexpr const char* kExpected = "the roots as [q, N] in strings, N > 0 an integer";
  if (!list.is_array()) reject(kExpected);
  std::vector<RootTerm> terms;
  for (const nlohmann::json& term : list) {
    if (!term.is_array() || term.size() != 2) reject(kExpected);
    terms.push_back({number_in(term[0], kExpected), integer_in(term[1], kExpected)});
    if (terms.back().radicand <= 0) reject(kExpected);
  }
  return RootSum(std::move(terms));
}

AngleSum edges_in(const nlohmann::json& list) {
  constexpr const char* kExpected =
      "the edges as [f, L, C, D] in strings, L, C >= 0, C and D integers that are not both 0";
  if (!list.is_array()) reject(kExpected);
  std::vector<AngleTerm> terms;
  for (const nlohmann::json& term : list) {
    if (!term.is_array() || term.size() != 4) reject(kExpected);
    const AngleTerm& edge = terms.emplace_back(
        AngleTerm{number_in(term[0], kExpected), number_in(term[1], kExpected),
                  integer_in(term[2], kExpected), integer_in(term[3], kExpected)});
    if (edge.squared_length < 0 || edge.squared_cross < 0 ||
        (edge.squared_cross == 0 && edge.dot == 0)) {
      reject(kExpected);
    }
  }
  return AngleSum(std::move(terms));
}

}  // namespace

std::optional<Cost> cost_in_json(const nlohmann::json& object, CostMeasure measure) {
  switch (measure) {
    case CostMeasure::Volume:
      if (!object.contains("exact")) return std::nullopt;
      if (!object["exact"].is_string()) reject("the exact cost as a string");
      return Cost(number_in(object["exact"], "the exact cost as p or p/q"));
    case CostMeasure::Area:
      if (!object.contains("roots")) return std::nullopt;
      return Cost(roots_in(object["roots"]));
    case CostMeasure::MeanWidth:
      break;
  }
  if (!object.contains("edges")) return std::nullopt;
  return Cost(edges_in(object["edges"]));
}

namespace {

ordered_json to_json(const Step& step) {
  ordered_json triangles = ordered_json::array();
  for (const auto& [a, b, c] : step.triangles) triangles.push_back({a.value, b.value, c.value});
  ordered_json object = {
      {"removed", step.removed.value},     {"cost", cost_json(step.cost.value())},
      {"tie", to_json(step.tie)},          {"ring", to_json(step.ring)},
      {"triangles", std::move(triangles)}, {"left", step.left}};
  const TieEvidence& evidence = step.tie_evidence;
  if (evidence.proof) object["tie_proof"] = name_of(*evidence.proof);
  if (evidence.proof == TieProof::Undecided) object["bits"] = evidence.bits;
  return object;
}

}  // namespace

ordered_json moves_json(const std::vector<Move>& moves) {
  ordered_json list = ordered_json::array();
  for (const Move& move : moves) {
    list.push_back({{"removed", to_json(move.removed)},
                    {"inserted", to_json(move.inserted)},
                    {"measure", cost_json(move.measure.value())}});
  }
  return list;
}

std::string write_trace_json(const Run& run) {
  ordered_json halfspaces = ordered_json::array(), steps = ordered_json::array();
  for (const Halfspace& halfspace : run.halfspaces) halfspaces.push_back(plane_json(halfspace));
  for (const Step& step : run.steps) steps.push_back(to_json(step));
  ordered_json document = {{"version", kTraceVersion},
                           {"measure", name_of(run.measure)},
                           {"halfspaces", std::move(halfspaces)},
                           {"steps", std::move(steps)},
                           {"stop", name_of(run.stop)}};
  if (!run.kept.empty()) document["kept"] = to_json(run.kept);
  if (!run.moves.empty()) document["moves"] = moves_json(run.moves);
  return write_json(document) + "\n";
}

}  // namespace convexact
