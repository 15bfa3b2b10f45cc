// SPDX-License-Identifier: MIT
// write_mesh.hpp - meshes to the bytes of OBJ, OFF, PLY and STL, from which the same numbers are
// read.
#pragma once
#include <string>

#include "convexact/io/mesh.hpp"
#include "convexact/io/mesh_format.hpp"
#include "convexact/number/precision.hpp"

namespace convexact {

enum class Encoding {
  Text,    ///< Shortest decimals whose nearest double is the coordinate.
  Binary,  ///< PLY: little-endian, float or double by the precision. STL: always float.
};

struct MeshWriteOptions {
  Precision precision = Precision::Binary64;  ///< Every coordinate must be a number of it already.
  Encoding encoding = Encoding::Text;         ///< OBJ and OFF know text only.
};

/// The bytes of a file that read_mesh_bytes reads as the same points, polygons and, for OBJ and STL
/// as text, parts. STL keeps triangles and the points that they use: a polygon becomes a fan from
/// its first corner, and equal points become one. XYZ keeps the points alone.
/// @param mesh   Binary points; polygons of at least 3 valid indices; parts that follow each other
///               and hold every polygon (or none at all).
/// @throws Error Unrepresentable if a coordinate is no number of the precision (STL in binary: of
///               binary32), if the points are rationals, or if there are 2^31 points or more;
///               InvalidArgument for OBJ or OFF in binary and for names with line ends.
[[nodiscard]] std::string write_mesh(const Mesh& mesh, MeshFormat format,
                                     const MeshWriteOptions& options = {});

}  // namespace convexact
