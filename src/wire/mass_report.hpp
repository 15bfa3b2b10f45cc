// SPDX-License-Identifier: MIT
// mass_report.hpp - mass properties for machines and for people.
#pragma once
#include <string>

#include "convexact/measure.hpp"
#include "io/json_document.hpp"

namespace convexact {

/// For density 1: "volume", "center" and "inertia" about it (xx, yy, zz, xy, xz, yz) as fractions.
[[nodiscard]] Json mass_json(const MassProperties& mass);

/// Lines of a summary, with so many digits.
[[nodiscard]] std::string mass_lines(const MassProperties& mass, int digits);

}  // namespace convexact
