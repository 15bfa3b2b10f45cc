// SPDX-License-Identifier: MIT
#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "convexact/scene.hpp"
#include "convexact/stored.hpp"
#include "scene/objects.hpp"

namespace convexact {
namespace {

void require_inside(std::size_t outside, const std::string& path) {
  if (outside > 0) reject_bytes(path, "misses " + std::to_string(outside) + " input points");
}

// The points that one part of a mesh uses.
PointSet points_of_part(const Mesh& mesh, const MeshPart& part) {
  std::vector<Point> points;
  for (std::size_t k = part.first_polygon; k < part.last_polygon; ++k) {
    for (const std::uint32_t corner : mesh.polygons[k]) {
      points.push_back(mesh.points.doubles()[corner]);
    }
  }
  return PointSet(std::move(points));
}

// Proves the bytes themselves, as a reader of the file would take them.
void prove_bytes(const std::string& bytes, const std::string& path,
                 std::span<const NamedSolid> solids) {
  if (const auto format = halfspace_format_of_path(path)) {
    const HalfspaceList read = read_halfspaces_bytes(bytes, *format);
    require_inside(count_outside(read.halfspaces, solids[0].solid->points), path);
    return;
  }
  const Mesh mesh = read_mesh_bytes(bytes, {.format = mesh_format_of_path(path)});
  if (solids.size() == 1) {
    require_inside(count_outside_hull(mesh.points, solids[0].solid->points), path);
    return;
  }
  CONVEXACT_ASSERT(mesh.parts.size() == solids.size());
  for (std::size_t k = 0; k < solids.size(); ++k) {
    const PointSet corners = points_of_part(mesh, mesh.parts[k]);
    require_inside(count_outside_hull(corners, solids[k].solid->points), path);
  }
}

std::string mesh_bytes(std::span<const NamedSolid> solids, MeshFormat format, Precision precision) {
  const Encoding encoding = format == MeshFormat::Stl ? Encoding::Binary : Encoding::Text;
  const MeshWriteOptions options{.precision = precision, .encoding = encoding};
  if (solids.size() == 1) return write_mesh(solids[0].solid->mesh->mesh, format, options);
  std::vector<NamedMesh> objects;
  for (const auto& [name, solid] : solids) objects.push_back({name, &solid->mesh->mesh});
  return write_mesh(joined(objects), format, options);
}

std::string plane_bytes(const Stored& solid, HalfspaceFormat format) {
  if (!solid.planes) return write_halfspaces(solid.exact.planes, format);
  return write_halfspaces(solid.planes->planes, format);
}

}  // namespace

std::string proven_bytes(std::span<const NamedSolid> solids, const std::string& path) {
  const auto mesh_format = mesh_format_of_path(path);
  std::string bytes = mesh_format
                          ? mesh_bytes(solids, *mesh_format, solids[0].solid->mesh->precision)
                          : plane_bytes(*solids[0].solid, *halfspace_format_of_path(path));
  prove_bytes(bytes, path, solids);
  return bytes;
}

}  // namespace convexact
