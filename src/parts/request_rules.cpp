// SPDX-License-Identifier: MIT
#include "parts/request_rules.hpp"

#include "convexact/error.hpp"

namespace convexact {
namespace {

[[noreturn]] void refuse_request(const std::string& message) {
  throw Error(ErrorCode::InvalidArgument, message);
}

}  // namespace

bool uses_reach(const DecomposeRequest& request) {
  return cuts(request) || request.guard == ReachUse::Reach || request.merge == ReachUse::Reach;
}

bool has_clusters(const DecomposeRequest& request) {
  const DecomposeRequest plain;
  return request.limit.value != plain.limit.value ||
         request.limit.is_share != plain.limit.is_share || request.connect != plain.connect ||
         request.guard != plain.guard || request.merge != plain.merge ||
         request.measure != plain.measure || request.flat == FlatParts::Merge;
}

void require_sensible(const DecomposeRequest& request) {
  if (request.max_parts && *request.max_parts == 0) refuse_request("at least one part is needed");
  const DecomposeRequest plain;
  if (request.method == DecomposeMethod::Acd) {
    if (request.measure != plain.measure) {
      refuse_request("the measure applies to hacd only: acd measures concavity to bridges");
    }
    if (request.engine != plain.engine) {
      refuse_request(
          "the engine applies to hacd only: acd has one, which decides as exact numbers do");
    }
  } else if (request.bridge != plain.bridge || request.coplanar != plain.coplanar) {
    refuse_request("bridges and the cosine of coplanar facets apply to acd only");
  }
  if (cuts(request)) {
    if (has_clusters(request)) {
      refuse_request(
          "concavity, measure, connect, guard, merge and merging flat parts apply to hacd and acd: "
          "cut is limited by the distance alone");
    }
    if (request.engine == Engine::Float) {
      refuse_request("the engine float applies to hacd only: cut prefers planes in doubles always");
    }
  } else if (request.max_excess || request.disjoint || request.effort != plain.effort) {
    refuse_request(
        "an effort, an excess allowed, and disjoint parts, apply to cut only, which closed "
        "surfaces "
        "get by themselves: name --method cut");
  }
  if (request.max_excess && *request.max_excess < 0) {
    refuse_request("the excess allowed is at least 0");
  }
  if (request.faces && request.total_faces) {
    refuse_request("give the faces of each part or the faces of all parts, not both");
  }
  if (request.distance && !uses_reach(request)) {
    refuse_request("a distance applies to a guard by reach, or to merging by reach: ask for one");
  }
  if (request.distance && request.distance->value <= 0) {
    refuse_request("the distance allowed is above 0");
  }
  if (request.total_faces && (request.max_vertices || request.max_facet_vertices)) {
    refuse_request("corners are counted in each part: leave out the faces of all parts");
  }
  if (request.max_vertices && *request.max_vertices < 4) {
    refuse_request("no part has fewer than 4 corners: allow at least 4 for each");
  }
  if (request.max_facet_vertices && *request.max_facet_vertices < 3) {
    refuse_request("no face has fewer than 3 corners: allow at least 3");
  }
  if (request.faces && *request.faces < 4) {
    refuse_request("no bounded part has fewer than 4 faces: allow at least 4 for each");
  }
  if (request.total_faces && *request.total_faces < 4) {
    refuse_request("no bounded part has fewer than 4 faces: allow at least 4 in all");
  }
}

}  // namespace convexact
