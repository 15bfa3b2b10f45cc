// SPDX-License-Identifier: MIT
// build_tree(): hulls over the parts, from the leaves to the root, each around the stored hulls
// below it.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "convexact/error.hpp"
#include "convexact/hull_tree.hpp"
#include "convexact/measure.hpp"
#include "number/arithmetic.hpp"
#include "number/precision.hpp"
#include "parts/stored_part.hpp"

namespace convexact {
namespace {

constexpr std::size_t kNeighbours = 8;  // that a group considers as partners

// A part, or the parts below a join.
struct Group {
  std::vector<std::size_t> children;
  Mesh mesh;        // as it is stored
  ConvexPart hull;  // of its points
  std::size_t facets = 0;
  Rational volume;
  Point low, high;  // of its box, in units of the scene
  bool is_joined = false;
};

class TreeBuilder {
 public:
  TreeBuilder(std::span<const NamedPart> parts, const TreeRequest& request)
      : parts_(parts), request_(request), log_(request.watch) {}

  BuiltTree run(std::span<const Join> joins) {
    make_leaves();
    log_.run("branches", [&] {
      const Watch watch = log_.watch("branches");
      for (const Join& join : joins) {
        require_free(join);
        (void)this->join(join.first, join.second, watch);
      }
      join_the_rest(watch);
    });
    made_.given_joins = joins.size();
    log_.run("levels", [&] { order_by_levels(); });
    log_.run("nesting", [&] {
      const auto fault = find_tree_fault(made_.tree, log_.watch("nesting"));
      if (fault) throw Error(ErrorCode::Internal, "the tree has a fault: " + fault->sentence);
    });
    made_.stages = log_.stages();
    return std::move(made_);
  }

 private:
  DecomposeRequest store_request(const std::optional<std::size_t>& faces) const {
    DecomposeRequest request;
    request.faces = faces;
    request.precision = request_.precision;
    request.seed = request_.seed;
    request.watch.stop = request_.watch.stop;
    return request;
  }

  // The part or branch as it is stored, simplified if it has more faces than it may.
  void add(Part part, ConvexPart stored, std::vector<std::size_t> children) {
    Group group{.children = std::move(children),
                .mesh = std::move(part.mesh),
                .hull = std::move(stored),
                .facets = part.faces,
                .volume = 0,
                .low = {},
                .high = {}};
    group.volume = volume(*group.hull.solid);
    for (int k = 0; k < 3; ++k) {
      group.low[k] = to_double(Rational(group.hull.box.low[k] * unit_), Rounding::Nearest);
      group.high[k] = to_double(Rational(group.hull.box.high[k] * unit_), Rounding::Nearest);
    }
    groups_.push_back(std::move(group));
  }

  void make_leaves() {
    std::vector<Part> leaves;
    log_.run("hulls of parts", [&] {
      const Watch watch = log_.watch("hulls of parts");
      std::vector<RationalPoint> corners;
      for (const NamedPart& part : parts_) {
        watch.at(leaves.size(), parts_.size());
        leaves.emplace_back().hull = convex_part(part.mesh.points, watch);
        const BoundingBox& box = leaves.back().hull.box;
        corners.insert(corners.end(), {box.low, box.high});
      }
      squared_diameter_ = bounding_box(corners).squared_diameter();
    });
    unit_ = scale_by_power_of_two(Rational(1), -exponent_of_diameter());
    std::vector<ConvexPart> stored =
        store_parts(leaves, squared_diameter_, store_request(request_.leaf_faces), log_);
    for (std::size_t k = 0; k < leaves.size(); ++k) {
      add(std::move(leaves[k]), std::move(stored[k]), {});
    }
  }

  // About the binary logarithm of the diameter; 0 of a single point.
  long exponent_of_diameter() const {
    return squared_diameter_ == 0 ? 0 : exponent_of(squared_diameter_) / 2;
  }

  PointSet corners_of(std::size_t a, std::size_t b) const {
    std::vector<RationalPoint> corners = groups_[a].hull.vertices;
    const auto& more = groups_[b].hull.vertices;
    corners.insert(corners.end(), more.begin(), more.end());
    return PointSet(std::move(corners));
  }

  std::size_t join(std::size_t a, std::size_t b, const Watch& watch) {
    watch.at(groups_.size() - parts_.size(), parts_.size() - 1);
    groups_[a].is_joined = groups_[b].is_joined = true;
    std::vector<Part> branch(1);
    branch[0].hull = convex_part(corners_of(a, b), watch);
    StageLog within(StageWatch{.stop = request_.watch.stop});
    std::vector<ConvexPart> stored =
        store_parts(branch, squared_diameter_, store_request(request_.faces), within);
    add(std::move(branch[0]), std::move(stored[0]), {a, b});
    return groups_.size() - 1;
  }

  void require_free(const Join& join) const {
    const auto [a, b] = join;
    const std::size_t groups = groups_.size();
    if (a < groups && b < groups && a != b && !groups_[a].is_joined && !groups_[b].is_joined) {
      return;
    }
    throw Error(ErrorCode::InvalidArgument,
                fmt::format("join {} is of groups {} and {}: expected two of the {} so far that no "
                            "other join has",
                            groups - parts_.size(), a, b, groups));
  }

  // ---- By the least volume of the common hull

  using Pair = std::pair<std::size_t, std::size_t>;

