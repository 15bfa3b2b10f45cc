// SPDX-License-Identifier: MIT
// verdict_json.hpp - verdicts of the oracle as JSON; docs/schema/verdict.schema.json.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "convexact/verify.hpp"

namespace convexact {

/// {"verdict", "claims", "candidate", "outside", "tightness", "notes"}; numbers that are not
/// doubles are strings, exact ones as fractions.
[[nodiscard]] nlohmann::ordered_json verdict_json(const Verdict& verdict);

/// {"code", "status", "sentence", "witness"} of one claim.
[[nodiscard]] nlohmann::ordered_json claim_json(const Claim& claim,
                                                const Rational& squared_diameter);

}  // namespace convexact
