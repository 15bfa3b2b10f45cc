// SPDX-License-Identifier: MIT
// Proofs with cells that no triangle runs through, written by hand around a bar of three unit
// cubes: what they claim is accepted where it is true by the cubes' coordinates, and nowhere else.
#include <doctest/doctest.h>

#include <set>

#include "cells.hpp"
#include "checker.hpp"
#include "decompositions.hpp"
#include "proof_text.hpp"
#include "proofs.hpp"

using namespace convexact;
using support::Cell;
using support::mesh_of_cells;

namespace {

const std::set<Cell> kBar = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
const std::set<Cell> kTwoCubes = {{0, 0, 0}, {2, 0, 0}};  // [0, 1] and [2, 3] along x

// The bar [0, 3] x [0, 1] x [0, 1] as the only part of a mesh, without a claim about its distance.
ProofText bar_of(const Mesh& mesh) {
  DecomposeRequest request;
  request.method = DecomposeMethod::Cut;
  request.max_parts = 1;
  request.close = Close::Never;
  ProofText proof(proof_of_parts(mesh, request));
  std::erase_if(proof.lines, [](const auto& line) {
    return std::set<std::string>{"reach", "root", "slack", "inner", "cell", "clear", "beyond"}
               .count(line[0]) == 1;
  });
  return proof;
}

using Lines = std::vector<std::vector<std::string>>;

std::vector<std::string> words(const std::string& line) { return ProofText(line).lines[0]; }

// A cube of cells of side 1, four each way, that begin at `start` along x and at -3/2 along y and
// z: two halvings of a root. The part is clear of all that it meets.
Lines unit_cells(const Rational& start) {
  Lines lines{words("reach length 1/10"), words("root " + to_string(start + 2) + " 1/2 1/2 2"),
              words("slack 1/2"), words("inner 0 3/2 1/2 1/2 1/100"), words("cell split")};
  for (int child = 0; child < 8; ++child) {
    lines.push_back(words("cell split"));
    for (int below = 0; below < 8; ++below) {
      lines.push_back(words("cell open"));
      std::string middle = "clear 0";
      bool meets = true;
      for (int k = 0; k < 3; ++k) {
        const Rational low =
            (k == 0 ? start : Rational(-3, 2)) + 2 * (child >> k & 1) + (below >> k & 1);
        const Rational from = std::max(low, Rational(0));
        const Rational to = std::min(Rational(low + 1), Rational(k == 0 ? 3 : 1));
        meets = meets && from < to;
        middle += " " + to_string((from + to) / 2);
      }
      if (meets) lines.push_back(words(middle));
    }
  }
  return lines;
}

ProofText with_cells(ProofText proof, const Lines& lines) {
  proof.lines.insert(proof.lines.end() - 1, lines.begin(), lines.end());
  return proof;
}

ProofText good_proof() { return with_cells(bar_of(mesh_of_cells(kBar)), unit_cells(0)); }

// The good proof with another line in place of the first of its kind, or with none.
ProofText with(const std::string& line, bool is_kept = true) {
  ProofText forged = good_proof();
  const std::size_t l = forged.all(words(line)[0]).at(0);
  forged.lines[l] = words(line);
  if (!is_kept) forged.lines.erase(forged.lines.begin() + std::ptrdiff_t(l));
  return forged;
}

}  // namespace

TEST_CASE("clear cells: a bar is inside of itself, with walls in its faces or across them") {
  for (const Rational& start : {Rational(0), Rational(-1, 2), Rational(-1), Rational(-1, 3)}) {
    const CheckerVerdict verdict =
        check_proof(with_cells(bar_of(mesh_of_cells(kBar)), unit_cells(start)).text(true));
    CAPTURE(verdict.said);
    CHECK(verdict.exit_code == 0);
    CHECK(verdict.said.find("no point of a part is farther than 1/10 from the solid") !=
          std::string::npos);
  }
}

TEST_CASE("clear cells: one is enough, if all triangles lie in the part's planes") {
  const ProofText bar = bar_of(mesh_of_cells(kBar));
  const Lines lines{words("reach length 1/1000"), words("root 3/2 1/2 1/2 2"), words("cell open"),
                    words("clear 0 3/2 1/2 1/2")};
  CHECK(check_proof(with_cells(bar, lines).text(true)).exit_code == 0);
}

TEST_CASE("clear cells: not where a gap is, whose walls lie in walls of cells or run through") {
  const ProofText bar = bar_of(mesh_of_cells(kTwoCubes));
  check_refused(with_cells(bar, unit_cells(0)), 1, "what a part has in a cell is outside");
  check_refused(with_cells(bar, unit_cells(-1)), 1, "what a part has in a cell is outside");
  check_refused(with_cells(bar, unit_cells(Rational(-1, 2))), 1,
                "a triangle runs through what a part has in a cell");
}

