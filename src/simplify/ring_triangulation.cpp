// SPDX-License-Identifier: MIT
#include "simplify/ring_triangulation.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>

#include "convexact/error.hpp"

namespace convexact {
namespace {

constexpr std::uint32_t kOutside = std::numeric_limits<std::uint32_t>::max();

// Corners are positions in the ring; edge e runs from corner[e] to corner[e + 1].
struct Piece {
  std::array<std::uint32_t, 3> corner;
  DualPlane plane;
  std::array<std::uint32_t, 3> across = {kOutside, kOutside, kOutside};
  bool alive = true;
};

// One side of a piece.
struct PieceSide {
  std::uint32_t piece = kOutside;
  std::uint32_t edge = 0;
};

// The triangulation of a growing convex polygon whose corners are ring points.
class PolygonTriangulation {
 public:
  PolygonTriangulation(std::span<const DualPoint> points, std::span<const HalfspaceId> ring,
                       RingObserver* observer)
      : points_(points), ring_(ring), observer_(observer), rim_(ring.size()) {}

  void start(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  void insert(std::uint32_t p, std::uint32_t before, std::uint32_t after);
  RingTriangulation result() const;

 private:
  // A directed edge that a new piece must take, and the piece on its other side.
  struct Gap {
    std::uint32_t from, to;
    PieceSide side;
  };

  const DualPoint& point(std::uint32_t position) const { return points_[ring_[position].index()]; }
  std::uint32_t add(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  void glue(PieceSide a, PieceSide b);
  Gap gap_beyond(const Piece& piece, std::uint32_t edge) const;
  DualTriangle triangle(const Piece& piece) const {
    return {ring_[piece.corner[0]], ring_[piece.corner[1]], ring_[piece.corner[2]]};
  }
  void tell(std::uint32_t p, std::size_t first_new) const;

  std::span<const DualPoint> points_;
  std::span<const HalfspaceId> ring_;
  RingObserver* observer_;
  std::vector<Piece> pieces_;
  std::vector<PieceSide> rim_;  // the side along the polygon's edge that starts at a corner
  std::vector<Gap> open_;
  std::vector<DualTriangle> lost_;  // in the latest insertion, if it is observed
};

std::uint32_t PolygonTriangulation::add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  pieces_.push_back({{a, b, c}, plane_through(point(a), point(b), point(c))});
  return static_cast<std::uint32_t>(pieces_.size() - 1);
}

// Joins two sides; where b is outside, side a becomes part of the polygon's rim.
void PolygonTriangulation::glue(PieceSide a, PieceSide b) {
  pieces_[a.piece].across[a.edge] = b.piece;
  if (b.piece == kOutside) {
    rim_[pieces_[a.piece].corner[a.edge]] = a;
  } else {
    pieces_[b.piece].across[b.edge] = a.piece;
  }
}

void PolygonTriangulation::start(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const std::uint32_t piece = add(a, b, c);
  for (std::uint32_t e = 0; e < 3; ++e) glue({piece, e}, {});
  if (observer_ != nullptr) observer_->started(triangle(pieces_[piece]));
}

// The neighbour of a new piece over `edge` of a removed piece.
PolygonTriangulation::Gap PolygonTriangulation::gap_beyond(const Piece& piece,
                                                           std::uint32_t edge) const {
  const std::uint32_t from = piece.corner[edge], to = piece.corner[(edge + 1) % 3];
  const std::uint32_t neighbour = piece.across[edge];
  if (neighbour == kOutside) return {from, to, {}};
  const auto& corner = pieces_[neighbour].corner;
  const auto start = std::find(corner.begin(), corner.end(), to) - corner.begin();
  return {from, to, {neighbour, static_cast<std::uint32_t>(start)}};
}

// Inserts corner p into the polygon's edge from `before` to `after`. The pieces that p is strictly
// beyond are connected and start at that edge, if there are any. Degenerate: p level with a piece
// leaves it alone; where p, `before` and `after` are level with the removed point, the new piece is
// seen edge-on from there, yet it is a true triangle, for no three dual points are collinear.
void PolygonTriangulation::insert(std::uint32_t p, std::uint32_t before, std::uint32_t after) {
  open_.assign(1, {after, before, rim_[before]});
  lost_.clear();
  const std::size_t first_new = pieces_.size();
  std::uint32_t previous = kOutside;
  while (!open_.empty()) {
    const Gap gap = open_.back();
    open_.pop_back();
    if (gap.side.piece != kOutside && is_beyond(point(p), pieces_[gap.side.piece].plane)) {
      Piece& piece = pieces_[gap.side.piece];
      piece.alive = false;
      if (observer_ != nullptr) lost_.push_back(triangle(piece));
      // Last in, first out: the fan around p grows counter-clockwise, from `after` to `before`.
      open_.push_back(gap_beyond(piece, (gap.side.edge + 2) % 3));
      open_.push_back(gap_beyond(piece, (gap.side.edge + 1) % 3));
      continue;
    }
    const std::uint32_t piece = add(p, gap.from, gap.to);
    glue({piece, 1}, gap.side);
    glue({piece, 0}, previous == kOutside ? PieceSide{} : PieceSide{previous, 2});
    previous = piece;
  }
  glue({previous, 2}, {});
  if (observer_ != nullptr) tell(p, first_new);
}

void PolygonTriangulation::tell(std::uint32_t p, std::size_t first_new) const {
  std::vector<DualTriangle> gained;
  for (std::size_t n = first_new; n < pieces_.size(); ++n) gained.push_back(triangle(pieces_[n]));
  observer_->inserted(ring_[p], lost_, gained);
}

RingTriangulation PolygonTriangulation::result() const {
  RingTriangulation result;
  for (const Piece& piece : pieces_) {
    if (!piece.alive) continue;
    result.triangles.push_back(triangle(piece));
    result.planes.push_back(piece.plane);
  }
  return result;
}

}  // namespace

bool RingTriangulation::is_bounded() const {
  return std::all_of(planes.begin(), planes.end(),
                     [](const DualPlane& plane) { return plane.d > 0; });
}

RingTriangulation triangulate_ring(std::span<const DualPoint> points,
                                   std::span<const HalfspaceId> ring, Random& random,
                                   RingObserver* observer) {
  const auto k = static_cast<std::uint32_t>(ring.size());
  CONVEXACT_ASSERT(k >= 3);
  // (1) Take the corners away in random order, down to three, noting each one's neighbours.
  std::vector<std::uint32_t> order(k), before(k), after(k);
  std::iota(order.begin(), order.end(), 0u);
  shuffle(std::span(order), random);
  for (std::uint32_t t = 0; t < k; ++t) {
    before[t] = (t + k - 1) % k;
    after[t] = (t + 1) % k;
  }
  for (std::uint32_t m = k; m-- > 3;) {
    const std::uint32_t p = order[m];
    after[before[p]] = after[p];
    before[after[p]] = before[p];
  }
  // (2) Begin with the triangle that is left and put them back in reverse. A corner's neighbours
  //     are those of its removal, so seen backwards every insertion is a random one: it touches
  //     as many pieces as a random corner has, fewer than six on average.
  PolygonTriangulation polygon(points, ring, observer);
  std::sort(order.begin(), order.begin() + 3);
  polygon.start(order[0], order[1], order[2]);
  for (std::uint32_t m = 3; m < k; ++m) {
    polygon.insert(order[m], before[order[m]], after[order[m]]);
  }
  return polygon.result();
}

}  // namespace convexact
