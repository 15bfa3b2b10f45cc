// SPDX-License-Identifier: MIT
// The C interface on an L of unit cells: its parts, what they own and measure, the tree over them,
// and verdicts on both; faults are a status.
#include <convexact.h>
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace {

struct Triangles {
  std::vector<double> points;
  std::vector<std::uint32_t> corners;

  std::size_t point_count() const { return points.size() / 3; }
  std::size_t count() const { return corners.size() / 3; }
};

// The L of the unit cells at (0, 0), (1, 0) and (0, 1), one high: an outline of eight edges, of
// which each is a wall, and three squares below and above. The corners are (x, y, z) with x + y
// <= 3.
Triangles l_shape() {
  Triangles mesh;
  const std::vector<std::array<int, 2>> outline = {{0, 0}, {1, 0}, {2, 0}, {2, 1},
                                                   {1, 1}, {1, 2}, {0, 2}, {0, 1}};
  for (const auto& [x, y] : outline) {
    for (const int z : {0, 1}) {
      mesh.points.insert(mesh.points.end(), {double(x), double(y), double(z)});
    }
  }
  const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.corners.insert(mesh.corners.end(), {a, b, c, a, c, d});
  };
  for (std::uint32_t k = 0; k < 8; ++k) {
    const std::uint32_t a = 2 * k, b = 2 * ((k + 1) % 8);
    quad(a, b, b + 1, a + 1);
  }
  for (const std::array<std::uint32_t, 4>& cell :
       std::vector<std::array<std::uint32_t, 4>>{{0, 1, 4, 7}, {1, 2, 3, 4}, {7, 4, 5, 6}}) {
    quad(2 * cell[0], 2 * cell[3], 2 * cell[2], 2 * cell[1]);
    quad(2 * cell[0] + 1, 2 * cell[1] + 1, 2 * cell[2] + 1, 2 * cell[3] + 1);
  }
  return mesh;
}

// A part of the floor of the L, and no other point.
Triangles flat_shape() {
  const Triangles mesh = l_shape();
  Triangles flat;
  for (const std::size_t corner : {0, 4, 2, 6}) {
    const auto first = mesh.points.begin() + static_cast<std::ptrdiff_t>(3 * corner);
    flat.points.insert(flat.points.end(), first, first + 3);
  }
  flat.corners = {0, 1, 2, 0, 3, 1};
  return flat;
}

// Clusters are the two arms of the L, and as hulls of points of the mesh have its doubles.
const std::string kHacd = "method=hacd", kOnePart = "method=hacd max_parts=1";

using Decomposition =
    std::unique_ptr<convexact_decomposition, decltype(&convexact_decomposition_free)>;

Decomposition decompose(const Triangles& mesh, const std::string& options) {
  convexact_decomposition* result = nullptr;
  REQUIRE(convexact_decompose(mesh.points.data(), mesh.point_count(), mesh.corners.data(),
                              mesh.count(), options.c_str(), &result) == CONVEXACT_OK);
  return {result, convexact_decomposition_free};
}

convexact_status refusal(const Triangles& mesh, const char* options) {
  convexact_decomposition* result = nullptr;
  const auto status = convexact_decompose(mesh.points.data(), mesh.point_count(),
                                          mesh.corners.data(), mesh.count(), options, &result);
  CHECK((result == nullptr) == (status != CONVEXACT_OK));
  convexact_decomposition_free(result);
  return status;
}

std::array<double, 2> volume(const Decomposition& parts, int which) {
  std::array<double, 2> bounds{};
  convexact_decomposition_volume(parts.get(), which, bounds.data());
  return bounds;
}

std::string exact_volume(const Decomposition& parts, int which) {
  return convexact_decomposition_exact_volume(parts.get(), which);
}

bool is_unknown(const std::array<double, 2>& bounds) {
  return std::isnan(bounds[0]) && std::isnan(bounds[1]);
}

// The value of n.p + d; exact for the small integers of this test.
double value_at(const double* plane, const double* p) {
  return plane[0] * p[0] + plane[1] * p[1] + plane[2] * p[2] + plane[3];
}

// The planes of a part, from their texts.
std::vector<double> exact_planes(const Decomposition& parts, std::size_t k) {
  std::vector<double> planes(4 * convexact_decomposition_plane_count(parts.get(), k));
  for (std::size_t i = 0; i < planes.size() / 4; ++i) {
    double* plane = &planes[4 * i];
    REQUIRE(std::sscanf(convexact_decomposition_plane_text(parts.get(), k, i), "%lf %lf %lf %lf",
                        plane, plane + 1, plane + 2, plane + 3) == 4);
  }
  return planes;
}

// Whether all points lie in all planes.
bool all_inside(const std::vector<double>& planes, const double* points, std::size_t count) {
  for (std::size_t i = 0; i < planes.size(); i += 4) {
    for (std::size_t p = 0; p < count; ++p) {
      if (value_at(&planes[i], points + 3 * p) > 0) return false;
    }
  }
  return true;
}

