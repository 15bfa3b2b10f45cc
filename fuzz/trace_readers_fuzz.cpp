// SPDX-License-Identifier: MIT
// Property of trace_json and removal_order: the reader takes any bytes and either reads them or
// refuses them with an Error of exit code 3. A trace that was read can be written and is then read
// as the same; every index in it names a halfspace. The rows of an order ascend.
#include "fuzz_target.hpp"
#include "oracle/removal_order_file.hpp"
#include "simplify/trace_json.hpp"
#include "unless_refused.hpp"

using namespace convexact;

namespace {

void check_ids(const Run& trace, const std::vector<HalfspaceId>& ids) {
  for (const HalfspaceId id : ids) FUZZ_CHECK(id.index() < trace.halfspaces.size());
}

void hold_trace_json(FuzzInput& in) {
  const auto trace = unless_refused([&] { return read_trace_json(in.rest()); });
  if (!trace) return;
  const Run back = read_trace_json(write_trace_json(*trace));
  FUZZ_CHECK(back.halfspaces == trace->halfspaces);
  FUZZ_CHECK(back.stop == trace->stop);
  FUZZ_CHECK(back.steps.size() == trace->steps.size());
  for (std::size_t s = 0; s < back.steps.size(); ++s) {
    const Step &step = trace->steps[s], &again = back.steps[s];
    check_ids(*trace, {step.removed});
    check_ids(*trace, step.tie);
    check_ids(*trace, step.ring);
    for (const DualTriangle& t : step.triangles) check_ids(*trace, {t.begin(), t.end()});
    FUZZ_CHECK(again.removed == step.removed && again.cost == step.cost && again.tie == step.tie);
    FUZZ_CHECK(again.ring == step.ring && again.triangles == step.triangles);
    FUZZ_CHECK(again.left == step.left);
  }
}

// The sides of a cube, in canonical order.
const std::vector<Halfspace>& cube() {
  static const std::vector<Halfspace> sides = [] {
    std::vector<Halfspace> list;
    for (int k = 0; k < 6; ++k) {
      IntegerVector3 normal = IntegerVector3::Zero();
      normal[k / 2] = k % 2 == 0 ? 1 : -1;
      list.emplace_back(normal, Integer(-1));
    }
    std::sort(list.begin(), list.end());
    return list;
  }();
  return sides;
}

void hold_removal_order(FuzzInput& in) {
  const Decimal decimal = in.below(2) == 0 ? Decimal::Nearest : Decimal::Exact;
  const auto order =
      unless_refused([&] { return read_removal_order(in.rest(), std::nullopt, cube(), decimal); });
  if (order) {
    std::size_t row = 0;
    for (const OrderedStep& removal : order->steps) {
      FUZZ_CHECK(removal.row > row);
      row = removal.row;
    }
  }
  const auto listed =
      unless_refused([&] { return read_facet_list(in.rest(), "facets.txt", decimal); });
  if (!listed) return;
  // As a list of facets the same bytes name what the order names plane by plane.
  const ListedFacets facets = *listed;
  const RemovalOrder by_id = read_removal_order("0\n", facets, cube());
  FUZZ_CHECK(by_id.facets == facets);
}

const FuzzTarget trace_json("trace_json", hold_trace_json);
const FuzzTarget removal_order("removal_order", hold_removal_order);

}  // namespace
