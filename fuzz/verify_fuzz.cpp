// SPDX-License-Identifier: MIT
// Property of verify: the verdict on any candidate, mesh or halfspaces, is the one that the
// definitions give: surfaces by counting edges, hulls by all triples of points, boundedness by all
// meetings of three planes, distances by all pairs.
// Property of candidates: the same, for any bytes of a candidate's file.
#include "convexact/verify.hpp"
#include "fuzz_check.hpp"
#include "fuzz_target.hpp"
#include "shapes/makers.hpp"
#include "verdict_check.hpp"

using namespace convexact;

namespace {

// The definitions take time to the fourth power of this.
constexpr std::size_t kMostInputs = 7, kMostInputsRarely = 14;
constexpr std::size_t kMostRows = 7, kMostRowsRarely = 12;

void check_verdict(const PointSet& input, const Candidate& candidate, bool tightness) {
  VerifyRequest request;
  request.tightness = tightness;
  const VerifyOutcome outcome = verify(input, candidate, request);
  const auto* verdict = std::get_if<Verdict>(&outcome);
  if (verdict == nullptr) {  // of the input, not of the candidate
    FUZZ_CHECK(affine_dimension(input.doubles()) < 3);
    return;
  }
  FUZZ_CHECK(definition::disagreement(*verdict, candidate, input).empty());
}

Mesh mesh_of(FuzzInput& in) {
  Mesh mesh;
  const std::vector<Point> points =
      in.grid_points(in.rarely() ? kMostInputsRarely : kMostInputs, 2);
  mesh.points = PointSet(points);
  if (points.empty()) return mesh;
  for (std::size_t count = in.below(13); count > 0 && !in.empty(); --count) {
    auto& polygon = mesh.polygons.emplace_back(3 + (in.below(4) == 0 ? in.below(3) : 0));
    for (std::uint32_t& corner : polygon) {
      corner = static_cast<std::uint32_t>(in.below(points.size()));
    }
  }
  return mesh;
}

HalfspaceList candidate_halfspaces(FuzzInput& in) {
  HalfspaceList list;
  for (std::size_t count = in.below((in.rarely() ? kMostRowsRarely : kMostRows) + 1); count > 0;
       --count) {
    RationalVector3 normal;
    for (Rational& n : normal) n = static_cast<int>(in.below(5)) - 2;
    list.add(normal, static_cast<int>(in.below(7)) - 5);
  }
  return list;
}

void hold_verify(FuzzInput& in) {
  const bool tightness = in.below(16) == 15;
  const bool is_cube = in.below(2) == 0;
  const PointSet input(is_cube ? shapes::cube() : in.grid_points(6, 2));
  if (in.below(2) == 0) {
    check_verdict(input, mesh_of(in), tightness);
  } else {
    check_verdict(input, candidate_halfspaces(in), tightness);
  }
}

constexpr const char* kCandidateNames[] = {"c.obj",  "c.off", "c.ply", "c.stl",
                                           "c.json", "c.ine", "c.txt", "c"};

bool is_small(const Candidate& candidate) {
  if (const auto* mesh = std::get_if<Mesh>(&candidate)) {
    return mesh->points.size() <= kMostInputsRarely &&
           mesh->polygons.size() <= 2 * kMostInputsRarely;
  }
  const auto* list = std::get_if<HalfspaceList>(&candidate);
  return list == nullptr || list->halfspaces.size() <= kMostRows;
}

void hold_candidates(FuzzInput& in) {
  const char* name = kCandidateNames[in.below(std::size(kCandidateNames))];
  const Decimal decimal = in.below(2) == 0 ? Decimal::Nearest : Decimal::Exact;
  std::optional<Candidate> found;
  try {
    found = read_candidate_bytes(in.rest(), name, decimal);
  } catch (const Error& error) {
    // The one reason: they are of no format that is read.
    FUZZ_CHECK(error.code() == ErrorCode::Unreadable);
    return;
  }
  const Candidate& candidate = *found;
  if (!is_small(candidate)) return;
  check_verdict(PointSet(shapes::cube()), candidate, in.rest().size() % 16 == 15);
}

const FuzzTarget kVerify("verify", hold_verify);
const FuzzTarget kCandidates("candidates", hold_candidates);

}  // namespace
