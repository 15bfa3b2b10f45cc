// SPDX-License-Identifier: MIT
// verdict_report.hpp - verdicts as JSON (docs/schema/verdict.schema.json) and as a table for
// people.
#pragma once
#include <span>
#include <string>

#include "convexact/verify.hpp"
#include "io/json_document.hpp"
#include "io/names.hpp"

namespace convexact {

inline constexpr auto kAsksNames = name_table<Asks>({{Asks::Enclosure, "enclosure"},
                                                     {Asks::Hull, "hull"},
                                                     {Asks::Inner, "inner"},
                                                     {Asks::Simplify, "simplify"}});

/// {"verdict", "claims", "candidate", "outside", "tightness", "notes"}; numbers that are not
/// doubles are strings, exact ones as fractions.
[[nodiscard]] Json verdict_json(const Verdict& verdict);

/// Whether a claim is violated, not only undecided.
[[nodiscard]] bool is_violated(std::span<const Claim> claims);

/// The claims with their witnesses, and what they come to: "verdict", "claims".
[[nodiscard]] Json claims_json(std::span<const Claim> claims, const Rational& squared_diameter);

/// A line for each claim that was asked, and one with those that were not.
[[nodiscard]] std::string claims_text(std::span<const Claim> claims);
/// The verdict that follows from the claims, as the last line of a table.
[[nodiscard]] std::string verdict_line(std::span<const Claim> claims);
/// A line of such a table.
[[nodiscard]] std::string verdict_line(const char* label, const std::string& text);

/// A line for each claim that was asked, then how tight the candidate is, then the verdict.
/// @param is_asked  Whether somebody chose the question; otherwise a line says what was not asked.
[[nodiscard]] std::string verdict_table(const Verdict& verdict, bool is_asked);

}  // namespace convexact
