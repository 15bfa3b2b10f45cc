// SPDX-License-Identifier: MIT
// convexact-check refuses proofs of right runs with any change in them. Where a change
// may leave a valid proof (of another point set, with another ray), the rule that says so is below,
// and the change must still end in a verdict.
#include <algorithm>
#include <set>

#include "checker.hpp"
#include "number/random.hpp"
#include "proof_text.hpp"
#include "proofs.hpp"
#include "shapes/makers.hpp"

using namespace convexact;

namespace {

// Small, with ties, repeats, points inside, and removals that are unbounded.
Shape small_shape() {
  std::vector<Point> points = shapes::cut_cube(4, 0.25);
  points.push_back(points[3]);
  points.push_back({0.125, 0.25, 0.5});
  return PointSet(points);
}

Shape small_halfspaces() {
  const auto row = [](int a, int b, int c, int d) {
    return Halfspace(IntegerVector3(a, b, c), Integer(d));
  };
  return std::vector<Halfspace>{row(1, 0, 0, -3),  row(-1, 0, 0, -3),  row(0, 1, 0, -2),
                                row(0, -1, 0, -2), row(0, 0, 1, -1),   row(0, 0, -1, -1),
                                row(1, 1, 1, -5),  row(-3, 5, 1, -19), row(2, 2, 2, -11)};
}

// Of a run that keeps the cut, which would go first.
std::string kept_proof() {
  SimplifyRequest request;
  request.engine = Engine::Exact;
  request.faces = 6;
  request.record = true;
  request.keep = {{KeepNormal{{-1, -1, -1}, 0.0}, "the cut"}};
  const auto result =
      std::get<SimplifyResult>(simplify(PointSet(shapes::cut_cube(1, 0.5)), request));
  return write_proof(*result.start, *result.run, result.solid.points, result.solid.planes);
}

std::vector<std::string> small_proofs() {
  return {kept_proof(),
          proof_of(small_shape(), Engine::Exact, 6, Precision::Binary64),
          proof_of(small_shape(), Engine::Filtered, 6),
          proof_of(small_shape(), Engine::Float, 7, Precision::Binary32),
          proof_of(small_halfspaces(), Engine::Filtered, 6, Precision::Binary32),
          proof_of(PointSet(shapes::antiprism(4)), Engine::Filtered, 5),
          proof_of(small_shape(), Engine::Exact, 6, {}, CostMeasure::Area),
          proof_of(PointSet(shapes::antiprism(4)), Engine::Filtered, 5, {}, CostMeasure::Area),
          proof_of(small_halfspaces(), Engine::Filtered, 6, {}, CostMeasure::MeanWidth)};
}

bool is_refusal(int exit_code) { return exit_code == 1 || exit_code == 3; }

void check_refused(const std::string& proof) {
  const CheckerVerdict verdict = check_proof(proof);
  CHECK_MESSAGE(is_refusal(verdict.exit_code), verdict.said);
}

// Whether a change of this one word may leave a valid proof.
bool may_stay_valid(const ProofText& proof, std::size_t l, std::size_t w,
                    const std::string& changed) {
  const std::vector<std::string>& line = proof.lines[l];
  const std::string& keyword = line[0];
  const auto as_number = [](const std::string& word) {
    try {
      const double value = std::stod(word);
      return word.find_first_not_of("-+.0123456789abcdefpx/") == word.npos ? value : 1e300;
    } catch (const std::exception&) {
      return 1e300;
    }
  };
  // The same number, spelt in another way.
  if (as_number(changed) == as_number(line[w]) && as_number(changed) != 1e300) return true;
  // What version 2 says of volumes, version 1 does, too; and version 3 with nothing kept says what
  // version 2 does.
  if (keyword == "convexact-proof" && w == 1) {
    if (!proof.all("keep").empty()) return false;
    return changed == "3" || (changed == "1" && (line[2] == "greedy" || line[2] == "costs"));
  }
  // Any interior point and any ray will do that does what it must.
  if (keyword == "interior") return true;
  if (keyword == "evaluate" && line[2] == "unbounded" && w >= 3) return true;
  // A point that is no vertex may lie elsewhere, as long as its line `inside` still says where.
  if (keyword == "point") {
    const std::string id = std::to_string(l - proof.all("point")[0]);
    for (const std::size_t t : proof.all("triangle")) {
      if (proof.lines[t][4] == id) return false;
    }
    return true;
  }
  // It may lie in another tetrahedron as well.
  if (keyword == "inside") return w >= 2;
  // A redundant halfspace may be another one that is redundant.
  if (keyword == "row") {
    for (const std::size_t p : proof.all("plane")) {
      if (std::equal(line.begin() + 1, line.end(), proof.lines[p].begin() + 1)) return false;
    }
    return true;
  }
  // A stored plane may lie farther out.
  if (keyword == "halfspace" && w == 4) return as_number(changed) < as_number(line[4]);
  return false;
}

const char* const kWords[] = {"0",
                              "1",
                              "2",
                              "3",
                              "-1",
                              "7/3",
                              "1/0",
                              "0/0",
                              "-",
                              "/",
                              "nan",
                              "inf",
                              "0x",
                              "0x1p9999",
                              "x",
                              "1e5",
                              "0x1.8p+1",
                              "99999999999",
                              "18446744073709551616",
                              "unbounded",
                              "tie"};

}  // namespace

