// SPDX-License-Identifier: MIT
// Property of parts: the verdict on any decomposition of a shape of unit cells into boxes, and its
// volumes, agree with counting cells. Property of parts_file: any bytes of a file of parts are
// read, or the verdict is that they are unreadable; the points of a cube are covered according to
// each part's halfspaces.
#include "fine_boxes.hpp"
#include "fuzz_check.hpp"
#include "fuzz_target.hpp"

using namespace convexact;
using namespace support;
using enum ClaimCode;

namespace {

constexpr std::size_t kMostCells = 6, kMostBoxes = 6;

std::set<Cell> cells_of(FuzzInput& in) {
  std::set<Cell> cells{{0, 0, 0}};
  for (std::size_t count = in.below(kMostCells); count > 0; --count) {
    Cell next = *std::next(cells.begin(), static_cast<long>(in.below(cells.size())));
    const std::size_t way = in.below(6);
    next[way / 2] += way % 2 == 0 ? 1 : -1;
    cells.insert(next);
  }
  return cells;
}

std::vector<FineBox> boxes_of(FuzzInput& in, const std::set<Cell>& cells) {
  std::vector<FineBox> boxes;
  for (std::size_t count = 1 + in.below(kMostBoxes); count > 0; --count) {
    const Cell& cell = *std::next(cells.begin(), static_cast<long>(in.below(cells.size())));
    FineBox box;
    for (int k = 0; k < 3; ++k) {
      box.low[k] = cell[k] * kFine + static_cast<int>(in.below(3)) - 1;
      box.high[k] = box.low[k] + 1 + static_cast<int>(in.below(3 * kFine));
    }
    boxes.push_back(box);
  }
  return boxes;
}

void hold_parts(FuzzInput& in) {
  const std::set<Cell> cells = cells_of(in);
  const std::vector<FineBox> boxes = boxes_of(in, cells);
  const int how = static_cast<int>(in.below(8));
  PartsRequest request;
  request.claims = {PartsSolid,  PartsConvex,   CoversPoints, CoversSurface,
                    CoversSolid, PartsDisjoint, PartsNeeded};
  request.measures = in.below(4) == 0 ? PartMeasures::All : PartMeasures::None;
  request.exact_volumes = true;
  const PartsVerdict verdict =
      verify_parts(sheared(mesh_of_cells(cells), how), parts_of(boxes, how), request);
  const ExpectedCoverage expected = counted(cells, boxes);
  const auto agrees = [&](ClaimCode code, bool holds) {
    FUZZ_CHECK(verdict[code].status == (holds ? Status::Holds : Status::Violated));
  };
  agrees(PartsSolid, true);
  agrees(PartsConvex, true);
  agrees(CoversPoints, expected.points);
  agrees(CoversSurface, expected.surface);
  agrees(CoversSolid, expected.solid);
  agrees(PartsDisjoint, expected.disjoint);
  agrees(PartsNeeded, expected.needed);
  FUZZ_CHECK(verdict.holds() == (expected.points && expected.surface && expected.solid &&
                                 expected.disjoint && expected.needed));
  if (request.measures == PartMeasures::None) return;
  const FineVolumes found = volumes(cells, boxes);
  const Rational fine(1, kFine * kFine * kFine);
  const PartsMeasures& m = *verdict.measures;
  FUZZ_CHECK(*m.solid_volume->exact == Rational(cells.size()));
  FUZZ_CHECK(*m.union_volume->exact == Rational(found.in_union * fine));
  FUZZ_CHECK(*m.uncovered_volume->exact == Rational(cells.size() - found.covered * fine));
  FUZZ_CHECK(*m.excess_volume->exact == Rational((found.in_union - found.covered) * fine));
}

constexpr const char* kPartNames[] = {"p.obj", "p.off", "p.ply", "p.stl", "p.xyz", "p.json", "p"};

// By the definition, on the halfspaces of the hulls.
bool is_covered(const std::vector<ConvexPart>& parts, const RationalPoint& x) {
  return std::any_of(parts.begin(), parts.end(), [&](const ConvexPart& part) {
    return std::all_of(part.halfspaces.begin(), part.halfspaces.end(),
                       [&](const Halfspace& h) { return h(x) <= 0; });
  });
}

void hold_parts_file(FuzzInput& in) {
  constexpr std::size_t kMostPoints = 60;
  const char* name = kPartNames[in.below(std::size(kPartNames))];
  const Decimal decimal = in.below(2) == 0 ? Decimal::Nearest : Decimal::Exact;
  std::optional<CandidateParts> found;
  try {
    found = read_parts_bytes(in.rest(), name, decimal);
  } catch (const Error& error) {
    // The one reason: they are of no format that is read.
    FUZZ_CHECK(error.code() == ErrorCode::Unreadable);
    return;
  }
  const CandidateParts& parts = *found;
  const Mesh cube = box_mesh(box_of({0, 0, 0}));
  const std::vector<NamedPart>* read = parts_of(parts);
  if (read != nullptr) {
    std::size_t points = 0;
    for (const NamedPart& part : *read) {
      points += part.mesh.points.size();
      FUZZ_CHECK(part.mesh.points.size() > 0);
    }
    if (points > kMostPoints) return;
  }
  const PartsVerdict verdict = verify_parts(cube, parts, {.measures = PartMeasures::None});
  const bool is_readable = verdict[PartsReadable].status == Status::Holds &&
                           verdict[PartsFinite].status == Status::Holds;
  FUZZ_CHECK(is_readable == (read != nullptr));
  if (read == nullptr) return;
  bool covers = true;
  for (std::size_t p = 0; p < cube.points.size(); ++p) {
    covers = covers && is_covered(verdict.hulls, cube.points[PointId(p)]);
  }
  FUZZ_CHECK((verdict[CoversPoints].status == Status::Holds) == covers);
  if (verdict[CoversSurface].status == Status::Holds) FUZZ_CHECK(covers);
}

const FuzzTarget kParts("parts", hold_parts);
const FuzzTarget kPartsFile("parts_file", hold_parts_file);

}  // namespace
