// SPDX-License-Identifier: MIT
// The C interface on a cube, where every distance has a closed form: verdicts, witnesses, errors.
#include <convexact.h>
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace {

using Numbers = std::vector<double>;

// [0, 4]^3.
Numbers cube(double top = 4) {
  Numbers points;
  for (int k = 0; k < 8; ++k) {
    for (const double x : {k & 1 ? 4.0 : 0.0, k & 2 ? 4.0 : 0.0, k & 4 ? top : 0.0}) {
      points.push_back(x);
    }
  }
  return points;
}

Numbers cube_planes(double top = 4) {
  return {1, 0, 0, -4, -1, 0, 0, 0, 0, 1, 0, -4, 0, -1, 0, 0, 0, 0, 2, -2 * top, 0, 0, -1, 0};
}

struct Verdict {
  convexact_status status = CONVEXACT_INTERNAL;
  bool holds = false;
  std::size_t outside = 0, point = 0, plane = 0;
  std::string plane_text, squared;
  double distance = 0;
};

Verdict take(convexact_status status, convexact_containment* result) {
  CHECK((result == nullptr) == (status != CONVEXACT_OK));
  Verdict verdict;
  verdict.status = status;
  if (result != nullptr) {
    verdict = {status,
               convexact_containment_holds(result) == 1,
               convexact_containment_outside(result),
               convexact_containment_point(result),
               convexact_containment_plane(result),
               convexact_containment_plane_text(result),
               convexact_containment_squared_distance(result),
               convexact_containment_distance(result)};
  }
  convexact_containment_free(result);
  return verdict;
}

Verdict in_planes(const Numbers& points, const Numbers& planes) {
  convexact_containment* result = nullptr;
  const auto status = convexact_verify_planes(points.data(), points.size() / 3, planes.data(),
                                              planes.size() / 4, &result);
  return take(status, result);
}

Verdict in_hull(const Numbers& points, const Numbers& vertices) {
  convexact_containment* result = nullptr;
  const auto status = convexact_verify_vertices(points.data(), points.size() / 3, vertices.data(),
                                                vertices.size() / 3, &result);
  return take(status, result);
}

}  // namespace

TEST_CASE("C interface: a cube is in itself, as planes and as vertices") {
  for (const Verdict& verdict : {in_planes(cube(), cube_planes()), in_hull(cube(), cube())}) {
    CHECK(verdict.status == CONVEXACT_OK);
    CHECK(verdict.holds);
    CHECK(verdict.outside == 0);
    CHECK(verdict.squared == "0");
    CHECK(verdict.distance == 0);
  }
  CHECK(in_planes({1, 2, 3}, cube_planes()).holds);  // one point is enough
}

TEST_CASE("C interface: the worst point, plane and distance, in closed form") {
  const Verdict cut = in_planes(cube(), cube_planes(3.75));
  CHECK_FALSE(cut.holds);
  CHECK(cut.outside == 4);
  CHECK(cut.point == 4);
  CHECK(cut.plane == 4);
  CHECK(cut.plane_text == "0 0 4 -15");
  CHECK(cut.squared == "1/16");
  CHECK(cut.distance == 0.25);
  const Verdict hull = in_hull(cube(), cube(3.75));
  CHECK(hull.outside == 4);
  CHECK(hull.plane_text == "0 0 4 -15");
  CHECK(hull.squared == "1/16");
  // An ulp is enough: 2^-51 below 4.
  const Verdict ulp = in_planes(cube(), cube_planes(std::nextafter(4.0, 0.0)));
  CHECK(ulp.squared == "1/5070602400912917605986812821504");  // 2^-102
  CHECK(ulp.distance == 0x1p-51);
  // A slanted plane, of which the distance is irrational: rounded up.
  const Verdict slanted = in_planes({2, 1, 0}, {1, 1, 0, -2});
  CHECK(slanted.squared == "1/2");
  CHECK(slanted.distance == 0x1.6a09e667f3bcdp-1);  // sqrt(1/2) = 0x1.6a09e667f3bcc908b2f...p-1
}

