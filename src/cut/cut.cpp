// SPDX-License-Identifier: MIT
// cut(): the leaf that reaches farthest is cut, until all are near the solid.
#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "convexact/error.hpp"
#include "convexact/hull.hpp"
#include "convexact/overlay.hpp"
#include "convexact/partition.hpp"
#include "cut/choose_plane.hpp"
#include "cut/notches.hpp"
#include "hull/near_solid.hpp"
#include "surface/box_tree.hpp"
#include "task/parallel.hpp"

namespace convexact {
namespace {

// Directions of planes through the farthest point: the axes first, then those to the middles of
// edges and to corners of a cube, and some between.
std::vector<Point> directions() {
  std::vector<Point> list;
  for (int longest = 1; longest <= 2; ++longest) {
    for (int nonzero = 1; nonzero <= 3; ++nonzero) {
      for (int u = 0; u <= longest; ++u) {
        for (int v = -longest; v <= longest; ++v) {
          for (int w = -longest; w <= longest; ++w) {
            const int most = std::max({u, std::abs(v), std::abs(w)});
            const int count = (u != 0) + (v != 0) + (w != 0);
            const bool is_first = u > 0 || v > 0 || (v == 0 && w > 0);
            const bool is_new = longest == 1 || u == 1 || std::abs(v) == 1 || std::abs(w) == 1;
            if (most != longest || count != nonzero || !is_first || !is_new) continue;
            if (u == 0 && v < 0) continue;
            list.emplace_back(u, v, w);
          }
        }
      }
    }
  }
  return list;
}

// Leaves that are cut so often are halved from then on.
constexpr int kDeepest = 40;
// So many leaves are judged at a time for each thread, as one may take longer than others.
constexpr std::size_t kChoicesPerThread = 4;
// So many facets' planes are tried at a time where there are no notches.
constexpr std::size_t kMostFacets = 100;

class Cutter {
 public:
  Cutter(const Surface& surface, const Winding* winding, ReachLimit& limit,
         const PartitionOptions& options)
      : winding_(winding),
        limit_(limit),
        options_(options),
        points_(surface, limit.frame(), options.is_exact),
        notches_(surface, points_, options.planes),
        cutter_(surface, winding, points_, planes_, options.watch) {}

  Partition run() {
    made_.squared_limit = limit_.squared_limit();
    made_.squared_diameter = bounding_box(points_.surface().points).squared_diameter();
    std::array<Leaf, 1> whole{Leaf{box(), {}, {}, notches_.all()}};
    for (std::uint32_t t = 0; t < points_.surface().triangles.size(); ++t) {
      whole[0].pieces.push_back({t, {}});
    }
    add_nodes(whole, {});
    while (!waiting_.empty()) {
      if (options_.max_leaves && leaf_count_ >= *options_.max_leaves) {
        made_.stopped_by_count = true;
        break;
      }
      options_.watch.at(0, 0);
      const Waiting next = *waiting_.begin();
      if (!choices_[next.node]) choose_planes();
      waiting_.erase(waiting_.begin());
      split(next.node);
    }
    for (std::uint32_t n = 0; n < made_.nodes.size(); ++n) {
      if (leaves_[n]) made_.leaves.push_back({n, {}, {}, false, is_within_[n]});
    }
    for_each_in_parallel(made_.leaves.size(), options_.jobs,
                         [&](std::size_t k) { describe(made_.leaves[k]); });
    return std::move(made_);
  }

 private:
  // The farthest first, of equal ones the lowest node.
  struct Waiting {
    double distance;
    std::uint32_t node;
    Point far;
    bool operator<(const Waiting& other) const {
      return std::pair(-distance, node) < std::pair(-other.distance, other.node);
    }
  };

