// SPDX-License-Identifier: MIT
// json_mesh.hpp - meshes and parts in requests and files as JSON.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "convexact/decompose.hpp"
#include "convexact/io.hpp"
#include "convexact/number.hpp"

namespace convexact {

/// A coordinate of a point, as in a mesh file: every decimal is the nearest double or binary32
/// number, even one without a point or an exponent. Fractions and hexadecimal floats are taken
/// exactly as spelled; where the numbers are binary32, they are rounded too. Strings mean what they
/// spell.
/// @throws Error Malformed; NotFinite for a number beyond the largest of the format.
[[nodiscard]] Rational coordinate_of_json(const nlohmann::json& value, Decimal decimal);

/// The points under "vertices" and the polygons under "faces", if there are any. The numbers were
/// read as text: see JsonDocument.
/// @throws Error as coordinate_of_json(); Malformed for anything but rows of three coordinates, and
///               for faces with fewer than three corners or without a point.
[[nodiscard]] Mesh mesh_of_json(const nlohmann::json& object, Decimal decimal);

/// An entry of "parts": "vertices", and possibly "name" and "faces". @param number  From 0.
/// @throws Error as mesh_of_json(), with the number.
[[nodiscard]] NamedPart part_of_json(const nlohmann::json& part, std::size_t number,
                                     Decimal decimal);

/// The nodes under "hull_tree": each with "parent" (null for the root), and "part", or "children"
/// and "vertices". Whether they make a tree is not checked.
/// @throws Error as mesh_of_json(), with the number of the node.
[[nodiscard]] std::vector<HullTreeNode> nodes_of_json(const nlohmann::json& nodes, Decimal decimal);

}  // namespace convexact
