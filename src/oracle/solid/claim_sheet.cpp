// SPDX-License-Identifier: MIT
#include "oracle/solid/claim_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "number/text.hpp"

namespace convexact::oracle {

std::string unused_text(std::size_t unused) {
  return counted(unused, "point of the input is", "points of the input are") +
         " used by no face, and not asked about";
}

std::string unused_outside_text(std::size_t unused, std::size_t outside) {
  return fmt::format("{} of the {} outside {} used by no face; --points used asks about the others",
                     with_separators(unused), counted(outside, "point", "points"),
                     unused == 1 ? "is" : "are");
}

void ClaimSheet::add(ClaimCode code, std::optional<bool> has_number, bool is_usual) {
  const bool is_in_list = std::find(named_.begin(), named_.end(), code) != named_.end();
  const bool is_asked = has_number.value_or(named_.empty() ? is_usual : is_in_list);
  const bool is_named = is_asked && (has_number || is_in_list);
  claims.push_back({code, Status::NotAsked, "", {}, is_named});
  if (is_asked) asked_.push_back(code);
}

bool ClaimSheet::asks(ClaimCode code) const {
  return std::find(asked_.begin(), asked_.end(), code) != asked_.end();
}

// Null if it was not asked for.
Claim* ClaimSheet::find_asked(ClaimCode code) {
  if (!asks(code)) return nullptr;
  return &*std::find_if(claims.begin(), claims.end(),
                        [&](const Claim& claim) { return claim.code == code; });
}

void ClaimSheet::decide(ClaimCode code, Status status, std::string sentence, Witness witness) {
  Claim* claim = find_asked(code);
  if (claim == nullptr) return;
  *claim = {code, status, std::move(sentence), std::move(witness), claim->is_named};
}

void ClaimSheet::violated_by(const Rational& squared_distance, ClaimCode code,
                             const std::string& sentence, Witness witness) {
  witness.squared_distance = squared_distance;
  if (allows(squared_distance)) {
    holds(code, "within the tolerance of " + describe(tolerance) + ": " + sentence,
          std::move(witness));
  } else {
    violated(code, sentence, std::move(witness));
    if (Claim* claim = find_asked(code)) claim->is_by_distance = true;
  }
}

void ClaimSheet::unreadable(const Error& error, ClaimCode readable, ClaimCode finite,
                            const std::string& what) {
  for (const ClaimCode code : asked_) not_applicable(code, what + " could not be read");
  const bool is_number = error.code() == ErrorCode::NotFinite;
  not_applicable(is_number ? readable : finite, "reading ended at that place");
  Witness witness;
  witness.line = error.line();
  violated(is_number ? finite : readable, error.what(), std::move(witness));
}

std::string ClaimSheet::distance_text(const Rational& squared) const {
  if (squared_diameter == 0) return decimal_of_root(squared);
  return decimal_of_root(squared) + " (" + decimal_of_root(squared / squared_diameter) +
         " of the diameter)";
}

}  // namespace convexact::oracle
