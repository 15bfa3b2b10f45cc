// SPDX-License-Identifier: MIT
// The float engine on the very inputs that the proven engines are compared on: it ends, its solid
// is bounded, what is written of it holds every input point, and where it ends early or refuses,
// the reason is a documented one. Judged by stored_checker, which shares no code with the library.
#include <doctest/doctest.h>

#include "check_bounded.hpp"
#include "check_float_bound.hpp"
#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "convexact/simplify.hpp"
#include "fast/cap.hpp"
#include "fast/engines.hpp"
#include "hard_inputs.hpp"
#include "oracle/order/removal_cost.hpp"
#include "stored_cases.hpp"

using namespace convexact;

namespace {

struct Seen {
  std::size_t runs = 0, vouched = 0, early = 0, refused_planes = 0, refused_mesh = 0;
};

using Homogeneous = std::vector<stored_checker::Homogeneous>;

// The whole pipeline; nothing if the format cannot hold the solid, for a reason that docs/stored.md
// gives. Any other error is a failure.
std::optional<SimplifyResult> run_pipeline(const PointSet& points, std::size_t faces,
                                           const StoreRequest& store, std::uint64_t seed) {
  SimplifyRequest request;
  request.faces = faces;
  request.engine = Engine::Float;
  request.seed = seed;
  request.store = store;
  try {
    return std::get<SimplifyResult>(simplify(points, request));
  } catch (const Error& error) {
    REQUIRE_MESSAGE(error.code() == ErrorCode::Unrepresentable, error.what());
    return {};
  }
}

void check_exact_planes(const SimplifyResult& result, const Homogeneous& input) {
  std::vector<stored_checker::Plane> planes;
  for (const Halfspace& h : result.solid.exact.planes) {
    planes.push_back(stored_cases::to_plane(h));
  }
  CHECK(stored_checker::count_outside(planes, input) == 0);
  CHECK(stored_checker::is_bounded(planes));
}

bool check_stored_planes(const PointSet& points, std::size_t faces, Precision precision,
                         const Homogeneous& input, std::uint64_t seed) {
  const auto result = run_pipeline(points, faces, {.planes = precision, .mesh = {}}, seed);
  if (!result) return false;
  std::vector<stored_checker::Plane> planes;
  for (const auto& p : result->solid.planes->planes) planes.push_back(stored_checker::plane(p));
  CHECK(stored_checker::count_outside(planes, input) == 0);
  CHECK(stored_checker::is_bounded(planes));
  return true;
}

bool check_stored_mesh(const PointSet& points, std::size_t faces, Precision precision,
                       const Homogeneous& input, std::uint64_t seed) {
  const auto result = run_pipeline(points, faces, {.planes = {}, .mesh = precision}, seed);
  if (!result) return false;
  const std::string bytes =
      write_mesh(result->solid.mesh->mesh, MeshFormat::Obj, {.precision = precision});
  const auto planes = stored_checker::hull_planes(stored_file::parse(bytes, "obj"));
  CHECK(planes.size() >= 4);
  CHECK(stored_checker::count_outside(planes, input) == 0);
  return true;
}

// Whether doubles, by the bounds that hold for the whole ring, prove of any three of its planes
// that they meet in a vertex or in none, and of any fourth one on which side of it that passes.
bool are_signs_certain(const FastDual& dual, HalfspaceId i, const OneRing& ring) {
  RingGeometry<double> geometry;
  geometry.load(i, ring.vertices, [&](HalfspaceId v) { return dual.near(v); });
  const PlaneFilter bound = geometry.filter(Roundoff<double>::kUnit);
  std::vector<Triple<double>> points = geometry.point;
  points.push_back(geometry.center);
  for (std::size_t c = 0; c < points.size(); ++c) {
    for (std::size_t b = 0; b < c; ++b) {
      for (std::size_t a = 0; a < b; ++a) {
        const auto normal = cross(points[b] - points[a], points[c] - points[a]);
        if (std::abs(dot(normal, points[a])) <= bound.determinant) return false;
        for (std::size_t d = 0; d < a; ++d) {
          if (std::abs(dot(normal, points[d] - points[a])) <= bound.height) return false;
        }
      }
    }
  }
  return true;
}

// A run that ends above the wanted number must have reason to: every further removal is unbounded,
// or doubles cannot tell the topology of what would be left.
void check_reason_to_end(const FastDual& dual, const FastResult& result) {
  const HalfEdgeMesh mesh(dual.size(), result.triangles);
  FilteredCap cap(dual, mesh, CostMeasure::Volume, 1);
  for (const HalfspaceId i : result.survivors) {
    cap.prepare(i);
    if (cap.in_doubles().kind == Boundedness::Unbounded) continue;
    CHECK_FALSE(are_signs_certain(dual, i, cap.ring()));
  }
}

void check(std::uint32_t i, const std::vector<Point>& points, Seen& seen) {
  const PointSet set(points);
  const HullOutcome outcome = convex_hull(set, {.seed = i});
  const Hull* hull = std::get_if<Hull>(&outcome);
  if (hull == nullptr) return;
  ++seen.runs;
  const FastDual dual = FastDual::of(*hull, set);
  const FastResult result = simplify_float(dual, {.seed = i});
  CHECK(result.survivors.size() + result.steps.size() == dual.size());
  check_bounded(dual, result);
  check_float_bound(dual, result);
  if (i % 4 == 1) {
    const CostMeasure cost = i % 8 == 1 ? CostMeasure::Area : CostMeasure::MeanWidth;
    check_float_bound(dual, simplify_float(dual, {.cost = cost, .seed = i}), cost);
  }
  seen.vouched += result.bound->is_vouched();
  if (result.survivors.size() > 4) {
    CHECK(result.stop == StopReason::AllUnbounded);
    check_reason_to_end(dual, result);
    ++seen.early;
  } else {
    CHECK(result.stop == StopReason::Reached);
  }

  const std::size_t faces = 4 + i % 9;
  const Homogeneous input = stored_cases::to_homogeneous(set);
  const auto plain = run_pipeline(set, faces, {}, i);
  REQUIRE(plain.has_value());  // exact integers hold everything
  CHECK((plain->stop == StopReason::AllUnbounded || plain->solid.exact.planes.size() <= faces ||
         plain->steps == 0));
  check_exact_planes(*plain, input);
  const Precision precision = i % 3 == 0 ? Precision::Binary32 : Precision::Binary64;
  seen.refused_planes += !check_stored_planes(set, faces, precision, input, i);
  seen.refused_mesh += !check_stored_mesh(set, faces, precision, input, i);
}

Seen check(std::string_view kind) {
  Seen seen;
  hard::for_each(kind, [&](std::uint32_t i, const std::vector<Point>& points) {
    CAPTURE(std::string(kind));
    CAPTURE(i);
    check(i, points, seen);
  });
  CHECK(seen.runs * 4 >= hard::named(kind).count / hard::stride() * 3);
  MESSAGE(std::string(kind) << ": " << seen.runs << " runs, " << seen.early
                            << " with more than 4 left, " << seen.vouched
                            << " vouched for; refused: " << seen.refused_planes << " planes, "
                            << seen.refused_mesh << " meshes");
  return seen;
}

}  // namespace

TEST_CASE("float: lattices and grids") {
  for (const char* kind : {"lattice", "grid part", "nudged lattice", "nudged grid"}) check(kind);
}
TEST_CASE("float: over polygons") {
  for (const char* kind : {"over a polygon", "nudged over a polygon", "turned over a polygon"}) {
    check(kind);
  }
}
TEST_CASE("float: boxes") {
  for (const char* kind : {"box", "nudged box"}) check(kind);
}
TEST_CASE("float: symmetric and round") {
  for (const char* kind : {"symmetric", "integer sphere", "sphere", "regular"}) check(kind);
}
TEST_CASE("float: needles and scales") {
  for (const char* kind :
       {"needle", "squeezed", "far away", "scaled", "mixed exponents", "barely nudged"}) {
    check(kind);
  }
}
TEST_CASE("float: near planes and high valence") {
  for (const char* kind : {"near a plane", "repeated", "high valence"}) check(kind);
}
