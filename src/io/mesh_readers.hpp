// SPDX-License-Identifier: MIT
// mesh_readers.hpp - one reader per format, behind read_mesh; errors as stated there.
#pragma once
#include <string_view>

#include "convexact/io.hpp"
#include "convexact/number.hpp"

namespace convexact {

Mesh read_obj(std::string_view bytes, Decimal decimal);
Mesh read_off(std::string_view bytes, Decimal decimal);
Mesh read_ply(std::string_view bytes, Decimal decimal);
Mesh read_stl(std::string_view bytes, Decimal decimal);
Mesh read_xyz(std::string_view bytes, Decimal decimal);

/// Whether the size of a file is that of a binary STL with its triangle count.
bool is_binary_stl(std::string_view bytes);

}  // namespace convexact
