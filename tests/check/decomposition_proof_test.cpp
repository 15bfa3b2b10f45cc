// SPDX-License-Identifier: MIT
// convexact-check accepts the proofs of decompositions, and says what they prove. Figures are
// closed forms, derived beside them.
#include <algorithm>
#include <sstream>

#include "checker.hpp"
#include "convexact/error.hpp"
#include "convexact/hull.hpp"
#include "convexact/io.hpp"
#include "decompositions.hpp"
#include "number/random.hpp"
#include "process.hpp"
#include "proof_text.hpp"
#include "shapes/makers.hpp"
#include "sweep.hpp"

using namespace convexact;
using support::box_mesh;
using support::Cell;
using support::mesh_of_cells;

namespace {

constexpr ConcavityMeasure kMeasures[] = {ConcavityMeasure::Surface, ConcavityMeasure::Vertices};

DecomposeRequest request_of(const Rational& share,
                            ConcavityMeasure measure = ConcavityMeasure::Surface) {
  DecomposeRequest request;
  request.limit = {share, true};
  request.measure = measure;
  return request;
}

// What is proven of the decomposition.
std::string said_of(const Mesh& mesh, const DecomposeRequest& request) {
  const std::string proof = proof_of_parts(mesh, request);
  CHECK(proof.starts_with("convexact-proof 4 decomposition\n"));
  const CheckerVerdict verdict = check_proof(proof);
  CHECK_MESSAGE(verdict.exit_code == 0, verdict.said);
  return verdict.said;
}

void check_says(const std::string& said, const std::string& part) {
  CHECK_MESSAGE(said.find(part) != std::string::npos, said);
}

const std::set<Cell> kBox = {{0, 0, 0}, {1, 0, 0}};
const std::set<Cell> kL = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
const std::set<Cell> kCross = {{0, 0, 0},  {1, 0, 0}, {-1, 0, 0}, {0, 1, 0},
                               {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
const std::set<Cell> kTwo = {{0, 0, 0}, {3, 0, 0}};

Mesh hull_of(const std::vector<Point>& corners) {
  const PointSet points(corners);
  const Polytope solid = to_polytope(std::get<Hull>(convex_hull(points)), points);
  return {PointSet(solid.vertices), solid.facets, {{"", 0, solid.facets.size()}}};
}

}  // namespace

TEST_CASE("decomposition proof: closed forms") {
  for (const ConcavityMeasure measure : kMeasures) {
    const std::string box = said_of(mesh_of_cells(kBox), request_of(0, measure));
    check_says(box, "each of 20 triangles is in one of 1 clusters, connected over edges\n");
    check_says(box, "1 of them within the limit of 0 of the diameter\n");
    check_says(box, "each of 0 pairs of neighbours is beyond it, as one cluster\n");
    check_says(box, "one of 1 convex parts, 1 of them exactly hulls of clusters\n");
    const std::string two = said_of(mesh_of_cells(kTwo), request_of(Rational(1, 2), measure));
    check_says(two, "in one of 2 clusters");
    check_says(two, "each of 0 pairs");
  }
  // Two boxes make an L; the arms of the cross are six.
  const std::string l = said_of(mesh_of_cells(kL), request_of(0));
  check_says(l, "in one of 2 clusters");
  check_says(l, "at all of its points, 2 of them within the limit of 0 of the diameter");
  check_says(l, "each of 1 pairs of neighbours is beyond it");
  check_says(said_of(mesh_of_cells(kCross), request_of(0)), "one of 6 convex parts, 6 of them");
  // All corners of the L lie on its hull.
  const std::string corners = said_of(mesh_of_cells(kL), request_of(0, ConcavityMeasure::Vertices));
  check_says(corners, "in one of 1 clusters");
  check_says(corners, "at its corners, 1 of them within the limit of 0 of the diameter");
}

TEST_CASE("decomposition proof: a concavity that no single plane bounds") {
  DecomposeRequest request;
  request.limit = {Rational(4), false};
  request.orient = Orient::Keep;
  const std::string proof = proof_of_parts(hip_roof(), request);
  const ProofText text(proof);
  REQUIRE(text.all("deepest").size() == 1);
  // The direction is (0, 0, 1), the length 4.
  CHECK(text.lines[text.all("deepest")[0]][4] == "4");
  CHECK(text.all("combined").size() == 1);
  const CheckerVerdict verdict = check_proof(proof);
  CHECK(verdict.exit_code == 0);
  check_says(verdict.said, "1 of them within the limit of 4\n");
  // Below 4, the roof is not one cluster.
  request.limit.value = Rational(399, 100);
  const std::string less = said_of(hip_roof(), request);
  CHECK(less.find("in one of 1 clusters") == std::string::npos);
  // As one part all the same: its cluster is beyond the limit, and that is said.
  request.max_parts = 1;
  check_says(said_of(hip_roof(), request), "0 of them within the limit of 399/100\n");
}

TEST_CASE("decomposition proof: parts that are no hulls of their clusters") {
  DecomposeRequest request = request_of(0);
  request.faces = 6;
  check_says(said_of(hull_of(shapes::cut_cube(4, 0.25)), request),
             "one of 1 convex parts, 0 of them exactly hulls");
  request.faces = {};
  request.precision = Precision::Binary32;
  const Mesh third = box_mesh({{0, 0, 0}, {1.0 / 3, 1, 1}});  // no binary32
  check_says(said_of(third, request), "one of 1 convex parts, 0 of them exactly hulls");
  // Decimals as spelt: the hull has fractions.
  Mesh tenth = mesh_of_cells(kBox);
  std::vector<RationalPoint> points;
  for (std::size_t p = 0; p < tenth.points.size(); ++p) {
    points.push_back(tenth.points[PointId(p)] / Rational(10));
  }
  tenth.points = PointSet(points);
  check_says(said_of(tenth, request_of(0)), "one of 1 convex parts, 0 of them exactly hulls");
}

TEST_CASE("decomposition proof: flat clusters") {
  // A square of four triangles about its middle.
  const Mesh square = {
      PointSet(std::vector<Point>{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}}),
      {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}},
      {{"", 0, 4}}};
  for (const ConcavityMeasure measure : kMeasures) {
    DecomposeRequest request = request_of(Rational(1, 100), measure);
    request.flat = FlatParts::Thicken;
    const std::string thick = proof_of_parts(square, request);
    CHECK(thick.find("\npart stored 0\n") != std::string::npos);
    CHECK(check_proof(thick).exit_code == 0);
    request.flat = FlatParts::Keep;
    const std::string flat = proof_of_parts(square, request);
    CHECK(flat.find("\npart flat 0\n") != std::string::npos);
    CHECK(ProofText(flat).all("between").size() == 1);  // the middle
    const CheckerVerdict verdict = check_proof(flat);
    CHECK_MESSAGE(verdict.exit_code == 0, verdict.said);
    check_says(verdict.said, "one of 1 convex parts, 0 of them exactly hulls");
  }
  // A flap on a box: it is kept, or joins the box.
  Mesh flap = mesh_of_cells({{0, 0, 0}});
  std::vector<Point> points(flap.points.doubles().begin(), flap.points.doubles().end());
  const auto index = [&](const Point& p) {
    return std::uint32_t(std::find(points.begin(), points.end(), p) - points.begin());
  };
  const std::uint32_t a = index({1, 1, 1}), b = index({1, 0, 1});
  points.push_back({1, 0.5, 5});
  flap.points = PointSet(points);
  flap.polygons.push_back({a, b, std::uint32_t(points.size() - 1)});
  for (const FlatParts flat : {FlatParts::Thicken, FlatParts::Keep, FlatParts::Merge}) {
    DecomposeRequest request = request_of(0);
    request.flat = flat;
    said_of(flap, request);
  }
}

