// SPDX-License-Identifier: MIT
#include "simplify/inner_trace.hpp"

#include <nlohmann/json.hpp>

#include "io/json.hpp"
#include "simplify/run_names.hpp"
#include "simplify/trace_json.hpp"

namespace convexact {
namespace {

nlohmann::ordered_json ids_json(const std::vector<VertexId>& ids) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const VertexId id : ids) list.push_back(id.value);
  return list;
}

nlohmann::ordered_json triangles_json(const std::vector<VertexTriangle>& triangles) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& [a, b, c] : triangles) list.push_back({a.value, b.value, c.value});
  return list;
}

}  // namespace

std::string write_inner_trace_json(const VertexHull& start, const InnerRun& run) {
  nlohmann::ordered_json vertices = nlohmann::ordered_json::array(), steps = vertices;
  for (std::size_t v = 0; v < start.ids.size(); ++v) {
    vertices.push_back(
        {{"point", start.ids[v].value}, {"at", vector_json(start.points[PointId(v)])}});
  }
  for (const InnerStep& step : run.steps) {
    steps.push_back({{"removed", step.removed.value},
                     {"cost", cost_json(Cost(step.cost.value()))},
                     {"tie", ids_json(step.tie)},
                     {"ring", ids_json(step.ring)},
                     {"triangles", triangles_json(step.triangles)},
                     {"left", step.left}});
  }
  const nlohmann::ordered_json document = {{"inner_trace", 1},
                                           {"vertices", std::move(vertices)},
                                           {"triangles", triangles_json(start.triangles)},
                                           {"steps", std::move(steps)},
                                           {"stop", name_of(run.stop)}};
  return write_json(document) + "\n";
}

}  // namespace convexact
