// SPDX-License-Identifier: MIT
// Meshes in any format: by the path or the content; and point clouds, the shortest of the formats.
#include <array>

#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "io/file_beside.hpp"
#include "io/file_kind.hpp"
#include "io/mesh_readers.hpp"
#include "io/point_collector.hpp"
#include "io/text_cursor.hpp"

namespace convexact {
namespace {

// Whether the first line with a word holds three numbers.
bool starts_with_a_point(TextCursor cursor) {
  if (!cursor.next_line()) return false;
  try {
    for (int k = 0; k < 3; ++k) (void)cursor.to_number(cursor.token());
    return cursor.token().empty();
  } catch (const Error&) {
    return false;
  }
}

}  // namespace

std::optional<MeshFormat> mesh_format_of_path(const std::string& path) {
  if (path.size() < 4) return {};
  const std::string extension = lower_case(std::string_view(path).substr(path.size() - 4));
  if (extension == ".obj") return MeshFormat::Obj;
  if (extension == ".off") return MeshFormat::Off;
  if (extension == ".ply") return MeshFormat::Ply;
  if (extension == ".stl") return MeshFormat::Stl;
  if (extension == ".xyz") return MeshFormat::Xyz;
  if (extension == ".glb") return MeshFormat::Gltf;
  return {};
}

MeshFormat mesh_format_of_content(std::string_view bytes) {
  if (is_binary_stl(bytes)) return MeshFormat::Stl;
  if (bytes.starts_with("glTF")) return MeshFormat::Gltf;
  if (is_collada(bytes)) return MeshFormat::Collada;
  // '#' begins a comment in OFF and OBJ; a PLY or STL file does not start with one.
  TextCursor cursor(bytes, {.comment = '#'});
  if (starts_with_a_point(cursor)) return MeshFormat::Xyz;
  const std::string first = cursor.next_line() ? lower_case(cursor.token()) : "";
  if (first == "ply") return MeshFormat::Ply;
  if (first == "solid") return MeshFormat::Stl;
  // OFF, COFF, NOFF, STCNOFF, 4OFF and so on.
  const bool is_off = first.size() >= 3 && first.size() <= 9 && first.ends_with("off");
  return is_off ? MeshFormat::Off : MeshFormat::Obj;
}

namespace {

Mesh read_in_format(std::string_view bytes, const ReadOptions& options) {
  switch (options.format.value_or(mesh_format_of_content(bytes))) {
    case MeshFormat::Off:
      return read_off(bytes, options);
    case MeshFormat::Ply:
      return read_ply(bytes, options);
    case MeshFormat::Stl:
      return read_stl(bytes, options);
    case MeshFormat::Xyz:
      return read_xyz(bytes, options);
    case MeshFormat::Pcd:
      return read_pcd(bytes, options);
    case MeshFormat::Ext:
      return read_ext(bytes, options);
    case MeshFormat::Gltf:
      return read_gltf(bytes, options);
    case MeshFormat::Collada:
      return read_collada(bytes, options);
    case MeshFormat::Obj:
      break;
  }
  return read_obj(bytes, options);
}

}  // namespace

Mesh read_mesh_bytes(std::string_view bytes, const ReadOptions& options) {
  Mesh mesh = read_in_format(bytes, options);
  if (options.points_only) {
    mesh.polygons = {};
    mesh.parts = {};
  }
  return mesh;
}

Mesh read_mesh(const std::string& path, const ReadOptions& options) {
  const std::string bytes = read_bytes(path);
  ReadOptions resolved = options;
  if (resolved.folder.empty()) resolved.folder = folder_of_file(path);
  try {
    if (!resolved.format) {
      resolved.format = kind_of_file(bytes, path).mesh;
      if (!resolved.format) {
        throw Error(ErrorCode::Malformed, "expected a mesh or points, found halfspaces");
      }
    }
    return read_mesh_bytes(bytes, resolved);
  } catch (const Error& error) {
    throw error.in_file(display_name(path));
  }
}

}  // namespace convexact
