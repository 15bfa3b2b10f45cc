// SPDX-License-Identifier: MIT
// Proofs that parts hold a solid: what is written is accepted; where a part is made smaller, a
// piece is sent elsewhere or a plane is another one, nothing is proven that is not true.
#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "cells.hpp"
#include "checker.hpp"
#include "decompositions.hpp"
#include "proof_text.hpp"
#include "sweep.hpp"

using namespace convexact;
using support::Cell;
using support::mesh_of_cells;

namespace {

std::string proof_of_cuts(const Mesh& mesh, const char* share = "1/20") {
  DecomposeRequest request;
  request.method = DecomposeMethod::Cut;
  request.distance = ConcavityLimit{parse_rational(share), true};
  request.close = Close::Never;
  return proof_of_parts(mesh, request);
}

const std::set<Cell> kBin = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 1}, {2, 0, 1}};

// A cavity, whose walls' hulls need no corner of a region, and a cube cut into octants, which do.
std::set<Cell> hollow() {
  std::set<Cell> cells;
  for (int k = 0; k < 27; ++k) {
    if (k != 13) cells.insert({k % 3, k / 3 % 3, k / 9});
  }
  return cells;
}

bool says(const CheckerVerdict& verdict, const std::string& text) {
  return verdict.said.find(text) != std::string::npos;
}

// Proofs by hand about a cube with a corner at 0.
class CubeProof {
 public:
  explicit CubeProof(int size) {
    const Surface surface = make_surface(mesh_of_cells({{0, 0, 0}}));
    for (const Point& p : surface.points.doubles()) {
      line("point " + words_of([&](int axis) { return std::to_string(size * int(p[axis])); }));
    }
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      const auto& [a, b, c] = surface.triangles[t];
      line("triangle " + std::to_string(a.value) + " " + std::to_string(b.value) + " " +
           std::to_string(c.value) + " " + std::to_string(surface.face[t]));
    }
  }

  void line(const std::string& words) {
    text_ += words + "\n";
    ++lines_;
  }

  // What looks like a box: the corner with bits x + 2y + 4z is coordinate(bits, axis).
  template <class Coordinate>
  void part(Coordinate coordinate, bool is_mirrored) {
    line("part");
    for (int bits = 0; bits < 8; ++bits) {
      line("corner " + words_of([&](int axis) { return coordinate(bits, axis); }));
    }
    for (const auto& [a, b, c] : std::vector<std::array<int, 3>>{{0, 2, 1},
                                                                 {1, 2, 3},
                                                                 {4, 5, 6},
                                                                 {5, 7, 6},
                                                                 {0, 1, 4},
                                                                 {1, 5, 4},
                                                                 {2, 6, 3},
                                                                 {3, 6, 7},
                                                                 {0, 4, 2},
                                                                 {2, 4, 6},
                                                                 {1, 3, 5},
                                                                 {3, 7, 5}}) {
      line("facet " + std::to_string(a) + " " + std::to_string(is_mirrored ? c : b) + " " +
           std::to_string(is_mirrored ? b : c));
    }
  }

  CheckerVerdict verdict() {
    line("end " + std::to_string(lines_ + 1));
    return check_proof(text_);
  }

 private:
  template <class Word>
  static std::string words_of(Word word) {
    return word(0) + " " + word(1) + " " + word(2);
  }

  std::string text_ = "convexact-proof 6 partition\n";
  std::size_t lines_ = 1;
};

constexpr const char* kNotHeld = "a corner of a region is in the solid, and not in the part";

void check_accepted(const Mesh& mesh, bool is_open) {
  const std::string text = proof_of_cuts(mesh);
  CHECK(text.starts_with("convexact-proof 6 partition\n"));
  const CheckerVerdict verdict = check_proof(text);
  CHECK(verdict.exit_code == 0);
  CHECK(says(verdict, is_open ? "convex parts hold the surface" : "convex parts hold the solid"));
  CHECK(says(verdict, "proven: no point of a part is farther than 1/20"));
}

}  // namespace

TEST_CASE("partition proof: what cut writes of a bin and of a hollow box is accepted") {
  for (const auto& cells : {kBin, hollow()}) check_accepted(mesh_of_cells(cells), false);
}

