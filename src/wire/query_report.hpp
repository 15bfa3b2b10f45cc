// SPDX-License-Identifier: MIT
// query_report.hpp - the answers to queries, as JSON (docs/schema/query.schema.json) and as text
// for people.
#pragma once
#include <span>
#include <string>

#include "convexact/query.hpp"
#include "io/json_document.hpp"

namespace convexact {

/// A solid that a query is about, with the name of its file.
struct NamedPolytope {
  std::string name;
  const Polytope& solid;
};

/// "overlap", and "witness" or "farkas" and "separating_plane".
[[nodiscard]] Json overlap_json(const NamedPolytope& a, const NamedPolytope& b,
                                const Overlap& answer);
[[nodiscard]] std::string overlap_text(const NamedPolytope& a, const NamedPolytope& b,
                                       const Overlap& answer);

/// "rays", in the order of the file, and "hits", their number.
[[nodiscard]] Json rays_json(const NamedPolytope& a, std::span<const RayAnswer> answers);
/// A line for each ray.
[[nodiscard]] std::string rays_text(const NamedPolytope& a, std::span<const RayAnswer> answers);

/// "inside", the ball, and "lines", "planes" and "points", each if there are samples.
[[nodiscard]] Json false_positives_json(const NamedPolytope& a, const NamedPolytope& b,
                                        const FalsePositives& found);
/// A table.
[[nodiscard]] std::string false_positives_text(const NamedPolytope& a, const NamedPolytope& b,
                                               const FalsePositives& found);

}  // namespace convexact
