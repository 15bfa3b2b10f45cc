// SPDX-License-Identifier: MIT
// parts.hpp - convex parts as files give them, alone or under a tree of hulls.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/mesh.hpp"
#include "convexact/number.hpp"

namespace convexact {

/// A part as its file gives it. It stands for the convex hull of its points.
struct NamedPart {
  std::string name;
  Mesh mesh;
};

/// A node of a tree as its file gives it, whether or not it is valid. Nodes are named by their
/// positions in HullTree::nodes.
struct HullTreeNode {
  std::optional<std::size_t> parent;  ///< None of the root.
  std::vector<std::size_t> children;  ///< None of a leaf.
  std::optional<std::size_t> part;    ///< For a leaf: its part, whose hull is the node's.
  Mesh mesh;                          ///< For a branch: its hull is that of these points.
};

/// Parts, and a tree whose leaves they are. Each hull is meant to hold the hulls of the children.
struct HullTree {
  std::vector<NamedPart> parts;
  std::vector<HullTreeNode> nodes;

  /// The points whose hull a node stands for. Precondition: a part, if it names one, exists.
  const Mesh& mesh_of(std::size_t node) const {
    const HullTreeNode& of = nodes[node];
    return of.part ? parts[*of.part].mesh : of.mesh;
  }
};

/// Parts, with or without a tree; or the error (Malformed or NotFinite) that reading them met.
using CandidateParts = std::variant<std::vector<NamedPart>, HullTree, Error>;

/// The parts in a file: in an OBJ the objects or groups that have faces, in an STL the solids; in
/// JSON the entries of "parts", each with "vertices" and possibly "name" and "faces", and the tree
/// under "hull_tree", if there is one; any other mesh is a single part. A part of several
/// has the points of its faces and its loose points (MeshPart); a single one has all points.
[[nodiscard]] CandidateParts read_parts_bytes(std::string_view bytes, const std::string& path,
                                              Decimal decimal = Decimal::Nearest);

/// The parts in the file, or in the meshes of the folder, by their names: "part_2.obj" before
/// "part_10.obj". Other files of a folder are not read; "-" is standard input.
/// @throws Error Unreadable if there is no such file or folder, or no mesh in the folder.
[[nodiscard]] CandidateParts read_parts(const std::string& path,
                                        Decimal decimal = Decimal::Nearest);

/// The parts that were read; null if reading met an error.
[[nodiscard]] const std::vector<NamedPart>* parts_of(const CandidateParts& candidate);

}  // namespace convexact
