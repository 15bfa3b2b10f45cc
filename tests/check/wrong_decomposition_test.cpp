// SPDX-License-Identifier: MIT
// Proofs of false claims about decompositions: each has a single mistake, which no other line
// reveals, or the first line that does is the one named.
#include <algorithm>

#include "checker.hpp"
#include "convexact/io.hpp"
#include "decompositions.hpp"
#include "proof_text.hpp"

using namespace convexact;
using support::box_mesh;
using support::Cell;
using support::mesh_of_cells;

namespace {

using Line = std::vector<std::string>;

Line words_of(const std::string& line) { return ProofText(line).lines.at(0); }

// A proof to be changed.
class Forged {
 public:
  explicit Forged(const std::string& proof) : text_(proof) {}

  // Of the n-th line with this keyword.
  Line& line(const std::string& keyword, std::size_t n = 0) {
    return text_.lines.at(text_.all(keyword).at(n));
  }
  Forged& set(const std::string& keyword, std::size_t n, const std::string& words) {
    line(keyword, n) = words_of(words);
    return *this;
  }
  Forged& append(const std::string& keyword, std::size_t n, const std::string& words) {
    for (const std::string& word : words_of(words)) line(keyword, n).push_back(word);
    return *this;
  }
  Forged& erase(const std::string& keyword, std::size_t n = 0) {
    text_.lines.erase(text_.lines.begin() + std::ptrdiff_t(text_.all(keyword).at(n)));
    return *this;
  }
  Forged& erase_all(const std::string& keyword) {
    while (!text_.all(keyword).empty()) erase(keyword);
    return *this;
  }
  Forged& insert_behind(const std::string& keyword, std::size_t n, const std::string& words) {
    text_.lines.insert(text_.lines.begin() + std::ptrdiff_t(text_.all(keyword).at(n)) + 1,
                       words_of(words));
    return *this;
  }
  std::string text() const { return text_.text(true); }
  std::size_t count(const std::string& keyword) const { return text_.all(keyword).size(); }

 private:
  ProofText text_;
};

void check_not_proven(const Forged& proof, const std::string& why) {
  const CheckerVerdict verdict = check_proof(proof.text());
  CHECK(verdict.exit_code == 1);
  CHECK_MESSAGE(verdict.said.find(why) != std::string::npos, verdict.said);
}
void check_proven(const Forged& proof) {
  const CheckerVerdict verdict = check_proof(proof.text());
  CHECK_MESSAGE(verdict.exit_code == 0, verdict.said);
}

std::string proof_at(const Mesh& mesh, const std::string& limit,
                     ConcavityMeasure measure = ConcavityMeasure::Surface) {
  DecomposeRequest request;
  request.limit = {parse_rational(limit), true};
  request.measure = measure;
  request.flat = FlatParts::Keep;
  return proof_of_parts(mesh, request);
}

// Two clusters that are neighbours, of concavity 0.
std::string l_proof() { return proof_at(mesh_of_cells({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), "0"); }

// Two clusters that are none.
std::string two_boxes() { return proof_at(mesh_of_cells({{0, 0, 0}, {3, 0, 0}}), "0"); }

std::string square() {
  return proof_at(
      {PointSet(std::vector<Point>{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}}),
       {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}},
       {{"", 0, 4}}},
      "0");
}

// One cluster of concavity 4; see hip_roof(). In the order of the proof the
// points are r0 (-100, 0, 4), (-1, -1, 0), (0, -8, 0), (0, 1, 0), (0, 8, 0), (1, -1, 0), r1 (100,
// 0, 4): numbers 0 to 6.
std::string roof_proof() {
  DecomposeRequest request;
  request.limit = {Rational(4), false};
  request.orient = Orient::Keep;
  return proof_of_parts(hip_roof(), request);
}

// The triangle (1 5 3) of the roof's proof.
std::string floor_of_roof() {
  const ProofText text(roof_proof());
  const auto all = text.all("triangle");
  for (std::size_t t = 0; t < all.size(); ++t) {
    const Line& line = text.lines[all[t]];
    if (line[1] == "1" && line[2] == "5" && line[3] == "3") return std::to_string(t);
  }
  return "none";
}

