// SPDX-License-Identifier: MIT
// definitional_split.hpp - bridges, notches, planes and the tree of split(), from the definitions.
// For a few dozen points.
#pragma once
#include <optional>
#include <utility>

#include "convexact/measure.hpp"
#include "definitional_patch.hpp"
#include "polytope_by_definition.hpp"

namespace definition {

/// The nearest point of a convex polygon: a corner, the foot on a side, or the foot in its inside.
inline RationalPoint nearest_on_polygon(const std::vector<RationalPoint>& corners,
                                        const RationalPoint& x) {
  std::vector<RationalPoint> found(corners);
  const RationalVector3 n = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const RationalPoint foot = x - n.dot(x - corners[0]) / n.squaredNorm() * n;
  bool is_inside = true;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const RationalPoint &a = corners[k], &b = corners[(k + 1) % corners.size()];
    const RationalVector3 along = b - a;
    const Rational share = along.dot(x - a) / along.squaredNorm();
    if (share > 0 && share < 1) found.push_back(a + share * along);
    is_inside = is_inside && n.dot(along.cross(foot - a)) > 0;
  }
  if (is_inside) found.push_back(foot);
  return *std::min_element(found.begin(), found.end(), [&](const auto& p, const auto& q) {
    return (p - x).squaredNorm() < (q - x).squaredNorm();
  });
}

/// The hull of some points of a surface.
struct SplitHull {
  SplitHull(const Surface& surface, const std::vector<PointId>& of) {
    std::vector<RationalPoint> points;
    for (const PointId p : of) points.push_back(surface.points[p]);
    if (affine_dimension(points) < 3) return;
    const Polytope polytope = polytope_by_definition(PointSet(points));
    for (const std::size_t k : extreme_points(points, polytope.planes)) corners.insert(of[k]);
    const std::vector<PointId> ids(corners.begin(), corners.end());
    for (std::size_t f = 0; f < polytope.planes.size(); ++f) {
      Association::Facet facet;
      for (const std::uint32_t k : polytope.facets[f]) facet.push_back(ids[k]);
      normals[facet] = polytope.planes[f].normal().cast<Rational>();
    }
  }

  std::set<PointId> corners;
  std::map<Association::Facet, RationalVector3> normals;  ///< By facet; none if it is flat.
};

/// The bridges over a patch, and the bridges of each of its points.
class SplitAssociation {
 public:
  SplitAssociation(const Patch& patch, const SplitHull& hull, const SplitOptions& options)
      : patch_(patch), hull_(hull), options_(options) {
    made_.points = patch.points;
    find_bridges();
    find_paths();
    for (const PointId p : patch.points) {
      for (const auto& [facet, b] : bridge_) {
        if (std::count(facet.begin(), facet.end(), p) > 0) own_[p].insert(b);
      }
      for (const BridgePath& path : made_.paths) {
        if (std::count(path.points.begin(), path.points.end(), p) == 0) continue;
        own_[p].insert(path.bridges.begin(), path.bridges.end());
      }
    }
    for (const PointId p : patch.points) {
      const std::set<std::uint32_t> label = label_of(p);
      made_.bridges_of.emplace_back(label.begin(), label.end());
    }
  }
  const Association& made() const { return made_; }

 private:
  static bool has_edge(const Association::Facet& facet, PointId a, PointId b) {
    for (std::size_t k = 0; k < facet.size(); ++k) {
      if (facet[k] == a && facet[(k + 1) % facet.size()] == b) return true;
    }
    return false;
  }
  bool is_joined(const Association::Facet& f, const Association::Facet& g) const {
    const RationalVector3 &n = hull_.normals.at(f), &m = hull_.normals.at(g);
    const Rational along = n.dot(m), bound = options_.coplanar * options_.coplanar;
    for (const PointId a : f) {
      for (const PointId b : f) {
        if (has_edge(f, a, b) && has_edge(g, b, a)) {
          return along > 0 && along * along > bound * n.squaredNorm() * m.squaredNorm();
        }
      }
    }
    return false;
  }

  void find_bridges() {
    for (const auto& [first, normal] : hull_.normals) {
      if (bridge_.count(first) > 0) continue;
      std::set<Association::Facet> bridge{first};
      for (std::size_t before = 0; before != bridge.size();) {
        before = bridge.size();
        for (const auto& other : hull_.normals) {
          if (std::any_of(bridge.begin(), bridge.end(),
                          [&](const auto& f) { return is_joined(f, other.first); })) {
            bridge.insert(other.first);
          }
        }
      }
      for (const auto& f : bridge) bridge_[f] = static_cast<std::uint32_t>(made_.bridges.size());
      made_.bridges.emplace_back(bridge.begin(), bridge.end());
    }
  }

  void find_paths() {
    for (const PointId a : patch_.points) {
      for (const PointId b : patch_.points) {
        for (const auto& [f, n] : hull_.normals) {
          for (const auto& [g, m] : hull_.normals) {
            if (a < b && has_edge(f, a, b) && has_edge(g, b, a) && bridge_.at(f) != bridge_.at(g))
              made_.paths.push_back(path(a, b, std::minmax(bridge_.at(f), bridge_.at(g)), n, m));
          }
        }
      }
    }
  }
  BridgePath path(PointId a, PointId b, std::pair<std::uint32_t, std::uint32_t> bridges,
                  const RationalVector3& n, const RationalVector3& m) const {
    BridgePath made{{bridges.first, bridges.second}, {a, b}};
    if (patch_.is_edge(a, b)) return made;
    made.spans_hole = patch_.spans_hole(a, b, n, m);
    made.is_joined = !made.spans_hole && patch_.is_reached(a, b);
    if (made.is_joined) made.points = patch_.path(a, b);
    return made;
  }