  // Around the surface, and a little larger, so that no corner of it is in the solid.
  Region box() {
    Point low = points_.near(0), high = low;
    for (std::uint32_t p = 0; p < points_.surface().points.size(); ++p) {
      low = low.cwiseMin(points_.near(p));
      high = high.cwiseMax(points_.near(p));
    }
    constexpr double kMargin = 0x1p-6, kStep = 0x1p-8;
    RationalPoint ends[2];
    Point at[2];
    for (int k = 0; k < 3; ++k) {
      at[0][k] = std::floor((low[k] - kMargin) / kStep) * kStep;
      at[1][k] = std::ceil((high[k] + kMargin) / kStep) * kStep;
    }
    ends[0] = points_.frame().point(at[0]);
    ends[1] = points_.frame().point(at[1]);
    std::array<std::uint32_t, 8> corners{};
    for (unsigned k = 0; k < 8; ++k) {
      corners[k] = points_.add({ends[k & 1][0], ends[(k >> 1) & 1][1], ends[(k >> 2) & 1][2]});
    }
    std::vector<Region::Face> faces;
    for (int axis = 0; axis < 3; ++axis) {
      for (const bool is_high : {false, true}) {
        RationalVector3 normal = RationalVector3::Zero();
        normal[axis] = is_high ? 1 : -1;
        Region::Face& face = faces.emplace_back(
            Region::Face{add_plane(Halfspace(normal, Rational(-normal.dot(ends[is_high])))), {}});
        const unsigned own = 1u << axis, u = 1u << (axis + 1) % 3, v = 1u << (axis + 2) % 3;
        const unsigned first = is_high ? own : 0;
        for (const unsigned k : {0u, is_high ? u : v, u | v, is_high ? v : u}) {
          face.corners.push_back(corners[first | k]);
        }
      }
    }
    return Region(std::move(faces));
  }

  std::uint32_t add_plane(Halfspace plane) {
    planes_.emplace_back(std::move(plane), points_.frame());
    return static_cast<std::uint32_t>(planes_.size() - 1);
  }

  std::vector<Point> near_points(const Leaf& leaf) const {
    std::vector<Point> near;
    for (const std::uint32_t id : leaf.points(points_.surface())) near.push_back(points_.near(id));
    return near;
  }

  // Those that hold nothing of the solid are nodes, too.
  void add_nodes(std::span<Leaf> leaves, std::optional<std::uint32_t> parent) {
    std::vector<std::uint32_t> added;
    std::vector<std::vector<Point>> points;
    for (Leaf& leaf : leaves) {
      const auto n = static_cast<std::uint32_t>(made_.nodes.size());
      made_.nodes.push_back({parent});
      depth_.push_back(parent ? depth_[*parent] + 1 : 0);
      is_within_.push_back(true);
      choices_.emplace_back();
      leaves_.emplace_back();
      std::vector<Point> near = near_points(leaf);
      if (near.empty()) continue;
      leaves_[n] = std::make_unique<Leaf>(std::move(leaf));
      added.push_back(n);
      points.push_back(std::move(near));
    }
    leaf_count_ += added.size();
    const auto far = limit_.farthest_of_each(points, options_.jobs, options_.watch);
    for (std::size_t k = 0; k < added.size(); ++k) {
      if (!far[k]) continue;
      waiting_.insert({far[k]->distance, added[k], far[k]->point});
      is_within_[added[k]] = false;
    }
  }

  // A plane for the farthest leaf, and on several threads for those that come after it: what plane
  // cuts a leaf does not depend on the others.
  void choose_planes() {
    std::size_t most = options_.jobs == 1 ? 1 : kChoicesPerThread * options_.jobs;
    if (options_.max_leaves) most = std::min(most, *options_.max_leaves - leaf_count_);
    std::vector<Waiting> open;
    for (auto next = waiting_.begin(); next != waiting_.end() && open.size() < most; ++next) {
      if (!choices_[next->node]) open.push_back(*next);
    }
    const std::size_t each = std::max<std::size_t>(1, options_.jobs / open.size());
    for_each_in_parallel(open.size(), options_.jobs, [&](std::size_t i) {
      choices_[open[i].node] = choose(open[i].node, open[i].far, each);
    });
  }

  struct Choice {
    std::optional<CutPlane> plane;
    std::size_t planes_tried = 0;
  };

  // @param jobs  Threads for this leaf alone.
  Choice choose(std::uint32_t n, const Point& far, std::size_t jobs) const {
    const Leaf& leaf = *leaves_[n];
    std::vector<CutPlane> tried;
    const auto add = [&](const Halfspace& plane) {
      const bool is_known = std::any_of(tried.begin(), tried.end(),
                                        [&](const CutPlane& x) { return x.exact == plane; });
      if (!is_known) tried.emplace_back(plane, points_.frame());
    };
    const auto add_through_far = [&] {
      for (const Point& direction : directions()) {
        add(plane_across(direction, far, points_.frame()));
      }
    };
    const bool only_facets = options_.planes == CutPlanes::Facets;
    if (only_facets || depth_[n] < kDeepest) {
      for (const Halfspace& plane : notches_.planes(leaf.notches)) add(plane);
      if (options_.planes == CutPlanes::All) add_through_far();
    } else {
      add(halving_plane(leaf));
    }
    Choice choice;
    const auto try_all = [&] {
      choice.planes_tried += tried.size();
      const auto best = choose_plane(leaf, far, tried, points_, winding_, jobs, options_.watch);
      if (best) choice.plane = tried[*best];
    };
    try_all();
    if (!choice.plane && options_.planes == CutPlanes::Bisectors) {
      tried.clear();
      add_through_far();
      try_all();
    }
    // Bodies with room between them have no notch there.
    for (std::size_t k = 0; !choice.plane && only_facets && k < leaf.pieces.size();) {
      tried.clear();
      for (; k < leaf.pieces.size() && tried.size() < kMostFacets; ++k) {
        const std::uint32_t t = leaf.pieces[k].triangle;
        if (has_no_area(points_.surface().points, points_.surface().triangles[t])) continue;
        add(turned(triangle_plane(points_.surface(), t)));
      }
      try_all();
    }
    return choice;
  }