TEST_CASE("C interface: rows without a normal hold everywhere or nowhere") {
  Numbers planes = cube_planes();
  planes.insert(planes.begin(), {0, 0, 0, -1});
  CHECK(in_planes(cube(), planes).holds);
  Numbers shifted = cube_planes(3);
  shifted.insert(shifted.begin(), {0, 0, 0, 0});
  CHECK(in_planes(cube(), shifted).plane == 5);  // the row that is given
  planes[3] = 1;
  const Verdict nowhere = in_planes(cube(), planes);
  CHECK(nowhere.outside == 8);
  CHECK(nowhere.plane == 0);
  CHECK(nowhere.plane_text == "0 0 0 1");
  CHECK(nowhere.squared == "inf");
  CHECK(std::isinf(nowhere.distance));
}

TEST_CASE("C interface: what makes no sense is a status, and the result is null") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = 1 / 0.0;
  CHECK(in_planes({nan, 0, 0}, cube_planes()).status == CONVEXACT_NOT_FINITE);
  CHECK(in_planes({0, 0, 0}, {1, 0, infinity, 0}).status == CONVEXACT_NOT_FINITE);
  CHECK(in_planes({0, 0, 0}, {1, 0, 0, nan}).status == CONVEXACT_NOT_FINITE);
  CHECK(in_hull({0, 0, 0}, {0, -infinity, 0}).status == CONVEXACT_NOT_FINITE);
  CHECK(in_hull({0, 0, 0}, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}).status == CONVEXACT_NO_INTERIOR);
  CHECK(in_planes({}, cube_planes()).status == CONVEXACT_INVALID_ARGUMENT);
  CHECK(in_planes(cube(), {}).status == CONVEXACT_INVALID_ARGUMENT);
  const Numbers points = cube();
  CHECK(convexact_verify_planes(points.data(), 8, points.data(), 6, nullptr) ==
        CONVEXACT_INVALID_ARGUMENT);
  convexact_containment* result = nullptr;
  CHECK(take(convexact_verify_planes(nullptr, 8, points.data(), 6, &result), result).status ==
        CONVEXACT_INVALID_ARGUMENT);
  CHECK(take(convexact_verify_vertices(points.data(), 8, points.data(), SIZE_MAX, &result), result)
            .status == CONVEXACT_INVALID_ARGUMENT);
  convexact_containment_free(nullptr);
  convexact_solid_free(nullptr);
}

namespace {

// The sides of the cube, counter-clockwise from outside.
const std::vector<std::uint32_t> kSides = {0, 4, 6, 2, 1, 3, 7, 5, 0, 1, 5, 4,
                                           2, 6, 7, 3, 0, 2, 3, 1, 4, 5, 7, 6};

struct Judged {
  convexact_status status;
  bool holds = false;
  std::map<std::string, std::string> claims, sentences;
};

Judged take(convexact_status status, convexact_verdict* result) {
  CHECK((result == nullptr) == (status != CONVEXACT_OK));
  Judged judged{status, false, {}, {}};
  if (result == nullptr) return judged;
  judged.holds = convexact_verdict_holds(result) == 1;
  for (std::size_t i = 0; i < convexact_verdict_claim_count(result); ++i) {
    const std::string name = convexact_verdict_claim_name(result, i);
    judged.claims[name] = convexact_verdict_claim_status(result, i);
    judged.sentences[name] = convexact_verdict_claim_sentence(result, i);
  }
  convexact_verdict_free(result);
  return judged;
}

Judged judge_planes(const Numbers& planes, const std::string& options = "") {
  convexact_verdict* result = nullptr;
  const Numbers points = cube();
  const auto status = convexact_judge_planes(points.data(), 8, nullptr, 0, planes.data(),
                                             planes.size() / 4, options.c_str(), &result);
  return take(status, result);
}

Judged judge_mesh(const Numbers& points, const Numbers& vertices,
                  const std::vector<std::uint32_t>& corners, const std::vector<std::size_t>& sizes,
                  const char* options = nullptr) {
  convexact_verdict* result = nullptr;
  const auto status = convexact_judge_mesh(points.data(), points.size() / 3, nullptr, 0,
                                           vertices.data(), vertices.size() / 3, corners.data(),
                                           sizes.data(), sizes.size(), options, &result);
  return take(status, result);
}

}  // namespace

