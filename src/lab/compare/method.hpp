// SPDX-License-Identifier: MIT
// method.hpp - methods that enclose a hull in few halfspaces, or keep few of its vertices.
//
// A method proposes directions or vertices and proves nothing: it may work with doubles.
// refit.hpp makes a solid of its proposal in exact numbers.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "solid/solid.hpp"

namespace convexact {

/// A hull in the forms that methods use: exact, and as a triangle mesh in doubles.
struct HullToFit {
  const Solid& solid;
  /// solid.polytope.vertices less the middle of their box, times a power of two that leaves the
  /// largest coordinate in (1/4, 1); then rounded to nearest. Directions stay as they are.
  std::vector<Point> vertices;
  /// The facets of solid.polytope cut into fans, as indices of vertices, counter-clockwise from
  /// outside; 2 vertices.size() - 4 of them.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  Watch watch = {};  ///< Methods whose loops may take seconds check it or pass it on.

  const Polytope& polytope() const { return solid.polytope; }
};

/// Keeps a reference to the solid.
[[nodiscard]] HullToFit hull_to_fit(const Solid& solid, const Watch& watch = {});

/// Outward directions, none of them zero. Their lengths do not matter, and repeats are allowed.
using Normals = std::vector<RationalVector3>;

/// Indices of HullToFit::vertices, repeats allowed.
using HullCorners = std::vector<std::uint32_t>;

/// A method for solids around the hull: it proposes at most `faces` >= 4 directions, unless
/// its directions are fixed or no further removal is bounded. The same seed gives the same ones.
/// One for solids inside selects vertices instead: at most `vertices` >= 4, unless no further edge
/// can be collapsed.
struct Method {
  std::string_view name;
  Normals (*propose)(const HullToFit& hull, std::size_t faces, std::uint64_t seed);
  bool takes_faces;          ///< Otherwise it proposes the same for every `faces`.
  std::string_view summary;  ///< What it does, for people.
  std::string_view source;   ///< A key of docs/references.md.
  /// Of a method for solids inside, which has no `propose`; null of the others.
  HullCorners (*select)(const HullToFit& hull, std::size_t vertices, std::uint64_t seed) = nullptr;
  bool is_own = false;  ///< The removals of convexact simplify, which others are compared with.

  bool is_inner() const { return select != nullptr; }
};

/// All of them for solids around the hull, and for those inside, in the order of tables.
[[nodiscard]] std::span<const Method> methods();
[[nodiscard]] std::span<const Method> inner_methods();

// Fixed directions.
[[nodiscard]] Normals propose_aabb(const HullToFit& hull, std::size_t faces, std::uint64_t seed);
[[nodiscard]] Normals propose_kdop14(const HullToFit& hull, std::size_t faces, std::uint64_t seed);
[[nodiscard]] Normals propose_kdop18(const HullToFit& hull, std::size_t faces, std::uint64_t seed);
[[nodiscard]] Normals propose_kdop26(const HullToFit& hull, std::size_t faces, std::uint64_t seed);

// A box in the best of many orientations.
[[nodiscard]] Normals propose_obb(const HullToFit& hull, std::size_t faces, std::uint64_t seed);

// Directions of facets, or of groups of them.
[[nodiscard]] Normals propose_mck(const HullToFit& hull, std::size_t faces, std::uint64_t seed);
[[nodiscard]] Normals propose_stl(const HullToFit& hull, std::size_t faces, std::uint64_t seed);

// Facets of a mesh that has lost edges.
[[nodiscard]] Normals propose_bloom(const HullToFit& hull, std::size_t faces, std::uint64_t seed);
[[nodiscard]] Normals propose_tlg(const HullToFit& hull, std::size_t faces, std::uint64_t seed);
[[nodiscard]] Normals propose_qem_dual(const HullToFit& hull, std::size_t faces,
                                       std::uint64_t seed);

// Facets that removals leave.
[[nodiscard]] Normals propose_greedy(const HullToFit& hull, std::size_t faces, std::uint64_t seed);
[[nodiscard]] Normals propose_greedy_area(const HullToFit& hull, std::size_t faces,
                                          std::uint64_t seed);
[[nodiscard]] Normals propose_greedy_mean_width(const HullToFit& hull, std::size_t faces,
                                                std::uint64_t seed);
[[nodiscard]] Normals propose_search(const HullToFit& hull, std::size_t faces, std::uint64_t seed);
[[nodiscard]] Normals propose_random(const HullToFit& hull, std::size_t faces, std::uint64_t seed);

// Vertices that removals or collapses leave.
[[nodiscard]] HullCorners select_drop(const HullToFit& hull, std::size_t vertices,
                                      std::uint64_t seed);
[[nodiscard]] HullCorners select_qem_ends(const HullToFit& hull, std::size_t vertices,
                                          std::uint64_t seed);

}  // namespace convexact