const std::string kTwoPoints[] = {"point 0x0p+0 0x0p+0 0x0p+0", "point 1 2 3"};

}  // namespace

TEST_CASE("wrong decomposition: the surface") {
  const Forged l(l_proof());
  check_proven(l);
  const std::size_t last = l.count("point") - 1;
  check_not_proven(Forged(l).insert_behind("point", last, kTwoPoints[0]), "a point is repeated");
  check_not_proven(Forged(l).insert_behind("point", last, kTwoPoints[1]), "a point is no corner");
  CHECK(check_proof("convexact-proof 4 decomposition\nmeasure surface\nlimit share 0\nneighbours "
                    "edges\nend 5\n")
            .said.find("a point is no corner") != std::string::npos);
}

TEST_CASE("wrong decomposition: clusters") {
  const Forged l(l_proof());
  const Line second = Forged(l).line("cluster", 1);
  check_not_proven(Forged(l).append("cluster", 1, Forged(l).line("cluster", 0)[1]),
                   "a triangle is in a cluster already");
  check_not_proven(Forged(l).append("cluster", 1, second[1]), "a triangle is in a cluster already");

  // A triangle in no cluster: the proof of the square with one triangle left out everywhere.
  Forged without(square());
  const std::string left_out = without.line("cluster").back();
  without.line("cluster").pop_back();
  for (const char* keyword : {"within", "owns"}) {
    Line& line = without.line(keyword);
    line.erase(std::find(line.begin() + (keyword[0] == 'w' ? 2 : 1), line.end(), left_out));
  }
  check_not_proven(without, "a triangle is in no cluster");

  // Two boxes as one cluster, right but for its connection.
  DecomposeRequest request;
  request.limit = {Rational(1), true};
  Decomposition made = decomposed(mesh_of_cells({{0, 0, 0}, {3, 0, 0}}), request);
  REQUIRE(made.parts.size() == 2);
  std::vector<TriangleId> all;
  for (std::size_t t = 0; t < made.surface.triangles.size(); ++t) all.emplace_back(t);
  Part& one = made.parts[0];
  one.owns = one.cluster = all;
  one.hull = convex_part(made.surface.points);
  one.concavity = ExactConcavity(made.surface, request.measure)(all, one.hull);
  one.mesh.points = PointSet(one.hull.vertices);
  made.parts.pop_back();
  std::get<Clustering>(made.origin).clusters = {all};
  const Forged apart(write_decomposition_proof(made, request));
  check_not_proven(apart, "the cluster is not connected");
  check_proven(Forged(apart).set("neighbours", 0, "neighbours unclaimed"));
}

TEST_CASE("wrong decomposition: facets and sides") {
  const Forged l(l_proof());
  const Line facet = Forged(l).line("facet");
  check_not_proven(Forged(l).set("facet", 0, "facet " + facet[1] + " " + facet[3] + " " + facet[2]),
                   "a point is beyond a facet");
  check_not_proven(Forged(l).set("facet", 0, "facet " + facet[1] + " " + facet[1] + " " + facet[2]),
                   "a facet has no normal");
  check_not_proven(Forged(l).erase("facet"), "an edge has a facet on one side only");
  check_not_proven(
      Forged(l).insert_behind("facet", 0, "facet " + facet[1] + " " + facet[2] + " " + facet[3]),
      "two facets lie on the same side of an edge");
  // The square: both of its sides are a closed surface, with no point beyond.
  const Line t = Forged(square()).line("triangle");
  const std::string front = "facet " + t[1] + " " + t[2] + " " + t[3],
                    back = "facet " + t[1] + " " + t[3] + " " + t[2];
  check_not_proven(
      Forged(square()).insert_behind("cluster", 0, front).insert_behind("cluster", 0, back),
      "the points lie in the plane of a facet");
  Forged side(square());
  side.line("side")[4] = "1";
  Forged other_side(square());
  other_side.line("side")[4] = "-1";
  const CheckerVerdict one = check_proof(side.text()), other = check_proof(other_side.text());
  CHECK(one.exit_code + other.exit_code == 2);
  check_not_proven(side, "a point is beyond a side");

  // Facets of the hull of two boxes, for the first one.
  DecomposeRequest request;
  Decomposition made = decomposed(mesh_of_cells({{0, 0, 0}, {3, 0, 0}}), request);
  std::vector<TriangleId> all;
  for (std::size_t k = 0; k < made.surface.triangles.size(); ++k) all.emplace_back(k);
  made.parts[0].owns = made.parts[0].cluster = all;
  made.parts[0].concavity =
      ExactConcavity(made.surface, request.measure)(all, convex_part(made.surface.points));
  made.parts.pop_back();
  std::get<Clustering>(made.origin).clusters = {all};
  Forged wide(write_decomposition_proof(made, request));
  Forged narrow(two_boxes());
  for (std::size_t f = 0; f < 12; ++f) narrow.line("facet", f) = wide.line("facet", f);
  check_not_proven(narrow, "a corner of no triangle");
}

