// SPDX-License-Identifier: MIT
#include "surface/nesting.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "number/roundoff.hpp"
#include "surface/box_tree.hpp"
#include "surface/common_point.hpp"

namespace convexact {
namespace {

// The sign of the volume that the triangles enclose: 6 V is the sum of the determinants of their
// corners, measured from one point.
Sign sign_of_volume(const Surface& surface, std::span<const std::uint32_t> triangles) {
  const PointId from = surface.triangles[triangles[0]][0];
  if (surface.points.is_binary()) {
    const auto points = surface.points.doubles();
    double sum = 0, size = 0;
    for (const std::uint32_t t : triangles) {
      const auto& [a, b, c] = surface.triangles[t];
      const Point p = points[a.index()] - points[from.index()],
                  q = points[b.index()] - points[from.index()],
                  r = points[c.index()] - points[from.index()];
      sum += p.dot(q.cross(r));
      size += p.cwiseAbs().dot(q.cwiseAbs().cross(r.cwiseAbs()).cwiseAbs()) +
              2 * p.cwiseAbs().maxCoeff() * q.cwiseAbs().maxCoeff() * r.cwiseAbs().maxCoeff();
    }
    // Each term is off by less than 16 u of its size, each addition by u of what it adds to.
    const double error =
        (static_cast<double>(triangles.size()) + 32) * 2 * kUnitRoundoff * size + 0x1p-900;
    if (std::abs(sum) > error) return sign_of(sum);
  }
  Rational sum = 0;
  const RationalPoint o = surface.points[from];
  for (const std::uint32_t t : triangles) {
    const auto& [a, b, c] = surface.triangles[t];
    sum += RationalVector3(surface.points[a] - o)
               .dot(RationalVector3(surface.points[b] - o)
                        .cross(RationalVector3(surface.points[c] - o)));
  }
  return sign_of(sum);
}

// A single closed component.
class Shell {
 public:
  Shell(const Surface& surface, std::vector<std::uint32_t> triangles)
      : surface_(surface), triangles_(std::move(triangles)) {
    for (const std::uint32_t t : triangles_) box_.include(box_of(t));
  }

  std::span<const std::uint32_t> triangles() const { return triangles_; }

  // Whether it lies in another: they have no common point, and the other winds about a vertex; or
  // they have a common edge, the other winds about all vertices that are not on it, and there are
  // some.
  bool lies_in(const Shell& other, const Watch& watch) const {
    for (int k = 0; k < 3; ++k) {
      if (box_.low[k] < other.box_.low[k] || other.box_.high[k] < box_.high[k]) return false;
    }
    if (!meets(other, watch)) {
      const PointId vertex = surface_.triangles[triangles_[0]][0];
      return other.winding()(surface_.points[vertex]).value_or(0) != 0;
    }
    if (!has_common_edge(other)) return false;
    std::set<PointId> vertices;
    for (const std::uint32_t t : triangles_) {
      vertices.insert(surface_.triangles[t].begin(), surface_.triangles[t].end());
    }
    bool is_inside = false;
    for (const PointId vertex : vertices) {
      watch.ask();
      const std::optional<long> winding = other.winding()(surface_.points[vertex]);
      if (winding == 0) return false;
      is_inside = is_inside || winding;
    }
    return is_inside;
  }

 private:
  NearBox box_of(std::uint32_t t) const {
    return convexact::box_of(surface_.points, surface_.triangles[t]);
  }

  bool has_common_edge(const Shell& other) const {
    std::set<std::pair<PointId, PointId>> edges;
    const auto edges_of = [&](std::uint32_t t, const auto& take) {
      const Triangle& corners = surface_.triangles[t];
      for (int k = 0; k < 3; ++k) take(std::minmax({corners[k], corners[(k + 1) % 3]}));
    };
    for (const std::uint32_t t : triangles_) edges_of(t, [&](const auto& e) { edges.insert(e); });
    bool is_common = false;
    for (const std::uint32_t t : other.triangles_) {
      edges_of(t, [&](const auto& e) { is_common = is_common || edges.contains(e); });
    }
    return is_common;
  }

  bool meets(const Shell& other, const Watch& watch) const {
    if (!other.tree_) {
      std::vector<NearBox> boxes;
      for (const std::uint32_t t : other.triangles_) boxes.push_back(box_of(t));
      other.tree_ = std::make_unique<BoxTree>(std::move(boxes));
    }
    std::vector<std::uint32_t> found;
    for (const std::uint32_t t : triangles_) {
      watch.ask();
      other.tree_->find(box_of(t), found);
      for (const std::uint32_t k : found) {
        if (have_common_point(surface_.points, surface_.triangles[t],
                              surface_.triangles[other.triangles_[k]])) {
          return true;
        }
      }
    }
    return false;
  }

  const Winding& winding() const {
    if (!winding_) {
      alone_.points = surface_.points;
      alone_.is_closed = true;
      for (const std::uint32_t t : triangles_) {
        alone_.triangles.push_back(surface_.triangles[t]);
      }
      winding_ = std::make_unique<Winding>(alone_);
    }
    return *winding_;
  }

  const Surface& surface_;
  std::vector<std::uint32_t> triangles_;
  NearBox box_;
  mutable Surface alone_;
  mutable std::unique_ptr<BoxTree> tree_;
  mutable std::unique_ptr<Winding> winding_;
};

}  // namespace

std::vector<bool> find_inside_out(const Surface& surface, const Watch& watch) {
  const std::size_t count = surface.components.size();
  std::vector<std::vector<std::uint32_t>> triangles(count);
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    triangles[surface.component[t]].push_back(t);
  }
  std::vector<std::size_t> components;
  std::vector<std::unique_ptr<Shell>> shells;
  for (std::size_t k = 0; k < count; ++k) {
    const SurfaceComponent& component = surface.components[k];
    if (!component.is_closed || !component.is_orientable || component.is_flat) continue;
    components.push_back(k);
    shells.push_back(std::make_unique<Shell>(surface, std::move(triangles[k])));
  }
  std::vector<std::vector<std::size_t>> around(shells.size());
  for (std::size_t i = 0; i < shells.size(); ++i) {
    for (std::size_t k = 0; k < shells.size(); ++k) {
      if (i != k && shells[i]->lies_in(*shells[k], watch)) around[i].push_back(k);
    }
  }
  std::vector<bool> is_inside_out(count, false);
  for (std::size_t i = 0; i < shells.size(); ++i) {
    std::size_t outermost = i;
    for (const std::size_t k : around[i]) {
      if (around[k].empty()) {
        outermost = k;
        break;
      }
    }
    is_inside_out[components[i]] =
        sign_of_volume(surface, shells[outermost]->triangles()) == Sign::Negative;
  }
  return is_inside_out;
}

}  // namespace convexact
