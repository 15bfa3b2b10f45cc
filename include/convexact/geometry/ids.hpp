// SPDX-License-Identifier: MIT
// ids.hpp - indices that cannot be mistaken for one another.
#pragma once
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace convexact {

/// A 0-based index into one kind of list.
template <class Tag>
struct Id {
  std::uint32_t value = 0;

  constexpr Id() = default;
  constexpr explicit Id(std::size_t index) : value(static_cast<std::uint32_t>(index)) {}
  constexpr std::size_t index() const { return value; }
  friend constexpr auto operator<=>(const Id&, const Id&) = default;
};

using PointId = Id<struct PointTag>;          ///< Into the input's points.
using HalfspaceId = Id<struct HalfspaceTag>;  ///< Into halfspaces in canonical order.

/// Three dual points (so three halfspaces, whose planes meet in a primal vertex), counter-clockwise
/// seen from outside the dual hull.
using DualTriangle = std::array<HalfspaceId, 3>;

}  // namespace convexact

template <class Tag>
struct std::hash<convexact::Id<Tag>> {
  std::size_t operator()(const convexact::Id<Tag>& id) const noexcept { return id.value; }
};