  std::set<std::uint32_t> label_of(PointId p) const {
    if (!own_at(p).empty()) return own_at(p);
    if (options_.bridge == BridgeChoice::Region) return label_of_region(p);
    std::optional<PointId> nearest;
    for (const PointId q : patch_.points) {
      if (own_at(q).empty() || !patch_.is_reached(p, q)) continue;
      if (!nearest || patch_.steps(p, q) < patch_.steps(p, *nearest)) nearest = q;
    }
    return nearest ? own_at(*nearest) : std::set<std::uint32_t>();
  }
  std::set<std::uint32_t> label_of_region(PointId p) const {
    std::set<PointId> region{p}, around;
    for (std::size_t before = 0; before != region.size();) {
      before = region.size();
      for (const PointId q : std::set<PointId>(region)) {
        for (const PointId r : patch_.beside(q)) (own_at(r).empty() ? region : around).insert(r);
      }
    }
    std::size_t most = 0;
    std::set<std::uint32_t> label;
    for (std::uint32_t b = 0; b < made_.bridges.size(); ++b) {
      const auto votes = static_cast<std::size_t>(std::count_if(
          around.begin(), around.end(), [&](PointId r) { return own_at(r).count(b) > 0; }));
      if (votes <= most) continue;
      most = votes;
      label = {b};
    }
    return label;
  }
  const std::set<std::uint32_t>& own_at(PointId p) const {
    static const std::set<std::uint32_t> kNone;
    const auto found = own_.find(p);
    return found == own_.end() ? kNone : found->second;
  }

  const Patch& patch_;
  const SplitHull& hull_;
  const SplitOptions& options_;
  std::map<Association::Facet, std::uint32_t> bridge_;
  std::map<PointId, std::set<std::uint32_t>> own_;  // before labels are spread
  Association made_;
};

// ---- Depths

struct Depth {
  Rational squared = 0;
  RationalPoint on_bridge;
};

inline Depth depth_below(const Surface& surface, const std::vector<Association::Facet>& facets,
                         PointId p) {
  std::optional<Depth> least;
  for (const Association::Facet& facet : facets) {
    std::vector<RationalPoint> corners;
    for (const PointId q : facet) corners.push_back(surface.points[q]);
    const RationalPoint near = nearest_on_polygon(corners, surface.points[p]);
    const Rational squared = (near - surface.points[p]).squaredNorm();
    if (!least || squared < least->squared) least = Depth{squared, near};
  }
  return *least;
}

/// A part of the tree, evaluated.
struct SplitPart {
  SplitPart(const Surface& surface, std::vector<TriangleId> triangles, long exponent,
            const SplitOptions& options)
      : patch(surface, std::move(triangles), exponent), hull(surface, patch.points) {
    association.points = patch.points;
    association.bridges_of.resize(patch.points.size());
    concavity.triangle = patch.triangles.front();
    concavity.at = concavity.leaves = surface.points[patch.points.front()];
    concavity.normal = IntegerVector3::Zero();
    if (hull.normals.empty()) return;
    association = SplitAssociation(patch, hull, options).made();
    std::vector<Association::Facet> all;
    for (const auto& [facet, normal] : hull.normals) all.push_back(facet);
    for (std::size_t k = 0; k < patch.points.size(); ++k) {
      const PointId p = patch.points[k];
      least_squared = std::max(least_squared, depth_below(surface, all, p).squared);
      if (hull.corners.count(p) > 0 || is_on_hull_around(surface, p)) continue;
      const Depth depth = depth_of(surface, p, association.bridges_of[k], all, options.bridge);
      if (depth.squared <= concavity.squared) continue;
      notch = p;
      concavity.squared = depth.squared;
      concavity.at = surface.points[p];
      concavity.leaves = depth.on_bridge;
    }
    if (!notch) return;
    concavity.triangle =
        *std::find_if(patch.triangles.begin(), patch.triangles.end(), [&](TriangleId t) {
          const auto& corners = surface.triangles[t.index()];
          return std::count(corners.begin(), corners.end(), *notch) > 0;
        });
  }

  bool is_on_hull_around(const Surface& surface, PointId p) const {
    const auto is_on_facet = [&](const std::vector<PointId>& points) {
      return std::any_of(hull.normals.begin(), hull.normals.end(), [&](const auto& facet) {
        const RationalPoint on = surface.points[facet.first[0]];
        return std::all_of(points.begin(), points.end(), [&](PointId q) {
          return facet.second.dot(surface.points[q] - on) == 0;
        });
      });
    };
    const std::vector<TriangleId> at = patch.triangles_at(p);
    return is_on_facet({p}) && std::all_of(at.begin(), at.end(), [&](TriangleId t) {
             const auto& [a, b, c] = surface.triangles[t.index()];
             return is_on_facet({a, b, c});
           });
  }

  Depth depth_of(const Surface& surface, PointId p, const std::vector<std::uint32_t>& bridges,
                 const std::vector<Association::Facet>& all, BridgeChoice choice) const {
    std::optional<Depth> found;
    for (const std::uint32_t b : bridges) {
      Depth depth = depth_below(surface, association.bridges[b], p);
      if (!found || (choice == BridgeChoice::Farther ? depth.squared > found->squared
                                                     : depth.squared < found->squared)) {
        found = std::move(depth);
      }
    }
    return found ? *found : depth_below(surface, all, p);
  }

  Patch patch;
  SplitHull hull;
  Association association;
  Concavity concavity;
  std::optional<PointId> notch;
  Rational least_squared = 0;
};

}  // namespace definition
