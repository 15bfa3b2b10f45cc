// SPDX-License-Identifier: MIT
// json.hpp - results and verdicts as JSON, as the program prints them, and enumerations by name.
//
// The documents follow docs/schema/. Numbers that are no doubles are strings, exact ones fractions.
#pragma once
#include <string>

#include "convexact/conform.hpp"
#include "convexact/decompose.hpp"
#include "convexact/simplify.hpp"
#include "convexact/verify.hpp"
#include "convexact/verify_order.hpp"
#include "convexact/verify_parts.hpp"

namespace convexact {

/// The document of a result, with its stages.
/// @param indent  Spaces for each level; -1 for all on one line.
[[nodiscard]] std::string to_json(const SimplifyResult& result, int indent = 2);
[[nodiscard]] std::string to_json(const InnerResult& result, int indent = 2);
/// @param digits  Certain digits of each measure, as HullRequest::digits.
[[nodiscard]] std::string to_json(const HullResult& result, int digits, int indent = 2);
/// Parts are named part_000 and so on, with their vertices, faces and halfspaces.
/// @param request  That it was made from.
[[nodiscard]] std::string to_json(const Decomposition& decomposition,
                                  const DecomposeRequest& request, int indent = 2);
[[nodiscard]] std::string to_json(const Verdict& verdict, int indent = 2);
[[nodiscard]] std::string to_json(const PartsVerdict& verdict, int indent = 2);
[[nodiscard]] std::string to_json(const TraceVerdict& verdict, int indent = 2);

/// As options and documents spell them: "filtered", "mean-width", "binary64".
[[nodiscard]] const char* name_of(Engine engine);
[[nodiscard]] const char* name_of(CostMeasure measure);
[[nodiscard]] const char* name_of(StopReason reason);
[[nodiscard]] const char* name_of(VerifyLevel level);
[[nodiscard]] const char* name_of(Precision precision);
[[nodiscard]] const char* name_of(DecomposeMethod method);

}  // namespace convexact
