// SPDX-License-Identifier: MIT
#include "convexact/verify.hpp"

namespace convexact {

const char* name_of(ClaimCode code) {
  switch (code) {
    case ClaimCode::CandidateReadable:
      return "candidate-readable";
    case ClaimCode::CandidateFinite:
      return "candidate-finite";
    case ClaimCode::CandidateSolid:
      return "candidate-solid";
    case ClaimCode::CandidateBounded:
      return "candidate-bounded";
    case ClaimCode::MeshClosed:
      return "mesh-closed";
    case ClaimCode::MeshOriented:
      return "mesh-oriented";
    case ClaimCode::MeshPlanar:
      return "mesh-planar";
    case ClaimCode::MeshConvex:
      return "mesh-convex";
    case ClaimCode::ContainsInput:
      return "contains-input";
    case ClaimCode::MaxFacets:
      return "max-facets";
    case ClaimCode::MaxVertices:
      return "max-vertices";
    case ClaimCode::MaxFacetVertices:
      break;
  }
  return "max-facet-vertices";
}

std::optional<ClaimCode> claim_of_name(const std::string& name) {
  for (const ClaimCode code : kAllClaims) {
    if (name == name_of(code)) return code;
  }
  return {};
}

const char* name_of(Status status) {
  switch (status) {
    case Status::Holds:
      return "holds";
    case Status::Violated:
      return "violated";
    case Status::NotAsked:
      return "not-asked";
    case Status::NotApplicable:
      break;
  }
  return "not-applicable";
}

}  // namespace convexact
