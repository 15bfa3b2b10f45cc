// SPDX-License-Identifier: MIT
// removal_orders.hpp - removal orders for tests, and their verdicts.
#pragma once
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "convexact/run.hpp"
#include "convexact/verify_order.hpp"
#include "cut_box.hpp"
#include "simplify_points.hpp"

namespace convexact {

inline RemovalOrder order_of(const DualHull& solid, const std::vector<HalfspaceId>& ids) {
  RemovalOrder order;
  order.facets.assign(solid.halfspaces.begin(), solid.halfspaces.end());
  for (const HalfspaceId id : ids) {
    order.steps.push_back({order.steps.size() + 1, std::to_string(id.index()), {id}});
  }
  return order;
}

/// The cuts of a cut_box in this order.
inline RemovalOrder cuts_in_order(const DualHull& solid, const std::vector<Rational>& depths) {
  std::vector<HalfspaceId> ids;
  for (std::size_t c = 0; c < depths.size(); ++c) {
    ids.push_back(id_of(solid, corner_cut(c, depths[c])));
  }
  return order_of(solid, ids);
}

inline RemovalOrder order_of(const Run& trace) {
  RemovalOrder order;
  order.facets.assign(trace.halfspaces.begin(), trace.halfspaces.end());
  order.stop = trace.stop;
  order.measure = trace.measure;
  for (const Step& step : trace.steps) {
    order.steps.push_back(
        {order.steps.size() + 1, std::to_string(step.removed.index()), step, true, true});
  }
  return order;
}

inline TraceVerdict judge(const DualHull& solid, const RemovalOrder& order,
                          const Rational& limit = 0) {
  JudgeOptions options;
  options.max_regret = limit;
  return judge_trace(solid, center_of(solid), order, options);
}

inline Status status(const TraceVerdict& verdict, const char* code) {
  for (const TraceClaim& claim : verdict.claims) {
    if (std::strcmp(name_of(claim.code), code) == 0) return claim.status;
  }
  throw std::logic_error("no such code");
}

inline TraceWitness witness(const TraceVerdict& verdict, const char* code) {
  for (const TraceClaim& claim : verdict.claims) {
    if (std::strcmp(name_of(claim.code), code) == 0) return claim.witness.value();
  }
  throw std::logic_error("no such code");
}

inline std::vector<std::string> violated(const TraceVerdict& verdict) {
  std::vector<std::string> codes;
  for (const TraceClaim& claim : verdict.claims) {
    if (claim.status == Status::Violated) codes.emplace_back(name_of(claim.code));
  }
  return codes;
}

using Codes = std::vector<std::string>;

}  // namespace convexact