TEST_CASE("wrong decomposition: the ray that shows a concavity") {
  const Forged right(roof_proof());
  check_proven(right);
  const std::string t = floor_of_roof();
  const auto with = [&](const std::string& ray) {
    return Forged(right).set("deepest", 0, "deepest " + t + " " + ray);
  };
  check_proven(with("1/4 1/2 4 0 1/2 6 1/2"));  // from (0, 0, 0), other than the proof's, perhaps
  // From (3, 0, 0) and (-3, 0, 0), beside the triangle, it is as long.
  check_not_proven(with("7/4 1/2 4 0 97/200 6 103/200"), "the ray starts outside of the triangle");
  check_not_proven(with("-5/4 1/2 4 0 103/200 6 97/200"), "the ray starts outside of the triangle");
  check_not_proven(with("1 -1/4 4 0 1/2 6 1/2"), "the ray starts outside of the triangle");
  // Backwards from (0, 0, 0); past the ridge; a weight below 0, and weights of 5/4 in all: points 2
  // and 4 are opposite to each other.
  check_not_proven(with("1/4 1/2 -4 0 1/2 6 1/2"), "the ray runs inward");
  check_not_proven(with("1/4 1/2 5 0 1/2 6 1/2"), "the ray ends elsewhere");
  check_not_proven(with("1/4 1/2 4 0 3/2 6 1/2 0 -1"), "a weight is negative");
  check_not_proven(with("1/4 1/2 4 0 1/2 6 1/2 2 1/8 4 1/8"), "the ray ends elsewhere");
  // Shorter than others.
  check_not_proven(with("1/4 1/2 3 0 3/8 6 3/8 2 1/8 4 1/8"),
                   "a ray may be longer than the concavity");
  check_not_proven(Forged(right).erase("deepest"), "a ray may be longer than the concavity");
}