TEST_CASE("partition proof: what cut writes of random cells is accepted" * sweep) {
  std::mt19937_64 random(6);
  for (int k = 0; k < 22; ++k) {
    CAPTURE(k);
    std::set<Cell> cells;
    const std::size_t count = 1 + random() % 9;
    for (std::size_t c = 0; c < count; ++c) {
      cells.insert({static_cast<int>(random() % 3), static_cast<int>(random() % 3),
                    static_cast<int>(random() % 2)});
    }
    Mesh mesh = mesh_of_cells(cells);
    const bool is_open = k % 4 == 3;
    if (is_open) mesh.polygons.pop_back();
    check_accepted(mesh, is_open);
  }
}

TEST_CASE("partition proof: no line can be left out, and no corner moved inward") {
  for (const auto& cells : {kBin, hollow()}) {
    const ProofText original(proof_of_cuts(mesh_of_cells(cells)));
    const std::size_t nodes = original.all("node").back();
    for (std::size_t l = 0; l <= nodes; ++l) {
      const std::string& keyword = original.lines[l][0];
      if (keyword == "point" || keyword == "triangle") continue;  // another surface
      CAPTURE(l);
      ProofText proof = original;
      proof.lines.erase(proof.lines.begin() + static_cast<long>(l));
      CHECK(check_proof(proof.text(true)).exit_code != 0);
      if (keyword != "corner") continue;
      // All parts lie around the point (3/2, 3/2, 3/2), or close to it.
      proof = original;
      for (std::size_t k = 1; k < 4; ++k) proof.lines[l][k] = "7/5";
      CHECK(check_proof(proof.text()).exit_code != 0);
    }
  }
}

TEST_CASE("partition proof: other planes, and other parts for a region") {
  const ProofText original(proof_of_cuts(mesh_of_cells(kBin)));
  const std::size_t parts = original.all("part").size();
  REQUIRE(parts == 3);
  std::size_t refused = 0;
  for (const std::size_t l : original.all("node")) {
    ProofText proof = original;
    if (original.lines[l][1] == "part") {
      for (std::size_t other = 0; other < parts; ++other) {
        if (original.lines[l][2] == std::to_string(other)) continue;
        proof.lines[l][2] = std::to_string(other);
        CHECK(check_proof(proof.text()).exit_code == 1);
      }
      proof.lines[l] = {"node", "empty"};
      CHECK(check_proof(proof.text()).exit_code == 1);
      continue;
    }
    for (std::size_t w = 2; w < 6; ++w) {
      for (const char* word : {"-5", "3", "1/2"}) {
        proof = original;
        proof.lines[l][w] = word;
        const CheckerVerdict verdict = check_proof(proof.text());
        // The parts are as they were, so what is proven by other planes is true.
        if (verdict.exit_code == 0) CHECK(says(verdict, "3 convex parts hold the solid"));
        refused += verdict.exit_code != 0 ? 1 : 0;
      }
    }
  }
  CHECK(refused > 0);
}

TEST_CASE("partition proof: no keyword can be left out, and none is another") {
  for (const auto& cells : {kBin, hollow()}) {
    const ProofText good(proof_of_cuts(mesh_of_cells(cells)));
    good.for_each_keyword_changed([&](const ProofText& forged) {
      CAPTURE(forged.text(true));
      CHECK(check_proof(forged.text(true)).exit_code != 0);
    });
  }
}

