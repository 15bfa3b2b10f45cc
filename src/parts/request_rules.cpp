// SPDX-License-Identifier: MIT
#include "parts/request_rules.hpp"

#include "convexact/error.hpp"
#include "task/parallel.hpp"

namespace convexact {

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
  if (request.max_parts && *request.max_parts == 0) reject_argument("at least one part is needed");
  require_threads(request.jobs);
  const DecomposeRequest plain;
  if (request.method == DecomposeMethod::Acd) {
    if (request.measure != plain.measure) {
      reject_argument("the measure applies to hacd only: acd measures concavity to bridges");
    }
    if (request.engine != plain.engine) {
      reject_argument(
          "the engine applies to hacd only: acd has one, which decides as exact numbers do");
    }
  } else if (request.bridge != plain.bridge || request.coplanar != plain.coplanar) {
    reject_argument("bridges and the cosine of coplanar facets apply to acd only");
  }
  if (cuts(request)) {
    if (has_clusters(request)) {
      reject_argument(
          "concavity, measure, connect, guard, merge and merging flat parts apply to hacd and acd: "
          "cut is limited by the distance alone");
    }
    if (request.engine == Engine::Float) {
      reject_argument(
          "the engine float applies to hacd only: cut prefers planes in doubles always");
    }
  } else if (request.max_excess || request.disjoint || request.effort != plain.effort) {
    reject_argument(
        "an effort, an excess allowed, and disjoint parts, apply to cut only, which closed "
        "surfaces "
        "get by themselves: name --method cut");
  }
  if (request.max_excess && *request.max_excess < 0) {
    reject_argument("the excess allowed is at least 0");
  }
  if (request.faces && request.total_faces) {
    reject_argument("give the faces of each part or the faces of all parts, not both");
  }
  if (request.distance && !uses_reach(request)) {
    reject_argument("a distance applies to a guard by reach, or to merging by reach: ask for one");
  }
  if (request.distance &&
      (request.distance->value < 0 || (request.distance->value == 0 && !cuts(request)))) {
    reject_argument("the distance allowed is above 0; cut, which is for solids, takes 0, too");
  }
  if (request.total_faces && (request.max_vertices || request.max_facet_vertices)) {
    reject_argument("corners are counted in each part: leave out the faces of all parts");
  }
  if (request.max_vertices && *request.max_vertices < 4) {
    reject_argument("no part has fewer than 4 corners: allow at least 4 for each");
  }
  if (request.max_facet_vertices && *request.max_facet_vertices < 3) {
    reject_argument("no face has fewer than 3 corners: allow at least 3");
  }
  if (request.faces && *request.faces < 4) {
    reject_argument("no bounded part has fewer than 4 faces: allow at least 4 for each");
  }
  if (request.total_faces && *request.total_faces < 4) {
    reject_argument("no bounded part has fewer than 4 faces: allow at least 4 in all");
  }
}

}  // namespace convexact
