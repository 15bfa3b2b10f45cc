// SPDX-License-Identifier: MIT
#include "convexact/geometry/halfspace_list.hpp"

namespace convexact {

void HalfspaceList::add(const RationalVector3& normal, const Rational& offset) {
  ++row_count_;
  if (normal != RationalVector3::Zero()) {
    halfspaces.emplace_back(normal, offset);
    rows.push_back(row_count_);
  } else if (offset <= 0) {
    trivial_rows.push_back(row_count_);
  } else if (!impossible_row) {
    impossible_row = row_count_;
  }
}

}  // namespace convexact