TEST_CASE("clear cells: points are inside of the part and of the cell") {
  // The first cell that the part meets is [0, 1] x [-1/2, 1/2] x [-1/2, 1/2].
  for (const char* line : {"clear 0 1/2 1/4 -1/4", "clear 0 1/2 0 1/4", "clear 0 3/2 1/4 1/4",
                           "clear 0 1 1/4 1/4", "clear 0 1/2 1/2 1/4", "clear 0 1/2 1/4 1/1000"}) {
    check_refused(with(line), 1, "a point is not inside of part and cell");
  }
  ProofText forged = good_proof();
  const std::size_t l = forged.all("clear").at(0);
  forged.lines.insert(forged.lines.begin() + std::ptrdiff_t(l), forged.lines[l]);
  check_refused(forged, 1, "a cell is clear of a part already");
  check_refused(with("clear 0", false), 1, "a part may reach into an open cell");
  check_refused(with("clear 1 1/2 1/4 1/4"), 3, "");
}

TEST_CASE("clear cells: a part is made smaller by its share, towards a point inside of it") {
  // The corners are sqrt(11) / 2 = 1.658 from the middle, and may move by 1/20.
  const ProofText most = with("inner 0 3/2 1/2 1/2 301/10000");
  CHECK(check_proof(most.text(true)).exit_code == 0);
  check_refused(with("inner 0 3/2 1/2 1/2 302/10000"), 1, "a part is made smaller by too much");
  check_refused(with("slack 1/100"), 1, "a part is made smaller by too much");
  check_refused(with("slack 1"), 3, "a share below 1");
  check_refused(with("slack -1/2"), 3, "a share below 1");
  for (const char* line : {"inner 0 0 1/2 1/2 1/1000", "inner 0 4 1/2 1/2 1/1000",
                           "inner 0 3/2 1/2 1/2 1", "inner 0 3/2 1/2 1/2 -1/1000"}) {
    check_refused(with(line), 1, "a part is not made smaller towards a point inside of it");
  }
  // As large as it is, it touches cells that are said to be open.
  check_refused(with("inner 0", false), 1, "a part may reach into an open cell");
  check_refused(with("inner 0 3/2 1/2 1/2 0"), 1, "a part may reach into an open cell");
  ProofText forged = good_proof();
  const std::size_t l = forged.all("inner").at(0);
  forged.lines.insert(forged.lines.begin() + std::ptrdiff_t(l), forged.lines[l]);
  check_refused(forged, 1, "a part is made smaller twice");
}

TEST_CASE("clear cells: cells are near within a share of the distance") {
  // The cells are [0, 3] x [-1/2, 3/2] x [-1/2, 3/2]: all within 4 of any triangle of the bar,
  // which is at most 1 long, and not all within 1 of one.
  Lines lines = unit_cells(0);
  for (std::size_t l = 0; l < lines.size(); ++l) {
    if (lines[l][0] != "clear") continue;
    lines[l - 1] = words("cell near 0");
    lines.erase(lines.begin() + std::ptrdiff_t(l--));
  }
  const ProofText bar = bar_of(mesh_of_cells(kBar));
  lines[0] = words("reach length 8");
  CHECK(check_proof(with_cells(bar, lines).text(true)).exit_code == 0);
  lines[0] = words("reach length 4");
  lines[2] = words("slack 3/4");
  check_refused(with_cells(bar, lines), 1, "a cell is not near its triangle");
}

TEST_CASE("clear cells: nothing is clear inside of an open surface") {
  Mesh open = mesh_of_cells(kBar);
  open.polygons.pop_back();
  open.parts.clear();
  check_refused(with_cells(bar_of(open), unit_cells(0)), 1, "the surface is not closed");
}

namespace {

// An L, leaning: rounding bends its faces, and the plane between the facets at its notch holds no
// point but those of the edge.
Mesh leaning_corner() {
  Mesh mesh = mesh_of_cells({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}});
  std::vector<Point> points;
  for (const Point& p : mesh.points.doubles()) {
    points.emplace_back(0.94 * p[0] + 0.35 * p[2], -0.06 * p[0] + 0.985 * p[1] + 0.16 * p[2],
                        -0.34 * p[0] - 0.17 * p[1] + 0.92 * p[2]);
  }
  mesh.points = PointSet(std::move(points));
  return mesh;
}

}  // namespace

TEST_CASE("clear cells: where parts fit the solid, a small distance takes no more of them") {
  const Mesh corner = mesh_of_cells({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  DecomposeRequest request;
  request.method = DecomposeMethod::Cut;
  for (const Mesh& mesh : {corner, turned(corner), leaning_corner()}) {
    for (const char* share : {"1/10", "1/1000", "1/100000"}) {
      request.distance = ConcavityLimit{parse_rational(share), true};
      const ProofText proof(proof_of_parts(mesh, request));
      CHECK(proof.all("cell").size() < 100);
      const CheckerVerdict verdict = check_proof(proof.text());
      CAPTURE(verdict.said);
      CHECK(verdict.exit_code == 0);
      CHECK(verdict.said.find(std::string("no point of a part is farther than ") + share) !=
            std::string::npos);
    }
  }
}
