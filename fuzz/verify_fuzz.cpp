// SPDX-License-Identifier: MIT
// Property: whatever bytes stand in a candidate's file, of any format, the verdict on it is the one
// that the definitions give: surfaces by counting edges, hulls by all triples of points,
// boundedness by all meetings of three planes, distances by all pairs.
#include "convexact/format/candidate_file.hpp"
#include "convexact/shapes/solids.hpp"
#include "fuzz_check.hpp"
#include "fuzz_input.hpp"
#include "verdict_check.hpp"

using namespace convexact;

namespace {

constexpr const char* kNames[] = {"c.obj",  "c.off", "c.ply", "c.stl",
                                  "c.json", "c.ine", "c.txt", "c"};

// The definitions take time to the fourth power of this.
constexpr std::size_t kMostPoints = 14;
constexpr std::size_t kMostRows = 12;

bool is_small(const Candidate& candidate) {
  if (const auto* mesh = std::get_if<Mesh>(&candidate)) {
    return mesh->points.size() <= kMostPoints && mesh->polygons.size() <= 4 * kMostPoints;
  }
  const auto* list = std::get_if<HalfspaceList>(&candidate);
  return list == nullptr || list->halfspaces.size() <= kMostRows;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzInput in(data, size);
  const char* name = kNames[in.below(std::size(kNames))];
  const Decimal decimal = in.below(2) == 0 ? Decimal::Nearest : Decimal::Exact;
  const Candidate candidate = read_candidate_bytes(in.rest(), name, decimal);
  if (!is_small(candidate)) return 0;
  const PointSet input(shapes::cube());
  StageLog log;
  const VerifyOutcome outcome = verify(input, candidate, {}, log);
  FUZZ_CHECK(definition::disagreement(std::get<Verdict>(outcome), candidate, input).empty());
  return 0;
}