TEST_CASE("C interface: a tolerance lets pass what is within it, exactly (#13)") {
  CHECK(judge_planes(cube_planes()).holds);
  // A quarter is missing at the top; the diameter is sqrt(48), so that is 0.03608... of it.
  for (const std::string enough : {"0.25", "1", "0.0361d"}) {
    CAPTURE(enough);
    CHECK(judge_planes(cube_planes(3.75), "tolerance=" + enough).holds);
  }
  for (const std::string little : {"0", "0.24999999999999999999", "0.036d"}) {
    CAPTURE(little);
    const Judged judged = judge_planes(cube_planes(3.75), "tolerance=" + little);
    CHECK(judged.status == CONVEXACT_OK);
    CHECK_FALSE(judged.holds);
    CHECK(judged.claims.at("contains-input") == "violated");
    CHECK(judged.sentences.at("contains-input") != "");
  }
  CHECK(judge_planes(cube_planes(), "tolerance=much").status == CONVEXACT_INVALID_ARGUMENT);
  CHECK(judge_planes(cube_planes(), "tolerance=-1").status == CONVEXACT_INVALID_ARGUMENT);
}

TEST_CASE("C interface: questions about a solid are asked by name") {
  const Judged hull = judge_planes(cube_planes(5), "asks=hull tolerance=0.5");
  CHECK(hull.claims.at("contains-input") == "holds");
  CHECK(hull.claims.at("is-hull") == "violated");
  const Judged inner = judge_planes(cube_planes(5), "asks=inner");
  CHECK(inner.claims.at("inside-input") == "violated");
  CHECK(judge_planes(cube_planes(), "max_facets=6 max_vertices=8 max_facet_vertices=4").holds);
  CHECK(judge_planes(cube_planes(), "max_facets=5").claims.at("max-facets") == "violated");
  const Judged named = judge_planes(cube_planes(3.75), "claims=candidate-solid,candidate-bounded");
  CHECK(named.holds);
  CHECK(named.claims.at("contains-input") == "not-asked");
  for (const char* refused : {"asks=simplify", "exact_facets", "claims=", "claims=holds"}) {
    CAPTURE(refused);
    CHECK(judge_planes(cube_planes(), refused).status == CONVEXACT_INVALID_ARGUMENT);
  }
}

TEST_CASE("C interface: the faces of a mesh are judged (#13)") {
  const std::vector<std::size_t> sizes(6, 4);
  const Judged good = judge_mesh(cube(), cube(), kSides, sizes);
  CHECK(good.holds);
  for (const char* claim : {"mesh-closed", "mesh-oriented", "mesh-planar", "mesh-convex"}) {
    CAPTURE(claim);
    CHECK(good.claims.at(claim) == "holds");
  }
  CHECK(judge_mesh(cube(), cube(3.75), kSides, sizes, "tolerance=0.25").holds);
  const Judged open = judge_mesh(cube(), cube(), kSides, std::vector<std::size_t>(5, 4));
  CHECK_FALSE(open.holds);
  CHECK(open.claims.at("mesh-closed") == "violated");
  std::vector<std::uint32_t> inward = kSides;
  std::reverse(inward.begin(), inward.end());
  CHECK(judge_mesh(cube(), cube(), inward, sizes).claims.at("mesh-oriented") == "violated");
  const Judged points_only = judge_mesh(cube(), cube(), {}, {});
  CHECK(points_only.holds);
  CHECK(points_only.claims.at("mesh-closed") == "not-applicable");
}

