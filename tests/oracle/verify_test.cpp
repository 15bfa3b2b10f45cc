// SPDX-License-Identifier: MIT
// The oracle on candidates small enough to be judged by hand. Expected values are closed forms: the
// input is the cube [-1, 1]^3, of squared diameter 12, volume 8, area 24 and mean width 3.
#include "convexact/verify.hpp"

#include <doctest/doctest.h>

#include "expect_error.hpp"
#include "oracle/solid/excess.hpp"
#include "oracle/solid/second_way.hpp"
#include "polytope_by_definition.hpp"
#include "shapes/makers.hpp"

using namespace convexact;
using enum ClaimCode;

namespace {

const std::string kQuads = "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n";

// [-a, a]^3 with z varying fastest: point 1 is (-a, -a, -a), point 8 is (a, a, a).
std::string corners(const std::string& a) {
  std::string text;
  for (const char* x : {"-", ""}) {
    for (const char* y : {"-", ""}) {
      for (const char* z : {"-", ""}) text += "v " + (x + a) + " " + (y + a) + " " + (z + a) + "\n";
    }
  }
  return text;
}

Verdict judge(const std::string& bytes, const std::string& name, VerifyRequest request = {},
              Decimal decimal = Decimal::Nearest) {
  const Candidate candidate = read_candidate_bytes(bytes, name, decimal);
  return std::get<Verdict>(verify(PointSet(shapes::cube()), candidate, request));
}

Verdict judge_obj(const std::string& bytes, VerifyRequest request = {}) {
  return judge(bytes, "c.obj", std::move(request));
}

bool is_only_violation(const Verdict& verdict, ClaimCode code) {
  return std::all_of(verdict.claims.begin(), verdict.claims.end(), [&](const Claim& claim) {
    return (claim.status == Status::Violated) == (claim.code == code);
  });
}

}  // namespace

TEST_CASE("verify: the input's own hull passes, and nothing is left between them") {
  const Verdict verdict = judge_obj(
      corners("1") + kQuads, {{.max_facets = 6, .max_vertices = 8, .max_facet_vertices = 4}});
  for (const Claim& claim : verdict.claims) {
    CAPTURE(name_of(claim.code));
    CHECK(claim.status == Status::Holds);
  }
  CHECK(verdict.holds());
  CHECK(verdict.squared_diameter == 12);
  CHECK(verdict.outside->tested == 8);
  CHECK(verdict.size.planes_of_the_input->size() == 6);
  CHECK(verdict.tightness->squared_hausdorff == 0);
  for (const Enclosure& ratio : {verdict.tightness->volume_ratio, verdict.tightness->area_ratio,
                                 verdict.tightness->mean_width_ratio}) {
    CHECK(ratio.low() == 1);
    CHECK(ratio.high() == 1);
  }
}

TEST_CASE("verify: a solid with as many facets and corners as the hull, larger by one bit") {
  // All corners of the cube, times 1 + 2^-52.
  const Verdict verdict = judge_obj(corners("1.0000000000000002220446049250313") + kQuads);
  const Rational grown = 1 + Rational(1, Integer(1) << 52);
  CHECK(verdict.holds());
  CHECK(verdict.tightness->squared_hausdorff == 3 * (grown - 1) * (grown - 1));
  CHECK(verdict.tightness->volume_ratio.contains(grown * grown * grown));
  CHECK(verdict.tightness->area_ratio.contains(grown * grown));
  CHECK(verdict.tightness->mean_width_ratio.contains(grown));
  CHECK(verdict.tightness->volume_ratio.low() > 1);
}

TEST_CASE("verify: twice the cube, in numbers") {
  const Verdict verdict = judge_obj(corners("2") + kQuads);
  CHECK(verdict.holds());
  CHECK(verdict.size.planes_of_the_input->empty());
  CHECK(verdict.tightness->squared_hausdorff == 3);  // from (2, 2, 2) to (1, 1, 1)
  CHECK(verdict.tightness->volume_ratio.contains(8));
  CHECK(verdict.tightness->area_ratio.contains(4));
  CHECK(verdict.tightness->mean_width_ratio.contains(2));
}

