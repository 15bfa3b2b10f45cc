// SPDX-License-Identifier: MIT
// judge_fields.hpp - what can be asked of the oracle: by options, in profiles, in vectors and in
// lines of JSON.
#pragma once
#include "convexact/conform.hpp"
#include "convexact/verify.hpp"
#include "convexact/verify_parts.hpp"
#include "wire/field.hpp"

namespace convexact {

/// max_facets, max_vertices and max_facet_vertices.
[[nodiscard]] const Fields<Budgets>& budget_fields();

/// What a program promises: asks, tolerance and numbers, the budgets, and whether it may accept
/// flat inputs.
[[nodiscard]] const Fields<Promise>& promise_fields();

/// What is asked about one solid, without the list of claims: asks, tolerance, the budgets,
/// exact_facets, tightness, and judge_points.
[[nodiscard]] const Fields<VerifyRequest>& verify_fields();

/// The names of claims, separated by commas.
/// @throws Error InvalidArgument, listing the names, for any other word, even an empty one.
[[nodiscard]] std::vector<ClaimCode> parse_claims(const std::string& option,
                                                  const std::string& text);

/// The same, and the list of claims: for the C interface.
[[nodiscard]] const Fields<VerifyRequest>& verify_call_fields();

/// "3%" and "0.03d" are shares of the diameter, "0.05" is a length; all exact.
/// @throws Error InvalidArgument for anything else, naming the option.
[[nodiscard]] Tolerance read_distance(const std::string& option, const std::string& text);

/// What is asked about parts besides: distance, max_parts, orient and exact_volumes.
[[nodiscard]] const Fields<PartsRequest>& parts_fields();

}  // namespace convexact
