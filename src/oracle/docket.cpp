// SPDX-License-Identifier: MIT
#include <algorithm>

#include "convexact/number/digits.hpp"
#include "judge.hpp"

namespace convexact::oracle {
namespace {

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

Docket::Docket(const VerifyRequest& asked, Verdict& result) : request(asked), verdict(result) {
  for (const ClaimCode code : kAllClaims) {
    verdict.claims.push_back({code, Status::NotAsked, "", {}});
  }
}

bool Docket::asks(ClaimCode code) const {
  const auto& list = request.claims;
  const bool listed = list.empty() || std::find(list.begin(), list.end(), code) != list.end();
  const bool is_budget = code == ClaimCode::MaxFacets || code == ClaimCode::MaxVertices ||
                         code == ClaimCode::MaxFacetVertices;
  return is_budget ? has_budget(request, code) : listed;
}

void Docket::set(ClaimCode code, Status status, std::string sentence, Witness witness) {
  if (!asks(code)) return;
  Claim& claim = verdict.claims[static_cast<std::size_t>(code)];
  claim = {code, status, std::move(sentence), std::move(witness)};
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

void Docket::violated_by(const Rational& squared_distance, ClaimCode code,
                         const std::string& sentence, Witness witness) {
  witness.squared_distance = squared_distance;
  if (request.tolerance.allows(squared_distance, verdict.squared_diameter)) {
    holds(code, "within the tolerance of " + describe(request.tolerance) + ": " + sentence,
          std::move(witness));
  } else {
    violated(code, sentence, std::move(witness));
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
