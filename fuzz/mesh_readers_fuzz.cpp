// SPDX-License-Identifier: MIT
// Property of obj, off, ply, stl, xyz, gltf, collada: the reader takes any bytes and either reads
// them or refuses them with an Error of exit code 3. A mesh that was read can be written, and
// reading it back gives the same mesh; decimals taken as spelled, when rounded, are the doubles or
// binary32 numbers that are read otherwise. Of scenes, where points that round to the same one are
// merged, the triangles of a written GLB are compared, corner by corner.
#include <algorithm>

#include "convexact/io.hpp"
#include "convexact/number.hpp"
#include "fuzz_target.hpp"
#include "same_mesh.hpp"
#include "unless_refused.hpp"

using namespace convexact;

namespace {

void check_round_trip(const Mesh& mesh, MeshFormat format, const MeshWriteOptions& options) {
  const Mesh back = read_mesh_bytes(write_mesh(mesh, format, options), {.format = format});
  FUZZ_CHECK(same_points(back.points, mesh.points));
  FUZZ_CHECK(back.polygons == mesh.polygons);
  if (options.encoding == Encoding::Text) FUZZ_CHECK(same_parts(back, mesh));
}

void check_binary32(std::string_view bytes, MeshFormat format, const PointSet& exact) {
  const auto rounded = unless_refused(
      [&] { return read_mesh_bytes(bytes, {.decimal = Decimal::Nearest32, .format = format}); });
  if (!rounded) return;
  for (std::size_t k = 0; k < exact.size(); ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      FUZZ_CHECK(rounded->points.doubles()[k][axis] ==
                 to_float(exact[PointId(k)][axis], Rounding::Nearest));
    }
  }
}

template <MeshFormat format>
void hold(FuzzInput& in) {
  const std::string_view bytes = in.rest();
  (void)mesh_format_of_content(bytes);
  const auto mesh = unless_refused([&] { return read_mesh_bytes(bytes, {.format = format}); });
  if (!mesh) return;
  for (const auto& polygon : mesh->polygons) {
    FUZZ_CHECK(polygon.size() >= 3);
    for (const std::uint32_t corner : polygon) FUZZ_CHECK(corner < mesh->points.size());
  }
  check_round_trip(*mesh, format, {});
  if (format == MeshFormat::Ply) check_round_trip(*mesh, format, {.encoding = Encoding::Binary});
  const auto exact = unless_refused(
      [&] { return read_mesh_bytes(bytes, {.decimal = Decimal::Exact, .format = format}); });
  // STL may keep points apart that are equal only as doubles.
  if (!exact || format == MeshFormat::Stl) return;
  FUZZ_CHECK(exact->polygons == mesh->polygons);
  FUZZ_CHECK(std::equal(exact->points.doubles().begin(), exact->points.doubles().end(),
                        mesh->points.doubles().begin(), mesh->points.doubles().end()));
  check_binary32(bytes, format, exact->points);
}

bool is_binary32(const Point& p) {
  return std::all_of(p.begin(), p.end(), [](double x) { return double(float(x)) == x; });
}

void check_glb(const Mesh& mesh) {
  const Mesh back =
      read_mesh_bytes(write_mesh(mesh, MeshFormat::Gltf), {.format = MeshFormat::Gltf});
  std::size_t triangle = 0;
  for (const auto& polygon : mesh.polygons) {
    for (std::size_t k = 2; k < polygon.size(); ++k, ++triangle) {
      FUZZ_CHECK(triangle < back.polygons.size());
      const auto& found = back.polygons[triangle];
      const std::uint32_t corners[] = {polygon[0], polygon[k - 1], polygon[k]};
      for (std::size_t c = 0; c < 3; ++c) {
        FUZZ_CHECK(back.points.doubles()[found[c]] == mesh.points.doubles()[corners[c]]);
      }
    }
  }
  FUZZ_CHECK(triangle == back.polygons.size());
}

template <MeshFormat format>
void hold_scene(FuzzInput& in) {
  const std::string_view bytes = in.rest();
  for (const Decimal decimal : {Decimal::Nearest, Decimal::Nearest32, Decimal::Exact}) {
    const auto mesh = unless_refused(
        [&] { return read_mesh_bytes(bytes, {.decimal = decimal, .format = format}); });
    if (!mesh) continue;
    for (const auto& polygon : mesh->polygons) {
      FUZZ_CHECK(polygon.size() >= 3);
      for (const std::uint32_t corner : polygon) FUZZ_CHECK(corner < mesh->points.size());
    }
    std::size_t next = 0;
    for (const MeshPart& part : mesh->parts) {
      FUZZ_CHECK(part.first_polygon == next && part.last_polygon >= next);
      next = part.last_polygon;
    }
    FUZZ_CHECK(next == mesh->polygons.size());
    const auto points = mesh->points.doubles();
    const bool is_narrow =
        mesh->points.is_binary() && std::all_of(points.begin(), points.end(), is_binary32);
    if (is_narrow && !mesh->polygons.empty()) check_glb(*mesh);
  }
}

const FuzzTarget kCollada("collada", hold_scene<MeshFormat::Collada>);
const FuzzTarget kGltf("gltf", hold_scene<MeshFormat::Gltf>);
const FuzzTarget kObj("obj", hold<MeshFormat::Obj>);
const FuzzTarget kOff("off", hold<MeshFormat::Off>);
const FuzzTarget kPly("ply", hold<MeshFormat::Ply>);
const FuzzTarget kStl("stl", hold<MeshFormat::Stl>);
const FuzzTarget kXyz("xyz", hold<MeshFormat::Xyz>);

}  // namespace
