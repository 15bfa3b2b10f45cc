// SPDX-License-Identifier: MIT
#include "decompose/near_rays.hpp"

#include <algorithm>
#include <cmath>

#include "number/roundoff.hpp"

namespace convexact {
namespace {

/// More than three roundings.
constexpr double kUp = 1 + 8 * kUnitRoundoff, kDown = 1 - 8 * kUnitRoundoff;
constexpr std::size_t kMostCuts = 8, kMostRounds = 24;
/// A point that is moved by this share towards the middle has a ray that is hardly shorter, and
/// keeps off planes beside the triangle that hold the ray.
constexpr double kInward = 0x1p-26;

}  // namespace

RayBound moved(RayBound ray, const std::vector<std::int32_t>& same) {
  bool holds = ray.planes[0] >= 0 || ray.planes[1] >= 0 || ray.planes[2] >= 0;
  for (std::int32_t& plane : ray.planes) {
    if (plane < 0) continue;
    plane = same[static_cast<std::size_t>(plane)];
    holds = holds && plane >= 0;
  }
  return holds ? ray : RayBound{.item = ray.item};
}

void NearRays::assign(std::span<const Point> corners, const Point& unit, double error) {
  count_ = corners.size();
  unit_ = unit;
  error_ = error;
  for (std::size_t k = 0; k < 3; ++k)
    corners_[k] = corners[std::min(k, count_ - 1)] - facets_.origin;
}

Point NearRays::at(const Weights& weights) const {
  if (count_ == 1) return corners_[0];
  return weights[0] * corners_[0] + weights[1] * corners_[1] + weights[2] * corners_[2];
}

// Not proven to be the first plane: any plane gives an upper bound.
std::int32_t NearRays::plane_ahead(const Weights& weights) const {
  const Point x = at(weights);
  std::int32_t first = -1;
  double least = kNoBound;
  for (std::size_t h = 0; h < facets_.planes.size(); ++h) {
    const NearFacets::Plane& plane = facets_.planes[h];
    const NearValue along = plane.along(unit_, error_);
    const double depth = plane.depth(x);
    // This decides nearly all planes, those that face away as well, without a division.
    if (depth > least * along.value * kUp) continue;
    if (!along.surely_positive()) continue;
    const double f = std::max(0.0, depth) / along.value;
    if (f < least) {
      least = f;
      first = static_cast<std::int32_t>(h);
    }
  }
  return first;
}

// The least f over all planes: a plane whose n.m may be positive counts.
double NearRays::low_at(const Weights& weights) const {
  const Point x = at(weights);
  double least = kNoBound;
  for (const NearFacets::Plane& plane : facets_.planes) {
    const NearValue along = plane.along(unit_, error_);
    const double most = along.value + along.error;
    if (most <= 0) continue;
    const double room = plane.depth(x) - plane.depth_error;
    least = room <= 0 ? 0 : std::min(least, room / most);
    if (least == 0) return 0;
  }
  return least == kNoBound ? 0 : least * kDown;
}

bool NearRays::add_cut(std::int32_t plane) {
  for (const Cut& cut : cuts_) {
    if (cut.plane == plane) return false;
  }
  if (plane < 0) return false;
  const NearFacets::Plane& h = facets_.planes[static_cast<std::size_t>(plane)];
  const NearValue along = h.along(unit_, error_);
  const double least = along.value - along.error;
  if (!(least > 0)) return false;
  Cut cut{plane, {}, true};
  for (std::size_t k = 0; k < 3; ++k) {
    const double depth = h.depth(corners_[k]);
    cut.high[k] = (std::max(0.0, depth) + h.depth_error) / least * kUp;
    cut.is_rounding = cut.is_rounding && depth <= h.depth_error;
  }
  cuts_.push_back(cut);
  return true;
}

void NearRays::bound_quickly(RayBound& ray) {
  cuts_.clear();
  if (add_cut(plane_ahead({1.0 / 3, 1.0 / 3, 1.0 / 3}))) tighten(ray);
}

void NearRays::bound_by(std::span<const std::int32_t> planes, RayBound& ray) {
  for (const std::int32_t plane : planes) {
    cuts_.clear();
    if (add_cut(plane)) tighten(ray);
  }
}

// Where the least of the cuts is highest: at a corner, where two cuts meet on an edge, or where
// three meet.
NearRays::Weights NearRays::highest_point() const {
  Weights best{1, 0, 0};
  double highest = -1;
  const auto look = [&](const Weights& w) {
    double least = kNoBound;
    for (const Cut& cut : cuts_) {
      least = std::min(least, w[0] * cut.high[0] + w[1] * cut.high[1] + w[2] * cut.high[2]);
    }
    if (least > highest) {
      highest = least;
      best = w;
    }
  };
  for (std::size_t k = 0; k < 3; ++k) {
    Weights corner{};
    corner[k] = 1;
    look(corner);
  }
  for (std::size_t i = 0; i < cuts_.size(); ++i) {
    for (std::size_t j = i + 1; j < cuts_.size(); ++j) {
      std::array<double, 3> difference;
      for (std::size_t k = 0; k < 3; ++k) difference[k] = cuts_[i].high[k] - cuts_[j].high[k];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        if ((difference[k] < 0) == (difference[next] < 0)) continue;
        Weights on_edge{};
        on_edge[next] = difference[k] / (difference[k] - difference[next]);
        on_edge[k] = 1 - on_edge[next];
        look(on_edge);
      }
      for (std::size_t l = j + 1; l < cuts_.size(); ++l) {
        // w with (cut i - cut j).w = 0 and (cut i - cut l).w = 0.
        std::array<double, 3> other;
        for (std::size_t k = 0; k < 3; ++k) other[k] = cuts_[i].high[k] - cuts_[l].high[k];
        Weights w;
        for (std::size_t k = 0; k < 3; ++k) {
          const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
          w[k] = difference[a] * other[b] - difference[b] * other[a];
        }
        const double sum = w[0] + w[1] + w[2];
        if (sum == 0) continue;
        for (double& each : w) each /= sum;
        if (w[0] > 0 && w[1] > 0 && w[2] > 0) look(w);
      }
    }
  }
  return best;
}

