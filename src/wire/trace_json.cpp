// SPDX-License-Identifier: MIT
#include "wire/trace_json.hpp"

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "io/json.hpp"
#include "number/precision.hpp"
#include "simplify/run_names.hpp"
#include "wire/tie_report.hpp"

namespace convexact {
namespace {

// The number without loss: a fraction, or the terms of a sum.
void add_exactly(Json& object, const Cost& cost) {
  Json terms = Json::array();
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

Json cost_json(const Cost& cost) {
  const Rational near =
      cost.measure() == CostMeasure::Volume ? cost.rational() : cost.enclose(kMeasureBits).low();
  const double value = to_double(near, Rounding::Nearest);
  Json object = {{"value", value_or_null(value)}, {"decimal", cost.decimal(kDigits)}};
  add_exactly(object, cost);
  return object;
}

namespace {

Json step_json(const Step& step) {
  Json object = {
      {"removed", step.removed}, {"cost", cost_json(step.cost.value())}, {"tie", step.tie},
      {"ring", step.ring},       {"triangles", step.triangles},          {"left", step.left}};
  object.update(tie_json(step.tie_evidence));
  return object;
}

}  // namespace

Json moves_json(const std::vector<Move>& moves) {
  Json list = Json::array();
  for (const Move& move : moves) {
    list.push_back({{"removed", move.removed},
                    {"inserted", move.inserted},
                    {"measure", cost_json(move.measure.value())}});
  }
  return list;
}

Json trace_json(const Run& run) {
  Json halfspaces = Json::array(), steps = Json::array();
  for (const Halfspace& halfspace : run.halfspaces) halfspaces.push_back(plane_json(halfspace));
  for (const Step& step : run.steps) steps.push_back(step_json(step));
  Json document = {{"version", kTraceVersion},
                   {"measure", name_of(run.measure)},
                   {"halfspaces", std::move(halfspaces)},
                   {"steps", std::move(steps)},
                   {"stop", name_of(run.stop)}};
  if (!run.kept.empty()) document["kept"] = run.kept;
  if (!run.moves.empty()) document["moves"] = moves_json(run.moves);
  return document;
}

std::string write_trace_json(const Run& run) { return write_json(trace_json(run)) + "\n"; }

Json inner_trace_json(const VertexHull& start, const InnerRun& run) {
  Json vertices = Json::array(), steps = vertices;
  for (std::size_t v = 0; v < start.ids.size(); ++v) {
    vertices.push_back({{"point", start.ids[v]}, {"at", vector_json(start.points[PointId(v)])}});
  }
  for (const Step& step : run.steps) steps.push_back(step_json(step));
  return {{"inner_trace", 1},
          {"vertices", std::move(vertices)},
          {"triangles", start.triangles},
          {"steps", std::move(steps)},
          {"stop", name_of(run.stop)}};
}

std::string write_inner_trace_json(const VertexHull& start, const InnerRun& run) {
  return write_json(inner_trace_json(start, run)) + "\n";
}

}  // namespace convexact