void check_owners(const Triangles& mesh, const Decomposition& parts) {
  const std::uint32_t* owners = convexact_decomposition_owners(parts.get());
  const std::size_t count = convexact_decomposition_part_count(parts.get());
  for (std::size_t t = 0; t < mesh.count(); ++t) {
    REQUIRE(owners[t] < count);
    const std::vector<double> planes = exact_planes(parts, owners[t]);
    for (int c = 0; c < 3; ++c) {
      CHECK(all_inside(planes, &mesh.points[3 * mesh.corners[3 * t + c]], 1));
    }
  }
}

// All parts in the arrays of convexact_verify_parts.
struct Parts {
  std::vector<double> vertices;
  std::vector<std::size_t> vertex_counts, face_sizes, face_counts;
  std::vector<std::uint32_t> corners;

  explicit Parts(const Decomposition& parts) {
    const convexact_decomposition* made = parts.get();
    for (std::size_t k = 0; k < convexact_decomposition_part_count(made); ++k) {
      const std::size_t points = convexact_decomposition_vertex_count(made, k),
                        faces = convexact_decomposition_face_count(made, k);
      vertex_counts.push_back(points);
      face_counts.push_back(faces);
      const double* xyz = convexact_decomposition_vertices(made, k);
      vertices.insert(vertices.end(), xyz, xyz + 3 * points);
      const std::uint32_t* corner = convexact_decomposition_corners(made, k);
      for (std::size_t f = 0; f < faces; ++f) {
        face_sizes.push_back(convexact_decomposition_face_sizes(made, k)[f]);
        corners.insert(corners.end(), corner, corner + face_sizes.back());
        corner += face_sizes.back();
      }
    }
  }
};

struct Judged {
  convexact_status status;
  bool holds = false;
  std::map<std::string, std::string> claims, sentences;
};

Judged taken(convexact_status status, convexact_verdict* result) {
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

Judged judge(const Triangles& mesh, const Parts& parts, const char* options = nullptr) {
  convexact_verdict* result = nullptr;
  const auto status = convexact_verify_parts(
      mesh.points.data(), mesh.point_count(), mesh.corners.data(), mesh.count(),
      parts.vertices.data(), parts.vertex_counts.data(), parts.vertex_counts.size(),
      parts.corners.data(), parts.face_sizes.data(), parts.face_counts.data(), options, &result);
  return taken(status, result);
}

}  // namespace

TEST_CASE("C interface: an L becomes two parts that own its triangles") {
  const Triangles mesh = l_shape();
  for (const std::string method : {"hacd", "acd", "cut", "auto"}) {
    CAPTURE(method);
    const Decomposition parts = decompose(mesh, "exact_volumes method=" + method);
    REQUIRE(convexact_decomposition_part_count(parts.get()) == 2);
    CHECK(convexact_decomposition_eps_holds(parts.get()) == 1);
    check_owners(mesh, parts);
    CHECK(volume(parts, CONVEXACT_VOLUME_SOLID) == std::array{3.0, 3.0});
    CHECK(exact_volume(parts, CONVEXACT_VOLUME_SOLID) == "3");
    // V(solid) + V(excess) = V(union) + V(uncovered); here in halves and quarters.
    CHECK(volume(parts, CONVEXACT_VOLUME_UNION)[0] ==
          3 + volume(parts, CONVEXACT_VOLUME_EXCESS)[0] -
              volume(parts, CONVEXACT_VOLUME_UNCOVERED)[0]);
    CHECK(exact_volume(parts, -1) == "");
    CHECK(is_unknown(volume(parts, -1)));
    CHECK(is_unknown(volume(parts, 5)));
    for (std::size_t k = 0; k < 2; ++k) {
      CHECK(convexact_decomposition_form(parts.get(), k) == CONVEXACT_FORM_HULL);
      CHECK(convexact_decomposition_within_limit(parts.get(), k) == 1);
      CHECK(convexact_decomposition_concavity(parts.get(), k) == 0);
      CHECK(std::string(convexact_decomposition_squared_concavity(parts.get(), k)) == "0");
    }
  }
}

