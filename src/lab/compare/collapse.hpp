// SPDX-License-Identifier: MIT
// collapse.hpp - a closed triangle mesh in doubles that loses one edge after another, the cheapest
// first.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"

namespace convexact {

using MeshCorner = std::uint32_t;
using MeshTriangle = std::array<MeshCorner, 3>;  ///< Counter-clockwise from outside.

class CollapsingMesh;

/// The position of the vertex that replaces an edge, and the cost.
struct Contraction {
  double cost;
  Point at;
};

/// The costs of collapses, and the positions of the new vertices.
class CollapseRule {
 public:
  virtual ~CollapseRule() = default;
  /// Ways to collapse the edge (a, b), the best first: the first one that the mesh allows is used.
  virtual std::vector<Contraction> contractions(const CollapsingMesh& mesh, MeshCorner a,
                                                MeshCorner b) const = 0;
  /// Called after b has become a.
  virtual void merged(MeshCorner a, MeshCorner b) = 0;
};

/// By the squared distances from the planes of the triangles merged into a vertex, weighted by
/// area: to the least point, or the best of the midpoint and the ends [GarlandHeckbert1997].
[[nodiscard]] std::unique_ptr<CollapseRule> quadric_rule(std::span<const Point> vertices,
                                                         std::span<const MeshTriangle> triangles);
/// By the added volume, to a point on or beyond all planes at the edge [Sander2000].
[[nodiscard]] std::unique_ptr<CollapseRule> outward_rule();

/// A closed triangle mesh without a boundary. A collapse must keep it one: both ends of the edge
/// have exactly two common neighbours (the link condition), and at least four vertices stay. No
/// triangle is turned over, unless every remaining collapse would do that.
class CollapsingMesh {
 public:
  /// @param rule  Must outlive the mesh.
  CollapsingMesh(std::vector<Point> vertices, std::span<const MeshTriangle> triangles,
                 CollapseRule& rule);

  /// Collapses edges until so many vertices are left, or no edge can be collapsed. Of equally cheap
  /// edges the one with the lower numbers is collapsed first.
  void reduce_to(std::size_t vertices, const Watch& watch = {});

  const Point& at(MeshCorner v) const { return vertices_[v]; }
  /// The triangles that are left, and those at an end of an edge.
  std::vector<MeshTriangle> triangles() const;
  std::vector<MeshTriangle> triangles_at(MeshCorner a, MeshCorner b) const;
  /// The vertices that are left, ascending.
  std::vector<MeshCorner> corners() const;

 private:
  using Edge = std::pair<MeshCorner, MeshCorner>;  // ascending
  struct Plan {
    double cost;
    Edge edge;
    bool operator<(const Plan& other) const {
      return cost != other.cost ? cost < other.cost : edge < other.edge;
    }
  };

  bool is_gone(const MeshTriangle& t) const { return t[0] == t[1]; }
  std::set<MeshCorner> neighbours(MeshCorner v) const;
  bool has_simple_link(MeshCorner a, MeshCorner b) const;
  bool turns_over(MeshCorner a, MeshCorner b, const Point& to) const;
  void plan(Edge edge);
  void plan_all();
  void forget(Edge edge);
  void collapse(Edge edge, const Point& to);

  std::vector<Point> vertices_;
  std::vector<MeshTriangle> triangles_;             // (0, 0, 0) where one is gone
  std::vector<std::vector<std::uint32_t>> around_;  // of each vertex its triangles
  CollapseRule& rule_;
  std::size_t left_;
  bool may_turn_over_ = false;
  std::set<Plan> queue_;
  std::map<Edge, Contraction> planned_;
};

/// Twice the area of a triangle along its outward normal.
[[nodiscard]] Point area_vector(const Point& a, const Point& b, const Point& c);

}  // namespace convexact