TEST_CASE("decomposition proof: neighbours that are not found over edges are not claimed") {
  DecomposeRequest request = request_of(0);
  request.connect = Connect::Touching;
  const std::string said = said_of(mesh_of_cells(kL), request);
  CHECK(said.find("connected over edges") == std::string::npos);
  check_says(said,
             "not claimed: that clusters are connected, or that neighbours are beyond it, as one "
             "cluster\n");
}

TEST_CASE("decomposition proof: clusters that come from splitting") {
  DecomposeRequest request = request_of(Rational(3, 100));
  request.method = DecomposeMethod::Acd;
  request.max_parts = 1;
  std::string said = said_of(dented_cube(), request);
  check_says(said, "each of 14 triangles is in one of 1 clusters, connected over edges\n");
  check_says(said, "1 clusters deeper than the limit of 3/100 of the diameter\n");
  check_says(said, "not claimed: concavities to bridges, which are at least as large\n");
  CHECK(proof_of_parts(dented_cube(), request).find("\ndepth 1\n") != std::string::npos);
  request.max_parts.reset();
  for (const auto& cells : {kBox, kL, kCross, kTwo}) {
    for (const Connect connect : {Connect::Edge, Connect::Touching}) {
      request.connect = connect;
      said = said_of(mesh_of_cells(cells), request);
      check_says(said, connect == Connect::Edge ? "connected over edges" : "that clusters are");
    }
  }
  // Flat clusters as they are, thickened, and within another one that they joined.
  request = request_of(0);
  request.method = DecomposeMethod::Acd;
  for (const FlatParts flat : {FlatParts::Keep, FlatParts::Thicken, FlatParts::Merge}) {
    request.flat = flat;
    said_of(mesh_of_cells(kCross), request);
  }
}