TEST_CASE("C interface: a face for each plane of a part, and planes in doubles around it") {
  const Decomposition parts = decompose(l_shape(), kHacd);
  for (std::size_t k = 0; k < convexact_decomposition_part_count(parts.get()); ++k) {
    const double* vertices = convexact_decomposition_vertices(parts.get(), k);
    const std::size_t count = convexact_decomposition_vertex_count(parts.get(), k),
                      faces = convexact_decomposition_face_count(parts.get(), k);
    const std::vector<double> planes = exact_planes(parts, k);
    REQUIRE(planes.size() == 4 * faces);
    CHECK(all_inside(planes, vertices, count));
    const std::uint32_t* corner = convexact_decomposition_corners(parts.get(), k);
    for (std::size_t f = 0; f < faces; ++f) {
      for (std::size_t c = 0; c < convexact_decomposition_face_sizes(parts.get(), k)[f]; ++c) {
        REQUIRE(*corner < count);
        CHECK(value_at(&planes[4 * f], vertices + 3 * *corner++) == 0);
      }
    }
    std::vector<double> rounded(planes.size());
    REQUIRE(convexact_decomposition_planes(parts.get(), k, rounded.data()) == CONVEXACT_OK);
    CHECK(all_inside(rounded, vertices, count));
    convexact_containment* contained = nullptr;
    REQUIRE(convexact_verify_planes(vertices, count, rounded.data(), faces, &contained) ==
            CONVEXACT_OK);
    CHECK(convexact_containment_holds(contained) == 1);
    convexact_containment_free(contained);
    CHECK(convexact_decomposition_planes(parts.get(), k, nullptr) == CONVEXACT_INVALID_ARGUMENT);
  }
}

// With one part the L is held by its hull, a pentagonal prism: the square of side 2 less half a
// cell. The diagonal (2, 1) - (1, 2) is a distance of sqrt(1/2) from the notch at (1, 1), but the
// rays of the notch's walls run along x and y, where it is 1 away.
TEST_CASE("C interface: a number of parts leads beyond the limit, and that is said") {
  const Decomposition parts = decompose(l_shape(), kOnePart + " exact_volumes=true");
  REQUIRE(convexact_decomposition_part_count(parts.get()) == 1);
  CHECK(convexact_decomposition_eps_holds(parts.get()) == 0);
  CHECK(convexact_decomposition_within_limit(parts.get(), 0) == 0);
  CHECK(convexact_decomposition_vertex_count(parts.get(), 0) == 10);
  CHECK(convexact_decomposition_face_count(parts.get(), 0) == 7);
  CHECK(std::string(convexact_decomposition_squared_concavity(parts.get(), 0)) == "1");
  CHECK(convexact_decomposition_concavity(parts.get(), 0) == 1);
  CHECK(volume(parts, CONVEXACT_VOLUME_SOLID) == std::array{3.0, 3.0});
  CHECK(volume(parts, CONVEXACT_VOLUME_UNION) == std::array{3.5, 3.5});
  CHECK(volume(parts, CONVEXACT_VOLUME_EXCESS) == std::array{0.5, 0.5});
  CHECK(exact_volume(parts, CONVEXACT_VOLUME_EXCESS) == "1/2");
  CHECK(volume(parts, CONVEXACT_VOLUME_UNCOVERED) == std::array{0.0, 0.0});
  CHECK(volume(parts, CONVEXACT_VOLUME_OVERLAP) == std::array{0.0, 0.0});
  // Without fractions, from 128 bits.
  const Decomposition bounded = decompose(l_shape(), kOnePart + " exact_volumes=false");
  const std::array<double, 2> bounds = volume(bounded, CONVEXACT_VOLUME_UNION);
  CHECK(bounds[0] <= 3.5);
  CHECK(bounds[1] >= 3.5);
  CHECK(bounds[1] - bounds[0] < 1e-15);
  CHECK(exact_volume(bounded, CONVEXACT_VOLUME_UNION) == "");
}

TEST_CASE("C interface: a limit is a share of the diameter or a length, taken as spelled") {
  // The concavity of the whole L is 1, and its diameter 3.
  const auto parts_at = [](const std::string& concavity) {
    return convexact_decomposition_part_count(
        decompose(l_shape(), "method=hacd concavity=" + concavity).get());
  };
  for (const char* enough : {"1", "34%", "0.34d", "33.34%", "1/3d"}) {
    CAPTURE(enough);
    CHECK(parts_at(enough) == 1);
  }
  for (const char* little : {"0.99999999999999999999999", "33.33%", "0.333333333333333333333d"}) {
    CAPTURE(little);
    CHECK(parts_at(little) == 2);
  }
}

TEST_CASE("C interface: fewer planes, floats, and no volumes on request") {
  const Triangles mesh = l_shape();
  const Decomposition simplified = decompose(mesh, kOnePart + " faces=6 no_measures");
  CHECK(convexact_decomposition_form(simplified.get(), 0) == CONVEXACT_FORM_SIMPLIFIED);
  CHECK(convexact_decomposition_face_count(simplified.get(), 0) == 6);  // the square's prism
  CHECK(is_unknown(volume(simplified, CONVEXACT_VOLUME_UNION)));
  check_owners(mesh, simplified);

  Triangles thirds = mesh;
  for (double& x : thirds.points) x /= 3;
  const Decomposition narrow = decompose(thirds, "method=hacd precision=32 concavity=1%");
  for (std::size_t k = 0; k < convexact_decomposition_part_count(narrow.get()); ++k) {
    CHECK(convexact_decomposition_form(narrow.get(), k) == CONVEXACT_FORM_ROUNDED);
    const double* vertices = convexact_decomposition_vertices(narrow.get(), k);
    for (std::size_t i = 0; i < 3 * convexact_decomposition_vertex_count(narrow.get(), k); ++i) {
      CHECK(vertices[i] == double(float(vertices[i])));
    }
  }
  Triangles huge = mesh;
  for (double& x : huge.points) x *= 1e39;
  CHECK(refusal(huge, "method=hacd precision=32") == CONVEXACT_UNREPRESENTABLE);
}