TEST_CASE("verify: a face pushed in by 2^-54 is found, with the exact distance") {
  // The plane x <= 1 - 2^-54 does not exist in doubles, x <= 1 - 2^-53 does.
  const std::string rows =
      "1 0 0 -0.99999999999999988897769753748\n-1 0 0 -1\n0 1 0 -1\n0 -1 0 -1\n0 0 1 -1\n0 0 -1 "
      "-1\n";
  const Verdict verdict = judge(rows, "c.txt");
  CHECK(is_only_violation(verdict, ContainsInput));
  CHECK(verdict.outside->points == 4);
  const Witness& w = verdict[ContainsInput].witness;
  CHECK(w.squared_distance == to_rational(0x1p-106));
  CHECK(w.rows == std::vector<std::size_t>{0});
  CHECK(w.point->x() == 1);
  CHECK(verdict.outside->relative_squared_distance == to_rational(0x1p-106) / 12);
}

TEST_CASE("verify: a tolerance lets the violation pass and still tells it") {
  const std::string rows = "1 0 0 -0.75\n-1 0 0 -1\n0 1 0 -1\n0 -1 0 -1\n0 0 1 -1\n0 0 -1 -1\n";
  const auto with = [&](const char* tolerance) {
    VerifyRequest request;
    request.tolerance = parse_tolerance(tolerance);
    return judge(rows, "c.txt", request)[ContainsInput];
  };
  CHECK(with("0.25").status == Status::Holds);
  CHECK(with("0.25").witness.squared_distance == Rational(1, 16));
  CHECK(with("0.25").sentence.starts_with("within the tolerance of 0.25: 4 points outside"));
  CHECK(with("0.2499999999999999999999999").status == Status::Violated);
  // The diameter is sqrt(12) = 3.4641..., and 0.25 / sqrt(12) = 0.072168...
  CHECK(with("0.07217d").status == Status::Holds);
  CHECK(with("0.07216d").status == Status::Violated);
}

// The planes z <= 1e-6 x and z >= -1e-6 x with 0 <= x <= 1 meet in a sharp edge at x = 0. The point
// (-1/2, 0, 0) is 5e-7 beyond each of these two, and 1/2 away from the solid.
TEST_CASE("verify: a tolerance bounds the distance to the solid, not to a plane (#13)") {
  const std::string rows =
      "-1000000 0 1000000000000 0\n-1000000 0 -1000000000000 0\n1 0 0 -1\n0 1 0 -1\n0 -1 0 -1\n";
  const std::string mesh =
      "v 0 -1 0\nv 0 1 0\nv 1 -1 1e-6\nv 1 1 1e-6\nv 1 -1 -1e-6\nv 1 1 -1e-6\n";
  const std::vector<Point> input{{-0.5, 0, 0}, {0.25, 0.5, 0}, {0.5, -0.5, 0}, {0.5, 0, 1e-7}};
  for (const auto& [bytes, name] : {std::pair(rows, "c.txt"), std::pair(mesh, "c.obj")}) {
    for (const bool all : {true, false}) {
      const auto with = [&, &bytes = bytes, &name = name](const char* tolerance) {
        VerifyRequest request;
        request.tolerance = parse_tolerance(tolerance);
        if (!all) request.claims = {ContainsInput};
        request.tightness = all;
        const Candidate candidate = read_candidate_bytes(bytes, name);
        return std::get<Verdict>(verify(PointSet(input), candidate, request));
      };
      const Verdict verdict = with("1e-6");
      const Claim& claim = verdict[ContainsInput];
      CHECK(claim.status == Status::Violated);
      CHECK(claim.witness.input_point == 0);
      CHECK(claim.witness.nearest == RationalPoint(0, 0, 0));
      CHECK(claim.witness.squared_distance == Rational(1, 4));
      CHECK(claim.sentence.find("point 0 is worst, 0.5 (") != std::string::npos);
      CHECK(verdict.outside->relative_squared_distance ==
            Rational(1, 4) / verdict.squared_diameter);
      CHECK(with("0.5")[ContainsInput].status == Status::Holds);
      CHECK(with("0.4999999999999999999")[ContainsInput].status == Status::Violated);
    }
  }
}

