// SPDX-License-Identifier: MIT
// union_distance_pieces.cpp - how far pieces of a surface are from a union of parts: the farthest
// point among some, against a tolerance, and as an enclosure. docs/design/union-distance.md.
#include <algorithm>
#include <queue>
#include <utility>

#include "convexact/error.hpp"
#include "convexact/overlay.hpp"
#include "overlay/union_distance_near.hpp"

namespace convexact {
namespace {

RationalPoint mean(std::span<const RationalPoint> points) {
  RationalPoint sum = points.front();
  for (const RationalPoint& x : points.subspan(1)) sum += x;
  return sum / Rational(points.size());
}

NearFrame frame_of(std::span<const UncoveredPiece> pieces, std::span<const ConvexPart> parts) {
  std::vector<BoundingBox> boxes;
  for (const ConvexPart& part : parts) boxes.push_back(part.box);
  for (const UncoveredPiece& piece : pieces) boxes.push_back(bounding_box(piece.corners));
  return frame_around(boxes);
}

// A point whose exact distance may be the largest one.
struct Contender {
  std::size_t piece;
  std::size_t corner;  // or the number of corners: the centroid
  NearBounds distance;
};

RationalPoint point_of(std::span<const UncoveredPiece> pieces, const Contender& contender) {
  const std::vector<RationalPoint>& corners = pieces[contender.piece].corners;
  return contender.corner < corners.size() ? corners[contender.corner] : mean(corners);
}

std::vector<Contender> find_contenders(std::span<const UncoveredPiece> pieces,
                                       const NearParts& near, const Watch& watch) {
  std::vector<Contender> list;
  double best = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    watch.at(i, pieces.size());
    const std::vector<RationalPoint>& corners = pieces[i].corners;
    for (std::size_t k = 0; k < corners.size() + (corners.size() > 1 ? 1 : 0); ++k) {
      Contender next{i, k, {}};
      next.distance = near.to_union(near.frame()(point_of(pieces, next)));
      if (next.distance.high < best) continue;
      best = std::max(best, next.distance.low);
      list.push_back(next);
    }
  }
  std::erase_if(list, [&](const Contender& c) { return c.distance.high < best; });
  return list;
}

// Symmetric inputs have many; if there are more than this, the bounds choose.
constexpr std::size_t kExactContenders = 16;

}  // namespace

std::optional<FarPoint> farthest_found(std::span<const UncoveredPiece> uncovered,
                                       const UnionDistance& distance, const Watch& watch) {
  if (uncovered.empty()) return {};
  const NearParts near(distance.parts(), frame_of(uncovered, distance.parts()));
  std::vector<Contender> list = find_contenders(uncovered, near, watch);
  std::stable_sort(list.begin(), list.end(), [](const Contender& a, const Contender& b) {
    return a.distance.high > b.distance.high;
  });
  if (list.size() > kExactContenders) list.resize(kExactContenders);
  std::sort(list.begin(), list.end(), [](const Contender& a, const Contender& b) {
    return std::pair(a.piece, a.corner) < std::pair(b.piece, b.corner);
  });
  std::optional<FarPoint> best;
  const auto try_point = [&](TriangleId triangle, RationalPoint x) {
    NearestPart nearest = distance(x);
    if (best && nearest.squared <= best->nearest.squared) return;
    best = FarPoint{triangle, std::move(x), std::move(nearest)};
  };
  for (const Contender& c : list) {
    watch.ask();
    try_point(uncovered[c.piece].triangle, point_of(uncovered, c));
  }
  // The distance is too small for doubles: corners may lie on the union, centroids do not.
  for (std::size_t i = 0; i < uncovered.size() && best->nearest.squared == 0; ++i) {
    watch.ask();
    try_point(uncovered[i].triangle, mean(uncovered[i].corners));
  }
  return best;
}

namespace {

// ---- Subdivision

// Pieces, bisected where the upper bound of the distance is largest. Each corner keeps the results
// about itself and each part; pieces share corners.
class PieceSearch {
 public:
  struct Piece {
    TriangleId triangle;
    std::vector<std::uint32_t> corners;  // a polygon, a triangle, a segment or a point
    std::vector<std::uint32_t> parts;    // that may be the nearest to one of its points; ascending
    double upper = 0;                    // of the largest distance
    double size = 0;                     // its longest side
    std::size_t order = 0;
  };