TEST_CASE("decomposition proof: random unions of cells, at every limit" * sweep) {
  Random random(7);
  for (int round = 0; round < 60; ++round) {
    CAPTURE(round);
    std::set<Cell> cells{{0, 0, 0}};
    for (std::size_t count = 1 + uniform_below(random, 7); count > 0; --count) {
      cells.insert({int(uniform_below(random, 3)), int(uniform_below(random, 3)),
                    int(uniform_below(random, 2))});
    }
    DecomposeRequest request =
        request_of(Rational(uniform_below(random, 5), 10), kMeasures[round % 2]);
    request.engine = std::array{Engine::Exact, Engine::Filtered, Engine::Float}[round % 3];
    if (round % 5 == 0) request.faces = 4 + uniform_below(random, 4);
    if (round % 7 == 0) request.keep_inner = true;
    said_of(mesh_of_cells(cells), request);
  }
}

// ---- The mesh

TEST_CASE("decomposition proof: the faces of a mesh file") {
  const support::ScratchFolder scratch;
  const std::string points =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n";
  const std::string sides = "f 1 5 7 3\nf 2 4 8 6\nf 1 2 6 5\nf 3 7 8 4\nf 1 3 4 2\n",
                    top = "f 5 6 8 7\n";
  const std::string mesh = scratch.write("box.obj", points + sides + top);
  const std::string proof = proof_of_parts(read_mesh(mesh), request_of(0));
  const auto verdict_on = [&](const std::string& name, const std::string& bytes) {
    return check_proof(proof, scratch.write(name, bytes));
  };
  const auto refused = [&](const std::string& bytes) {
    const CheckerVerdict verdict = verdict_on("other.obj", bytes);
    CHECK(verdict.exit_code == 1);
    return verdict.said;
  };
  check_says(check_proof(proof, mesh).said,
             "proven: the faces are those of " + mesh +
                 ", 0 of them turned, decimals as the nearest doubles");
  // Unused and repeated points, corners counted back, and slashes.
  CHECK(verdict_on("a.obj", "v 9 9 9\nv 1 1 1\n" + points +
                                "f 3 7 9 5\nf 4 6/1 10/1/1 8//1\nf 3 4 8 7\nf 5 9 2 6\n"
                                "f 3 5 6 4\nf -4 -3 -1 -2\n")
            .exit_code == 0);
  const std::string lines =
      "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n4 0 4 6 2\n4 1 3 7 5\n4 0 1 5 4\n"
      "4 2 6 7 3\n4 0 2 3 1\n4 4 5 7 6\n";
  CHECK(verdict_on("a.off", "OFF\n8 6 0\n" + lines).exit_code == 0);
  CHECK(verdict_on("a.off", "OFF 8 5 0\n" + lines).exit_code == 1);
  CHECK(verdict_on("a.off", "OFF 8 7 0\n" + lines).exit_code == 3);
  for (const std::string counts : {"8", "8 x 0", "8 -6 0"}) {
    CAPTURE(counts);
    const CheckerVerdict verdict = verdict_on("a.off", "OFF\n" + counts + "\n" + lines);
    CHECK(verdict.exit_code == 3);
    check_says(verdict.said, "the number of faces");
  }
  for (const std::string last :
       {"x 4 5 7 6", "-4 4 5 7 6", "5 4 5 7 6", "4 4 5 x 6", "4 4 5 -7 6"}) {
    CAPTURE(last);
    const std::string all = lines.substr(0, lines.size() - 10) + last + "\n";
    CHECK(verdict_on("a.off", "OFF\n8 6 0\n" + all).exit_code == 3);
  }
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float "
      "z\nelement face 6\nproperty list uchar int vertex_indices\nend_header\n";
  CHECK(verdict_on("a.ply", header + lines).exit_code == 0);
  // Instead of 7, 7/2 and 2^64 + 7, among others.
  for (const std::string last :
       {"-4 4 5 7 6", "4.5 4 5 7 6", "x 4 5 7 6", "4 4 5 -7 6", "4 4 5 7.5 6", "4 4 5 x 6",
        "4 4 5 3.5 6", "4 4 5 18446744073709551623 6", "4 4 5 7 6 1", "4 4 5 7"}) {
    CAPTURE(last);
    const std::string all = lines.substr(0, lines.size() - 10) + last + "\n";
    CHECK(verdict_on("a.ply", header + all).exit_code == 3);
  }
  CHECK(verdict_on("a.xyz", "0 0 0\n").exit_code == 1);
  CHECK(verdict_on("a.txt", "1 0 0 -1\n").exit_code == 1);
  // Faces of one and two corners bound nothing, and the program skips them, too.
  CHECK(verdict_on("a.obj", points + "f 1 2\n" + sides + top + "f 3\n").exit_code == 0);
  // A face turned, a face less, more, moved, repeated, or cut.
  check_says(verdict_on("a.obj", points + sides + "f 7 8 6 5\n").said, " 1 of them turned,");
  check_says(refused(points + sides), "it has fewer faces than the proof");
  check_says(refused(points + sides + top + "f 1 2 3\n"), "its face 7 is not the one of the proof");
  check_says(refused(points + sides + "f 5 6 8\n"), "its face 6 is not the one of the proof");
  check_says(refused(points + sides + "f 5 6 7 8\n"), "its face 6 is not the one of the proof");
  check_says(refused(points + top + sides), "its face 1 is not the one of the proof");
  check_says(refused(points + "v 0 0 1.5\n" + sides + "f 9 6 8 7\n"),
             "its face 6 has a corner that is not in the proof");
  CHECK(verdict_on("a.obj", points + sides + "f 5 6 9\n").exit_code == 3);
  CHECK(verdict_on("a.obj", points + sides + "f 5 6 0\n").exit_code == 3);
  CHECK(verdict_on("a.obj", points + sides + "f 5 6 x\n").exit_code == 3);
}