TEST_CASE("mutated proof: the originals are accepted") {
  for (const std::string& proof : small_proofs()) {
    CHECK(check_proof(proof).exit_code == 0);
    CHECK(check_proof(ProofText(proof).text()).exit_code == 0);
  }
}

TEST_CASE("mutated proof: any word replaced, left out or doubled") {
  std::set<std::string> keywords;
  for (const std::string& text : small_proofs()) {
    const ProofText original(text);
    ProofText proof = original;
    for (std::size_t l = 0; l < proof.lines.size(); ++l) {
      keywords.insert(original.lines[l][0]);
      for (std::size_t w = 0; w < original.lines[l].size(); ++w) {
        INFO(original.lines[l][0], ", line ", l + 1, ", word ", w);
        // Two of the words at each place, other ones at the next.
        for (std::size_t k = 0; k < 2; ++k) {
          const char* const word = kWords[(2 * (l + w) + l + k) % std::size(kWords)];
          proof.lines[l][w] = word;
          if (proof.lines[l][w] == original.lines[l][w]) continue;
          CAPTURE(word);
          const int exit_code = check_proof(proof.text()).exit_code;
          const bool may_be_valid = w > 0 && may_stay_valid(original, l, w, word);
          CHECK((is_refusal(exit_code) || (may_be_valid && exit_code == 0)));
        }
        proof.lines[l] = original.lines[l];
        proof.lines[l].erase(proof.lines[l].begin() + static_cast<std::ptrdiff_t>(w));
        check_refused(proof.text());
        proof.lines[l] = original.lines[l];
        proof.lines[l].insert(proof.lines[l].begin() + static_cast<std::ptrdiff_t>(w),
                              original.lines[l][w]);
        check_refused(proof.text());
        proof.lines[l] = original.lines[l];
      }
    }
  }
  // Every kind of line was there to be changed.
  CHECK(keywords == std::set<std::string>{"convexact-proof", "end", "evaluate", "halfspace",
                                          "inside", "interior", "keep", "plane", "point", "remove",
                                          "row", "stored", "survive", "triangle", "vertex"});
}

