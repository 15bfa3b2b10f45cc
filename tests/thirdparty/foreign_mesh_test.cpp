// SPDX-License-Identifier: MIT
// The oracle's verdict on meshes that another program wrote: CGAL computes the hull of each shipped
// mesh in doubles and writes it as OFF, with 17 digits, with 6 and with 3. What is outside, and by
// how much, is then found once more by CGAL's exact kernel, which reads the same file back: every
// point against every facet of the exact hull, and the distance to the nearest triangle of it.
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>

#include "convexact/io.hpp"
#include "convexact/verify.hpp"
#include "shipped_meshes.hpp"
using namespace convexact;

namespace {

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Doubles = CGAL::Exact_predicates_inexact_constructions_kernel;

std::string hull_as_off(const PointSet& points, int digits) {
  std::vector<Doubles::Point_3> input;
  for (const Point& p : points.doubles()) input.emplace_back(p[0], p[1], p[2]);
  CGAL::Surface_mesh<Doubles::Point_3> hull;
  CGAL::convex_hull_3(input.begin(), input.end(), hull);
  std::ostringstream file;
  file.precision(digits);
  file << hull;
  return file.str();
}

struct Truth {
  std::size_t outside = 0;
  Rational worst = 0;
};

Truth by_cgal(const std::string& off, const PointSet& points) {
  std::istringstream file(off);
  CGAL::Surface_mesh<Doubles::Point_3> read;
  file >> read;
  std::vector<Exact::Point_3> corners;
  for (const auto v : read.vertices()) {
    const auto& p = read.point(v);
    corners.emplace_back(p.x(), p.y(), p.z());
  }
  CGAL::Surface_mesh<Exact::Point_3> hull;
  CGAL::convex_hull_3(corners.begin(), corners.end(), hull);
  std::vector<Exact::Triangle_3> triangles;
  for (const auto face : hull.faces()) {
    std::vector<Exact::Point_3> c;
    for (const auto v : CGAL::vertices_around_face(hull.halfedge(face), hull)) {
      c.push_back(hull.point(v));
    }
    triangles.emplace_back(c[0], c[1], c[2]);
  }
  using Primitive = CGAL::AABB_triangle_primitive<Exact, std::vector<Exact::Triangle_3>::iterator>;
  const CGAL::AABB_tree<CGAL::AABB_traits<Exact, Primitive> > tree(triangles.begin(),
                                                                   triangles.end());
  Truth truth;
  for (const Point& point : points.doubles()) {
    const Exact::Point_3 p(point[0], point[1], point[2]);
    const bool is_outside =
        std::any_of(triangles.begin(), triangles.end(), [&](const Exact::Triangle_3& t) {
          return CGAL::orientation(t[0], t[1], t[2], p) == CGAL::POSITIVE;
        });
    if (!is_outside) continue;
    ++truth.outside;
    std::ostringstream distance;
    distance << CGAL::exact(tree.squared_distance(p));
    truth.worst = std::max(truth.worst, parse_rational(distance.str()));
  }
  return truth;
}

}  // namespace

TEST_CASE("verify: hulls by CGAL, as CGAL itself judges them exactly") {
  std::size_t faulty = 0;
  for (const std::string& path : shipped_meshes()) {
    const PointSet points = read_mesh(path).points;
    for (const int digits : {17, 6, 3}) {
      CAPTURE(path);
      CAPTURE(digits);
      const std::string off = hull_as_off(points, digits);
      VerifyRequest request;
      request.tightness = false;
      const auto outcome = verify(points, read_candidate_bytes(off, "hull.off"), request);
      const auto& verdict = std::get<Verdict>(outcome);
      const Truth truth = by_cgal(off, points);
      REQUIRE(verdict.outside.has_value());
      CHECK(verdict.outside->points == truth.outside);
      const Claim& contains = verdict[ClaimCode::ContainsInput];
      CHECK((contains.status == Status::Holds) == (truth.outside == 0));
      CHECK(contains.witness.squared_distance.value_or(0) == truth.worst);
      if (digits == 17) CHECK(verdict.holds());
      faulty += truth.outside > 0 ? 1 : 0;
    }
  }
  CHECK(faulty > 0);  // else nothing was put to the test
}