TEST_CASE("C interface: a flat mesh is refused, thickened, or kept flat") {
  const Triangles mesh = flat_shape();
  for (const char* options : {"", "method=hacd", "flat=merge", "method=hacd flat=merge"}) {
    CAPTURE(options);
    CHECK(refusal(mesh, options) == CONVEXACT_NO_INTERIOR);
  }
  CHECK(refusal(mesh, nullptr) == CONVEXACT_NO_INTERIOR);
  const Decomposition thick = decompose(mesh, "method=hacd flat=thicken");
  CHECK(convexact_decomposition_form(thick.get(), 0) == CONVEXACT_FORM_THICKENED);
  CHECK(judge(mesh, Parts(thick)).holds);
  const Decomposition flat = decompose(mesh, "method=hacd flat=keep");
  REQUIRE(convexact_decomposition_part_count(flat.get()) == 1);
  CHECK(convexact_decomposition_form(flat.get(), 0) == CONVEXACT_FORM_FLAT);
  CHECK(convexact_decomposition_face_count(flat.get(), 0) == 1);
  CHECK(is_unknown(volume(flat, CONVEXACT_VOLUME_SOLID)));
  CHECK(volume(flat, CONVEXACT_VOLUME_UNION) == std::array{0.0, 0.0});
  std::vector<double> planes(4 * convexact_decomposition_plane_count(flat.get(), 0));
  CHECK(convexact_decomposition_planes(flat.get(), 0, planes.data()) == CONVEXACT_NO_INTERIOR);
  CHECK(judge(mesh, Parts(flat)).claims.at("parts-solid") == "violated");
}

TEST_CASE("C interface: options of a decomposition out of their range are refused") {
  const Triangles mesh = l_shape();
  CHECK(refusal(mesh, "") == CONVEXACT_OK);
  for (const char* options : {"method=vhacd",
                              "method=-1",
                              "method",
                              "concavity=",
                              "concavity=-1",
                              "concavity=101%",
                              "concavity=much",
                              "measure=2",
                              "method=acd measure=vertices",
                              "faces=3",
                              "total_faces=3",
                              "total_faces=7",  // of two parts
                              "faces=8 total_faces=8",
                              "flat=4",
                              "precision=16",
                              "no_measures exact_volumes",
                              "size=0",
                              "max_parts=0",
                              "max_part_vertices=3",
                              "disjoint=yes"}) {
    CAPTURE(options);
    CHECK(refusal(mesh, options) == CONVEXACT_INVALID_ARGUMENT);
  }
}

TEST_CASE("C interface: meshes that make no sense are a status") {
  const Triangles good = l_shape();
  Triangles mesh = good;
  mesh.corners.back() = std::uint32_t(mesh.point_count());
  CHECK(refusal(mesh, nullptr) == CONVEXACT_INVALID_ARGUMENT);
  for (const double x :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    mesh = good;
    mesh.points[4] = x;
    CHECK(refusal(mesh, nullptr) == CONVEXACT_NOT_FINITE);
  }
  mesh = good;
  mesh.corners.clear();
  CHECK(refusal(mesh, nullptr) == CONVEXACT_INVALID_ARGUMENT);
  mesh = {{}, good.corners};
  CHECK(refusal(mesh, nullptr) == CONVEXACT_INVALID_ARGUMENT);
  CHECK(convexact_decompose(good.points.data(), good.point_count(), good.corners.data(),
                            good.count(), nullptr, nullptr) == CONVEXACT_INVALID_ARGUMENT);
  convexact_decomposition* result = nullptr;
  CHECK(convexact_decompose(good.points.data(), good.point_count(), nullptr, good.count(), nullptr,
                            &result) == CONVEXACT_INVALID_ARGUMENT);
  CHECK(convexact_decompose(good.points.data(), good.point_count(), good.corners.data(), SIZE_MAX,
                            nullptr, &result) == CONVEXACT_INVALID_ARGUMENT);
  CHECK(result == nullptr);
  convexact_decomposition_free(nullptr);
}

