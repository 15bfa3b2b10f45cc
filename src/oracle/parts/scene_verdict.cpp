// SPDX-License-Identifier: MIT
#include "oracle/parts/scene_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <unordered_map>

#include "convexact/error.hpp"
#include "convexact/hull.hpp"
#include "number/text.hpp"
#include "scene/objects.hpp"
#include "solid/solid.hpp"

namespace convexact {
namespace {

// The halfspaces of the hull of a part's points; none if these span no volume.
std::vector<Halfspace> hull_planes(const PointSet& points, const VerifyRequest& request) {
  StageLog within(StageWatch{.stop = request.watch.stop});
  const auto outcome = make_hull(points, {.seed = request.seed}, within);
  const auto* hull = std::get_if<Hull>(&outcome);
  return hull != nullptr ? to_polytope(*hull, points).planes : std::vector<Halfspace>();
}

// Of a face that is not inside the solid of its part.
GapVerdict::Witness witness_of(const PartFace& face, const SceneObject& part,
                               const std::vector<Halfspace>& solid) {
  const auto& points = std::get<PointSet>(part.shape);
  const auto& corners = part.polygons[face.face];
  for (const std::uint32_t corner : corners) {
    const RationalPoint point = points[PointId(corner)];
    const auto beyond = std::find_if(solid.begin(), solid.end(), [&](const Halfspace& halfspace) {
      return halfspace(point) > 0;
    });
    if (beyond != solid.end()) return {face, part.part, point, *beyond};
  }
  return {face, part.part, points[PointId(corners[0])], {}};
}

GapVerdict judge_gaps(const std::vector<SceneObject>& input,
                      const std::vector<std::vector<Halfspace>>& solids, const Watch& watch) {
  GapVerdict found{find_gaps(input, solids, watch), {}, {}};
  const Gaps& gaps = found.gaps;
  if (gaps.out_of_own.empty()) {
    found.sentence = fmt::format("each of {} faces is inside the candidate of its part",
                                 with_separators(gaps.faces));
    return found;
  }
  // A face that no part covers says more than one that another part covers.
  const PartFace& worst = (gaps.in_no_part.empty() ? gaps.out_of_own : gaps.in_no_part).front();
  found.witness = witness_of(worst, input[worst.part], solids[worst.part]);
  found.sentence = fmt::format(
      "{} of {} faces are not inside the candidate of their part, and {} of these in no other; "
      "face "
      "{} of part {} is one",
      with_separators(gaps.out_of_own.size()), with_separators(gaps.faces),
      with_separators(gaps.in_no_part.size()), worst.face, in_quotes(found.witness->part));
  return found;
}

std::vector<std::string> names_of(const std::vector<SceneObject>& parts) {
  std::vector<std::string> names;
  for (const SceneObject& part : parts) names.push_back(part.part);
  return names;
}

}  // namespace

bool SceneVerdict::holds() const {
  return !(gaps && gaps->witness) &&
         std::all_of(parts.begin(), parts.end(),
                     [](const PartVerdict& part) { return part.verdict.holds(); });
}

std::vector<std::size_t> match_parts(const std::vector<std::string>& input,
                                     const std::vector<std::string>& candidate) {
  if (input.size() != candidate.size()) {
    throw Error(ErrorCode::InvalidArgument,
                fmt::format("the input has {} parts and the candidate has {}", input.size(),
                            candidate.size()));
  }
  std::vector<std::size_t> in_order;
  for (std::size_t k = 0; k < input.size(); ++k) in_order.push_back(k);
  if (input == candidate) return in_order;
  std::unordered_map<std::string, std::size_t> place;
  for (std::size_t k = 0; k < candidate.size(); ++k) place.emplace(candidate[k], k);
  const auto missing = std::find_if(input.begin(), input.end(),
                                    [&](const auto& name) { return !place.contains(name); });
  const bool none = std::none_of(input.begin(), input.end(),
                                 [&](const auto& name) { return place.contains(name); });
  if (none) return in_order;
  if (missing != input.end()) {
    throw Error(ErrorCode::InvalidArgument,
                "the candidate has no part " + in_quotes(*missing) + ", but others by name");
  }
  const std::set<std::string> once(input.begin(), input.end());
  if (once.size() != input.size() || place.size() != candidate.size()) {
    throw Error(ErrorCode::InvalidArgument,
                "several parts have one name, and they are in another order in the candidate");
  }
  std::vector<std::size_t> by_name;
  for (const std::string& name : input) by_name.push_back(place.at(name));
  return by_name;
}

std::variant<SceneVerdict, NotSolidPart> verify_scene(const std::vector<SceneObject>& input,
                                                      const Candidate& candidate,
                                                      const VerifyRequest& request) {
  if (std::holds_alternative<HalfspaceList>(candidate)) {
    throw Error(ErrorCode::InvalidArgument,
                "the candidate is a list of halfspaces, which has no parts");
  }
  const auto* mesh = std::get_if<Mesh>(&candidate);
  std::vector<SceneObject> parts;
  std::vector<std::size_t> place;
  if (mesh != nullptr) {
    parts = parts_of(*mesh, "CANDIDATE");
    place = match_parts(names_of(input), names_of(parts));
  }
  VerifyRequest of_part = request;
  const bool judges_gaps =
      std::erase(of_part.claims, ClaimCode::NoGaps) > 0 || request.claims.empty();
  const bool judges_parts = request.claims.empty() || !of_part.claims.empty();
  SceneVerdict verdict;
  std::vector<std::vector<Halfspace>> solids;
  for (std::size_t k = 0; k < input.size(); ++k) {
    Candidate own = mesh != nullptr ? Candidate(Mesh{}) : candidate;
    std::string name;
    if (mesh != nullptr) {
      const SceneObject& part = parts[place[k]];
      own = Mesh{std::get<PointSet>(part.shape), part.polygons, {}};
      name = part.part;
      if (judges_gaps) {
        solids.push_back(hull_planes(std::get<PointSet>(part.shape), request));
      }
    }
    if (mesh != nullptr && !judges_parts) continue;
    VerifyRequest each = of_part;
    each.used = used_flags(input[k]);
    VerifyOutcome outcome = verify(input[k].shape, own, each);
    if (const auto* reason = std::get_if<NotSolid>(&outcome)) return NotSolidPart{k, *reason};
    verdict.parts.push_back({input[k].part, name, std::get<Verdict>(std::move(outcome))});
  }
  if (mesh != nullptr && judges_gaps) {
    verdict.gaps = judge_gaps(input, solids, request.watch.stop);
  }
  return verdict;
}

}  // namespace convexact