// The weighted mean of up to three cuts whose largest corner is lowest. Any weights give an upper
// bound, so how they were found does not matter.
void NearRays::tighten(RayBound& ray) const {
  for (const Cut& cut : cuts_) ray.is_rounding = ray.is_rounding || cut.is_rounding;
  const auto look = [&](std::array<std::size_t, 3> used, Weights weights) {
    double sum = 0;
    std::array<double, 3> corner{};
    for (std::size_t i = 0; i < 3; ++i) {
      if (!(weights[i] > 0)) continue;
      sum += weights[i];
      for (std::size_t k = 0; k < 3; ++k) corner[k] += weights[i] * cuts_[used[i]].high[k];
    }
    const double high = std::max({corner[0], corner[1], corner[2]}) / sum * kUp;
    if (!(high < ray.high)) return;
    ray.high = high;
    for (std::size_t i = 0; i < 3; ++i) {
      ray.planes[i] = weights[i] > 0 ? cuts_[used[i]].plane : -1;
    }
  };
  for (std::size_t i = 0; i < cuts_.size(); ++i) {
    const auto& a = cuts_[i].high;
    look({i, i, i}, {1, 0, 0});
    for (std::size_t j = i + 1; j < cuts_.size(); ++j) {
      const auto& b = cuts_[j].high;
      for (std::size_t k = 0; k < 3; ++k) {  // corners k and k + 1 become equal
        const std::size_t next = (k + 1) % 3;
        const double at_a = a[k] - a[next], at_b = b[k] - b[next];
        if ((at_a < 0) != (at_b < 0)) look({i, j, j}, {std::abs(at_b), std::abs(at_a), 0});
      }
      for (std::size_t l = j + 1; l < cuts_.size(); ++l) {
        const auto& c = cuts_[l].high;
        // Weights with equal corners: both differences of corners vanish.
        const std::array<double, 3> x{a[0] - a[1], b[0] - b[1], c[0] - c[1]};
        const std::array<double, 3> y{a[1] - a[2], b[1] - b[2], c[1] - c[2]};
        Weights w{x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
        if (w[0] + w[1] + w[2] < 0) w = {-w[0], -w[1], -w[2]};
        if (w[0] > 0 && w[1] > 0 && w[2] > 0) look({i, j, l}, w);
      }
    }
  }
}

double NearRays::bound_tightly(RayBound& ray, double enough) {
  cuts_.clear();
  for (const std::int32_t plane : ray.planes) (void)add_cut(plane);
  if (cuts_.empty()) (void)add_cut(plane_ahead({1.0 / 3, 1.0 / 3, 1.0 / 3}));
  if (cuts_.empty()) return 0;
  Weights best{1.0 / 3, 1.0 / 3, 1.0 / 3};
  for (std::size_t round = 0; round < kMostRounds; ++round) {
    tighten(ray);
    if (ray.high <= enough) return 0;
    best = count_ == 1 ? Weights{1, 0, 0} : highest_point();
    if (!add_cut(plane_ahead(best))) break;
    if (cuts_.size() <= kMostCuts) continue;
    // The cut that is highest there matters least.
    const auto value = [&](const Cut& cut) {
      return best[0] * cut.high[0] + best[1] * cut.high[1] + best[2] * cut.high[2];
    };
    cuts_.erase(std::max_element(cuts_.begin(), cuts_.end(),
                                 [&](const Cut& a, const Cut& b) { return value(a) < value(b); }));
  }
  tighten(ray);
  const double low = low_at(best);
  if (count_ == 1 || low >= ray.high * (1 - kInward)) return low;
  Weights inward;
  for (std::size_t k = 0; k < 3; ++k) inward[k] = best[k] + kInward * (1.0 / 3 - best[k]);
  return std::max(low, low_at(inward));
}

}  // namespace convexact
