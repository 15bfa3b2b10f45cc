// SPDX-License-Identifier: MIT
// Property of removal_order: the reader takes any bytes, a trace or rows, and either reads them or
// refuses them with an Error of exit code 3. The rows of an order ascend.
#include "fuzz_target.hpp"
#include "unless_refused.hpp"
#include "wire/removal_order_file.hpp"

using namespace convexact;

namespace {

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
  const auto order = unless_refused([&]() -> std::optional<RemovalOrder> {
                       try {
                         return read_removal_order(in.rest(), std::nullopt, cube(), decimal);
                       } catch (const Error& error) {
                         // Costs of another measure than the one that is asked about: wrong usage.
                         if (error.code() != ErrorCode::InvalidArgument) throw;
                         return std::nullopt;
                       }
                     }).value_or(std::nullopt);
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

const FuzzTarget kRemovalOrder("removal_order", hold_removal_order);

}  // namespace
