// SPDX-License-Identifier: MIT
#include <cmath>

#include "capi/arrays.hpp"
#include "capi/guarded.hpp"
#include "convexact/hull.hpp"
#include "convexact/number.hpp"
#include "convexact/scene.hpp"
#include "convexact/stored.hpp"
#include "number/precision.hpp"
#include "oracle/solid/excess.hpp"
#include "solid/solid.hpp"

struct convexact_containment {
  std::size_t outside = 0, point = 0, plane = 0;
  std::string plane_text = "0", squared_distance = "0";
  double distance = 0;
};

namespace convexact::capi {
namespace {

convexact_containment containment_in(std::span<const Halfspace> planes, const PointSet& points) {
  convexact_containment result;
  result.outside = count_outside(planes, points);
  if (result.outside == 0) return result;
  const std::optional<Excess> worst = find_excess(planes, points);
  if (!worst) throw Error(ErrorCode::Internal, "a point is outside, but beyond no plane");
  result.point = worst->point.index();
  result.plane = worst->plane;
  result.plane_text = to_text(planes[worst->plane]);
  result.squared_distance = to_string(worst->squared_distance);
  result.distance =
      to_double(sqrt(Enclosure(worst->squared_distance, kMeasureBits)).high(), Rounding::Up);
  return result;
}

convexact_containment verify_planes(const PointSet& points, const HalfspaceList& list) {
  if (list.impossible_row) {
    return {.outside = points.size(),
            .plane = *list.impossible_row,
            .plane_text = "0 0 0 1",
            .squared_distance = "inf",
            .distance = std::numeric_limits<double>::infinity()};
  }
  convexact_containment result = containment_in(list.halfspaces, points);
  if (result.outside > 0) result.plane = list.rows[result.plane];
  return result;
}

convexact_containment verify_vertices(const PointSet& points, const PointSet& vertices) {
  StageLog log;
  const auto outcome = make_hull(vertices, {}, log);
  const auto* hull = std::get_if<Hull>(&outcome);
  if (hull == nullptr) throw Error(ErrorCode::NoInterior, "the vertices lie in one plane");
  return containment_in(facet_halfspaces(*hull, vertices), points);
}

}  // namespace
}  // namespace convexact::capi

using namespace convexact::capi;

convexact_status convexact_verify_planes(const double* points, size_t point_count,
                                         const double* planes, size_t plane_count,
                                         convexact_containment** result) {
  return guarded(result, [&] {
    return verify_planes(to_points(points, point_count), to_list(planes, plane_count));
  });
}

convexact_status convexact_verify_vertices(const double* points, size_t point_count,
                                           const double* vertices, size_t vertex_count,
                                           convexact_containment** result) {
  return guarded(result, [&] {
    return verify_vertices(to_points(points, point_count),
                           to_points(vertices, vertex_count, "vertices"));
  });
}

int convexact_containment_holds(const convexact_containment* result) {
  return result->outside == 0;
}
size_t convexact_containment_outside(const convexact_containment* result) {
  return result->outside;
}
size_t convexact_containment_point(const convexact_containment* result) { return result->point; }
size_t convexact_containment_plane(const convexact_containment* result) { return result->plane; }
const char* convexact_containment_plane_text(const convexact_containment* result) {
  return result->plane_text.c_str();
}
const char* convexact_containment_squared_distance(const convexact_containment* result) {
  return result->squared_distance.c_str();
}
double convexact_containment_distance(const convexact_containment* result) {
  return result->distance;
}
void convexact_containment_free(convexact_containment* result) { delete result; }
