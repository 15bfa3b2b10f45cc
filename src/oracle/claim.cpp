// SPDX-License-Identifier: MIT
#include "convexact/verify.hpp"
#include "io/names.hpp"

namespace convexact {
namespace {

constexpr auto kClaimNames =
    name_table<ClaimCode>({{ClaimCode::CandidateReadable, "candidate-readable"},
                           {ClaimCode::CandidateFinite, "candidate-finite"},
                           {ClaimCode::CandidateSolid, "candidate-solid"},
                           {ClaimCode::CandidateBounded, "candidate-bounded"},
                           {ClaimCode::MeshClosed, "mesh-closed"},
                           {ClaimCode::MeshOriented, "mesh-oriented"},
                           {ClaimCode::MeshPlanar, "mesh-planar"},
                           {ClaimCode::MeshConvex, "mesh-convex"},
                           {ClaimCode::ContainsInput, "contains-input"},
                           {ClaimCode::MaxFacets, "max-facets"},
                           {ClaimCode::MaxVertices, "max-vertices"},
                           {ClaimCode::MaxFacetVertices, "max-facet-vertices"}});
static_assert(kClaimNames.size() == kAllClaims.size());

constexpr auto kStatusNames = name_table<Status>({{Status::Holds, "holds"},
                                                  {Status::Violated, "violated"},
                                                  {Status::NotAsked, "not-asked"},
                                                  {Status::NotApplicable, "not-applicable"}});

}  // namespace

const char* name_of(ClaimCode code) { return name_in(kClaimNames, code); }
std::optional<ClaimCode> claim_of_name(const std::string& name) {
  return value_in(kClaimNames, name);
}
const char* name_of(Status status) { return name_in(kStatusNames, status); }

}  // namespace convexact
