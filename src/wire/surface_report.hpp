// SPDX-License-Identifier: MIT
// surface_report.hpp - a surface, and the measures of it and of parts that hold it, as JSON and as
// text for people.
#pragma once
#include <string>

#include "convexact/number.hpp"
#include "convexact/surface.hpp"
#include "io/json_document.hpp"

namespace convexact {

/// {"low", "high"}, and {"decimal"} where all its digits are certain, {"exact"} where it is known.
/// Differences may be 0, and then have no certain digit.
[[nodiscard]] Json interval_json(const Measured& x);
[[nodiscard]] Json interval_json(const Enclosure& x);

/// "0.0123", or "at most 1e-38" of an interval that may be 0.
[[nodiscard]] std::string interval_text(const Enclosure& x);
[[nodiscard]] std::string interval_text(const Measured& x);

/// "12.5%", an upper bound.
[[nodiscard]] std::string percent_text(const Enclosure& percent);

/// " (12.5%)", an upper bound; empty unless `whole` is certainly more than 0.
[[nodiscard]] std::string share_text(const Enclosure& part, const Enclosure& whole);

/// Counts: points, triangles, components, edges of borders, triangles that were turned, and so on.
[[nodiscard]] Json surface_json(const Surface& surface);

/// "12 triangles on 8 points, 1 component, closed: it bounds a solid"
[[nodiscard]] std::string surface_text(const Surface& surface);

}  // namespace convexact
