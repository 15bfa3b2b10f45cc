// SPDX-License-Identifier: MIT
// mesh_file.hpp - the shape in a file as requests have it.
#pragma once
#include <string>
#include <string_view>

namespace convexact {

/// {"points": rows, "triangles": rows, "notes": texts}, or {"planes": rows} for halfspaces: what
/// requests (solid_request.hpp) take, on one line. Read again, the numbers are the same. A mesh of
/// several objects has "objects", too, each with its "name", its triangles from "first" to before
/// "end", and its "loose" points, which no triangle uses.
/// @param name  Of the file: its extension says the format, as for the command line.
/// @throws Error as read_mesh_bytes() and read_halfspaces_bytes(), with the name in front;
///               Unreadable for a format that is not read.
[[nodiscard]] std::string shape_in_file(const std::string& name, std::string_view bytes);

}  // namespace convexact