TEST_CASE("partition proof: regions are not cut without end") {
  // Ever thinner slabs of the box around the bin, which begins at -1.
  ProofText forged(proof_of_cuts(mesh_of_cells(kBin)));
  const std::size_t first = forged.all("node").front();
  std::vector<std::vector<std::string>> cuts;
  for (int k = 2; k < 1'100; ++k) {
    const std::string offset = std::to_string(k - 1) + "/" + std::to_string(k);
    cuts.push_back({"node", "cut", "1", "0", "0", offset});
  }
  const auto at = forged.lines.begin() + static_cast<std::ptrdiff_t>(first);
  forged.lines.insert(at, cuts.begin(), cuts.end());
  const CheckerVerdict verdict = check_proof(forged.text(true));
  CHECK(verdict.exit_code == 3);
  CHECK_MESSAGE(says(verdict, "line " + std::to_string(first + 1'001)), verdict.said);
}

TEST_CASE("partition proof: planes between disjoint parts") {
  DecomposeRequest request;
  request.method = DecomposeMethod::Cut;
  request.close = Close::Never;
  request.disjoint = true;
  const ProofText original(proof_of_parts(mesh_of_cells(hollow()), request));
  const CheckerVerdict accepted = check_proof(original.text());
  CHECK(accepted.exit_code == 0);
  CHECK(says(accepted, "proven: no two parts have a common interior point"));
  const std::vector<std::size_t> planes = original.all("between");
  REQUIRE(planes.size() == 15);  // of six parts
  for (const std::size_t l : planes) {
    CAPTURE(l);
    const auto refuses = [&](auto&& change) {
      ProofText proof = original;
      change(proof.lines);
      CHECK(check_proof(proof.text(true)).exit_code == 1);
    };
    refuses([&](auto& lines) { lines.erase(lines.begin() + static_cast<long>(l)); });
    refuses([&](auto& lines) { lines.insert(lines.begin() + static_cast<long>(l), lines[l]); });
    refuses([&](auto& lines) { std::swap(lines[l][1], lines[l][2]); });
    refuses([&](auto& lines) {
      for (std::size_t k = 3; k < 6; ++k) lines[l][k] = "0";
    });
    // The parts are one beside the other, and no plane is between them the other way round.
    refuses([&](auto& lines) {
      for (std::size_t k = 3; k < 6; ++k) {
        std::string& word = lines[l][k];
        word = word == "0" ? word : word[0] == '-' ? word.substr(1) : "-" + word;
      }
    });
  }
  // What is allowed for is believed no further than it is so.
  ProofText less = original;
  less.lines[original.all("disjoint")[0]][1] = "-1";
  CHECK(check_proof(less.text()).exit_code != 0);
}

// A cube of 2 in octants; where the corners at its middle are cut off, no part has that.
TEST_CASE("partition proof: a corner of a region inside of the solid must be held") {
  for (const bool has_middle : {true, false}) {
    CubeProof proof(2);
    for (int octant = 0; octant < 8; ++octant) {
      const auto coordinate = [&](int bits, int axis) -> std::string {
        const bool is_high = (octant >> axis & 1) != 0;
        if ((bits >> axis & 1) != 0) return is_high ? "2" : "0";
        if (bits != 0 || has_middle) return "1";
        return is_high ? "4/3" : "2/3";  // in the plane of the three corners next to it
      };
      const bool is_even = ((octant & 1) ^ (octant >> 1 & 1) ^ (octant >> 2 & 1)) == 0;
      proof.part(coordinate, is_even);
    }
    proof.line("node cut 1 0 0 -1");
    for (int x = 0; x < 2; ++x) {
      proof.line("node cut 0 1 0 -1");
      for (int y = 0; y < 2; ++y) {
        proof.line("node cut 0 0 1 -1");
        for (int z = 0; z < 2; ++z) proof.line("node part " + std::to_string(x + 2 * y + 4 * z));
      }
    }
    const CheckerVerdict verdict = proof.verdict();
    INFO(verdict.said);
    CHECK(verdict.exit_code == (has_middle ? 0 : 1));
    if (!has_middle) CHECK(says(verdict, kNotHeld));
  }
}

// A cube of 3 in slabs around a cube of 1, which no triangle reaches.
TEST_CASE("partition proof: a region without triangles is not empty because of that") {
  for (const bool is_called_empty : {false, true}) {
    CubeProof proof(3);
    int low[3] = {0, 0, 0}, high[3] = {3, 3, 3};
    const auto add_box = [&] {
      proof.part(
          [&](int bits, int k) { return std::to_string((bits >> k & 1) ? high[k] : low[k]); },
          false);
    };
    for (int axis = 0; axis < 3; ++axis) {
      high[axis] = 1;
      add_box();
      low[axis] = 2;
      high[axis] = 3;
      add_box();
      low[axis] = 1;
      high[axis] = 2;
    }
    add_box();
    for (int axis = 0; axis < 3; ++axis) {
      const std::string normal = axis == 0 ? "1 0 0" : axis == 1 ? "0 1 0" : "0 0 1";
      proof.line("node cut " + normal + " -1");
      proof.line("node part " + std::to_string(2 * axis));
      proof.line("node cut " + normal + " -2");
    }
    proof.line(is_called_empty ? "node empty" : "node part 6");
    for (int axis = 2; axis >= 0; --axis) proof.line("node part " + std::to_string(2 * axis + 1));
    const CheckerVerdict verdict = proof.verdict();
    INFO(verdict.said);
    CHECK(verdict.exit_code == (is_called_empty ? 1 : 0));
    if (is_called_empty) CHECK(says(verdict, kNotHeld));
  }
}