TEST_CASE("C interface: meshes that make no sense are a status (#13)") {
  const std::vector<std::size_t> sizes(6, 4);
  std::vector<std::uint32_t> beyond = kSides;
  beyond.back() = 8;
  CHECK(judge_mesh(cube(), cube(), beyond, sizes).status == CONVEXACT_INVALID_ARGUMENT);
  CHECK(judge_mesh(cube(), cube(), kSides, {2}).status == CONVEXACT_INVALID_ARGUMENT);
  CHECK(judge_mesh(cube(), {}, {}, {}).status == CONVEXACT_INVALID_ARGUMENT);
  CHECK(judge_mesh({0, 0, 0, 1, 0, 0, 0, 1, 0}, cube(), kSides, sizes).status ==
        CONVEXACT_NO_INTERIOR);
  const Numbers points = cube();
  convexact_verdict* result = nullptr;
  CHECK(take(convexact_judge_mesh(points.data(), 8, nullptr, 0, points.data(), 8, nullptr,
                                  sizes.data(), 6, nullptr, &result),
             result)
            .status == CONVEXACT_INVALID_ARGUMENT);
  // What is wrong with a candidate is a claim: the vertices lie in one plane.
  const Judged flat = judge_mesh(cube(), {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, {}, {});
  CHECK(flat.status == CONVEXACT_OK);
  CHECK(flat.claims.at("candidate-solid") == "violated");
  convexact_verdict_free(nullptr);
}

TEST_CASE("C interface: points that no triangle uses are asked or not") {
  // The cube of the other tests, and a point beside it: its own hull holds the used points only.
  Numbers points = cube();
  points.insert(points.end(), {9, 2, 2});
  const std::vector<std::uint32_t> triangles{0, 1, 2, 3, 4, 5, 6, 7, 0};
  const Numbers planes = cube_planes();
  const auto judge = [&](const char* options) {
    convexact_verdict* result = nullptr;
    const auto status = convexact_judge_planes(points.data(), 9, triangles.data(), 3, planes.data(),
                                               planes.size() / 4, options, &result);
    return take(status, result);
  };
  CHECK(judge("asks=hull judge_points=used").holds);
  CHECK(!judge("asks=hull judge_points=all").holds);
  CHECK(!judge("asks=hull").holds);
  CHECK(judge("asks=hull judge_points=some").status == CONVEXACT_INVALID_ARGUMENT);
}

TEST_CASE("C interface: simplify encloses, in doubles and exactly") {
  Numbers points = cube();
  points[21] = 3.5;  // the corner (4, 4, 4) becomes (3.5, 4, 4)
  convexact_solid* solid = nullptr;
  REQUIRE(convexact_simplify(points.data(), 8, "faces=6", &solid) == CONVEXACT_OK);
  const std::size_t count = convexact_solid_plane_count(solid);
  CHECK(count == 6);
  Numbers planes(4 * count), exact(4 * count);
  for (std::size_t i = 0; i < count; ++i) {
    convexact_solid_plane(solid, i, &planes[4 * i]);
    const std::string text = convexact_solid_plane_text(solid, i);
    REQUIRE(std::sscanf(text.c_str(), "%lf %lf %lf %lf", &exact[4 * i], &exact[4 * i + 1],
                        &exact[4 * i + 2], &exact[4 * i + 3]) == 4);
  }
  convexact_solid_free(solid);
  CHECK(in_planes(points, planes).holds);
  CHECK(in_planes(points, exact).holds);

  // Without a number of faces and without a limit of growth there is no end, as in the program.
  for (const char* refused : {"faces=3", "", static_cast<const char*>(nullptr)}) {
    CHECK(convexact_simplify(points.data(), 8, refused, &solid) == CONVEXACT_INVALID_ARGUMENT);
    CHECK(solid == nullptr);
  }
  CHECK(convexact_simplify(points.data(), 3, "faces=6", &solid) == CONVEXACT_NO_INTERIOR);
  CHECK(convexact_simplify(points.data(), 8, "faces=6", nullptr) == CONVEXACT_INVALID_ARGUMENT);
  // The corner that is cut off has a volume of 4/3; the cube, of 64.
  REQUIRE(convexact_simplify(points.data(), 8, "max_growth=0", &solid) == CONVEXACT_OK);
  CHECK(convexact_solid_plane_count(solid) > 6);
  convexact_solid_free(solid);
  for (const char* engine : {"exact", "filtered", "float"}) {
    CAPTURE(engine);
    const std::string options = std::string("max_growth=10% engine=") + engine;
    REQUIRE(convexact_simplify(points.data(), 8, options.c_str(), &solid) == CONVEXACT_OK);
    CHECK(convexact_solid_plane_count(solid) == 6);
    convexact_solid_free(solid);
  }
}

namespace {

// [0, 4]^3 without the corner of legs a, a, a at the origin, and without that of legs 15/4, 1/2 and
// 1/2 at (4, 4, 4).
Numbers twice_cut(double a) {
  return {a, 0, 0, 0, a, 0, 0, 0, a, 4,    0, 0, 0, 4,   0, 4, 4, 0,
          0, 0, 4, 4, 0, 4, 0, 4, 4, 0.25, 4, 4, 4, 3.5, 4, 4, 4, 3.5};
}

// Whether seven planes of it, by this cost, are without the one at the origin.
bool fills_origin(double a, const std::string& cost) {
  const Numbers points = twice_cut(a);
  convexact_solid* solid = nullptr;
  REQUIRE(convexact_simplify(points.data(), points.size() / 3, ("faces=7 cost=" + cost).c_str(),
                             &solid) == CONVEXACT_OK);
  CHECK(convexact_solid_plane_count(solid) == 7);
  CHECK(convexact_solid_tie_count(solid) == 0);
  bool fills = true;
  for (std::size_t i = 0; i < convexact_solid_plane_count(solid); ++i) {
    double plane[4];
    convexact_solid_plane(solid, i, plane);
    if (plane[0] < 0 && plane[1] < 0 && plane[2] < 0) fills = false;
  }
  convexact_solid_free(solid);
  return fills;
}

}  // namespace

// A corner of legs p, q, r adds pqr / 6 to the volume and (pq + qr + rp - sqrt(ppqq + qqrr + rrpp))
// / 2 to the area; 4 pi times what it adds to the mean width is (p + q + r) pi / 2 less, for each
// edge of the cut, its length times the angle between the cut and the cube there. The long corner
// adds 0.15625, 0.668 and 0.442; that at the origin 0.16667, 0.634 and 0.659 if a = 1, and 0.0703,
// 0.357 and 0.494 if a = 3/4.
TEST_CASE("C interface: the measure of the costs decides which planes stay") {
  CHECK_FALSE(fills_origin(1, "volume"));
  CHECK(fills_origin(1, "area"));
  CHECK_FALSE(fills_origin(1, "mean-width"));
  CHECK(fills_origin(0.75, "volume"));
  CHECK(fills_origin(0.75, "area"));
  CHECK_FALSE(fills_origin(0.75, "mean-width"));
}

// Two opposite corners of a cube, cut off alike: the first removal is one of two that cost the
// same, the second is the other.
TEST_CASE("C interface: ties are counted, and proven for each measure") {
  const Numbers points = {1, 0, 0, 0, 1, 0, 0, 0, 1, 4, 0, 0, 0, 4, 0, 4, 4, 0,
                          0, 0, 4, 4, 0, 4, 0, 4, 4, 3, 4, 4, 4, 3, 4, 4, 4, 3};
  const auto simplified = [&](const std::string& options, convexact_solid** solid) {
    return convexact_simplify(points.data(), 12, ("faces=6 " + options).c_str(), solid);
  };
  for (const std::string cost : {"volume", "area", "mean-width"}) {
    CAPTURE(cost);
    convexact_solid* solid = nullptr;
    REQUIRE(simplified("tie_bits=128 cost=" + cost, &solid) == CONVEXACT_OK);
    CHECK(convexact_solid_plane_count(solid) == 6);
    CHECK(convexact_solid_tie_count(solid) == 1);
    CHECK(convexact_solid_undecided_count(solid) == 0);
    CHECK(convexact_solid_undecided_bits(solid) == 0);
    convexact_solid_free(solid);
  }
  convexact_solid* solid = nullptr;
  for (const char* cost : {"cost=width", "cost=0", "cost=", "cost"}) {
    CHECK(simplified(cost, &solid) == CONVEXACT_INVALID_ARGUMENT);
  }
  for (const std::string bits : {"-1", "127", "1048577"}) {
    CHECK(simplified("cost=mean-width tie_bits=" + bits, &solid) == CONVEXACT_INVALID_ARGUMENT);
    CHECK(solid == nullptr);
  }
}

namespace {

// The rows (n1, n2, n3, d) after a search.
struct Searched {
  std::vector<std::string> planes;
  std::size_t moves = 0;
};

Searched searched(const Numbers& points, const std::string& search) {
  convexact_solid* solid = nullptr;
  REQUIRE(convexact_simplify(points.data(), points.size() / 3, ("faces=4 search=" + search).c_str(),
                             &solid) == CONVEXACT_OK);
  Searched result{{}, convexact_solid_move_count(solid)};
  for (std::size_t i = 0; i < convexact_solid_plane_count(solid); ++i) {
    result.planes.emplace_back(convexact_solid_plane_text(solid, i));
  }
  convexact_solid_free(solid);
  return result;
}

// Of the tetrahedron of four planes: |D|^3 / (6 |D1 D2 D3 D4|), with the determinant D of the rows
// and those of the normals of three planes each.
double tetrahedron_volume(const std::vector<std::string>& planes) {
  REQUIRE(planes.size() == 4);
  Eigen::Matrix4d rows;
  for (int i = 0; i < 4; ++i) {
    std::istringstream words(planes[static_cast<std::size_t>(i)]);
    for (int c = 0; c < 4; ++c) words >> rows(i, c);
    rows.row(i) /= rows.row(i).head<3>().norm();
  }
  double minors = 1;
  for (int i = 0; i < 4; ++i) {
    Eigen::Matrix3d three;
    for (int k = 0, row = 0; k < 4; ++k) {
      if (k != i) three.row(row++) = rows.row(k).head<3>();
    }
    minors *= three.determinant();
  }
  return std::abs(std::pow(rows.determinant(), 3) / (6 * minors));
}

}  // namespace

// Around an icosahedron the tightest four of its planes are those of a regular tetrahedron:
// (7 + 3 sqrt 5) / 5 times its volume, which is 5 (3 + sqrt 5) / 12 edges^3.
TEST_CASE("C interface: a search ends at fewer volume") {
  const double phi = (1 + std::sqrt(5.0)) / 2;
  Numbers points;
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-phi, phi}) {
      points.insert(points.end(), {0, a, b, a, b, 0, b, 0, a});
    }
  }
  const double hull = 8 * 5 * (3 + std::sqrt(5.0)) / 12;  // of edges of length 2
  const Searched none = searched(points, "none");
  CHECK(none.moves == 0);
  CHECK(searched(points, "none seed=7").planes == none.planes);
  const Searched local = searched(points, "local");
  CHECK(local.moves > 0);
  CHECK(tetrahedron_volume(local.planes) / hull ==
        doctest::Approx((7 + 3 * std::sqrt(5.0)) / 5).epsilon(1e-9));
  CHECK(tetrahedron_volume(none.planes) / hull > 5);
  CHECK(searched(points, "local moves=200 seed=1").planes == local.planes);

  // What a search reads needs a search.
  convexact_solid* solid = nullptr;
  for (const char* refused : {"faces=4 search=far", "faces=4 moves=7", "faces=4 nodes=7"}) {
    CAPTURE(refused);
    CHECK(convexact_simplify(points.data(), 12, refused, &solid) == CONVEXACT_INVALID_ARGUMENT);
    CHECK(solid == nullptr);
  }
}

TEST_CASE("C interface: many threads at once come to the same verdicts") {
  std::vector<Verdict> verdicts(4);
  std::vector<std::thread> threads;
  for (Verdict& verdict : verdicts) {
    threads.emplace_back([&verdict] {
      for (int k = 0; k < 50; ++k) verdict = in_hull(cube(), cube(3.75));
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const Verdict& verdict : verdicts) CHECK(verdict.squared == "1/16");
}

TEST_CASE("C interface: every status has a sentence, and the version is that of the library") {
  for (int status = -1; status <= 71; ++status) {
    CHECK(std::string(convexact_status_text(status)) != "");
  }
  CHECK(std::string(convexact_version()).find('.') != std::string::npos);
}
