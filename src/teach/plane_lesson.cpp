// SPDX-License-Identifier: MIT
#include "teach/plane_lesson.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <vector>

#include "convexact/hull.hpp"
#include "io/json.hpp"
#include "number/arithmetic.hpp"
#include "number/text.hpp"
#include "pages/page_parts.hpp"
#include "teach/lesson_parts.hpp"

namespace convexact {
namespace {

void require_one_plane(const PointSet& points) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Rational z = points[PointId(i)].z(), first = points[PointId(std::size_t{0})].z();
    if (z == first) continue;
    reject_argument(fmt::format(
        "a lesson in the plane takes points with one z; point 0 has {}, point {} has {}",
        first.str(), i, z.str()));
  }
  const HullOutcome outcome = convex_hull(points);
  const auto* flat = std::get_if<FlatInput>(&outcome);
  if (flat == nullptr || flat->dimension == 2) return;
  throw Error(ErrorCode::NoInterior,
              "a lesson in the plane needs three points that are not in "
              "line: " +
                  describe(NotSolid(*flat)));
}

using PlanePoint = std::array<Rational, 2>;

// Positive if c lies on the left of a -> b.
Sign turn(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return sign_of(Rational((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])));
}

// Whether x, which is in line with a and b, lies between them or on one.
bool is_between(const PlanePoint& a, const PlanePoint& b, const PlanePoint& x) {
  const auto within = [&](int k) {
    return std::min(a[k], b[k]) <= x[k] && x[k] <= std::max(a[k], b[k]);
  };
  return within(0) && within(1);
}

// Whether the segments ab and cd have a point in common.
bool do_meet(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d) {
  const Sign s[] = {turn(a, b, c), turn(a, b, d), turn(c, d, a), turn(c, d, b)};
  if (s[0] * s[1] == Sign::Negative && s[2] * s[3] == Sign::Negative) return true;
  return (s[0] == Sign::Zero && is_between(a, b, c)) ||
         (s[1] == Sign::Zero && is_between(a, b, d)) ||
         (s[2] == Sign::Zero && is_between(c, d, a)) || (s[3] == Sign::Zero && is_between(c, d, b));
}

// No two sides have a point in common, but for the corner of neighbours.
void require_simple(const std::vector<PlanePoint>& corners) {
  const std::size_t n = corners.size();
  const auto corner = [&](std::size_t k) -> const PlanePoint& { return corners[k % n]; };
  for (std::size_t i = 0; i < n; ++i) {
    const bool turns_back = turn(corner(i), corner(i + 1), corner(i + 2)) == Sign::Zero &&
                            !is_between(corner(i), corner(i + 2), corner(i + 1));
    bool crosses = turns_back || corner(i) == corner(i + 1);
    for (std::size_t k = i + 2; k < n && k + 1 < i + n; ++k) {
      crosses = crosses || do_meet(corner(i), corner(i + 1), corner(k), corner(k + 1));
    }
    if (crosses) {
      reject_argument(
          fmt::format("a lesson on parts takes a polygon whose sides meet at corners only; side {} "
                      "meets others",
                      i));
    }
  }
}

// The points that the page begins with: the corners of the face, or all.
std::vector<PlanePoint> points_of(const SceneObject& object, const PointSet& points) {
  std::vector<PlanePoint> found;
  const auto take = [&](std::size_t id) {
    const RationalPoint p = points[PointId(id)];
    found.push_back({p.x(), p.y()});
  };
  if (object.polygons.empty()) {
    for (std::size_t i = 0; i < points.size(); ++i) take(i);
    return found;
  }
  if (object.polygons.size() > 1) {
    reject_argument(
        fmt::format("a lesson on parts takes one face, found {}; points without faces "
                    "give the lesson on halfplanes",
                    object.polygons.size()));
  }
  for (const std::uint32_t id : object.polygons.front()) take(id);
  require_simple(found);
  return found;
}

}  // namespace

std::string plane_lesson_page(const SceneObject& object) {
  const auto* points = std::get_if<PointSet>(&object.shape);
  if (points == nullptr) {
    reject_argument("a lesson in the plane takes points, not halfspaces");
  }
  if (points->size() > kMostPlanePoints) {
    reject_argument(fmt::format("a lesson in the plane shows at most {} points, found {}",
                                kMostPlanePoints, points->size()));
  }
  require_one_plane(*points);
  Json rows = Json::array();
  for (const auto& [x, y] : points_of(object, *points)) {
    rows.push_back(Json::array({x.str(), y.str()}));
  }
  const bool is_about_parts = !object.polygons.empty();
  const std::string name = as_utf8(std::filesystem::path(object.name).filename().string());
  return fill_page(kPlanePage, {{"TITLE", escaped_markup(name)},
                                {"SUBTITLE", is_about_parts ? "in few convex parts"
                                                            : "enclosed in few halfplanes"},
                                {"STYLE", kPlaneStyle},
                                {"DATA", for_script_element(write_json(Json{{"points", rows}}))},
                                {"SCRIPT", is_about_parts ? kPartsScript : kHalfplanesScript}});
}

}  // namespace convexact
