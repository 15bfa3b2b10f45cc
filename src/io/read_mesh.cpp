// SPDX-License-Identifier: MIT
#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "io/mesh_readers.hpp"

namespace convexact {

Mesh read_mesh_bytes(std::string_view bytes, const ReadOptions& options) {
  switch (options.format.value_or(mesh_format_of_content(bytes))) {
    case MeshFormat::Off:
      return read_off(bytes, options.decimal);
    case MeshFormat::Ply:
      return read_ply(bytes, options.decimal);
    case MeshFormat::Stl:
      return read_stl(bytes, options.decimal);
    case MeshFormat::Xyz:
      return read_xyz(bytes, options.decimal);
    case MeshFormat::Obj:
      break;
  }
  return read_obj(bytes, options.decimal);
}

Mesh read_mesh(const std::string& path, const ReadOptions& options) {
  const std::string bytes = read_bytes(path);
  ReadOptions resolved = options;
  if (!resolved.format) resolved.format = mesh_format_of_path(path);
  try {
    return read_mesh_bytes(bytes, resolved);
  } catch (const Error& error) {
    throw error.in_file(display_name(path));
  }
}

}  // namespace convexact
