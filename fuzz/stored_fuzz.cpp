// SPDX-License-Identifier: MIT
// Property of stored: for the result of any engine on a few points, planes and meshes stored in
// binary64 and binary32 consist of numbers of the format, are bounded and hold every point, all in
// rationals and from the definition; or they are refused because the format cannot hold them.
#include "convexact/error.hpp"
#include "convexact/simplify.hpp"
#include "fuzz_check.hpp"
#include "fuzz_target.hpp"
#include "hard_numbers.hpp"
#include "stored_cases.hpp"

using namespace convexact;

namespace {

PointSet some_points(FuzzInput& in) {
  const std::size_t most = in.rarely() ? 16 : 6;
  if (in.below(3) == 0) {
    std::vector<RationalPoint> thirds;
    for (const Point& p : in.grid_points(most, 3)) thirds.push_back(to_rational(p) / Rational(3));
    return PointSet(thirds);
  }
  HardNumbers numbers(in);
  std::vector<Point> points;
  for (std::size_t count = in.below(most + 1); count > 0; --count) {
    points.push_back(numbers.point());
  }
  return PointSet(points);
}

bool is_of(Precision precision, double x) {
  return precision == Precision::Binary64 || static_cast<double>(static_cast<float>(x)) == x;
}

void check_planes(const StoredPlanes& stored, const SimplifyResult& result,
                  const std::vector<stored_checker::Homogeneous>& points) {
  std::vector<stored_checker::Plane> planes;
  for (const std::array<double, 4>& p : stored.planes) {
    for (const double x : p) FUZZ_CHECK(is_of(stored.precision, x));
    planes.push_back(stored_checker::plane(p));
  }
  FUZZ_CHECK(planes.size() == result.solid.exact.planes.size());
  FUZZ_CHECK(stored_checker::is_bounded(planes));
  FUZZ_CHECK(stored_checker::count_outside(planes, points) == 0);
}

void check_mesh(const StoredMesh& stored, const std::vector<stored_checker::Homogeneous>& points) {
  stored_file::Solid solid;
  for (const Point& p : stored.mesh.points.doubles()) {
    for (const double x : p) FUZZ_CHECK(is_of(stored.precision, x));
    solid.vertices.push_back({p[0], p[1], p[2]});
  }
  for (const auto& polygon : stored.mesh.polygons) {
    solid.polygons.emplace_back(polygon.begin(), polygon.end());
  }
  const std::vector<stored_checker::Plane> planes = stored_checker::hull_planes(solid);
  FUZZ_CHECK(planes.size() >= 4);
  FUZZ_CHECK(stored_checker::count_outside(planes, points) == 0);
}

void hold_stored(FuzzInput& in) {
  SimplifyRequest request;
  request.faces = 4 + in.below(6);
  request.engine = in.below(3) == 0 ? Engine::Filtered : Engine::Float;
  request.verify = VerifyLevel::None;
  const Precision precision = in.below(2) == 0 ? Precision::Binary64 : Precision::Binary32;
  const bool wants_mesh = in.below(2) == 0;
  (wants_mesh ? request.store.mesh : request.store.planes) = precision;
  const PointSet points = some_points(in);
  try {
    const SimplifyOutcome outcome = simplify(points, request);
    const auto* result = std::get_if<SimplifyResult>(&outcome);
    if (result == nullptr) return;
    const auto input = stored_cases::to_homogeneous(points);
    if (wants_mesh) check_mesh(result->solid.mesh.value(), input);
    if (!wants_mesh) check_planes(result->solid.planes.value(), *result, input);
  } catch (const Error& error) {
    FUZZ_CHECK(error.code() == ErrorCode::Unrepresentable);
  }
}

const FuzzTarget kStored("stored", hold_stored);

}  // namespace