TEST_CASE("wrong decomposition: rays of points and triangles elsewhere") {
  const std::set<Cell> cross = {{0, 0, 0},  {1, 0, 0}, {-1, 0, 0}, {0, 1, 0},
                                {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (const auto measure : {ConcavityMeasure::Surface, ConcavityMeasure::Vertices}) {
    const bool at_corners = measure == ConcavityMeasure::Vertices;
    const std::string proof = proof_at(mesh_of_cells(cross), "0", measure);
    const Forged right(proof);
    check_proven(right);
    // A triangle, or a point, of neither cluster.
    const Line apart = Forged(right).line("apart");
    const std::size_t a = std::stoul(apart[1]), b = std::stoul(apart[2]);
    std::size_t starts_elsewhere = 0, not_allowed = 0;
    const std::size_t items = right.count(at_corners ? "point" : "triangle");
    for (std::size_t item = 0; item < items; ++item) {
      Forged other(right);
      other.line("apart")[3] = std::to_string(item);
      const CheckerVerdict verdict = check_proof(other.text());
      const bool elsewhere = verdict.said.find("the ray starts elsewhere") != std::string::npos;
      if (!at_corners) {
        const Line first = Forged(right).line("cluster", a),
                   second = Forged(right).line("cluster", b);
        const auto holds = [&](const Line& line) {
          return std::find(line.begin() + 1, line.end(), std::to_string(item)) != line.end();
        };
        CHECK(elsewhere == (!holds(first) && !holds(second)));
      }
      starts_elsewhere += elsewhere ? 1 : 0;
    }
    CHECK(starts_elsewhere > 0);
    for (std::size_t p = 0; p < right.count("point"); ++p) {  // with weight 0
      const Forged other = Forged(right).append("apart", 0, std::to_string(p) + " 0");
      const CheckerVerdict verdict = check_proof(other.text());
      const bool refused =
          verdict.said.find("a point of the combination is not allowed") != std::string::npos;
      CHECK(refused == (verdict.exit_code != 0));
      not_allowed += refused ? 1 : 0;
    }
    CHECK(not_allowed > 0);
    CHECK(not_allowed < right.count("point"));
  }
}

TEST_CASE("wrong decomposition: bounds") {
  const Forged right(roof_proof());
  const Line combined = Forged(right).line("combined");  // i h y h y
  REQUIRE(combined.size() == 6);
  const std::string i = combined[1], g = combined[2], h = combined[4];
  const auto with = [&](const std::string& planes) {
    return Forged(right).set("combined", 0, "combined " + i + planes);
  };
  check_proven(with(" " + g + " 1/2 " + h + " 1/2"));
  check_proven(with(" " + g + " 7 " + h + " 7"));  // any positive multiple
  check_not_proven(with(" " + g + " 1/2 " + h + " 1/3"), "a ray may be longer than the concavity");
  check_not_proven(with(" " + g + " 1"), "a ray may be longer than the concavity");
  check_not_proven(with(" " + g + " 3/2 " + h + " 1/2 " + g + " -1"), "a multiplier is negative");
  check_not_proven(with(""), "the rays do not run towards the plane");
  check_not_proven(Forged(right).erase("combined"), "the concavity is not bounded everywhere");
  check_not_proven(
      Forged(right).insert_behind("combined", 0, "combined " + i + " " + g + " 1/2 " + h + " 1/2"),
      "nothing is to be bounded there");
  Forged within(right);
  within.line("within").pop_back();
  check_not_proven(within, "the concavity is not bounded everywhere");
  Forged twice(right);
  twice.line("within").push_back(twice.line("within").back());
  check_not_proven(twice, "nothing is to be bounded there");
  // The planes of the roof's bottom look away.
  std::size_t away = 0;
  for (std::size_t plane = 0; plane < right.count("facet"); ++plane) {
    const CheckerVerdict verdict = check_proof(with(" " + std::to_string(plane) + " 1").text());
    CHECK(verdict.exit_code == 1);
    away += verdict.said.find("do not run towards the plane") != std::string::npos ? 1 : 0;
  }
  CHECK(away == right.count("facet") - 2);
  // Of a single triangle the opposite side of its plane does not bound the rays.
  const Mesh single = {
      PointSet(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), {{0, 1, 2}}, {{"", 0, 1}}};
  for (const auto measure : {ConcavityMeasure::Surface, ConcavityMeasure::Vertices}) {
    Forged flat(proof_at(single, "0", measure));
    check_proven(flat);
    Line& line = flat.line("within");
    const std::string plane = line[1];
    std::size_t refused = 0;
    for (std::size_t side = 0; side < flat.count("side"); ++side) {
      line[1] = std::to_string(side);
      if (side == std::stoul(plane)) continue;
      check_not_proven(flat, "the rays do not run towards the plane");
      ++refused;
    }
    CHECK(refused == 4);
  }
}

TEST_CASE("wrong decomposition: owners") {
  const Forged two(two_boxes());
  const Line first = Forged(two).line("owns", 0), second = Forged(two).line("owns", 1);
  check_not_proven(Forged(two).append("owns", 1, first[1]), "a triangle has an owner already");
  Forged less(two);
  less.line("owns", 0).pop_back();
  check_not_proven(less, "it does not own its cluster");
  // The second box without a part.
  Forged alone(two);
  alone.erase("part", 1).erase("owns", 1);
  check_not_proven(alone, "a triangle has no owner");
  for (std::size_t k = 1; k < second.size(); ++k) alone.append("owns", 0, second[k]);
  check_not_proven(alone, "a triangle reaches out of its owner");
  check_not_proven(Forged(two).set("part", 1, "part hull 0"), "the cluster has a part already");
  check_not_proven(
      Forged(square()).set("part", 0, "part hull 0").erase_all("corner").erase_all("between"),
      "the cluster has no facets");
}

TEST_CASE("wrong decomposition: stored corners, by one unit of the last digit") {
  const Mesh tetrahedron = {
      PointSet(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}),
      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
      {{"", 0, 4}}};
  const Forged hull(proof_at(tetrahedron, "0"));
  check_proven(hull);
  const auto stored = [&](const char* top, const std::string& facets) {
    Forged proof(hull);
    proof.set("part", 0, "part stored 0");
    const std::string corners[] = {"0 0 0", std::string("0 0 ") + top, "0 1 0", "1 0 0"};
    for (std::size_t k = 4; k-- > 0;) proof.insert_behind("part", 0, "corner " + corners[k]);
    const ProofText lines(facets);
    for (std::size_t k = lines.lines.size(); k-- > 0;) {
      std::string line;
      for (const std::string& word : lines.lines[k]) line += word + " ";
      proof.insert_behind("corner", 3, line);
    }
    return proof;
  };
  const std::string facets = "facet 0 2 3\nfacet 0 3 1\nfacet 3 2 1\nfacet 2 0 1\n";
  check_proven(stored("0x1p+0", facets));
  check_proven(stored("0x1.0000000000001p+0", facets));
  check_not_proven(stored("0x1.fffffffffffffp-1", facets), "a triangle reaches out of its owner");
  check_not_proven(stored("0x1p+0", ""), "there are no facets");
  check_not_proven(stored("0x1p+0", "facet 0 2 3\nfacet 0 3 1\nfacet 3 2 1\n"),
                   "an edge has a facet on one side only");
  check_not_proven(stored("0x1p+0", "facet 0 3 2\nfacet 0 1 3\nfacet 3 1 2\nfacet 2 1 0\n"),
                   "a point is beyond a facet");
}

TEST_CASE("wrong decomposition: flat parts") {
  const Forged right(square());
  check_proven(right);
  const Line between = Forged(right).line("between");
  check_not_proven(Forged(right).erase("between"), "a triangle reaches out of its owner");
  const std::string p = between[1];
  const auto with = [&](const std::string& weights) {
    return Forged(right).set("between", 0, "between " + p + " " + weights);
  };
  check_proven(with("0 1/4 1 1/4 2 1/4 3 1/4"));
  check_not_proven(with("0 1/4 1 1/4 2 1/4 3 1/8"), "the combination is another point");
  check_not_proven(with("0 1/4 1 1/4 2 1/4 3 1/2 0 -1/4"), "a weight is negative");
  Forged moved(right);  // no corner holds the first corner of the square any more
  moved.line("corner", 0) = words_of("corner 0x1p-1074 0 0");
  const CheckerVerdict verdict = check_proof(moved.text());
  CHECK(verdict.exit_code == 1);
}

TEST_CASE("wrong decomposition: pairs of neighbours") {
  const Forged right(l_proof());
  check_not_proven(Forged(right).erase("apart"), "two neighbours may be within the limit together");
  const Line apart = Forged(right).line("apart");
  std::string again = "apart";
  for (std::size_t k = 1; k < apart.size(); ++k) again += " " + apart[k];
  check_not_proven(Forged(right).insert_behind("apart", 0, again),
                   "no neighbours, or they are apart already");
  Forged swapped(right);
  std::swap(swapped.line("apart")[1], swapped.line("apart")[2]);
  check_not_proven(swapped, "no neighbours, or they are apart already");
  Forged unclaimed(right);
  unclaimed.set("neighbours", 0, "neighbours unclaimed");
  check_not_proven(unclaimed, "no neighbours, or they are apart already");
  check_proven(unclaimed.erase("apart"));
  // Directions are of length 1, so the ray is as long as its line says. A limit of as much is not
  // exceeded.
  Forged equal(right);
  equal.set("limit", 0, "limit length " + apart[6]);
  const CheckerVerdict verdict = check_proof(equal.text());
  CHECK_MESSAGE(verdict.said.find("the ray is within the limit") != std::string::npos,
                verdict.said);
}

TEST_CASE("wrong decomposition: every line and every truncation") {
  for (const std::string& proof : {l_proof(), roof_proof(), square()}) {
    const ProofText text(proof);
    for (std::size_t l = 0; l < text.lines.size(); ++l) {
      CAPTURE(l);
      ProofText without(proof), twice(proof), cut(proof);
      without.lines.erase(without.lines.begin() + std::ptrdiff_t(l));
      twice.lines.insert(twice.lines.begin() + std::ptrdiff_t(l), twice.lines[l]);
      cut.lines.resize(l);
      CHECK(check_proof(without.text()).exit_code != 0);  // the last line counts
      CHECK(check_proof(twice.text()).exit_code != 0);
      CHECK(check_proof(cut.text()).exit_code != 0);
      // Counted right, what is left out or repeated matters, but for a side that no bound names.
      const std::string& keyword = text.lines[l][0];
      if (l + 1 == text.lines.size() || keyword == "side") continue;
      CHECK(check_proof(without.text(true)).exit_code != 0);
      CHECK(check_proof(twice.text(true)).exit_code !=
            (keyword == "corner" || keyword == "between" ? 3 : 0));
    }
    CHECK(check_proof(proof + "1").exit_code == 3);
    CHECK(check_proof(proof + "\n").exit_code == 0);
  }
}

TEST_CASE("wrong decomposition: malformed") {
  const Forged right(l_proof());
  const std::pair<const char*, const char*> changes[] = {
      {"convexact-proof", "convexact-proof 4 greedy"},
      {"convexact-proof", "convexact-proof 5 decomposition"},
      {"convexact-proof", "convexact-proof 4"},
      {"measure", "measure bridge"},
      {"measure", "measure"},
      {"limit", "limit share -1/100"},
      {"limit", "limit 3"},
      {"neighbours", "neighbours all"},
      {"point", "point 0 0"},
      {"triangle", "triangle 0 1 2"},
      {"triangle", "triangle 0 1 99 0"},
      {"cluster", "cluster"},
      {"cluster", "cluster 999"},
      {"facet", "facet 0 1 99"},
      {"within", "within 99 0"},
      {"within", "within 0 99"},
      {"part", "part hull 9"},
      {"part", "part round 0"},
      {"owns", "owns 99"},
      {"apart", "apart 0 9 0 0 0 0"},
  };
  for (const auto& change : changes) {
    const std::string line = change.second;
    CAPTURE(line);
    CHECK(check_proof(Forged(right).set(change.first, 0, line).text()).exit_code == 3);
  }
  for (const char* const keyword : {"measure", "limit", "neighbours", "owns"}) {
    CAPTURE(keyword);
    Forged without(right);
    Line& line = without.line(keyword);
    line.erase(line.begin());
    CHECK(check_proof(without.text()).exit_code == 3);
  }
}

TEST_CASE("wrong decomposition: how deep points lie") {
  DecomposeRequest request;
  request.method = DecomposeMethod::Acd;
  request.max_parts = 1;
  const Forged dented(proof_of_parts(dented_cube(), request));
  check_proven(dented);
  const std::string why = "its points lie deeper, or less deep";
  check_not_proven(Forged(dented).set("depth", 0, "depth 4"), why);
  check_not_proven(Forged(dented).set("depth", 0, "depth 99/100"), why);
  check_not_proven(Forged(dented).erase("depth"), why);
  // There are no pairs.
  check_not_proven(Forged(dented).insert_behind("owns", 0, "apart 0 0 0 0 0 0 0 1"),
                   "no neighbours");
  // Rays are of the other measures.
  CHECK(check_proof(Forged(dented).set("depth", 0, "deepest 0 0 0 0 0 1").text()).exit_code != 0);
  CHECK(check_proof(Forged(dented).set("measure", 0, "measure surface").text()).exit_code != 0);
}