// Each of these proofs is right about its triangles, which are not those of the cube: of its first
// face one is flipped, or there are two more that cancel.
TEST_CASE("decomposition proof: triangles of a face that are flipped, or that cancel") {
  const support::ScratchFolder scratch;
  const std::string cube =
      scratch.write("cube.obj",
                    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
                    "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n");
  const std::string before =
      "convexact-proof 4 decomposition\nmeasure surface\nlimit share 3/100\nneighbours edges\n"
      "point 0 0 0\npoint 0 0 1\npoint 0 1 0\npoint 0 1 1\npoint 1 0 0\npoint 1 0 1\n"
      "point 1 1 0\npoint 1 1 1\ntriangle 0 1 2 4\ntriangle 0 4 1 2\n";
  const std::string between =
      "triangle 1 3 2 4\ntriangle 1 5 3 1\ntriangle 1 4 5 2\ntriangle 2 3 6 3\n"
      "triangle 2 6 4 0\ntriangle 3 5 7 1\ntriangle 3 7 6 3\ntriangle 4 6 5 5\n"
      "triangle 5 6 7 5\n";
  const std::string hull =
      "facet 0 1 3\nfacet 0 3 2\nfacet 0 2 6\nfacet 0 6 4\nfacet 0 4 5\nfacet 0 5 1\n"
      "facet 1 5 7\nfacet 1 7 3\nfacet 2 3 7\nfacet 2 7 6\nfacet 4 6 7\nfacet 4 7 5\n"
      "within 0 0 3\nwithin 4 1 5\nwithin 6 4 8\nwithin 8 6 9\nwithin 10 10 11\npart hull 1\n";
  const auto proof = [&](const std::string& third, const std::string& more,
                         const std::string& clusters, const std::string& owned) {
    const std::string body = before + third + between + more + clusters + hull + owned;
    return body + "end " + std::to_string(std::ranges::count(body, '\n') + 1) + "\n";
  };
  const std::string of_rest = "cluster 0 1 3 4 5 6 8 9 10 11\n",
                    sides = "side 0 0 -1 0\nside 0 0 1 0\n";
  // With the one half of a side flipped, that side is a cluster of its own.
  const std::string flipped = proof("triangle 0 4 2 0\n", "",
                                    "cluster 2 7\n" + sides + "within 0 7\nwithin 1 2\n" + of_rest,
                                    "owns 0 1 2 3 4 5 6 7 8 9 10 11\napart 0 1 2 0 0 1 1 1\n");
  const CheckerVerdict turned = check_proof(flipped, cube);
  CHECK_MESSAGE(turned.exit_code == 0, turned.said);
  check_says(turned.said, "1 of them turned,");
  const std::string cancelling =
      proof("triangle 0 2 4 0\n", "triangle 0 4 2 0\ntriangle 0 2 4 0\n",
            "cluster 2 7 12 13\n" + sides + "within 0 2 7 13\nwithin 1 12\n" + of_rest,
            "owns 0 1 2 3 4 5 6 7 8 9 10 11 12 13\napart 0 1 12 0 0 1 1 1\n");
  CHECK(check_proof(cancelling).exit_code == 0);
  check_says(check_proof(cancelling, cube).said, "its face 1 is not the one of the proof");
  // The last two as those of a face that goes back and forth, so that its edges cancel, too: only
  // its corners are not theirs.
  std::string elsewhere = cancelling;
  const std::size_t last = elsewhere.find("triangle 0 4 2 0\ntriangle 0 2 4 0\n");
  elsewhere.replace(last, 34, "triangle 0 4 2 6\ntriangle 0 2 4 6\n");
  const std::string there_and_back =
      scratch.write("back.obj", support::bytes_of(cube) + "f 5 7 5 6\n");
  CHECK(check_proof(elsewhere).exit_code == 0);
  check_says(check_proof(elsewhere, there_and_back).said, "its face 7 is not the one of the proof");
}