// Triangles with a corner twice, or in a line, and points that repeat: each keeps its number.
TEST_CASE("C interface: every triangle that is given has an owner, also one without area") {
  Triangles mesh = l_shape();
  const std::vector<double> first(mesh.points.begin(), mesh.points.begin() + 3);
  mesh.points.insert(mesh.points.end(), first.begin(), first.end());
  const auto again = std::uint32_t(mesh.point_count() - 1);
  const std::vector<std::uint32_t> degenerate = {0, 0, 2, again, 0, again, 0, 2, 4};
  mesh.corners.insert(mesh.corners.begin(), degenerate.begin(), degenerate.end());
  mesh.corners.insert(mesh.corners.end(), mesh.corners.end() - 3, mesh.corners.end());
  const Decomposition parts = decompose(mesh, kHacd);
  check_owners(mesh, parts);
}

// The top of a cube with a square hole, which a cap closes, so that it can be cut.
TEST_CASE("C interface: a cap over a hole has no number among the triangles that are given") {
  Triangles mesh;
  for (const double z : {0.0, 4.0}) {
    for (const double y : {0.0, 4.0}) {
      for (const double x : {0.0, 4.0}) mesh.points.insert(mesh.points.end(), {x, y, z});
    }
  }
  mesh.points.insert(mesh.points.end(),
                     {1.75, 1.75, 4, 2.25, 1.75, 4, 2.25, 2.25, 4, 1.75, 2.25, 4});
  for (const std::array<std::uint32_t, 4>& q :
       std::vector<std::array<std::uint32_t, 4>>{{0, 2, 3, 1},
                                                 {0, 1, 5, 4},
                                                 {2, 6, 7, 3},
                                                 {0, 4, 6, 2},
                                                 {1, 3, 7, 5},
                                                 {4, 5, 9, 8},
                                                 {5, 7, 10, 9},
                                                 {7, 6, 11, 10},
                                                 {6, 4, 8, 11}}) {
    mesh.corners.insert(mesh.corners.end(), {q[0], q[1], q[2], q[0], q[2], q[3]});
  }
  for (const char* options : {"", "method=cut", "method=hacd guard=reach"}) {
    CAPTURE(options);
    const Decomposition parts = decompose(mesh, options);
    CHECK(convexact_decomposition_part_count(parts.get()) == 1);
    check_owners(mesh, parts);
  }
}

TEST_CASE("C interface: the parts of an L are judged") {
  const Triangles mesh = l_shape();
  const Decomposition made = decompose(mesh, kHacd);
  const Parts parts(made);
  const Judged good = judge(mesh, parts);
  CHECK(good.holds);
  for (const char* claim : {"parts-solid", "parts-convex", "covers-points", "covers-surface"}) {
    CAPTURE(claim);
    CHECK(good.claims.at(claim) == "holds");
  }
  for (const char* claim : {"covers-solid", "parts-disjoint", "parts-needed", "max-parts"}) {
    CAPTURE(claim);
    CHECK(good.claims.at(claim) == "not-asked");
  }
  Parts raised = parts;  // a quarter above the floor, which was at z = 0
  for (std::size_t i = 2; i < raised.vertices.size(); i += 3) {
    if (raised.vertices[i] == 0) raised.vertices[i] = 0.25;
  }
  const Judged bad = judge(mesh, raised);
  CHECK_FALSE(bad.holds);
  CHECK(bad.claims.at("covers-points") == "violated");
  CHECK(bad.claims.at("covers-surface") == "violated");
  CHECK(bad.sentences.at("covers-points").find("8 of 16") != std::string::npos);
  CHECK(judge(mesh, raised, "tolerance=0.25").holds);
  CHECK_FALSE(judge(mesh, raised, "tolerance=0.24999").holds);
}

TEST_CASE("C interface: how far parts reach") {
  // The hull of the L passes the corner that lacks at 1/2 from both arms.
  const Triangles mesh = l_shape();
  CHECK(convexact_decomposition_reach_holds(decompose(mesh, kOnePart).get()) == 0);
  const Decomposition hull = decompose(mesh, kOnePart + " guard=reach distance=0.2");
  CHECK(convexact_decomposition_reach_holds(hull.get()) == 0);
  const Decomposition two = decompose(mesh, "method=hacd guard=reach merge=reach distance=0.2");
  CHECK(convexact_decomposition_part_count(two.get()) == 2);
  CHECK(convexact_decomposition_reach_holds(two.get()) == 1);
  CHECK(refusal(mesh, "method=hacd guard=reach distance=0") == CONVEXACT_INVALID_ARGUMENT);
  CHECK(convexact_decomposition_reach_holds(decompose(mesh, "distance=0.2").get()) == 1);  // cut

  CHECK(judge(mesh, Parts(two), "distance=0.2").claims.at("within-solid") == "holds");
  const Judged beyond = judge(mesh, Parts(hull), "distance=0.2");
  CHECK(beyond.claims.at("within-solid") == "violated");
  CHECK(beyond.claims.at("covers-solid") == "holds");
  CHECK_FALSE(beyond.holds);
}

