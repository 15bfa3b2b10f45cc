// SPDX-License-Identifier: MIT
#include "simplify/trace_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "convexact/number.hpp"
#include "io/json.hpp"

namespace convexact {
namespace {

using nlohmann::ordered_json;

ordered_json to_json(const std::vector<HalfspaceId>& ids) {
  ordered_json list = ordered_json::array();
  for (const HalfspaceId id : ids) list.push_back(id.value);
  return list;
}

ordered_json to_json(const Step& step) {
  ordered_json triangles = ordered_json::array();
  for (const auto& [a, b, c] : step.triangles) triangles.push_back({a.value, b.value, c.value});
  const Rational& cost = step.cost.value().rational();
  const double value = to_double(cost, Rounding::Nearest);
  return {{"removed", step.removed.value},
          {"cost",
           {{"value", std::isfinite(value) ? ordered_json(value) : ordered_json()},
            {"exact", to_string(cost)}}},
          {"tie", to_json(step.tie)},
          {"ring", to_json(step.ring)},
          {"triangles", std::move(triangles)},
          {"left", step.left}};
}

}  // namespace

std::string write_trace_json(const Run& run) {
  ordered_json halfspaces = ordered_json::array(), steps = ordered_json::array();
  for (const Halfspace& halfspace : run.halfspaces) halfspaces.push_back(plane_json(halfspace));
  for (const Step& step : run.steps) steps.push_back(to_json(step));
  const ordered_json document = {{"halfspaces", std::move(halfspaces)},
                                 {"steps", std::move(steps)},
                                 {"stop", name_of(run.stop)}};
  return write_json(document) + "\n";
}

}  // namespace convexact
