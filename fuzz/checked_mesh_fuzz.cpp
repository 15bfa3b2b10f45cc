// SPDX-License-Identifier: MIT
// Property of checked_mesh: from the bytes of a mesh file or of a list of halfspaces,
// convexact-check reads the same exact points, faces and rows as the library, which shares no code
// with it, or both refuse them. The checker alone refuses statements of OBJ that it does not know,
// lines of an XYZ that are more than numbers, and "linearity 0".
#include "../tests/check/checker.hpp"
#include "convexact/geometry.hpp"
#include "convexact/io.hpp"
#include "fuzz_target.hpp"
#include "unless_refused.hpp"

using namespace convexact;

namespace {

using Rows = std::vector<std::string>;

Rows sorted(Rows rows) {
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

std::optional<Rows> points_by_library(std::string_view bytes, MeshFormat format, Decimal decimal) {
  const auto mesh = unless_refused(
      [&] { return read_mesh_bytes(bytes, {.decimal = decimal, .format = format}); });
  if (!mesh) return std::nullopt;
  Rows rows;
  for (std::size_t p = 0; p < mesh->points.size(); ++p) {
    const RationalPoint point = mesh->points[PointId(p)];
    rows.push_back(to_string(point[0]) + " " + to_string(point[1]) + " " + to_string(point[2]));
  }
  return sorted(rows);
}

std::optional<Rows> faces_by_library(std::string_view bytes, MeshFormat format, Decimal decimal) {
  const auto mesh = unless_refused(
      [&] { return read_mesh_bytes(bytes, {.decimal = decimal, .format = format}); });
  if (!mesh) return std::nullopt;
  Rows faces;
  for (const auto& polygon : mesh->polygons) {
    faces.emplace_back();
    for (const std::uint32_t corner : polygon) {
      const RationalPoint point = mesh->points[PointId(corner)];
      for (int k = 0; k < 3; ++k) faces.back() += to_string(point[k]) + (k == 2 ? ", " : " ");
    }
  }
  return faces;
}

std::optional<Rows> halfspaces_by_library(std::string_view bytes, HalfspaceFormat format,
                                          Decimal decimal) {
  const auto list = unless_refused([&] { return read_halfspaces_bytes(bytes, format, decimal); });
  if (!list) return std::nullopt;
  Rows rows;
  for (const Halfspace& h : list->halfspaces) {
    std::string row;
    for (const Integer& n : h.normal()) row += to_string(n) + " ";
    rows.push_back(row + to_string(h.offset()));
  }
  return sorted(rows);
}

void hold_checked_mesh(FuzzInput& in) {
  const std::size_t kind = in.below(7);
  const bool as_spelt = in.below(2) == 1;
  const Decimal decimal = as_spelt ? Decimal::Exact : Decimal::Nearest;
  constexpr const char* kNames[] = {"a.obj", "a.off", "a.ply", "a.stl", "a.xyz", "a.txt", "a.ine"};
  constexpr MeshFormat kMeshes[] = {MeshFormat::Obj, MeshFormat::Off, MeshFormat::Ply,
                                    MeshFormat::Stl, MeshFormat::Xyz};
  const std::string bytes(in.rest());
  const auto theirs = rows_by_checker(bytes, kNames[kind], as_spelt);
  const auto ours =
      kind < 5 ? points_by_library(bytes, kMeshes[kind], decimal)
               : halfspaces_by_library(
                     bytes, kind == 5 ? HalfspaceFormat::Rows : HalfspaceFormat::Ine, decimal);
  if (ours && theirs) FUZZ_CHECK(*ours == *theirs);
  if (kind >= 5 || !ours) return;
  const auto faces = faces_by_checker(bytes, kNames[kind], as_spelt);
  if (faces) FUZZ_CHECK(*faces == *faces_by_library(bytes, kMeshes[kind], decimal));
}

const FuzzTarget kCheckedMesh("checked_mesh", hold_checked_mesh);

}  // namespace