  Rational common_volume(const Pair& pair, const Watch& watch) const {
    return volume(*convex_part(corners_of(pair.first, pair.second), watch).solid);
  }

  // Half the surface of the box around both: doubles suffice, since it only chooses where to look.
  double common_box(std::size_t a, std::size_t b) const {
    const Point size =
        groups_[a].high.cwiseMax(groups_[b].high) - groups_[a].low.cwiseMin(groups_[b].low);
    return size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
  }

  std::vector<std::size_t> neighbours_of(std::size_t group,
                                         const std::vector<std::size_t>& roots) const {
    std::vector<std::pair<double, std::size_t>> by_box;
    for (const std::size_t other : roots) {
      if (other != group) by_box.emplace_back(common_box(group, other), other);
    }
    const std::size_t count = std::min(kNeighbours, by_box.size());
    std::partial_sort(by_box.begin(), by_box.begin() + static_cast<std::ptrdiff_t>(count),
                      by_box.end());
    std::vector<std::size_t> nearest;
    for (std::size_t i = 0; i < count; ++i) nearest.push_back(by_box[i].second);
    return nearest;
  }

  // Among all pairs in which one group considers the other, the pair with the least common hull; of
  // equal ones the lowest. Known volumes are kept in `common`.
  Pair best_pair(const std::vector<std::size_t>& roots, std::map<Pair, Rational>& common,
                 const Watch& watch) const {
    const std::pair<const Pair, Rational>* best = nullptr;
    for (const std::size_t root : roots) {
      for (const std::size_t other : neighbours_of(root, roots)) {
        const Pair pair = std::minmax({root, other});
        if (!common.contains(pair)) common.emplace(pair, common_volume(pair, watch));
        const auto& found = *common.find(pair);
        const bool is_better = best == nullptr || found.second < best->second ||
                               (found.second == best->second && pair < best->first);
        if (is_better) best = &found;
      }
    }
    return best->first;
  }

  void join_the_rest(const Watch& watch) {
    std::vector<std::size_t> roots;
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      if (!groups_[g].is_joined) roots.push_back(g);
    }
    std::map<Pair, Rational> common;
    while (roots.size() > 1) {
      const Pair best = best_pair(roots, common, watch);
      std::erase_if(roots, [&](std::size_t g) { return g == best.first || g == best.second; });
      roots.push_back(join(best.first, best.second, watch));
    }
  }

  // ---- The tree

  // The last group is the root: every branch is made after its children.
  void order_by_levels() {
    std::vector<std::size_t> place(groups_.size());
    std::size_t placed = 0;
    for (std::vector<std::size_t> level = {groups_.size() - 1}; !level.empty();) {
      std::vector<std::size_t> below;
      for (const std::size_t g : level) {
        place[g] = placed++;
        below.insert(below.end(), groups_[g].children.begin(), groups_[g].children.end());
      }
      made_.levels.push_back(measure(level));
      level = std::move(below);
    }
    made_.tree.nodes.resize(groups_.size());
    made_.facets.resize(groups_.size());
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      HullTreeNode& node = made_.tree.nodes[place[g]];
      made_.facets[place[g]] = groups_[g].facets;
      for (const std::size_t child : groups_[g].children) {
        node.children.push_back(place[child]);
        made_.tree.nodes[place[child]].parent = place[g];
      }
      if (g < parts_.size()) {
        node.part = g;
        made_.tree.parts.push_back({parts_[g].name, std::move(groups_[g].mesh)});
      } else {
        node.mesh = std::move(groups_[g].mesh);
      }
    }
  }

  TreeLevel measure(const std::vector<std::size_t>& level) const {
    TreeLevel sums{.volume = Enclosure(Rational(0), kMeasureBits),
                   .area = Enclosure(Rational(0), kMeasureBits)};
    for (const std::size_t g : level) {
      ++sums.nodes;
      sums.leaves += groups_[g].children.empty() ? 1 : 0;
      sums.volume += Enclosure(groups_[g].volume, kMeasureBits);
      sums.area += surface_area(*groups_[g].hull.solid, kMeasureBits);
    }
    return sums;
  }

  std::span<const NamedPart> parts_;
  const TreeRequest& request_;
  StageLog log_;
  Rational squared_diameter_, unit_;
  std::vector<Group> groups_;
  BuiltTree made_;
};

void require_sensible(std::span<const NamedPart> parts, const TreeRequest& request) {
  if (parts.empty()) throw Error(ErrorCode::InvalidArgument, "a tree needs at least one part");
  for (const auto& faces : {request.faces, request.leaf_faces}) {
    if (faces && *faces < 4) {
      throw Error(ErrorCode::InvalidArgument,
                  "no bounded hull has fewer than 4 faces: allow at least 4 for each");
    }
  }
}

}  // namespace

BuiltTree build_tree(std::span<const NamedPart> parts, std::span<const Join> joins,
                     const TreeRequest& request) {
  require_sensible(parts, request);
  return TreeBuilder(parts, request).run(joins);
}

BuiltTree build_tree(const Decomposition& decomposition, std::span<const std::string> names,
                     const TreeRequest& request) {
  std::vector<NamedPart> parts;
  for (std::size_t k = 0; k < decomposition.parts.size(); ++k) {
    parts.push_back({names[k], decomposition.parts[k].mesh});
  }
  return build_tree(parts, joins_of(decomposition), request);
}

}  // namespace convexact
