// SPDX-License-Identifier: MIT
// Forward selection: a hull of few vertices grows by the vertex that recovers the most volume; the
// directions are those of its facets.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "convexact/geometry.hpp"
#include "lab/compare/method.hpp"

namespace convexact {
namespace {

using Corner = std::uint32_t;
using Piece = std::array<Corner, 3>;  // counter-clockwise from outside

Point cross(const Point& a, const Point& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
          a.x() * b.y() - a.y() * b.x()};
}
double dot(const Point& a, const Point& b) { return a.x() * b.x() + a.y() * b.y() + a.z() * b.z(); }

// The hull of selected vertices. Visibility of triangles is decided exactly for the rounded
// vertices, so the surface stays closed; volumes are doubles.
class GrowingHull {
 public:
  explicit GrowingHull(std::span<const Point> points) : points_(points) {}

  /// The extreme pair of the widest axis, the vertex farthest from their line, and that farthest
  /// from the plane of the three. @return  False if the rounded vertices are all in one plane.
  bool start();
  /// The vertex outside that adds the most volume, the first on a tie; none if there is none.
  std::optional<Corner> best() const;
  void add(Corner apex);
  std::span<const Piece> pieces() const { return pieces_; }

 private:
  const Point& at(Corner v) const { return points_[v]; }
  bool sees(Corner v, const Piece& t) const {
    return is_beyond(at(t[0]), at(t[1]), at(t[2]), at(v));
  }
  // Six times the volume of the tetrahedron.
  double six_volumes(const Piece& t, Corner v) const {
    const Point a = at(t[0]) - at(v), b = at(t[1]) - at(v), c = at(t[2]) - at(v);
    return std::abs(dot(a, cross(b, c)));
  }
  template <class Score>
  Corner highest(const Score& score) const {
    Corner best = 0;
    double most = -1;
    for (Corner v = 0; v < points_.size(); ++v) {
      const double value = score(at(v));
      if (value <= most) continue;
      best = v;
      most = value;
    }
    return best;
  }

  std::span<const Point> points_;
  std::vector<Piece> pieces_;
};

bool GrowingHull::start() {
  Piece base{};
  double widest = -1;
  for (const int k : {0, 1, 2}) {
    const auto by_axis = [k](const Point& a, const Point& b) { return a[k] < b[k]; };
    const auto [low, high] = std::minmax_element(points_.begin(), points_.end(), by_axis);
    if ((*high)[k] - (*low)[k] <= widest) continue;
    widest = (*high)[k] - (*low)[k];
    base[0] = static_cast<Corner>(low - points_.begin());
    base[1] = static_cast<Corner>(high - points_.begin());
  }
  const Point a = at(base[0]), b = at(base[1]);
  base[2] = highest([&](const Point& p) {
    const Point n = cross(b - a, p - a);
    return dot(n, n);
  });
  const Point normal = cross(b - a, at(base[2]) - a);
  const Corner top = highest([&](const Point& p) { return std::abs(dot(normal, p - a)); });
  const Sign side = orient3d(a, b, at(base[2]), at(top));
  if (side == Sign::Zero) return false;
  // Seen from outside, the base turns away from the top.
  if (side == Sign::Negative) std::swap(base[0], base[1]);
  pieces_ = {base};
  for (const int k : {0, 1, 2}) pieces_.push_back({base[(k + 1) % 3], base[k], top});
  return true;
}

std::optional<Corner> GrowingHull::best() const {
  std::optional<Corner> best;
  double most = 0;
  for (Corner v = 0; v < points_.size(); ++v) {
    double gain = 0;
    for (const Piece& t : pieces_) {
      if (sees(v, t)) gain += six_volumes(t, v);
    }
    if (gain <= most) continue;
    best = v;
    most = gain;
  }
  return best;
}

void GrowingHull::add(Corner apex) {
  const auto hidden = std::stable_partition(pieces_.begin(), pieces_.end(),
                                            [&](const Piece& t) { return !sees(apex, t); });
  const std::vector<Piece> visible(hidden, pieces_.end());
  pieces_.erase(hidden, pieces_.end());
  const auto has_edge = [&](Corner tail, Corner head) {
    return std::any_of(visible.begin(), visible.end(), [&](const Piece& t) {
      return (t[0] == tail && t[1] == head) || (t[1] == tail && t[2] == head) ||
             (t[2] == tail && t[0] == head);
    });
  };
  // An edge of a visible triangle is on the horizon if no visible one lies on its other side.
  for (const Piece& t : visible) {
    for (const std::size_t k : {0u, 1u, 2u}) {
      const Corner tail = t[k], head = t[(k + 1) % 3];
      if (!has_edge(head, tail)) pieces_.push_back({tail, head, apex});
    }
  }
}

// Directions of the facets, each once. A triangle that exists only by rounding is left out.
Normals facet_directions(const Polytope& hull, std::span<const Piece> pieces) {
  std::vector<Halfspace> facets;
  for (const auto& [a, b, c] : pieces) {
    const RationalPoint &p = hull.vertices[a], &q = hull.vertices[b], &r = hull.vertices[c];
    const RationalVector3 normal = (q - p).cross(r - p);
    if (!normal.isZero()) facets.emplace_back(normal, Rational(0));
  }
  std::sort(facets.begin(), facets.end());
  facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
  Normals normals;
  for (const Halfspace& facet : facets) normals.push_back(facet.normal().cast<Rational>());
  return normals;
}

}  // namespace

Normals propose_mck(const HullToFit& hull, std::size_t faces, std::uint64_t) {
  GrowingHull growing(hull.vertices);
  if (!growing.start()) return {};
  Normals chosen = facet_directions(hull.polytope(), growing.pieces());
  while (const auto next = growing.best()) {
    hull.watch.ask();
    growing.add(*next);
    Normals grown = facet_directions(hull.polytope(), growing.pieces());
    if (grown.size() > faces) break;
    chosen = std::move(grown);
  }
  return chosen;
}

}  // namespace convexact