  PieceSearch(std::span<const UncoveredPiece> pieces, const UnionDistance& distance,
              const Watch& watch)
      : distance_(distance),
        watch_(watch),
        near_(distance.parts(), frame_of(pieces, distance.parts())) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      watch.at(i, pieces.size());
      Piece piece{pieces[i].triangle, {}, {}};
      for (const RationalPoint& x : pieces[i].corners) piece.corners.push_back(add_corner(x));
      piece.size = longest_side(piece);
      const Point& first = corners_[piece.corners.front()].near;
      piece.parts = near_.candidates(first, reach_from_first(piece));
      first_.push_back(std::move(piece));
    }
  }

  const NearFrame& frame() const { return near_.frame(); }
  std::vector<Piece>& first() { return first_; }
  const RationalPoint& point(std::uint32_t corner) const { return corners_[corner].exact; }
  std::size_t bisections() const { return bisections_; }

  // A piece cut in two through the middle of its longest side; a polygon of more than three sides
  // into a fan of triangles.
  std::vector<Piece> cut(const Piece& piece) {
    watch_.at(bisections_++, kReachPieces);
    const std::vector<std::uint32_t>& c = piece.corners;
    std::vector<Piece> result;
    const auto add = [&](std::vector<std::uint32_t> corners) {
      Piece half{piece.triangle, std::move(corners), {}};
      half.size = longest_side(half);
      keep_candidates(half, piece.parts);
      result.push_back(std::move(half));
    };
    if (c.size() > 3) {
      for (std::size_t k = 1; k + 1 < c.size(); ++k) add({c[0], c[k], c[k + 1]});
      return result;
    }
    std::size_t at = 0;
    for (std::size_t k = 1; k < c.size(); ++k) {
      if (side(piece, k) > side(piece, at)) at = k;
    }
    const std::uint32_t a = c[at], b = c[(at + 1) % c.size()];
    const RationalPoint middle = (corners_[a].exact + corners_[b].exact) / Rational(2);
    const std::uint32_t m = add_corner(middle);
    if (c.size() == 2) {
      add({a, m});
      add({m, b});
    } else {
      const std::uint32_t apex = c[(at + 2) % 3];
      add({a, m, apex});
      add({m, b, apex});
    }
    return result;
  }

  // The least over the parts of the largest distance of a corner: an upper bound for all points of
  // the piece, because a dilated convex set is convex.
  double upper_bound(const Piece& piece) {
    double least = std::numeric_limits<double>::infinity();
    for (const std::uint32_t p : piece.parts) {
      double largest = 0;
      for (const std::uint32_t c : piece.corners) {
        if (near_.box_distance(p, corners_[c].near) >= least) {
          largest = least;
          break;
        }
        largest = std::max(largest, known(c, p).bounds.high);
        if (largest >= least) break;
      }
      least = std::min(least, largest);
    }
    return least;
  }

  // Bounds of the distance of a corner to the union. `parts` may leave out parts that are not
  // nearest.
  const NearBounds& to_union(std::uint32_t corner, const std::vector<std::uint32_t>& parts) {
    if (!corners_[corner].to_union) {
      constexpr double kInfinity = std::numeric_limits<double>::infinity();
      NearBounds all{kInfinity, kInfinity};
      for (const std::uint32_t p : parts) {
        if (near_.box_distance(p, corners_[corner].near) > all.high) continue;
        const NearBounds& bounds = known(corner, p).bounds;
        all = {std::min(all.low, bounds.low), std::min(all.high, bounds.high)};
      }
      corners_[corner].to_union = all;
    }
    return *corners_[corner].to_union;
  }

  // ---- Against a tolerance, exactly

  void set_tolerance(const Rational& squared) {
    squared_tolerance_ = squared;
    tolerance_ = {frame().root_down(squared), frame().root_up(squared)};
  }

  bool is_within(std::uint32_t corner, std::uint32_t part) {
    Known& entry = known(corner, part);
    if (entry.bounds.high <= tolerance_.low) return true;
    if (entry.bounds.low > tolerance_.high) return false;
    if (!entry.is_within) {
      const RationalPoint& x = corners_[corner].exact;
      const RationalVector3 gap = x - distance_.nearest_in(part, x);
      entry.is_within = gap.squaredNorm() <= squared_tolerance_;
    }
    return *entry.is_within;
  }

  // Whether all corners are within the tolerance of one and the same part.
  bool is_within_one(const Piece& piece) {
    return std::any_of(piece.parts.begin(), piece.parts.end(), [&](std::uint32_t p) {
      return std::all_of(piece.corners.begin(), piece.corners.end(), [&](std::uint32_t c) {
        return !(near_.box_distance(p, corners_[c].near) > tolerance_.high) && is_within(c, p);
      });
    });
  }

  // Whether a corner is farther than the tolerance from all parts.
  bool is_beyond(std::uint32_t corner, const std::vector<std::uint32_t>& parts) {
    const NearBounds bounds = to_union(corner, parts);
    if (bounds.high <= tolerance_.low) return false;
    if (bounds.low > tolerance_.high) return true;
    return std::none_of(parts.begin(), parts.end(), [&](std::uint32_t p) {
      return !(near_.box_distance(p, corners_[corner].near) > tolerance_.high) &&
             is_within(corner, p);
    });
  }

  bool is_tiny(const Piece& piece) const { return piece.size < tolerance_.low * 0x1p-20; }

 private:
  // The data on a corner and a part.
  struct Known {
    std::uint32_t part;
    NearBounds bounds;
    std::optional<bool> is_within;
  };
  struct Corner {
    RationalPoint exact;
    Point near;
    std::vector<Known> known;
    std::optional<NearBounds> to_union;
  };

  std::uint32_t add_corner(const RationalPoint& x) {
    corners_.push_back({x, near_.frame()(x), {}, {}});
    return static_cast<std::uint32_t>(corners_.size() - 1);
  }

  Known& known(std::uint32_t corner, std::uint32_t part) {
    Corner& c = corners_[corner];
    for (Known& entry : c.known) {
      if (entry.part == part) return entry;
    }
    c.known.push_back({part, near_.to_part(part, c.near), {}});
    return c.known.back();
  }

  double side(const Piece& piece, std::size_t k) const {
    const std::vector<std::uint32_t>& c = piece.corners;
    return (corners_[c[k]].near - corners_[c[(k + 1) % c.size()]].near).norm();
  }

  double longest_side(const Piece& piece) const {
    double longest = 0;
    for (std::size_t k = 0; k < piece.corners.size(); ++k) {
      longest = std::max(longest, side(piece, k));
    }
    return longest;
  }

  double reach_from_first(const Piece& piece) const {
    double reach = 0;
    for (const std::uint32_t c : piece.corners) {
      reach = std::max(reach, (corners_[c].near - corners_[piece.corners.front()].near).norm());
    }
    return reach + 2 * kDistanceError;
  }

  // Keeps those parts of the whole piece that are not too far from the first corner: with d the
  // distance of that corner to the union, a part more than d + 2r from it is not the nearest to any
  // point within r of it.
  void keep_candidates(Piece& half, const std::vector<std::uint32_t>& parts) {
    const std::uint32_t first = half.corners.front();
    const double reach = to_union(first, parts).high + 2.125 * reach_from_first(half);
    for (const std::uint32_t p : parts) {
      if (!(near_.box_distance(p, corners_[first].near) > reach)) half.parts.push_back(p);
    }
  }

  const UnionDistance& distance_;
  const Watch& watch_;
  NearParts near_;
  std::vector<Corner> corners_;
  std::vector<Piece> first_;
  std::size_t bisections_ = 0;
  Rational squared_tolerance_;
  NearBounds tolerance_;
};