TEST_CASE("C interface: claims and budgets of parts are asked by name and number") {
  const Triangles mesh = l_shape();
  const Parts hull(decompose(mesh, kOnePart));  // ten vertices, seven faces of at most five
  const Judged named = judge(mesh, hull, "claims=covers-solid,parts-disjoint");
  CHECK(named.holds);
  CHECK(named.claims.at("covers-solid") == "holds");
  CHECK(named.claims.at("parts-disjoint") == "holds");
  CHECK(named.claims.at("covers-surface") == "not-asked");
  const auto claim_with = [&](const char* claim, const char* budget) {
    return judge(mesh, hull, budget).claims.at(claim);
  };
  CHECK(claim_with("max-parts", "max_parts=1") == "holds");
  CHECK(claim_with("max-part-facets", "max_facets=7") == "holds");
  CHECK(claim_with("max-part-facets", "max_facets=6") == "violated");
  CHECK(claim_with("max-part-vertices", "max_vertices=10") == "holds");
  CHECK(claim_with("max-part-vertices", "max_vertices=9") == "violated");
  CHECK(claim_with("max-part-facet-vertices", "max_facet_vertices=5") == "holds");
  CHECK(claim_with("max-part-facet-vertices", "max_facet_vertices=4") == "violated");
  for (const char* options :
       {"claims=", "claims=covers-everything", "claims=contains-input", "claims=covers-surface,,",
        "claims=max-parts",  // without a number
        "tolerance=much", "size=0", "asks=enclosure", "exact_facets", "exact_volumes"}) {
    CAPTURE(options);
    CHECK(judge(mesh, hull, options).status == CONVEXACT_INVALID_ARGUMENT);
  }
}

TEST_CASE("C interface: faces of parts are judged, and parts without faces are their hulls") {
  const Triangles mesh = l_shape();
  Parts parts(decompose(mesh, kHacd));
  // With hulls alone, and with or without the triangles of the mesh.
  const auto judge_hulls = [&](std::size_t triangles) {
    convexact_verdict* result = nullptr;
    const auto status = convexact_verify_parts(
        mesh.points.data(), mesh.point_count(), triangles > 0 ? mesh.corners.data() : nullptr,
        triangles, parts.vertices.data(), parts.vertex_counts.data(), 2, nullptr, nullptr, nullptr,
        nullptr, &result);
    return taken(status, result);
  };
  const Judged hulls = judge_hulls(mesh.count());
  CHECK(hulls.holds);
  CHECK(hulls.claims.at("parts-convex") == "holds");  // there is no face that is not
  const Judged points = judge_hulls(0);
  CHECK(points.claims.at("covers-points") == "holds");
  CHECK(points.claims.at("covers-surface") == "not-applicable");
  --parts.face_counts.back();  // an open side
  parts.face_sizes.pop_back();
  CHECK(judge(mesh, parts).claims.at("parts-convex") == "violated");
}

TEST_CASE("C interface: arrays of parts that make no sense are a status") {
  const Triangles mesh = l_shape();
  const Parts good(decompose(mesh, kHacd));
  Parts parts = good;
  parts.corners.back() = 1000;
  CHECK(judge(mesh, parts).status == CONVEXACT_INVALID_ARGUMENT);
  parts = good;
  parts.face_sizes[0] = 2;
  CHECK(judge(mesh, parts).status == CONVEXACT_INVALID_ARGUMENT);
  parts = good;
  parts.vertex_counts[0] = 0;
  CHECK(judge(mesh, parts).status == CONVEXACT_INVALID_ARGUMENT);
  parts = good;
  parts.vertices[1] = std::numeric_limits<double>::quiet_NaN();
  CHECK(judge(mesh, parts).status == CONVEXACT_NOT_FINITE);
  parts = good;
  parts.vertex_counts.clear();
  CHECK(judge(mesh, parts).status == CONVEXACT_INVALID_ARGUMENT);
  const auto ask = [&](const double* vertices, const std::size_t* counts,
                       const std::uint32_t* corners, const std::size_t* sizes) {
    convexact_verdict* result = nullptr;
    const auto status = convexact_verify_parts(
        mesh.points.data(), mesh.point_count(), mesh.corners.data(), mesh.count(), vertices, counts,
        2, corners, sizes, good.face_counts.data(), nullptr, &result);
    return taken(status, result).status;
  };
  const double* vertices = good.vertices.data();
  const std::size_t* counts = good.vertex_counts.data();
  const std::uint32_t* corners = good.corners.data();
  const std::size_t* sizes = good.face_sizes.data();
  CHECK(ask(vertices, counts, corners, sizes) == CONVEXACT_OK);
  CHECK(ask(nullptr, counts, corners, sizes) == CONVEXACT_INVALID_ARGUMENT);
  CHECK(ask(vertices, nullptr, corners, sizes) == CONVEXACT_INVALID_ARGUMENT);
  CHECK(ask(vertices, counts, nullptr, sizes) == CONVEXACT_INVALID_ARGUMENT);
  CHECK(ask(vertices, counts, corners, nullptr) == CONVEXACT_INVALID_ARGUMENT);
  CHECK(convexact_verify_parts(mesh.points.data(), mesh.point_count(), mesh.corners.data(),
                               mesh.count(), vertices, counts, 2, nullptr, nullptr, nullptr,
                               nullptr, nullptr) == CONVEXACT_INVALID_ARGUMENT);
}

