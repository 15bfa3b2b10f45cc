// SPDX-License-Identifier: MIT
#include "convexact/halfspace.hpp"

namespace convexact {

void HalfspaceList::add(const RationalVector3& normal, const Rational& offset) {
  ++row_count_;
  if (normal != RationalVector3::Zero()) {
    const Halfspace& halfspace = halfspaces.emplace_back(normal, offset);
    rows.push_back(row_count_);
    const int k = normal[0] != 0 ? 0 : normal[1] != 0 ? 1 : 2;
    scales.push_back(Rational(halfspace.normal()[k]) / normal[k]);
  } else if (offset <= 0) {
    trivial_rows.push_back(row_count_);
  } else if (!impossible_row) {
    impossible_row = row_count_;
  }
}

}  // namespace convexact
