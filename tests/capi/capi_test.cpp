// SPDX-License-Identifier: MIT
// The C interface on a cube, where every distance has a closed form: verdicts, witnesses, errors.
#include <convexact.h>
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <limits>
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

TEST_CASE("C interface: simplify encloses, in doubles and exactly") {
  Numbers points = cube();
  points[21] = 3.5;  // the corner (4, 4, 4) becomes (3.5, 4, 4)
  convexact_solid* solid = nullptr;
  REQUIRE(convexact_simplify(points.data(), 8, 6, &solid) == CONVEXACT_OK);
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

  CHECK(convexact_simplify(points.data(), 8, 3, &solid) == CONVEXACT_INVALID_ARGUMENT);
  CHECK(solid == nullptr);
  CHECK(convexact_simplify(points.data(), 3, 6, &solid) == CONVEXACT_NO_INTERIOR);
  CHECK(convexact_simplify(points.data(), 8, 6, nullptr) == CONVEXACT_INVALID_ARGUMENT);
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
