// SPDX-License-Identifier: MIT
// angle_basis.hpp - whether a sum of roots times angles is zero, by a basis of all angles.
#pragma once
#include <optional>
#include <span>

#include "convexact/error.hpp"
#include "number/normal_form.hpp"

namespace convexact {

/// Whether a sum in normal form is zero: proven either way, or nothing. compare() in cost.hpp
/// says why this decides, and when it does not.
/// @throws Error Stopped when the watch ends the call.
/// @par Source  [Baker1966], [ConwayRadinSadun1999], [BachDriscollShallit1993]
[[nodiscard]] std::optional<bool> vanishes_in_angle_basis(std::span<const ReducedAngles> form,
                                                          const Watch& watch = {});

}  // namespace convexact