TEST_CASE("verify: without a bounded solid no tolerance lets a point outside pass (#13)") {
  VerifyRequest request;
  request.tolerance = parse_tolerance("1e9");
  const std::string corner = "-1 0 0 0\n0 -1 0 0\n0 0 -1 0\n";  // x, y, z >= 0
  const std::string plate = "v -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\nf 1 2 3 4\n";
  for (const auto& file : {std::pair(corner, "c.txt"), std::pair(plate, "c.obj"),
                           std::pair(std::string("0 0 0 1\n"), "c.txt"),
                           std::pair(std::string("1 0 0 1\n-1 0 0 1\n"), "c.txt"),
                           std::pair(std::string(), "c.obj")}) {
    const std::string& bytes = file.first;  // Clang 14 captures no bindings
    const char* const name = file.second;
    for (const bool all : {true, false}) {
      CAPTURE(bytes);
      request.claims = {};
      if (!all) request.claims = {ContainsInput};
      request.tightness = all;
      const Verdict verdict = judge(bytes, name, request);
      CHECK(verdict[ContainsInput].status == Status::Violated);
      CHECK_FALSE(verdict[ContainsInput].witness.squared_distance.has_value());
      CHECK_FALSE(verdict.outside->relative_squared_distance.has_value());
    }
  }
  // Unbounded or not, what holds every point holds the input.
  CHECK(judge("1 0 0 -1\n", "c.txt", request)[ContainsInput].status == Status::Holds);
}

// The cube [-1, 1]^3 as the input, smaller cubes as candidates: from facet, edge and vertex.
TEST_CASE("verify: the worst point is the one farthest from the solid (#13)") {
  const auto rows = [](const char* x, const char* y, const char* z) {
    return std::string("1 0 0 ") + x + "\n-1 0 0 -2\n0 1 0 " + y + "\n0 -1 0 -2\n0 0 1 " + z +
           "\n0 0 -1 -2\n";
  };
  const auto distance = [](const std::string& bytes) {
    return judge(bytes, "c.txt")[ContainsInput].witness.squared_distance;
  };
  CHECK(distance(rows("-0.75", "-2", "-2")) == Rational(1, 16));
  CHECK(distance(rows("-0.75", "-0.5", "-2")) == Rational(1, 16) + Rational(1, 4));
  const Verdict corner = judge(rows("-0.75", "-0.5", "0.25"), "c.txt");
  const Witness& w = corner[ContainsInput].witness;
  CHECK(w.squared_distance == Rational(1, 16) + Rational(1, 4) + Rational(25, 16));
  CHECK(w.nearest == RationalPoint(Rational(3, 4), Rational(1, 2), Rational(-1, 4)));
  CHECK(w.rows == std::vector<std::size_t>{4});  // z <= -1/4 is what it is farthest beyond
}

TEST_CASE("parse_tolerance: what is no distance is refused") {
  for (const char* text : {"", "d", "x", "1e", "-1", "-1d", "1dd", "nan", "inf"}) {
    CAPTURE(text);
    CHECK(error_of([&] { return parse_tolerance(text); }).code() == ErrorCode::InvalidArgument);
  }
}