namespace {

using Tree = std::unique_ptr<convexact_tree, decltype(&convexact_tree_free)>;

Tree tree_over(const Decomposition& parts, const char* options = nullptr) {
  convexact_tree* tree = nullptr;
  REQUIRE(convexact_decomposition_tree(parts.get(), options, &tree) == CONVEXACT_OK);
  return {tree, convexact_tree_free};
}

// All nodes in the arrays of convexact_verify_tree.
struct Nodes {
  std::vector<double> vertices;
  std::vector<std::size_t> vertex_counts, parents;

  explicit Nodes(const Tree& tree) {
    for (std::size_t i = 0; i < convexact_tree_node_count(tree.get()); ++i) {
      const double* xyz = convexact_tree_vertices(tree.get(), i);
      vertex_counts.push_back(convexact_tree_vertex_count(tree.get(), i));
      vertices.insert(vertices.end(), xyz, xyz + 3 * vertex_counts.back());
      parents.push_back(convexact_tree_parent(tree.get(), i));
    }
  }
};

Judged judge_nodes(const Triangles& mesh, const Nodes& nodes, const char* options = nullptr) {
  convexact_verdict* result = nullptr;
  const auto status =
      convexact_verify_tree(mesh.points.data(), mesh.point_count(), mesh.corners.data(),
                            mesh.count(), nodes.vertices.data(), nodes.vertex_counts.data(),
                            nodes.parents.data(), nodes.parents.size(), options, &result);
  return taken(status, result);
}

}  // namespace

// The root over two parts is the hull of the L, a pentagonal prism.
TEST_CASE("C interface: a tree over the parts of an L, whose hulls hold their children") {
  const Triangles mesh = l_shape();
  for (const std::string method : {"hacd", "acd"}) {
    for (const std::string tree : {"false", "true"}) {
      CAPTURE(method);
      CAPTURE(tree);
      const Decomposition parts = decompose(mesh, "method=" + method + " tree=" + tree);
      const Tree made = tree_over(parts);
      REQUIRE(convexact_tree_node_count(made.get()) == 3);
      CHECK(convexact_tree_parent(made.get(), 0) == CONVEXACT_NONE);
      CHECK(convexact_tree_part(made.get(), 0) == CONVEXACT_NONE);
      CHECK(convexact_tree_vertex_count(made.get(), 0) == 10);
      CHECK(convexact_tree_face_count(made.get(), 0) == 7);
      REQUIRE(convexact_tree_child_count(made.get(), 0) == 2);
      std::size_t seen = 0;
      for (std::size_t c = 0; c < 2; ++c) {
        const std::size_t child = convexact_tree_children(made.get(), 0)[c];
        REQUIRE((child == 1 || child == 2));
        CHECK(convexact_tree_parent(made.get(), child) == 0);
        CHECK(convexact_tree_child_count(made.get(), child) == 0);
        const std::size_t part = convexact_tree_part(made.get(), child);
        REQUIRE(part < 2);
        seen |= std::size_t(1) << part;
        CHECK(convexact_tree_vertex_count(made.get(), child) ==
              convexact_decomposition_vertex_count(parts.get(), part));
      }
      CHECK(seen == 3);  // each part once
      std::size_t corners = 0;
      for (std::size_t f = 0; f < 7; ++f) {
        corners += convexact_tree_face_sizes(made.get(), 0)[f];
      }
      CHECK(corners == 30);  // two pentagons and five squares
      for (std::size_t c = 0; c < corners; ++c) {
        CHECK(convexact_tree_corners(made.get(), 0)[c] < 10);
      }
      const Judged judged = judge_nodes(mesh, Nodes(made));
      CHECK(judged.holds);
      CHECK(judged.claims.at("tree-nested") == "holds");
      CHECK(judged.claims.at("covers-surface") == "holds");
    }
  }
}

