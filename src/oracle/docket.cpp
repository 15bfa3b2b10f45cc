// SPDX-License-Identifier: MIT
#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "number/text.hpp"
#include "oracle/judge.hpp"

namespace convexact::oracle {
namespace {

bool is_budget(ClaimCode code) {
  return code == ClaimCode::MaxFacets || code == ClaimCode::MaxVertices ||
         code == ClaimCode::MaxFacetVertices;
}

bool has_budget(const VerifyRequest& request, ClaimCode code) {
  switch (code) {
    case ClaimCode::MaxFacets:
      return request.max_facets.has_value();
    case ClaimCode::MaxVertices:
      return request.max_vertices.has_value();
    case ClaimCode::MaxFacetVertices:
      return request.max_facet_vertices.has_value();
    default:
      return true;
  }
}

}  // namespace

void require_numbers(const VerifyRequest& request) {
  for (const ClaimCode code : request.claims) {
    if (has_budget(request, code)) continue;
    throw Error(ErrorCode::InvalidArgument, std::string("the claim ") + name_of(code) +
                                                " needs the number that it allows: --" +
                                                name_of(code) + " N");
  }
}

void judge_tolerance(const Rational& rounding, Docket& docket) {
  Verdict& verdict = docket.verdict;
  Rational worst = 0;
  for (const Claim& claim : verdict.claims) {
    if (claim.is_undecided()) return;
    if (claim.status != Status::Violated) continue;
    if (!claim.is_by_distance) return;
    worst = std::max(worst, *claim.witness.squared_distance);
  }
  if (worst == 0) return;
  const SmallestTolerance least{least_tolerance(worst), worst <= rounding * rounding};
  verdict.smallest_tolerance = least;
  verdict.notes.push_back((least.is_rounding
                               ? "every violation is no larger than rounding explains, " +
                                     std::to_string(kRoundingUlps) +
                                     " units in the last place of the largest coordinate; "
                               : std::string()) +
                          "with --tolerance " + least.decimal + " every claim holds");
}

Docket::Docket(const VerifyRequest& asked, Verdict& result) : request(asked), verdict(result) {
  for (const ClaimCode code : kAllClaims) {
    verdict.claims.push_back({code, Status::NotAsked, "", {}, false});
    verdict.claims.back().is_named = asks(code) && (!asked.claims.empty() || is_budget(code));
  }
}

bool Docket::asks(ClaimCode code) const {
  const auto& list = request.claims;
  const bool listed = list.empty() || std::find(list.begin(), list.end(), code) != list.end();
  return is_budget(code) ? has_budget(request, code) : listed;
}

void Docket::set(ClaimCode code, Status status, std::string sentence, Witness witness) {
  if (!asks(code)) return;
  Claim& claim = verdict.claims[static_cast<std::size_t>(code)];
  claim = {code, status, std::move(sentence), std::move(witness), claim.is_named};
}

void Docket::holds(ClaimCode code, std::string sentence, Witness witness) {
  set(code, Status::Holds, std::move(sentence), std::move(witness));
}

void Docket::violated(ClaimCode code, std::string sentence, Witness witness) {
  set(code, Status::Violated, std::move(sentence), std::move(witness));
}

void Docket::not_applicable(ClaimCode code, std::string sentence) {
  set(code, Status::NotApplicable, std::move(sentence), {});
}

bool Docket::allows(const Rational& squared_distance) const {
  return request.tolerance.allows(squared_distance, verdict.squared_diameter);
}

void Docket::violated_by(const Rational& squared_distance, ClaimCode code,
                         const std::string& sentence, Witness witness) {
  witness.squared_distance = squared_distance;
  if (allows(squared_distance)) {
    holds(code, "within the tolerance of " + describe(request.tolerance) + ": " + sentence,
          std::move(witness));
  } else {
    violated(code, sentence, std::move(witness));
    verdict.claims[static_cast<std::size_t>(code)].is_by_distance = asks(code);
  }
}

std::string Docket::distance_text(const Rational& squared) const {
  return decimal_of_root(squared) + " (" + decimal_of_root(squared / verdict.squared_diameter) +
         " of the diameter)";
}

std::string counted(std::size_t count, const char* one, const char* many) {
  return with_separators(count) + " " + (count == 1 ? one : many);
}

}  // namespace convexact::oracle
