// SPDX-License-Identifier: MIT
// Proofs of how far parts reach: what is written is accepted, and nothing that lacks a line, or has
// a changed one, proves more than is true.
#include <algorithm>

#include "checker.hpp"
#include "decompositions.hpp"
#include "proof_text.hpp"
#include "proofs.hpp"
#include "sweep.hpp"

using namespace convexact;
using support::mesh_of_cells;

namespace {

using Line = std::vector<std::string>;

// A slot of width 3 between two walls, turned: narrow enough to be filled at that distance, so that
// a part reaches out of the solid, along edges that no plane of a cell is parallel to.
Mesh slot() {
  return turned(mesh_of_cells({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 1}, {2, 0, 1}}));
}

DecomposeRequest guarded() {
  DecomposeRequest request;
  request.guard = ReachUse::Reach;
  request.distance = ConcavityLimit{Rational(8, 5), false};
  request.limit = {Rational(6), false};
  return request;
}

ProofText slot_proof() { return ProofText(proof_of_parts(slot(), guarded())); }

CheckerVerdict verdict_on(const ProofText& proof) { return check_proof(proof.text(true)); }

std::size_t first(const ProofText& proof, const std::string& keyword, const std::string& second) {
  for (const std::size_t l : proof.all(keyword)) {
    if (second.empty() || proof.lines[l][1] == second) return l;
  }
  FAIL("no such line");
  return 0;
}

}  // namespace

TEST_CASE("reach proof: what is written is accepted, of every form of parts") {
  const CheckerVerdict verdict = verdict_on(slot_proof());
  CHECK(verdict.exit_code == 0);
  CHECK(verdict.said.find("proven: no point of a part is farther than 8/5 from the solid") !=
        std::string::npos);
  for (const FlatParts flat : {FlatParts::Thicken, FlatParts::Keep}) {
    for (const Precision precision : {Precision::Binary64, Precision::Binary32}) {
      DecomposeRequest request = guarded();
      request.flat = flat;
      request.precision = precision;
      const CheckerVerdict of_form = check_proof(proof_of_parts(slot(), request));
      CHECK_MESSAGE(of_form.said.find("no point of a part is farther") != std::string::npos,
                    of_form.said);
    }
  }
  Mesh open = slot();
  open.polygons.pop_back();
  open.parts.clear();
  const CheckerVerdict of_open = check_proof(proof_of_parts(open, guarded()));
  CHECK_MESSAGE(of_open.said.find("from the surface") != std::string::npos, of_open.said);
  DecomposeRequest farther = guarded();
  farther.max_parts = 1;
  farther.distance = ConcavityLimit{Rational(1), false};
  const std::string without = proof_of_parts(slot(), farther);
  CHECK(check_proof(without).said.find("farther") == std::string::npos);
  CHECK_FALSE(claims_reach(without));
  CHECK(claims_reach(slot_proof().text()));
}

TEST_CASE("reach proof: a smaller distance, another root, other cells and directions are refused") {
  const ProofText good = slot_proof();
  ProofText forged = good;
  forged.lines[first(forged, "reach", "")][2] = "1";
  check_refused(forged, 1, "a cell is not near its triangle");
  forged = good;
  forged.lines[first(forged, "reach", "")][2] = "0";
  CHECK(verdict_on(forged).exit_code == 3);
  forged = good;
  forged.lines[first(forged, "root", "")][4] = "1/2";
  CHECK(verdict_on(forged).exit_code == 1);
  forged = good;
  forged.lines[first(forged, "root", "")][4] = "0";
  check_refused(forged, 1, "the root has no size");
  forged = good;
  forged.lines[first(forged, "cell", "near")] = {"cell", "inside"};
  check_refused(forged, 1, "a triangle meets a cell of the inside");
  forged = good;
  forged.lines[first(forged, "cell", "near")] = {"cell", "open"};
  check_refused(forged, 1, "a part may reach into an open cell");
  forged = good;
  forged.lines[first(forged, "cell", "open")] = {"cell", "inside"};
  CHECK(verdict_on(forged).exit_code == 1);
  forged = good;
  forged.lines[first(forged, "cell", "inside")].resize(2);  // counted itself: still right
  CHECK(verdict_on(forged).exit_code == 0);
}