TEST_CASE("verify: faces that are no surface of a convex solid, one fault each") {
  const std::string v = corners("1");
  const auto without_last = kQuads.substr(0, kQuads.rfind("f "));
  CHECK(is_only_violation(judge_obj(v + without_last), MeshClosed));
  CHECK(judge_obj(v + without_last)[MeshClosed].witness.faces.size() == 1);
  // One face turned over: its neighbors run along its edges as it does, and all is beyond it.
  const Verdict turned = judge_obj(v + without_last + "f 4 8 6 2\n");
  CHECK(turned[MeshClosed].status == Status::Holds);
  CHECK(turned[MeshOriented].status == Status::Violated);
  CHECK(turned[MeshConvex].witness.faces == std::vector<std::size_t>{5});
  // All turned over: they look inward, which is one fault.
  const Verdict inward =
      judge_obj(v + "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n");
  CHECK(is_only_violation(inward, MeshOriented));
  CHECK(inward[ContainsInput].status == Status::Holds);
  // One corner lifted: three quads are bent, and the hull is larger.
  std::string lifted = v;
  lifted.replace(lifted.rfind("v 1 1 1"), 7, "v 1 1 2");
  CHECK(judge_obj(lifted + kQuads)[MeshPlanar].status == Status::Violated);
  // A point that no face uses is part of what the mesh stands for.
  const Verdict stray = judge_obj(v + "v 0 0 3\n" + kQuads);
  CHECK(is_only_violation(stray, MeshConvex));
  CHECK(stray[MeshConvex].witness.vertices == std::vector<std::size_t>{8});
  CHECK(stray[MeshConvex].witness.squared_distance == 4);
}

