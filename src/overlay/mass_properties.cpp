// SPDX-License-Identifier: MIT
// Mass properties as sums over a boundary: of the cones from one point over triangles of it. With
// corners a, b, c as seen from the point, a cone has the volume V = det(a, b, c) / 6, the first
// moment V (a + b + c) / 4, and the second moment V (a a' + b b' + c c' + s s') / 20, s = a + b +
// c.
#include "convexact/mass.hpp"
#include "overlay/solid_boundary.hpp"
#include "overlay/union_boundary.hpp"

namespace convexact {
namespace {

// The entries of a symmetric matrix, in the order of MassProperties.
constexpr std::pair<int, int> kEntries[] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};

class MassSum {
 public:
  explicit MassSum(RationalPoint origin) : origin_(std::move(origin)) {}

  void add(Arrangement<3>& arrangement, const ConvexPiece<3>& piece, bool looks_out) {
    std::vector<RationalVector3> corners;
    for (const auto& corner : piece.corners) {
      corners.emplace_back(arrangement.point(corner.at) - origin_);
    }
    for (std::size_t k = 2; k < corners.size(); ++k) {
      add_cone(corners[0], corners[looks_out ? k - 1 : k], corners[looks_out ? k : k - 1]);
    }
  }

  std::optional<MassProperties> total() {
    MassProperties made;
    made.volume = balanced_sum(std::move(volumes_)) / 6;
    if (made.volume == 0) return {};
    RationalVector3 offset;
    for (int k = 0; k < 3; ++k) {
      offset[k] = balanced_sum(std::move(first_[k])) / (24 * made.volume);
    }
    made.center = origin_ + offset;
    for (std::size_t e = 0; e < 6; ++e) {
      const auto [i, k] = kEntries[e];
      // About the origin, less that of all mass at the center.
      made.moments[e] =
          balanced_sum(std::move(second_[e])) / 120 - made.volume * offset[i] * offset[k];
    }
    return made;
  }

 private:
  void add_cone(const RationalVector3& a, const RationalVector3& b, const RationalVector3& c) {
    const Rational six = a.dot(b.cross(c));
    if (six == 0) return;
    const RationalVector3 sum = a + b + c;
    volumes_.push_back(six);
    for (int k = 0; k < 3; ++k) first_[k].push_back(six * sum[k]);
    for (std::size_t e = 0; e < 6; ++e) {
      const auto [i, k] = kEntries[e];
      second_[e].push_back(six * (a[i] * a[k] + b[i] * b[k] + c[i] * c[k] + sum[i] * sum[k]));
    }
  }

  RationalPoint origin_;
  std::vector<Rational> volumes_;
  std::array<std::vector<Rational>, 3> first_;
  std::array<std::vector<Rational>, 6> second_;
};

}  // namespace

std::array<Rational, 6> MassProperties::inertia() const {
  const auto& m = moments;
  return {m[1] + m[2], m[0] + m[2], m[0] + m[1], -m[3], -m[4], -m[5]};
}

std::optional<MassProperties> mass_properties(const Surface& surface, const Watch& watch) {
  const Winding winding(surface);
  if (surface.points.size() == 0) return {};
  MassSum sum(bounding_box(surface.points).middle());
  const auto visit = [&](const SolidPiece& p) {
    sum.add(p.arrangement, p.piece, p.looks_out);
    return true;
  };
  visit_uncovered_boundary(surface, winding, {}, common_exponent(surface, {}), visit, watch);
  return sum.total();
}

std::optional<MassProperties> mass_properties(std::span<const ConvexPart> parts,
                                              const Watch& watch) {
  std::vector<BoundingBox> boxes;
  std::vector<RationalPoint> ends;
  for (const ConvexPart& part : parts) {
    if (!part.solid) continue;
    boxes.push_back(part.box);
    ends.push_back(part.box.low);
    ends.push_back(part.box.high);
  }
  if (boxes.empty()) return {};
  const UnionBoundary boundary(parts, common_exponent(boxes));
  MassSum sum(bounding_box(ends).middle());
  std::size_t done = 0;
  for (const UnionBoundary::FacetId f : boundary.facets()) {
    watch.at(done++, boundary.facets().size());
    if (auto rest = boundary.rest(f)) {
      for (const ConvexPiece<3>& piece : rest->pieces) sum.add(rest->arrangement, piece, true);
    }
  }
  return sum.total();
}

}  // namespace convexact