  void split(std::uint32_t n) {
    const Leaf& leaf = *leaves_[n];
    const Choice choice = *std::exchange(choices_[n], {});
    made_.planes_tried += choice.planes_tried;
    if (!choice.plane) return;
    planes_.push_back(*choice.plane);
    const auto plane = static_cast<std::uint32_t>(planes_.size() - 1);
    auto [lower, upper] = cutter_.cut(leaf, plane, made_.nodes[n].raised);
    std::array<Leaf, 2> halves{std::move(lower), std::move(upper)};
    halves[0].notches = notches_.clipped(leaf.notches, planes_[plane], Sign::Negative);
    halves[1].notches = notches_.clipped(leaf.notches, planes_[plane], Sign::Positive);
    leaves_[n].reset();
    --leaf_count_;
    const auto first = static_cast<std::uint32_t>(made_.nodes.size());
    made_.nodes[n].plane = planes_[plane].exact;
    made_.nodes[n].children = {first, first + 1};
    add_nodes(halves, n);
  }

  // Across the longest side of the leaf's box: what is so small that it lies within T of any of its
  // points is not cut any more, so this ends.
  Halfspace halving_plane(const Leaf& leaf) const {
    NearBox box;
    for (const Point& y : near_points(leaf)) box.include(y);
    int axis = 0;
    (void)(box.high - box.low).maxCoeff(&axis);
    return plane_across(Point::Unit(axis), (box.low + box.high) / 2, points_.frame());
  }

  // The triangles and corners of a leaf.
  void describe(PartitionLeaf& made) const {
    const Watch watch = options_.watch.without_reports();
    watch.ask();
    const Leaf& leaf = *leaves_[made.node];
    for (const Piece& piece : leaf.pieces) made.triangles.emplace_back(piece.triangle);
    const PointSet points = outer_points(leaf);
    const HullOutcome outcome = convex_hull(points, {.watch = watch});
    const auto* hull = std::get_if<Hull>(&outcome);
    made.is_flat = hull == nullptr;
    made.corners = hull != nullptr ? subset(points, hull->vertices)
                                   : PointSet(convex_part(points, watch).vertices);
  }

  // The points of the leaf but those that are certainly inside of their hull.
  PointSet outer_points(const Leaf& leaf) const {
    constexpr double kInside = 0x1p-40;
    const NearSolid solid = near_solid(near_points(leaf));
    std::vector<RationalPoint> corners;
    for (const std::uint32_t id : leaf.points(points_.surface())) {
      const Point& y = points_.near(id);
      const bool is_inside =
          !points_.is_exact() && !solid.planes.empty() &&
          std::all_of(solid.planes.begin(), solid.planes.end(), [&](const NearSolid::Plane& plane) {
            return plane.normal.dot(y) + plane.offset < -kInside;
          });
      if (!is_inside) corners.push_back(points_.exact(id));
    }
    return PointSet(std::move(corners));
  }

  const Winding* winding_;
  ReachLimit& limit_;
  const PartitionOptions& options_;
  CutPoints points_;
  std::vector<CutPlane> planes_;
  Notches notches_;
  LeafCutter cutter_;
  Partition made_;
  std::vector<std::unique_ptr<Leaf>> leaves_;   // by node; none of those that are cut or empty
  std::vector<bool> is_within_;                 // by node
  std::vector<int> depth_;                      // by node
  std::vector<std::optional<Choice>> choices_;  // by node, where it was made and not yet used
  std::set<Waiting> waiting_;
  std::size_t leaf_count_ = 0;
};

}  // namespace

Partition cut(const Surface& surface, const Winding* winding, ReachLimit& limit,
              const PartitionOptions& options) {
  require_threads(options.jobs);
  return Cutter(surface, winding, limit, options).run();
}

}  // namespace convexact