// The largest upper bound first; of equal ones the older piece.
struct ByUpperBound {
  bool operator()(const PieceSearch::Piece& a, const PieceSearch::Piece& b) const {
    return a.upper != b.upper ? a.upper < b.upper : a.order > b.order;
  }
};

class PieceQueue {
 public:
  bool is_empty() const { return queue_.empty(); }
  const PieceSearch::Piece& top() const { return queue_.top(); }
  void add(PieceSearch::Piece piece) {
    piece.order = next_order_++;
    queue_.push(std::move(piece));
  }
  PieceSearch::Piece take() {
    PieceSearch::Piece piece = queue_.top();
    queue_.pop();
    return piece;
  }

 private:
  std::priority_queue<PieceSearch::Piece, std::vector<PieceSearch::Piece>, ByUpperBound> queue_;
  std::size_t next_order_ = 0;
};

}  // namespace

// Pieces that are not within the tolerance of one part are in the queue, or in `tiny`.
WithinDistance is_within(std::span<const UncoveredPiece> uncovered, const UnionDistance& distance,
                         const Rational& squared_tolerance, const Watch& watch) {
  if (squared_tolerance < 0) throw Error(ErrorCode::InvalidArgument, "a negative tolerance");
  std::optional<FarPoint> farthest = farthest_found(uncovered, distance, watch);
  if (!farthest) return {};
  if (farthest->nearest.squared > squared_tolerance) return {Reach::Beyond, farthest, {}};

  PieceSearch search(uncovered, distance, watch);
  search.set_tolerance(squared_tolerance);
  PieceQueue queue;
  std::optional<double> tiny;  // the largest upper bound of those that are too small
  std::optional<FarPoint> beyond;
  const auto judge = [&](PieceSearch::Piece piece) {
    if (search.is_within_one(piece)) return;
    for (const std::uint32_t c : piece.corners) {
      if (!search.is_beyond(c, piece.parts)) continue;
      const RationalPoint& x = search.point(c);
      beyond = FarPoint{piece.triangle, x, distance(x)};
      return;
    }
    piece.upper = search.upper_bound(piece);
    if (search.is_tiny(piece)) {
      tiny = std::max(tiny.value_or(0), piece.upper);
    } else {
      queue.add(std::move(piece));
    }
  };
  for (PieceSearch::Piece& piece : search.first()) {
    judge(std::move(piece));
    if (beyond) return {Reach::Beyond, beyond, {}};
  }
  while (!queue.is_empty() && search.bisections() < kReachPieces) {
    for (PieceSearch::Piece& half : search.cut(queue.take())) {
      judge(std::move(half));
      if (beyond) return {Reach::Beyond, beyond, {}};
    }
  }
  if (queue.is_empty() && !tiny) return {};
  const double upper = std::max(tiny.value_or(0), queue.is_empty() ? 0 : queue.top().upper);
  const Rational high = search.frame().length(upper);
  return {Reach::Undecided, farthest, SquaredBracket{farthest->nearest.squared, high * high}};
}

