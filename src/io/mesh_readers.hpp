// SPDX-License-Identifier: MIT
// mesh_readers.hpp - one reader per format, behind read_mesh; errors as stated there.
#pragma once
#include <string>
#include <string_view>

#include "convexact/io.hpp"
#include "convexact/number.hpp"

namespace convexact {

Mesh read_obj(std::string_view bytes, const ReadOptions& options);
Mesh read_off(std::string_view bytes, const ReadOptions& options);
Mesh read_ply(std::string_view bytes, const ReadOptions& options);
Mesh read_stl(std::string_view bytes, const ReadOptions& options);
Mesh read_xyz(std::string_view bytes, const ReadOptions& options);
Mesh read_pcd(std::string_view bytes, const ReadOptions& options);
/// Also Unreadable for what the format allows and this reader does not know, such as compression,
/// and for files that it may not open.
Mesh read_gltf(std::string_view bytes, const ReadOptions& options);
Mesh read_collada(std::string_view bytes, const ReadOptions& options);
/// @throws Error also NoInterior for a ray or a line.
Mesh read_ext(std::string_view bytes, const ReadOptions& options);

/// Whether a text is what qhull's option o writes: an OFF with "3" in the place of its header.
bool is_off_of_qhull(std::string_view bytes);

/// Whether bytes are XML with an element COLLADA soon.
bool is_collada(std::string_view bytes);

/// Meters for each unit, as a COLLADA file says; 1 if it does not, or is none.
double collada_unit(std::string_view bytes);

/// Whether an .ine or .ext says so.
bool is_v_representation(std::string_view bytes);

/// "3 points were skipped: a coordinate is not finite".
std::string skipped_points_note(std::size_t count);
/// "2 faces of fewer than 3 corners were skipped; their points count".
std::string skipped_faces_note(std::size_t count);

/// Whether the size of a file is that of a binary STL with its triangle count.
bool is_binary_stl(std::string_view bytes);

}  // namespace convexact
