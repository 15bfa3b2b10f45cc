// SPDX-License-Identifier: MIT
// inner_parts.hpp - parts that lie in other ones are given up.
#pragma once
#include <vector>

#include "convexact/decompose.hpp"
#include "convexact/error.hpp"
#include "convexact/overlay.hpp"

namespace convexact {

/// Gives up each part that lies in another one, as these solids say; of equal ones the first stays.
/// What it owned goes to a part that holds it and lies in no other.
/// @param solids  By part.
/// @return        Which parts stay.
std::vector<bool> give_up_inner_parts(Decomposition& made,
                                      const std::vector<const ConvexPart*>& solids,
                                      const Watch& watch);

/// Those of a list that stay, in their order.
template <class T>
void keep_those(const std::vector<bool>& stays, std::vector<T>& list) {
  std::size_t next = 0;
  for (std::size_t k = 0; k < list.size(); ++k) {
    if (!stays[k]) continue;
    if (next != k) list[next] = std::move(list[k]);
    ++next;
  }
  list.resize(next);
}

}  // namespace convexact
