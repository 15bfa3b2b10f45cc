// SPDX-License-Identifier: MIT
// Every shipped mesh in every format and precision: an exact test of the bytes, with a parser and a
// checker that share no code with the library, finds no input point outside.
#include <doctest/doctest.h>

#include <cstdlib>
#include <set>

#include "convexact/io.hpp"
#include "convexact/stored.hpp"
#include "shapes/makers.hpp"
#include "stored_cases.hpp"

using namespace convexact;
using namespace stored_cases;

namespace {

PointSet shipped(const std::string& name) {
  return read_mesh(std::string(std::getenv("CONVEXACT_TEST_DATA")) + "/" + name).points;
}

// A valid result of about `count` halfspaces: for directions all around, the facet plane whose
// normal is the nearest.
Case enclose(const PointSet& input, std::uint32_t count) {
  Case c = *hull_case(input);
  std::set<std::size_t> chosen;
  for (const Point& direction : shapes::fibonacci_sphere(count)) {
    std::size_t best = 0;
    double most = -2;
    for (std::size_t i = 0; i < c.exact.planes.size(); ++i) {
      const IntegerVector3& n = c.exact.planes[i].normal();
      const Point normal(n[0].convert_to<double>(), n[1].convert_to<double>(),
                         n[2].convert_to<double>());
      const double cosine = normal.normalized().dot(direction);
      if (cosine > most) most = cosine, best = i;
    }
    chosen.insert(best);
  }
  std::vector<Halfspace> kept;
  for (const std::size_t i : chosen) kept.push_back(c.exact.planes[i]);
  c.exact = solid_of(kept, c.input, c.witnesses);
  return c;
}

struct FileKind {
  MeshFormat format;
  const char* extension;
  Encoding encoding;
  bool any_precision;  // else binary32 only
};

const FileKind kFileKinds[] = {{MeshFormat::Obj, "obj", Encoding::Text, true},
                               {MeshFormat::Off, "off", Encoding::Text, true},
                               {MeshFormat::Ply, "ply", Encoding::Text, true},
                               {MeshFormat::Ply, "ply", Encoding::Binary, true},
                               {MeshFormat::Stl, "stl", Encoding::Text, true},
                               {MeshFormat::Stl, "stl", Encoding::Binary, false}};

void check_files(const Case& c, const std::vector<stored_checker::Homogeneous>& input) {
  for (const Precision precision : kPrecisions) {
    const StoredMesh stored = store_mesh(c.exact, c.input, c.witnesses, precision);
    for (const FileKind& kind : kFileKinds) {
      if (precision == Precision::Binary64 && !kind.any_precision) continue;
      CAPTURE(std::string(kind.extension));
      CAPTURE(significand_bits(precision));
      const std::string bytes =
          write_mesh(stored.mesh, kind.format, {.precision = precision, .encoding = kind.encoding});
      const auto planes = stored_checker::hull_planes(stored_file::parse(bytes, kind.extension));
      CHECK(planes.size() >= 4);
      CHECK(stored_checker::count_outside(planes, input) == 0);
      // The proof that a run makes before it renames the file into place.
      const Mesh read = read_mesh_bytes(bytes, {.format = kind.format});
      CHECK(count_outside_hull(read.points, c.input) == 0);
    }
  }
}

void check_planes(const Case& c, const std::vector<stored_checker::Homogeneous>& input) {
  for (const Precision precision : kPrecisions) {
    const StoredPlanes stored = store_planes(c.exact, c.input, c.witnesses, precision);
    std::vector<stored_checker::Plane> planes;
    for (const auto& p : stored.planes) planes.push_back(stored_checker::plane(p));
    CHECK(stored_checker::count_outside(planes, input) == 0);
    CHECK(stored_checker::is_bounded(planes));
  }
}

}  // namespace

TEST_CASE("stored files: no point of a shipped mesh is outside, whatever the format") {
  for (const char* name : {"bunny.obj", "spot.obj", "teapot.obj"}) {
    CAPTURE(std::string(name));
    const PointSet points = shipped(name);
    const Case c = enclose(points, 18);
    const auto input = to_homogeneous(points);
    check_files(c, input);
    check_planes(c, input);
  }
}

TEST_CASE("stored files: the whole hull of a shipped mesh") {
  const PointSet points = shipped("spot.obj");
  const Case c = *hull_case(points);
  // All points against all facets takes minutes in GMP: the hull's vertices stand for the others.
  std::vector<RationalPoint> vertices;
  for (const PointId id : c.witnesses) vertices.push_back(points[id]);
  check_files(c, to_homogeneous(PointSet(vertices)));
}

TEST_CASE("stored files: the rounding is needed, to nearest cuts input points off") {
  // So that the cases above could fail: vertices rounded to nearest floats, not pushed.
  const PointSet points = shipped("spot.obj");
  const Case c = enclose(points, 18);
  std::vector<Point> nearest;
  for (const RationalPoint& v : c.exact.vertices) {
    Point p;
    for (int k = 0; k < 3; ++k) p[k] = to_float(v[k], Rounding::Nearest);
    nearest.push_back(p);
  }
  CHECK(count_outside_hull(PointSet(nearest), points) > 0);
  const StoredMesh stored = store_mesh(c.exact, c.input, c.witnesses, Precision::Binary32);
  CHECK(count_outside_hull(stored.mesh.points, points) == 0);
}
