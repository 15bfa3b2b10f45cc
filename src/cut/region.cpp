// SPDX-License-Identifier: MIT
#include "cut/region.hpp"

#include <algorithm>
#include <map>

namespace convexact {
namespace {

using CornerPair = std::pair<std::uint32_t, std::uint32_t>;

class RegionCutter {
 public:
  RegionCutter(std::span<const Region::Face> faces, std::uint32_t plane,
               std::span<const CutPlane> planes, CutPoints& points)
      : plane_(plane), planes_(planes), points_(points) {
    for (const Region::Face& face : faces) {
      for (std::size_t k = 0; k < face.corners.size(); ++k) {
        const std::uint32_t a = face.corners[k], b = face.corners[(k + 1) % face.corners.size()];
        side_.try_emplace(a, points.side(planes[plane], a));
        face_of_[{a, b}] = face.plane;
      }
    }
  }

  // The side where the plane's values have this sign.
  Region keep(std::span<const Region::Face> faces, Sign sign) {
    std::vector<Region::Face> kept;
    std::map<std::uint32_t, std::uint32_t> next;  // along the plane, against the other faces
    for (const Region::Face& face : faces) {
      const bool is_met = std::any_of(face.corners.begin(), face.corners.end(),
                                      [&](std::uint32_t c) { return side_[c] == sign; });
      if (!is_met) continue;
      Region::Face rest{face.plane, {}};
      std::vector<std::uint32_t> on_plane;
      for (std::size_t k = 0; k < face.corners.size(); ++k) {
        const std::uint32_t a = face.corners[k], b = face.corners[(k + 1) % face.corners.size()];
        if (side_[a] != -sign) rest.corners.push_back(a);
        if (side_[a] == Sign::Zero) on_plane.push_back(a);
        if (side_[a] == -side_[b] && side_[a] != Sign::Zero) {
          rest.corners.push_back(crossing(a, b, face.plane));
          on_plane.push_back(rest.corners.back());
        }
      }
      if (on_plane.size() == 2) add_side(rest, on_plane, next);
      kept.push_back(std::move(rest));
    }
    Region::Face own{plane_, {}};
    for (std::uint32_t c = next.begin()->first; own.corners.size() < next.size(); c = next.at(c)) {
      own.corners.push_back(c);
    }
    kept.push_back(std::move(own));
    return Region(std::move(kept));
  }

 private:
  // The new face runs against the old one along their common edge.
  static void add_side(const Region::Face& face, const std::vector<std::uint32_t>& ends,
                       std::map<std::uint32_t, std::uint32_t>& next) {
    for (std::size_t k = 0; k < face.corners.size(); ++k) {
      const std::uint32_t a = face.corners[k], b = face.corners[(k + 1) % face.corners.size()];
      if (a == ends[0] && b == ends[1]) next[b] = a;
      if (a == ends[1] && b == ends[0]) next[b] = a;
    }
  }

  std::uint32_t crossing(std::uint32_t a, std::uint32_t b, std::uint32_t face) {
    const auto [made, is_new] = crossings_.try_emplace(std::minmax(a, b), 0);
    if (is_new) {
      made->second = points_.add(
          meet(planes_[face].exact, planes_[face_of_.at({b, a})].exact, planes_[plane_].exact));
    }
    return made->second;
  }

  std::uint32_t plane_;
  std::span<const CutPlane> planes_;
  CutPoints& points_;
  std::map<std::uint32_t, Sign> side_;
  std::map<CornerPair, std::uint32_t>
      face_of_;  // the plane of the face that has this directed edge
  std::map<CornerPair, std::uint32_t> crossings_;
};

}  // namespace

std::vector<std::uint32_t> Region::corners() const {
  std::vector<std::uint32_t> all;
  for (const Face& face : faces_) all.insert(all.end(), face.corners.begin(), face.corners.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

// The mean of the corners: rounded, so that it has few bits, where that is certain to be inside.
RationalPoint Region::middle(std::span<const CutPlane> planes, const CutPoints& points) const {
  const std::vector<std::uint32_t> all = corners();
  Point near = Point::Zero();
  for (const std::uint32_t c : all) near += points.near(c);
  near /= static_cast<double>(all.size());
  const double certain = kCutError * 16;  // the mean is off by less than that
  if (!points.is_exact() && std::all_of(faces_.begin(), faces_.end(), [&](const Face& face) {
        return std::abs(planes[face.plane](near)) > certain;
      })) {
    return points.frame().point(near);
  }
  RationalPoint sum = RationalPoint::Zero();
  for (const std::uint32_t c : all) sum += points.exact(c);
  return sum / Rational(static_cast<long>(all.size()));
}

std::pair<Region, Region> Region::cut(std::uint32_t plane, std::span<const CutPlane> planes,
                                      CutPoints& points) const {
  RegionCutter cutter(faces_, plane, planes, points);
  return {cutter.keep(faces_, Sign::Negative), cutter.keep(faces_, Sign::Positive)};
}

}  // namespace convexact