namespace {

// Bits of the bounds of distances, which rarely differ by less than 1/kDistanceSteps.
constexpr long kDistanceBits = 64;

}  // namespace

// The largest lower bound among all corners, the largest upper bound among all pieces.
DirectedDistance surface_to_union(std::span<const UncoveredPiece> uncovered,
                                  const UnionDistance& distance, const Rational& squared_diameter,
                                  const Watch& watch) {
  if (squared_diameter <= 0) throw Error(ErrorCode::InvalidArgument, "a diameter that is not > 0");
  if (uncovered.empty()) return {Enclosure(kDistanceBits), {}};
  PieceSearch search(uncovered, distance, watch);
  // A little less, for the roundings of the bounds.
  const double gap = search.frame().root_down(squared_diameter) * (1 - 0x1p-10) / kDistanceSteps;
  PieceQueue queue;
  double lower = -1;
  std::uint32_t farthest = 0;
  const auto add = [&](PieceSearch::Piece piece) {
    for (const std::uint32_t c : piece.corners) {
      const double low = search.to_union(c, piece.parts).low;
      if (low > lower) {
        lower = low;
        farthest = c;
      }
    }
    piece.upper = search.upper_bound(piece);
    queue.add(std::move(piece));
  };
  for (PieceSearch::Piece& piece : search.first()) add(std::move(piece));
  while (queue.top().upper > lower + gap && search.bisections() < kReachPieces &&
         queue.top().corners.size() > 1) {
    for (PieceSearch::Piece& half : search.cut(queue.take())) add(std::move(half));
  }
  const RationalPoint& x = search.point(farthest);
  const Rational squared = distance(x).squared;
  const Enclosure root = sqrt(Enclosure(squared, kDistanceBits));
  const Rational high = std::max<Rational>(root.high(), search.frame().length(queue.top().upper));
  DirectedDistance result{Enclosure(root.low(), high, kDistanceBits), {}};
  if (squared != 0) result.at = x;
  return result;
}

}  // namespace convexact
