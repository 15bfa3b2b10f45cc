// SPDX-License-Identifier: MIT
#include "convexact/io.hpp"
#include "convexact/verify.hpp"

namespace convexact {

Candidate read_candidate_bytes(std::string_view bytes, const std::string& path, Decimal decimal) {
  try {
    const std::optional<MeshFormat> mesh = mesh_format_of_path(path);
    std::optional<HalfspaceFormat> halfspaces = halfspace_format_of_path(path);
    if (!mesh && !halfspaces) halfspaces = halfspace_format_of_content(bytes);
    if (halfspaces) return read_halfspaces_bytes(bytes, *halfspaces, decimal);
    return read_mesh_bytes(bytes, {.decimal = decimal, .format = mesh});
  } catch (const Error& error) {
    if (error.code() != ErrorCode::Malformed && error.code() != ErrorCode::NotFinite) throw;
    return error.in_file(display_name(path));
  }
}

Candidate read_candidate(const std::string& path, Decimal decimal) {
  return read_candidate_bytes(read_bytes(path), path, decimal);
}

}  // namespace convexact