TEST_CASE("mutated proof: a number moved by the least that its format can say") {
  for (const std::string& text : small_proofs()) {
    const ProofText original(text);
    ProofText proof = original;
    for (std::size_t l = 0; l < proof.lines.size(); ++l) {
      const std::string& keyword = original.lines[l][0];
      if (keyword != "plane" && keyword != "vertex" && keyword != "evaluate") continue;
      for (std::size_t w = 1; w < original.lines[l].size(); ++w) {
        const std::string& word = original.lines[l][w];
        if (word.find_first_not_of("-/0123456789") != word.npos) continue;
        if (may_stay_valid(original, l, w, "no number")) continue;
        proof.lines[l][w] = to_string(Rational(parse_rational(word) + Rational(1, 1000000)));
        if (keyword == "plane") proof.lines[l][w] = to_string(Rational(parse_rational(word) + 1));
        check_refused(proof.text());
        proof.lines[l][w] = word;
      }
    }
  }
}

TEST_CASE("mutated proof: a number in hexadecimal is what it spells, not the nearest double") {
  std::size_t changed = 0;
  for (const std::string& text : small_proofs()) {
    const ProofText original(text);
    for (const std::size_t t : original.all("triangle")) {
      const std::size_t l = original.all("point")[0] + std::stoul(original.lines[t][4]);
      for (std::size_t w = 1; w <= 3; ++w) {
        const std::string& word = original.lines[l][w];
        const std::size_t power = word.find('p');
        if (power == word.npos) continue;
        ProofText proof = original;
        const std::string fraction = word.find('.') == word.npos ? "." : "";
        proof.lines[l][w] = word.substr(0, power) + fraction + "000" + word.substr(power);
        CHECK(check_proof(proof.text()).exit_code == 0);
        // A vertex elsewhere by less than a double can say.
        proof.lines[l][w] =
            word.substr(0, power) + fraction + std::string(20, '0') + "1" + word.substr(power);
        check_refused(proof.text());
        proof.lines[l][w] = "0x1p-1999";
        check_refused(proof.text());
        ++changed;
      }
    }
  }
  CHECK(changed > 30);
}

TEST_CASE("mutated proof: a line left out or doubled") {
  for (const std::string& text : small_proofs()) {
    const ProofText original(text);
    for (std::size_t l = 0; l < original.lines.size(); ++l) {
      CAPTURE(l + 1);
      ProofText proof = original;
      proof.lines.insert(proof.lines.begin() + static_cast<std::ptrdiff_t>(l), original.lines[l]);
      check_refused(proof.text());
      // With the count mended, a repeated row of the input says nothing new; all else is refused.
      if (original.lines[l][0] != "row") check_refused(proof.text(true));
      proof = original;
      proof.lines.erase(proof.lines.begin() + static_cast<std::ptrdiff_t>(l));
      check_refused(proof.text());
    }
  }
}

TEST_CASE("mutated proof: what it rests on left out, with the count of lines mended") {
  for (const std::string& text : small_proofs()) {
    const ProofText original(text);
    const bool is_greedy = original.lines[0][2].starts_with("greedy");
    const std::size_t first_removal = original.all("remove").front();
    for (std::size_t l = 0; l < original.lines.size(); ++l) {
      const std::string& keyword = original.lines[l][0];
      // Of the evaluations, those that every greedy run needs: before the first removal each
      // halfspace has one. Points and rows that say nothing about P are the input's own business.
      const bool is_needed = keyword == "plane" || keyword == "triangle" || keyword == "inside" ||
                             keyword == "remove" || keyword == "vertex" || keyword == "halfspace" ||
                             (keyword == "evaluate" && is_greedy && l < first_removal);
      if (!is_needed) continue;
      INFO(keyword, ", line ", l + 1);
      ProofText proof = original;
      proof.lines.erase(proof.lines.begin() + static_cast<std::ptrdiff_t>(l));
      check_refused(proof.text(true));
    }
  }
}

TEST_CASE("mutated proof: a removal without the evaluation that it rests on") {
  for (const std::string& text : small_proofs()) {
    const ProofText original(text);
    for (const std::size_t removal : original.all("remove")) {
      std::size_t last = 0;
      for (const std::size_t l : original.all("evaluate")) {
        if (l < removal && original.lines[l][1] == original.lines[removal][1]) last = l;
      }
      REQUIRE(last > 0);
      ProofText proof = original;
      proof.lines.erase(proof.lines.begin() + static_cast<std::ptrdiff_t>(last));
      check_refused(proof.text(true));
    }
  }
}