TEST_CASE("decomposition proof: triangles of STL, and decimals as spelt") {
  const support::ScratchFolder scratch;
  const std::string points = "v 0.1 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n",
                    faces = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  const std::string mesh = scratch.write("t.obj", points + faces);
  const std::string spelt =
      proof_of_parts(read_mesh(mesh, {.decimal = Decimal::Exact}), request_of(0));
  check_says(check_proof(spelt, mesh).said, "decimals as spelt\n");
  const std::string nearest = proof_of_parts(read_mesh(mesh), request_of(0));
  const char* const corners[] = {"0.1 0 0", "1 0 0", "0 1 0", "0 0 1"};
  std::ostringstream stl;
  stl << "solid\n";
  for (const auto& t :
       std::vector<std::array<int, 3>>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
    stl << "facet normal 0 0 0\nouter loop\n";
    for (const int p : t) stl << "vertex " << corners[p] << "\n";
    stl << "endloop\nendfacet\n";
  }
  stl << "endsolid\n";
  const std::string path = scratch.write("t.stl", stl.str());
  check_says(check_proof(nearest, path).said, "proven: the faces are those of " + path);
}

TEST_CASE("decomposition proof: spot, by both measures" * sweep) {
  const std::string path = support::data("spot.obj");
  for (const ConcavityMeasure measure : kMeasures) {
    const std::string proof =
        proof_of_parts(read_mesh(path), request_of(Rational(3, 100), measure));
    const CheckerVerdict verdict = check_proof(proof, path);
    CHECK_MESSAGE(verdict.exit_code == 0, verdict.said);
    check_says(verdict.said, "each of 5856 triangles is in one of ");
    check_says(verdict.said, "0 of them turned, decimals as the nearest doubles");
  }
}
