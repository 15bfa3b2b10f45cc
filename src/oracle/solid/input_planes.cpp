// SPDX-License-Identifier: MIT
// Which planes of the input's hull a candidate still has.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "convexact/number.hpp"
#include "near/near_plane.hpp"
#include "oracle/solid/judge.hpp"
#include "surface/box_tree.hpp"

namespace convexact::oracle {
namespace {

// Planes of a solid as points of its dual: p = n / D for n.x <= D, seen from a point inside of it.
// A plane that comes near x has a p.x near 1, so a tree of these points finds it. Only a filter.
class DualTree {
 public:
  /// @param most  How far from a plane, in units of its largest normal component, is near.
  /// @param largest  Bounds all coordinates.
  DualTree(std::span<const DoubleHalfspace> planes, const Point& inside, double largest,
           double most)
      : count_(planes.size()), inside_(inside) {
    double least = HUGE_VAL;
    for (const DoubleHalfspace& h : planes) least = std::min(least, -h(inside));
    if (!(least > 0x1p-500 && largest < 0x1p500)) return;
    // Rounding moves D and x by less than 2^-45 of the largest coordinate.
    near_ = (most + kUnit * largest) / least;
    relative_ = kUnit + kUnit * largest / least;
    std::vector<NearBox> boxes(planes.size());
    for (std::size_t i = 0; i < planes.size(); ++i) {
      const DoubleHalfspace& h = planes[i];
      boxes[i].include(Point(h.n[0], h.n[1], h.n[2]) / -h(inside));
    }
    tree_.emplace(std::move(boxes));
  }

  /// Ascending, and among others all planes that come near all corners.
  std::vector<std::uint32_t> near(std::span<const Point> corners) const {
    std::vector<std::uint32_t> found;
    if (!tree_) {
      found.resize(count_);
      std::iota(found.begin(), found.end(), 0u);
      return found;
    }
    NearBox all;
    all.low.setConstant(-HUGE_VAL);
    all.high.setConstant(HUGE_VAL);
    const auto may_hold = [&](const NearBox& box) {
      return std::all_of(corners.begin(), corners.end(), [&](const Point& x) {
        const Point at = x - inside_;
        const Point one = box.low.cwiseProduct(at), other = box.high.cwiseProduct(at);
        const double size = one.cwiseAbs().cwiseMax(other.cwiseAbs()).sum();
        const double off = near_ + relative_ * size;
        return one.cwiseMin(other).sum() <= 1 + off && 1 - off <= one.cwiseMax(other).sum();
      });
    };
    tree_->find_if(all, may_hold, found);
    return found;
  }

 private:
  static constexpr double kUnit = 0x1p-45;

  const std::size_t count_;
  const Point inside_;
  double near_ = 0, relative_ = 0;
  std::optional<BoxTree> tree_;  // none where doubles are too short for it
};

// Finds the facet planes of the input's hull that are so near to every corner of a patch that
// rounding, in any program, explains the distance.
class NearPlanes {
 public:
  NearPlanes(const Polytope& polytope, Precision precision, const Polytope& input)
      : polytope_(polytope),
        planes_(input.planes),
        near_planes_(input.planes.begin(), input.planes.end()),
        slack_(
            kRoundingUlps *
            unit_in_last_place(precision, bounding_box(polytope.vertices).largest_coordinate())) {
    for (const RationalPoint& v : polytope.vertices) vertices_.push_back(rounded(v));
    Point sum = Point::Zero();
    double largest = 0;
    const auto count = static_cast<double>(input.vertices.size());
    for (const RationalPoint& v : input.vertices) sum += rounded(v) / count;
    for (const Point& v : vertices_) largest = std::max(largest, v.lpNorm<Eigen::Infinity>());
    largest = std::max(largest,
                       to_double(bounding_box(input.vertices).largest_coordinate(), Rounding::Up));
    arrays_.emplace(vertices_);
    // No component of a normal is above 1 there.
    most_ = 3 * to_double(slack_, Rounding::Up);
    tree_.emplace(near_planes_, sum, largest, most_);
  }

  // The first plane that is near to all corners of the patch.
  std::optional<Halfspace> near(const std::vector<std::uint32_t>& patch) const {
    std::vector<Point> corners;
    for (const std::uint32_t v : polytope_.facets[patch[0]]) corners.push_back(vertices_[v]);
    for (const std::uint32_t i : tree_->near(corners)) {
      if (may_be_near(i, patch[0]) && is_near(planes_[i], patch)) return planes_[i];
    }
    return std::nullopt;
  }

 private:
  static Point rounded(const RationalPoint& x) {
    Point near;
    for (int k = 0; k < 3; ++k) near[k] = to_double(x[k], Rounding::Nearest);
    return near;
  }
  bool may_be_near(std::uint32_t plane, std::uint32_t facet) const {
    const std::vector<std::uint32_t>& corners = polytope_.facets[facet];
    const double absolute = absolute_plane_error(arrays_->largest);
    return std::all_of(corners.begin(), corners.end(), [&](std::uint32_t v) {
      const NearValue near = near_planes_[plane].at(*arrays_, v, absolute);
      return !(std::abs(near.value) - near.error > most_);
    });
  }
  bool is_near(const Halfspace& h, const std::vector<std::uint32_t>& patch) const {
    Rational limit = 0;
    for (const Integer& n : h.normal()) limit += Rational(abs(n)) * slack_;
    return std::all_of(patch.begin(), patch.end(), [&](std::uint32_t f) {
      const auto& corners = polytope_.facets[f];
      return std::all_of(corners.begin(), corners.end(),
                         [&](std::uint32_t v) { return abs(h(polytope_.vertices[v])) <= limit; });
    });
  }

  const Polytope& polytope_;
  std::span<const Halfspace> planes_;
  std::vector<DoubleHalfspace> near_planes_;
  const Rational slack_;
  std::vector<Point> vertices_;
  std::optional<CoordinateArrays> arrays_;  // of these
  double most_ = 0;  // how far from a plane is near, in units of its largest normal component
  std::optional<DualTree> tree_;
};

}  // namespace

void count_planes_of_the_input(Trial& trial) {
  const Polytope& polytope = *trial.set.polytope;
  CandidateSize& size = trial.verdict.size;
  const std::vector<Halfspace>& planes = trial.input.hull.planes;  // in canonical order
  std::optional<NearPlanes> near;  // most candidates of many facets have all planes exactly
  std::vector<std::vector<std::uint32_t>> patches = trial.set.patches;
  if (patches.empty()) {  // halfspaces: each facet is one
    for (std::uint32_t f = 0; f < polytope.facets.size(); ++f) patches.push_back({f});
  }
  const Watch watch(trial.stop());
  size.planes_of_the_input.emplace();
  for (const auto& patch : patches) {
    watch.ask();
    const auto exact = std::find_if(patch.begin(), patch.end(), [&](std::uint32_t f) {
      return std::binary_search(planes.begin(), planes.end(), polytope.planes[f]);
    });
    if (exact != patch.end()) {
      size.planes_of_the_input->push_back(polytope.planes[*exact]);
      continue;
    }
    if (!near) near.emplace(polytope, size.slack.precision, trial.input.hull);
    if (auto plane = near->near(patch)) size.planes_of_the_input->push_back(std::move(*plane));
  }
}

}  // namespace convexact::oracle