TEST_CASE("C interface: branches with fewer planes, floats, and a tree of one part") {
  const Triangles mesh = l_shape();
  const Tree tree = tree_over(decompose(mesh, kHacd), "faces=6 precision=32");
  CHECK(convexact_tree_face_count(tree.get(), 0) == 6);  // the square's prism
  CHECK(judge_nodes(mesh, Nodes(tree)).holds);
  const Tree single = tree_over(decompose(mesh, kOnePart));
  REQUIRE(convexact_tree_node_count(single.get()) == 1);
  CHECK(convexact_tree_parent(single.get(), 0) == CONVEXACT_NONE);
  CHECK(convexact_tree_part(single.get(), 0) == 0);
  CHECK(judge_nodes(mesh, Nodes(single)).holds);
  const Tree simple = tree_over(decompose(mesh, kOnePart), "leaf_faces=6");
  CHECK(convexact_tree_face_count(simple.get(), 0) == 6);
}

TEST_CASE("C interface: a tree of which something is wrong is a violated claim") {
  const Triangles mesh = l_shape();
  const Nodes good(tree_over(decompose(mesh, kHacd)));
  Nodes nodes = good;
  for (std::size_t i = 0; i < 3 * nodes.vertex_counts[0]; ++i) nodes.vertices[i] *= 0.5;
  const Judged shrunk = judge_nodes(mesh, nodes);
  CHECK(shrunk.status == CONVEXACT_OK);
  CHECK_FALSE(shrunk.holds);
  CHECK(shrunk.claims.at("tree-nested") == "violated");
  CHECK(shrunk.sentences.at("tree-nested") != "");
  CHECK(shrunk.claims.at("covers-surface") == "holds");
  nodes = good;
  nodes.parents[1] = CONVEXACT_NONE;  // a second root
  CHECK(judge_nodes(mesh, nodes).claims.at("tree-nested") == "violated");
  nodes = good;
  nodes.parents[0] = 1;  // a cycle, and no root
  CHECK(judge_nodes(mesh, nodes).claims.at("tree-nested") == "violated");
  // Parts alone are under no tree.
  CHECK(judge_nodes(mesh, good, "claims=tree-nested").holds);
  const Judged none = judge(mesh, Parts(decompose(mesh, kHacd)), "claims=tree-nested");
  CHECK_FALSE(none.holds);
  CHECK(none.claims.at("tree-nested") == "not-applicable");
}

TEST_CASE("C interface: trees that make no sense are a status") {
  const Triangles mesh = l_shape();
  const Decomposition parts = decompose(mesh, kHacd);
  convexact_tree* tree = nullptr;
  CHECK(convexact_decomposition_tree(nullptr, nullptr, &tree) == CONVEXACT_INVALID_ARGUMENT);
  CHECK(convexact_decomposition_tree(parts.get(), nullptr, nullptr) == CONVEXACT_INVALID_ARGUMENT);
  for (const char* options : {"size=0", "faces=3", "leaf_faces=3", "precision=16"}) {
    CAPTURE(options);
    CHECK(convexact_decomposition_tree(parts.get(), options, &tree) == CONVEXACT_INVALID_ARGUMENT);
    CHECK(tree == nullptr);
  }
  convexact_tree_free(nullptr);
  const Nodes good(tree_over(parts));
  Nodes nodes = good;
  nodes.parents[1] = 3;  // of three nodes
  CHECK(judge_nodes(mesh, nodes).status == CONVEXACT_INVALID_ARGUMENT);
  nodes = good;
  nodes.vertex_counts[2] = 0;
  CHECK(judge_nodes(mesh, nodes).status == CONVEXACT_INVALID_ARGUMENT);
  nodes = good;
  nodes.vertices[5] = std::numeric_limits<double>::infinity();
  CHECK(judge_nodes(mesh, nodes).status == CONVEXACT_NOT_FINITE);
  nodes = good;
  nodes.parents.clear();
  CHECK(judge_nodes(mesh, nodes).status == CONVEXACT_INVALID_ARGUMENT);
  convexact_verdict* result = nullptr;
  CHECK(convexact_verify_tree(mesh.points.data(), mesh.point_count(), mesh.corners.data(),
                              mesh.count(), good.vertices.data(), good.vertex_counts.data(),
                              nullptr, 3, nullptr, &result) == CONVEXACT_INVALID_ARGUMENT);
  CHECK(result == nullptr);
}

TEST_CASE("C interface: threads decompose at once, and read one result together") {
  const Triangles mesh = l_shape();
  const Decomposition shared = decompose(mesh, kHacd);
  std::vector<std::size_t> counts(4);
  std::vector<std::thread> threads;
  for (std::size_t& count : counts) {
    threads.emplace_back([&] {
      convexact_decomposition* own = nullptr;
      if (convexact_decompose(mesh.points.data(), mesh.point_count(), mesh.corners.data(),
                              mesh.count(), nullptr, &own) != CONVEXACT_OK) {
        return;
      }
      std::vector<double> planes(4 * convexact_decomposition_plane_count(shared.get(), 0));
      const auto status = convexact_decomposition_planes(shared.get(), 0, planes.data());
      if (status == CONVEXACT_OK) count = convexact_decomposition_part_count(own);
      convexact_decomposition_free(own);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::size_t count : counts) CHECK(count == 2);
}