TEST_CASE("reach proof: a direction that separates nothing, or twice, is refused") {
  const ProofText good = slot_proof();
  CHECK(verdict_on(good).exit_code == 0);
  const std::vector<std::size_t> beyond = good.all("beyond");
  REQUIRE(beyond.size() > 0);
  ProofText forged = good;
  for (std::size_t w = 3; w < 6; ++w) forged.lines[beyond[0]][w] = "0";
  check_refused(forged, 1, "a part may reach into an open cell");
  forged = good;
  forged.lines.push_back(forged.lines.back());
  forged.lines[forged.lines.size() - 2] = forged.lines[beyond[0]];
  check_refused(forged, 1, "a cell is beyond a part already");
  forged = good;
  forged.lines.erase(forged.lines.begin() + std::ptrdiff_t(beyond[0]));
  check_refused(forged, 1, "a part may reach into an open cell");
}

namespace {

struct CubeOfCell {
  RationalPoint center;
  Rational half;
};

// The cubes of all cells of a proof, from its root and the order of its lines.
std::vector<CubeOfCell> cubes_of(const ProofText& proof) {
  const Line& root = proof.lines[first(proof, "root", "")];
  std::vector<CubeOfCell> cubes,
      next = {{{parse_rational(root[1]), parse_rational(root[2]), parse_rational(root[3])},
               parse_rational(root[4])}};
  for (const std::size_t l : proof.all("cell")) {
    const CubeOfCell cube = next.back();
    next.pop_back();
    cubes.push_back(cube);
    if (proof.lines[l][1] != "split") continue;
    for (int child = 7; child >= 0; --child) {  // the first of the eight is to be on top
      CubeOfCell below{cube.center, cube.half / 2};
      for (int k = 0; k < 3; ++k) below.center[k] += (child >> k & 1 ? 1 : -1) * below.half;
      next.push_back(below);
    }
  }
  return cubes;
}

// The points of the slot, moved as the only part is.
std::vector<RationalPoint> smaller_slot(const ProofText& proof) {
  const Line& inner = proof.lines[first(proof, "inner", "")];
  const RationalPoint middle(parse_rational(inner[2]), parse_rational(inner[3]),
                             parse_rational(inner[4]));
  const Mesh mesh = slot();
  std::vector<RationalPoint> moved;
  for (const Point& p : mesh.points.doubles()) {
    const RationalPoint x = to_rational(p);
    moved.push_back(x + parse_rational(inner[5]) * (middle - x));
  }
  return moved;
}

// Whether all of the cube is farther along n than every point.
bool separates(const RationalVector3& n, const CubeOfCell& cube,
               const std::vector<RationalPoint>& points) {
  const Rational nearest = n.dot(cube.center) - cube.half * n.cwiseAbs().sum();
  return std::all_of(points.begin(), points.end(),
                     [&](const RationalPoint& x) { return n.dot(x) < nearest; });
}

}  // namespace

TEST_CASE("reach proof: a direction is accepted iff it separates the cell from the part" * sweep) {
  const ProofText good = slot_proof();
  const std::vector<CubeOfCell> cubes = cubes_of(good);
  const std::size_t line = good.all("beyond")[0];
  const std::size_t cell = std::stoul(good.lines[line][1]);
  const std::vector<RationalPoint> part = smaller_slot(good);
  std::size_t accepted = 0, only_centers = 0;
  for (int x = -2; x <= 2; ++x) {
    for (int y = -2; y <= 2; ++y) {
      for (int z = -2; z <= 2; ++z) {
        const RationalVector3 n(x, y, z);
        ProofText other = good;
        for (int k = 0; k < 3; ++k) other.lines[line][3 + std::size_t(k)] = to_string(n[k]);
        const bool is_right = separates(n, cubes[cell], part);
        CAPTURE(other.text());
        CHECK((verdict_on(other).exit_code == 0) == is_right);
        accepted += is_right ? 1 : 0;
        only_centers += !is_right && separates(n, {cubes[cell].center, 0}, part) ? 1 : 0;
      }
    }
  }
  CHECK(accepted > 0);
  CHECK(only_centers > 0);
}

