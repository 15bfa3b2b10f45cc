// SPDX-License-Identifier: MIT
#include <algorithm>

#include "capi/arrays.hpp"
#include "capi/guarded.hpp"
#include "convexact/simplify.hpp"

struct convexact_solid {
  std::vector<std::array<double, 4>> planes;
  std::vector<std::string> texts;  // before rounding
};

namespace convexact::capi {
namespace {

convexact_solid simplify_points(PointSet points, std::size_t plane_count) {
  SimplifyRequest request;
  request.faces = plane_count;
  request.store.planes = Precision::Binary64;
  const SimplifyOutcome outcome = simplify(std::move(points), request);
  const auto* result = std::get_if<SimplifyResult>(&outcome);
  if (result == nullptr) throw Error(ErrorCode::NoInterior, "the points lie in one plane");
  convexact_solid solid{result->solid.planes->planes, {}};
  for (const Halfspace& plane : result->solid.exact.planes) solid.texts.push_back(to_text(plane));
  return solid;
}

}  // namespace
}  // namespace convexact::capi

using namespace convexact::capi;

convexact_status convexact_simplify(const double* points, size_t point_count, size_t plane_count,
                                    convexact_solid** result) {
  return guarded(result,
                 [&] { return simplify_points(to_points(points, point_count), plane_count); });
}

size_t convexact_solid_plane_count(const convexact_solid* result) { return result->planes.size(); }
void convexact_solid_plane(const convexact_solid* result, size_t i, double plane[4]) {
  std::copy_n(result->planes[i].begin(), 4, plane);
}
const char* convexact_solid_plane_text(const convexact_solid* result, size_t i) {
  return result->texts[i].c_str();
}
void convexact_solid_free(convexact_solid* result) { delete result; }
