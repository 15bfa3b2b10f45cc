// SPDX-License-Identifier: MIT
// claim_sheet.hpp - the claims about one candidate, a solid or parts: which are asked, what is
// found, and how far off may pass.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "convexact/verify.hpp"

namespace convexact::oracle {

/// The claims about one candidate: which are asked, what is found, and how far off may pass.
class ClaimSheet {
 public:
  bool asks(ClaimCode code) const;
  /// Each of these is ignored if the claim was not asked for.
  void holds(ClaimCode code, std::string sentence, Witness witness = {}) {
    decide(code, Status::Holds, std::move(sentence), std::move(witness));
  }
  void violated(ClaimCode code, std::string sentence, Witness witness = {}) {
    decide(code, Status::Violated, std::move(sentence), std::move(witness));
  }
  void undecided(ClaimCode code, std::string sentence, Witness witness) {
    decide(code, Status::Undecided, std::move(sentence), std::move(witness));
  }
  void not_applicable(ClaimCode code, std::string sentence) {
    decide(code, Status::NotApplicable, std::move(sentence), {});
  }
  /// Violated by so much, unless the tolerance allows it.
  void violated_by(const Rational& squared_distance, ClaimCode code, const std::string& sentence,
                   Witness witness);
  /// Reading has failed: `finite` is violated by a number that is not, otherwise `readable`, and no
  /// other claim applies.
  /// @param what  "the candidate".
  void unreadable(const Error& error, ClaimCode readable, ClaimCode finite,
                  const std::string& what);

  /// Whether a distance with this square is within the tolerance.
  bool allows(const Rational& squared_distance) const {
    return tolerance.allows(squared_distance, squared_diameter);
  }
  /// "1.5e-9 (2e-12 of the diameter)" of the square of a distance.
  std::string distance_text(const Rational& squared) const;

  std::vector<Claim> claims;  ///< As added, each NotAsked until it is decided.
  const Tolerance tolerance;
  Rational squared_diameter;  ///< Of the input; 0 of a point.

 protected:
  /// @param named  The claims that the request names, which outlive this; none: the usual ones.
  ClaimSheet(const std::vector<ClaimCode>& named, const Tolerance& allowed, Rational squared)
      : tolerance(allowed), squared_diameter(std::move(squared)), named_(named) {}
  /// @param has_number  Of a claim that is asked for by a number: whether that is given.
  void add(ClaimCode code, std::optional<bool> has_number, bool is_usual);

 private:
  Claim* find_asked(ClaimCode code);
  void decide(ClaimCode code, Status status, std::string sentence, Witness witness);

  const std::vector<ClaimCode>& named_;
  std::vector<ClaimCode> asked_;
};

// ---- Points that no face of the input uses

/// Of those that are not asked about, for people.
[[nodiscard]] std::string unused_text(std::size_t unused);
/// How many of the points outside no face uses, for people.
[[nodiscard]] std::string unused_outside_text(std::size_t unused, std::size_t outside);

}  // namespace convexact::oracle