TEST_CASE("reach proof: a cell outside is not inside, whatever touches it") {
  // The surface winds 0 times about the slot: its cells are at most open.
  const ProofText good = slot_proof();
  std::size_t tried = 0;
  for (const std::size_t l : good.all("cell")) {
    if (good.lines[l][1] != "open" || ++tried % 97 != 0) continue;
    ProofText forged = good;
    forged.lines[l] = {"cell", "inside"};
    CHECK(verdict_on(forged).exit_code == 1);
  }
  CHECK(tried > 97);
}

TEST_CASE("reach proof: what a cell of the inside is told by is one itself, and touches it") {
  const ProofText good = slot_proof();
  const std::vector<std::size_t> cells = good.all("cell");
  const auto kind_of = [&](std::size_t number) { return good.lines[cells[number]][1]; };
  std::size_t inside = 0;
  while (kind_of(inside) != "inside") ++inside;
  std::size_t tried = 0, without_triangles = 0;
  for (std::size_t number = inside + 1; number < cells.size(); ++number) {
    if (kind_of(number) != "open" || kind_of(number - 1) == "inside" || ++tried % 97 != 0) continue;
    for (const std::size_t beside : {inside, number - 1}) {
      ProofText forged = good;
      forged.lines[cells[number]] = {"cell", "inside", std::to_string(beside)};
      const CheckerVerdict verdict = verdict_on(forged);
      CHECK(verdict.exit_code == 1);
      if (verdict.said.find("a triangle meets a cell of the inside") != std::string::npos) continue;
      CHECK_MESSAGE(
          verdict.said.find("a cell does not touch one of the inside") != std::string::npos,
          verdict.said);
      ++without_triangles;
    }
  }
  CHECK(without_triangles > 1);
}

TEST_CASE("reach proof: an open surface has no inside") {
  Mesh open = slot();
  open.polygons.pop_back();
  open.parts.clear();
  ProofText forged(proof_of_parts(open, guarded()));
  forged.lines[first(forged, "cell", "open")] = {"cell", "inside"};
  check_refused(forged, 1, "the surface is not closed: it has no inside");
}

TEST_CASE("reach proof: no line of the claim can be left out" * sweep) {
  const ProofText good = slot_proof();
  const std::size_t from = first(good, "reach", "");
  std::size_t accepted = 0, tried = 0;
  // Each of the first and last, and every so many between.
  for (std::size_t l = from; l + 1 < good.lines.size(); ++l) {
    if (l > from + 20 && l + 40 < good.lines.size() && l % 41 != 0) continue;
    ProofText forged = good;
    forged.lines.erase(forged.lines.begin() + std::ptrdiff_t(l));
    ++tried;
    accepted += verdict_on(forged).exit_code == 0 ? 1 : 0;
  }
  CHECK(tried > 60);
  CHECK(accepted == 0);
}

TEST_CASE("reach proof: no keyword can be left out, and none is another") {
  const ProofText good = slot_proof();
  std::size_t tried = 0;
  good.for_each_keyword_changed([&](const ProofText& forged) {
    CAPTURE(forged.text(true));
    CHECK(verdict_on(forged).exit_code != 0);
    ++tried;
  });
  CHECK(tried > 20);
  ProofText forged = good;
  forged.lines[first(forged, "reach", "")][2] += '\0';
  CHECK(verdict_on(forged).exit_code == 3);
}

TEST_CASE("reach proof: cells are halved no more often than doubles can be") {
  ProofText forged = slot_proof();
  const auto cells = forged.lines.begin() + std::ptrdiff_t(forged.all("cell").front());
  forged.lines.insert(cells, 1200, {"cell", "split"});
  check_refused(forged, 3, "fewer halvings");
}

TEST_CASE("reach proof: a root that holds a corner of the parts alone is refused") {
  ProofText forged = slot_proof();
  const Line triangle = forged.lines[first(forged, "triangle", "")];
  const Line corner = forged.lines[forged.all("point").at(std::stoul(triangle[1]))];
  std::erase_if(forged.lines,
                [](const Line& line) { return line[0] == "cell" || line[0] == "beyond"; });
  const std::size_t root = first(forged, "root", "");
  forged.lines[root] = {"root", corner[1], corner[2], corner[3], "1/1000"};
  forged.lines.insert(forged.lines.begin() + std::ptrdiff_t(root) + 1, {"cell", "near", "0"});
  check_refused(forged, 1, "a part reaches out of the root");
}