TEST_CASE("verify: points at the same place are one point") {
  // Each quad has its own four points, as exporters with normals write it.
  const Point v[] = {{-1, -1, -1}, {-1, -1, 1}, {-1, 1, -1}, {-1, 1, 1},
                     {1, -1, -1},  {1, -1, 1},  {1, 1, -1},  {1, 1, 1}};
  const int quads[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                           {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
  std::string bytes;
  for (const auto& quad : quads) {
    for (const int c : quad) {
      bytes += "v " + std::to_string(v[c].x()) + " " + std::to_string(v[c].y()) + " " +
               std::to_string(v[c].z()) + "\n";
    }
    bytes += "f -4 -3 -2 -1\n";
  }
  CHECK(judge_obj(bytes).holds());
}

TEST_CASE("verify: a surface that covers the hull twice is not convex") {
  // Both copies of each face, with the edges welded: four faces at each edge.
  CHECK(judge_obj(corners("1") + kQuads + kQuads)[MeshClosed].status == Status::Violated);
  // The same square twice, as a face of its own that the others do not know.
  CHECK_FALSE(judge_obj(corners("1") + kQuads + "f 2 6 8 4\n").holds());
}

TEST_CASE("verify: candidates that are no solid contain nothing") {
  const Verdict nothing = judge_obj("");
  CHECK(nothing[CandidateReadable].status == Status::Holds);
  CHECK(nothing[CandidateSolid].status == Status::Violated);
  CHECK(nothing[ContainsInput].status == Status::Violated);
  CHECK(nothing.outside->points == 8);
  const Verdict plate = judge_obj("v -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\nf 1 2 3 4\n");
  CHECK(plate[CandidateSolid].status == Status::Violated);
  CHECK(plate[ContainsInput].witness.plane == Halfspace(IntegerVector3(0, 0, -1), 1));
  CHECK_FALSE(plate[ContainsInput].witness.squared_distance.has_value());
  const Verdict empty = judge("1 0 0 1\n-1 0 0 1\n", "c.txt");  // x <= -1 and x >= 1
  CHECK(empty[CandidateSolid].status == Status::Violated);
  CHECK(empty[CandidateSolid].witness.rows == std::vector<std::size_t>{0, 1});
  // Rows are those of the file, also behind one that bounds nothing.
  const Verdict behind = judge("0 0 0 -1\n1 0 0 1\n-1 0 0 1\n", "c.txt");
  CHECK(behind[CandidateSolid].witness.rows == std::vector<std::size_t>{1, 2});
  CHECK(behind[CandidateSolid].sentence.find("halfspace 2") != std::string::npos);
  CHECK(behind[CandidateSolid].sentence.find("halfspace 0") == std::string::npos);
  CHECK(empty[CandidateBounded].status == Status::NotApplicable);
  CHECK(empty.outside->points == 8);
  const Verdict never = judge("1 0 0 -5\n0 0 0 1\n", "c.txt");  // 1 <= 0
  CHECK(never[CandidateSolid].witness.rows == std::vector<std::size_t>{1});
  CHECK(never[ContainsInput].status == Status::Violated);
}

TEST_CASE("verify: an unbounded candidate contains the input, and is told where it ends not") {
  const Verdict verdict = judge("1 0 0 -1\n-1 0 0 -1\n0 1 0 -1\n0 -1 0 -1\n0 0 1 -1\n", "c.txt");
  CHECK(is_only_violation(verdict, CandidateBounded));
  CHECK(verdict[CandidateBounded].witness.direction->z() < 0);
  CHECK_FALSE(verdict.tightness.has_value());
}

TEST_CASE("verify: what cannot be read is a verdict, with the line") {
  const Verdict word = judge_obj("v 0 0 0\nv 1 0 zero\n");
  CHECK(is_only_violation(word, CandidateReadable));
  CHECK(word[CandidateReadable].witness.line == 2);
  const Verdict nan = judge_obj("v 0 0 nan\n");
  CHECK(is_only_violation(nan, CandidateFinite));
  CHECK(nan[ContainsInput].status == Status::NotApplicable);
  CHECK(is_only_violation(judge("[[1,0,0", "c.json"), CandidateReadable));
}

TEST_CASE("verify: budgets count the solid, not how it is stored") {
  // Each square as two triangles.
  const std::string triangles =
      "f 1 2 4\nf 1 4 3\nf 5 7 8\nf 5 8 6\nf 1 5 6\nf 1 6 2\nf 3 4 8\nf 3 8 7\nf 1 3 7\nf 1 7 5\nf "
      "2 6 8\nf 2 8 4\n";
  VerifyRequest request;
  request.max_facets = 6;
  CHECK(judge_obj(corners("1") + triangles, request).holds());
  request.max_facets = 5;
  request.max_vertices = 7;
  request.max_facet_vertices = 3;
  const Verdict verdict = judge_obj(corners("1") + triangles, request);
  CHECK(verdict.size.stored_faces == 12);
  CHECK(verdict[MaxFacets].witness.count == 6);
  CHECK(verdict[MaxVertices].witness.count == 8);
  CHECK(verdict[MaxFacetVertices].witness.count == 4);
}

TEST_CASE("verify: only what is asked is decided") {
  VerifyRequest request;
  request.claims = {ContainsInput};
  request.tightness = false;
  const Verdict verdict = judge_obj(corners("1") + "f 1 2 3\n", request);
  CHECK(verdict.holds());
  CHECK(verdict[MeshClosed].status == Status::NotAsked);
  CHECK(verdict[ContainsInput].status == Status::Holds);
}

TEST_CASE("verify: decimals by one rule for both files") {
  // 0.1 as a double is larger than one tenth, so only the double holds the double.
  const std::string bytes = corners("0.1");
  const auto input = [](Decimal decimal) {
    return std::get<Mesh>(read_candidate_bytes(corners("0.1"), "i.obj", decimal)).points;
  };
  for (const Decimal decimal : {Decimal::Nearest, Decimal::Exact}) {
    const Candidate same = read_candidate_bytes(bytes + kQuads, "c.obj", decimal);
    CHECK(std::get<Verdict>(verify(input(decimal), same, {})).holds());
  }
  const Candidate spelled = read_candidate_bytes(bytes + kQuads, "c.obj", Decimal::Exact);
  const VerifyOutcome mixed = verify(input(Decimal::Nearest), spelled, {});
  CHECK(is_only_violation(std::get<Verdict>(mixed), ContainsInput));
}

TEST_CASE("verify: the input may be halfspaces, with vertices that are no doubles") {
  // x, y, z >= 0 and 3x + 3y + 3z <= 1: a tetrahedron with corners at 1/3.
  const HalfspaceList input = std::get<HalfspaceList>(
      read_candidate_bytes("-1 0 0 0\n0 -1 0 0\n0 0 -1 0\n3 3 3 -1\n", "i.txt"));
  const auto judge_it = [&](const std::string& bytes, const char* name, Decimal decimal) {
    const Candidate candidate = read_candidate_bytes(bytes, name, decimal);
    return std::get<Verdict>(verify(input.halfspaces, candidate, {}));
  };
  const std::string rows = "-1 0 0 0\n0 -1 0 0\n0 0 -1 0\n";
  CHECK(judge_it(rows + "3 3 3 -1\n", "c.txt", Decimal::Nearest).holds());
  // The double nearest to 1/3 is smaller by 2^-54 / 3, so the corner (1/3, 0, 0) is outside.
  const Verdict rounded = judge_it(rows + "1 1 1 -0.3333333333333333\n", "c.txt", Decimal::Nearest);
  CHECK(is_only_violation(rounded, ContainsInput));
  CHECK(rounded.outside->points == 3);
  const Rational gap = Rational(1, 3) - to_rational(0.3333333333333333);
  CHECK(rounded[ContainsInput].witness.squared_distance == gap * gap);  // along an axis
  const Verdict mesh =
      judge_it("v 0 0 0\nv 0.34 0 0\nv 0 0.34 0\nv 0 0 0.34\n", "c.obj", Decimal::Exact);
  CHECK(mesh.holds());
}

TEST_CASE("verify: an input without volume is no verdict") {
  const Candidate candidate = read_candidate_bytes(corners("1") + kQuads, "c.obj");
  const PointSet flat(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
  CHECK(std::holds_alternative<NotSolid>(verify(flat, candidate, {})));
}

TEST_CASE("find_excess: the farthest pair, as the definition finds it") {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    const PointSet points(shapes::lattice(60, 5, seed));
    std::vector<Halfspace> planes;
    const std::vector<Point> normals = shapes::lattice(20, 4, seed + 10);
    for (std::size_t i = 0; i < normals.size(); ++i) {
      if (normals[i].isZero(0)) continue;
      planes.emplace_back(to_rational(normals[i]), Rational(-int(i)));
    }
    Rational worst = 0;
    for (const Halfspace& h : planes) {
      for (std::size_t p = 0; p < points.size(); ++p) {
        const Rational value = h(points[PointId(p)]);
        if (value <= 0) continue;
        worst = std::max(worst, Rational(value * value / Rational(h.normal().squaredNorm())));
      }
    }
    CHECK(find_excess(planes, points).value().squared_distance == worst);
  }
  CHECK_FALSE(find_excess({}, PointSet(shapes::cube())).has_value());
}

TEST_CASE("SupportProgram: the maximum over all vertices, in every direction") {
  for (const auto& points :
       {shapes::cube(), shapes::icosahedron(), shapes::prism(7), shapes::in_ball(25, 3)}) {
    const Polytope polytope = polytope_by_definition(PointSet(points));
    oracle::SupportProgram program(polytope);
    for (int x = -3; x <= 3; ++x) {
      for (int y = -3; y <= 3; ++y) {
        for (int z = -3; z <= 3; ++z) {
          if (x == 0 && y == 0 && z == 0) continue;
          const IntegerVector3 n(x, y, z);
          Rational most = polytope.vertices[0].dot(n.cast<Rational>());
          for (const RationalPoint& v : polytope.vertices) {
            most = std::max(most, Rational(v.dot(n.cast<Rational>())));
          }
          CHECK(program.maximum(n) == most);
        }
      }
    }
    for (const Halfspace& plane : polytope.planes) {
      CHECK(program.maximum(plane.normal()) == Rational(-plane.offset()));
    }
  }
}