TEST_CASE("mutated proof: two removals swapped") {
  for (const std::string& text : small_proofs()) {
    const ProofText original(text);
    if (!original.lines[0][2].starts_with("greedy")) continue;
    // A removal is its line and those of its vertices; the evaluations stay where they are.
    const std::vector<std::size_t> removals = original.all("remove");
    for (std::size_t r = 1; r < removals.size(); ++r) {
      const auto block = [&](std::size_t start) {
        std::size_t end = start + 1;
        while (original.lines[end][0] == "vertex") ++end;
        return std::vector(original.lines.begin() + static_cast<std::ptrdiff_t>(start),
                           original.lines.begin() + static_cast<std::ptrdiff_t>(end));
      };
      const auto first = block(removals[r - 1]), second = block(removals[r]);
      ProofText proof = original;
      const auto replace = [&](std::size_t start, const auto& old, const auto& by) {
        const auto place = proof.lines.begin() + static_cast<std::ptrdiff_t>(start);
        proof.lines.insert(
            proof.lines.erase(place, place + static_cast<std::ptrdiff_t>(old.size())), by.begin(),
            by.end());
      };
      replace(removals[r], second, first);
      replace(removals[r - 1], first, second);
      check_refused(proof.text(true));
    }
  }
}

TEST_CASE("mutated proof: ties") {
  using Line = std::vector<std::string>;
  const std::pair<const char*, void (*)(Line&)> changes[] = {
      {"one dropped", [](Line& line) { line.pop_back(); }},
      {"all dropped but the removed one", [](Line& line) { line.resize(4); }},
      {"none listed", [](Line& line) { line.resize(3); }},
      {"one added that is dearer",
       [](Line& line) { line.push_back(line.back() == "0" ? "1" : "0"); }},
      {"two swapped", [](Line& line) { std::swap(line[4], line[5]); }},
      {"not the first of the tie removed", [](Line& line) { line[1] = line[4]; }},
      {"another tied one removed, and listed first",
       [](Line& line) {
         std::swap(line[3], line[4]);
         line[1] = line[3];
       }},
  };
  for (const CostMeasure cost : {CostMeasure::Volume, CostMeasure::Area}) {
    const ProofText original(
        proof_of(PointSet(shapes::cut_cube(8, 0.25)), Engine::Filtered, 6, {}, cost));
    const std::size_t removal = original.all("remove").front();
    REQUIRE(original.lines[removal].size() == 3 + 8);
    for (const auto& change : changes) {
      CAPTURE(change.first);
      ProofText proof = original;
      change.second(proof.lines[removal]);
      check_refused(proof.text());
    }
  }
}

TEST_CASE("mutated proof: a run that claims more than it proves") {
  // The float engine proves no greed; its file with the other claim is refused.
  ProofText proof(proof_of(small_shape(), Engine::Float, 6));
  REQUIRE(proof.lines[0][2] == "costs");
  proof.lines[0][2] = "greedy";
  check_refused(proof.text());
}

TEST_CASE("mutated proof: cut off anywhere") {
  for (const std::string& proof : small_proofs()) {
    const std::size_t stride = 1 + proof.size() / 500;
    for (std::size_t size = 0; size + 1 < proof.size(); size += stride) {
      CAPTURE(size);
      check_refused(proof.substr(0, size));
    }
    check_refused(proof + "end");
  }
}

TEST_CASE("mutated proof: random bytes end in a verdict") {
  Random random(7);
  for (const std::string& original : small_proofs()) {
    for (std::uint64_t round = 0; round < 300; ++round) {
      std::string proof = original;
      for (std::uint64_t k = 0; k <= round % 3; ++k) {
        proof[random() % proof.size()] = static_cast<char>(random() % 256);
      }
      const int exit_code = check_proof(proof).exit_code;
      CHECK((exit_code == 0 || is_refusal(exit_code)));
    }
  }
}
