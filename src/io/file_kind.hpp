// SPDX-License-Identifier: MIT
// file_kind.hpp - what a file holds, by its name and its first bytes; and what to do with one that
// is not read.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "convexact/error.hpp"
#include "convexact/io.hpp"

namespace convexact {

/// One of the two.
struct FileKind {
  std::optional<MeshFormat> mesh;
  std::optional<HalfspaceFormat> halfspaces;
};

/// By the extension if it is a known one, otherwise by content. An .ext is points or halfspaces, as
/// it says, and a .txt may be a cloud of qhull.
/// @throws Error Unreadable for a format that is known but not read, with what to do, and for bytes
///               without a known extension that are no format at all.
[[nodiscard]] FileKind kind_of_file(std::string_view bytes, const std::string& path);

/// The format of a mesh by the extension, those included that are read only.
[[nodiscard]] std::optional<MeshFormat> readable_mesh_format(const std::string& path);

/// The fault of a file that is judged, with its name: what its reader found malformed or not
/// finite; or rays of a V-representation, since what they span is no candidate.
/// @throws Error Any other error, with the name.
[[nodiscard]] Error fault_of_candidate(const Error& error, const std::string& path);

/// The letters A to Z as a to z.
[[nodiscard]] std::string lower_case(std::string_view text);

}  // namespace convexact
