// SPDX-License-Identifier: MIT
// Thousands of candidates, each a good one with something broken: bits of the file, vertices off by
// an ulp, faces lost, turned or doubled, planes tilted. The verdict must always be the one that the
// definitions give (tests/support/verdict_check.hpp), without a crash.
#include <doctest/doctest.h>

#include <cmath>

#include "convexact/io.hpp"
#include "convexact/verify.hpp"
#include "hard_inputs.hpp"
#include "perturb.hpp"
#include "shapes/makers.hpp"
#include "verdict_check.hpp"

using namespace convexact;

namespace {

using Points = std::vector<Point>;

std::vector<Points> bases() {
  return {shapes::tetrahedron(),     shapes::cube(),
          shapes::octahedron(),      shapes::in_ball(9, 7),
          shapes::cut_cube(2, 0.25), shapes::in_ball(6, 3),
          shapes::lattice(10, 2, 5)};
}

// The hull of the points as a mesh file would hold it.
Mesh mesh_of(const Points& points) {
  Mesh mesh;
  mesh.points = PointSet(points);
  const HullOutcome outcome = convex_hull(mesh.points);
  const Hull& hull = std::get<Hull>(outcome);
  for (std::size_t f = 0; f < hull.facets.size(); ++f) {
    std::vector<std::uint32_t> polygon;
    for (const PointId p : hull.facets[f]) polygon.push_back(static_cast<std::uint32_t>(p.index()));
    mesh.polygons.push_back(std::move(polygon));
  }
  mesh.parts.push_back({"", 0, mesh.polygons.size()});
  return mesh;
}

std::uint32_t below(Random& random, std::size_t n) {
  return static_cast<std::uint32_t>(uniform_below(random, n));
}

double nudged(double x, Random& random) {
  const double towards = below(random, 2) == 0 ? -1e308 : 1e308;
  return std::nextafter(x, towards);
}

// Breaks the mesh in one of the ways in which programs get it wrong.
void corrupt(Mesh& mesh, Random& random) {
  Points points(mesh.points.doubles().begin(), mesh.points.doubles().end());
  auto& polygons = mesh.polygons;
  const std::uint32_t face = below(random, polygons.size());
  const std::uint32_t v = below(random, points.size());
  switch (below(random, 10)) {
    case 0:
      for (int k = 0; k < 3; ++k) points[v][k] = nudged(points[v][k], random);
      break;
    case 1:
      points[v] *= 0.5;
      break;
    case 2:
      points[v] *= 1 + 0x1p-52;
      break;
    case 3:
      polygons.erase(polygons.begin() + face);
      break;
    case 4:
      std::reverse(polygons[face].begin(), polygons[face].end());
      break;
    case 5:
      for (auto& polygon : polygons) std::reverse(polygon.begin(), polygon.end());
      break;
    case 6:
      polygons.push_back(polygons[face]);
      break;
    case 7:
      polygons[face][below(random, polygons[face].size())] = v;
      break;
    case 8:
      if (polygons[face].size() > 3) polygons[face].pop_back();
      break;
    default:
      points[v] = points[below(random, points.size())];
      break;
  }
  mesh.points = PointSet(std::move(points));
  mesh.parts = {{"", 0, mesh.polygons.size()}};
}

void flip_bits(std::string& bytes, Random& random) {
  if (bytes.empty()) return;
  for (std::uint32_t k = below(random, 3); k > 0; --k) {
    bytes[below(random, bytes.size())] ^= static_cast<char>(1 << below(random, 8));
  }
  if (below(random, 20) == 0) bytes.resize(below(random, bytes.size()));
}

void check(const std::string& bytes, const std::string& path, const Points& input) {
  const Candidate candidate = read_candidate_bytes(bytes, path);
  const PointSet points(input);
  const VerifyOutcome outcome = verify(points, candidate, {});
  const auto& verdict = std::get<Verdict>(outcome);
  CHECK(definition::disagreement(verdict, candidate, points) == "");
}

constexpr std::uint32_t kCandidates = 6000;

}  // namespace

TEST_CASE("verify: corrupted meshes are judged as the definitions say") {
  constexpr MeshFormat kFormats[] = {MeshFormat::Obj, MeshFormat::Off, MeshFormat::Ply,
                                     MeshFormat::Stl};
  constexpr const char* kNames[] = {"c.obj", "c.off", "c.ply", "c.stl"};
  const std::vector<Points> all = bases();
  for (std::uint32_t i = 0; i < kCandidates; i += hard::stride()) {
    CAPTURE(i);
    Random random(i);
    const Points& input = all[i % all.size()];
    Mesh mesh = mesh_of(input);
    const std::uint32_t way = below(random, 4);
    if (way != 0) corrupt(mesh, random);
    const std::size_t format = below(random, 4);
    const Precision precision =
        kFormats[format] == MeshFormat::Stl ? Precision::Binary32 : Precision::Binary64;
    std::string bytes;
    try {
      const bool binary = kFormats[format] == MeshFormat::Stl || below(random, 2) == 0;
      bytes = write_mesh(mesh, kFormats[format],
                         {.precision = precision,
                          .encoding = binary && kFormats[format] != MeshFormat::Obj &&
                                              kFormats[format] != MeshFormat::Off
                                          ? Encoding::Binary
                                          : Encoding::Text});
    } catch (const Error&) {
      continue;  // the writer cannot hold it in this format
    }
    if (way == 0) flip_bits(bytes, random);
    check(bytes, kNames[format], input);
  }
}

TEST_CASE("verify: corrupted planes are judged as the definitions say") {
  constexpr HalfspaceFormat kFormats[] = {HalfspaceFormat::Json, HalfspaceFormat::Ine,
                                          HalfspaceFormat::Rows};
  constexpr const char* kNames[] = {"c.json", "c.ine", "c.txt"};
  const std::vector<Points> all = bases();
  for (std::uint32_t i = 0; i < kCandidates; i += hard::stride()) {
    CAPTURE(i);
    Random random(i);
    const Points& input = all[i % all.size()];
    const PointSet points(input);
    std::vector<BinaryHalfspace> planes;
    for (const Halfspace& h : supporting_planes(definition::rationals(points))) {
      BinaryHalfspace plane;
      for (int k = 0; k < 3; ++k) plane[k] = static_cast<double>(h.normal()[k]);
      plane[3] = static_cast<double>(h.offset());
      planes.push_back(plane);
    }
    BinaryHalfspace& chosen = planes[below(random, planes.size())];
    const std::uint32_t way = below(random, 7);
    if (way == 0) chosen[below(random, 4)] = nudged(chosen[below(random, 4)], random);
    if (way == 1) chosen[below(random, 3)] *= 1 + 0x1p-52;
    if (way == 2) chosen = {0, 0, 0, below(random, 2) == 0 ? -1.0 : 1.0};
    if (way == 3) chosen = {-chosen[0], -chosen[1], -chosen[2], -chosen[3]};
    if (way == 4) planes.pop_back();
    if (way == 5) chosen[3] = nudged(chosen[3], random);
    const std::size_t format = below(random, 3);
    std::string bytes =
        write_halfspaces(std::span<const BinaryHalfspace>(planes), kFormats[format]);
    if (way == 6) flip_bits(bytes, random);
    check(bytes, kNames[format], input);
  }
}
