// SPDX-License-Identifier: MIT
#include "simplify/inner_trace.hpp"

#include <nlohmann/json.hpp>

#include "io/json.hpp"
#include "simplify/run_names.hpp"
#include "simplify/trace_json.hpp"

namespace convexact {
std::string write_inner_trace_json(const VertexHull& start, const InnerRun& run) {
  nlohmann::ordered_json vertices = nlohmann::ordered_json::array(), steps = vertices;
  for (std::size_t v = 0; v < start.ids.size(); ++v) {
    vertices.push_back({{"point", start.ids[v]}, {"at", vector_json(start.points[PointId(v)])}});
  }
  for (const InnerStep& step : run.steps) {
    steps.push_back({{"removed", step.removed},
                     {"cost", cost_json(Cost(step.cost.value()))},
                     {"tie", step.tie},
                     {"ring", step.ring},
                     {"triangles", step.triangles},
                     {"left", step.left}});
  }
  const nlohmann::ordered_json document = {{"inner_trace", 1},
                                           {"vertices", std::move(vertices)},
                                           {"triangles", start.triangles},
                                           {"steps", std::move(steps)},
                                           {"stop", name_of(run.stop)}};
  return write_json(document) + "\n";
}

}  // namespace convexact
