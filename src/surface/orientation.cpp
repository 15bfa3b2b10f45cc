// SPDX-License-Identifier: MIT
#include "surface/orientation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "number/arithmetic.hpp"
#include "number/precision.hpp"
#include "number/roundoff.hpp"
#include "surface/edges.hpp"
#include "surface/nesting.hpp"

namespace convexact {
namespace {

// ---- Patches, each consistent in itself

constexpr std::uint32_t kNoPatch = ~std::uint32_t{0};

struct ConsistentPatches {
  std::vector<std::uint32_t> of;   // by triangle
  std::vector<bool> turns;         // by triangle: against the patch's lowest
  std::vector<bool> has_one_side;  // by patch
};

ConsistentPatches consistent_patches(const EdgeTable& edges, std::size_t triangles) {
  struct Neighbor {
    std::uint32_t triangle;
    bool runs_alike;  // along the common edge, so that one is to be turned
  };
  std::vector<std::vector<Neighbor>> neighbors(triangles);
  edges.for_each([&](std::span<const EdgeUse> uses) {
    if (uses.size() != 2 || uses[0].triangle == uses[1].triangle) return;
    const bool alike = uses[0].is_forward == uses[1].is_forward;
    neighbors[uses[0].triangle].push_back({uses[1].triangle, alike});
    neighbors[uses[1].triangle].push_back({uses[0].triangle, alike});
  });
  ConsistentPatches patches{std::vector(triangles, kNoPatch), std::vector(triangles, false), {}};
  for (std::uint32_t seed = 0; seed < triangles; ++seed) {
    if (patches.of[seed] != kNoPatch) continue;
    const auto patch = static_cast<std::uint32_t>(patches.has_one_side.size());
    patches.has_one_side.push_back(false);
    patches.of[seed] = patch;
    std::vector<std::uint32_t> queue{seed};
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const std::uint32_t t = queue[next];
      for (const auto& [other, alike] : neighbors[t]) {
        const bool turn = patches.turns[t] != alike;
        if (patches.of[other] == kNoPatch) {
          patches.of[other] = patch;
          patches.turns[other] = turn;
          queue.push_back(other);
        } else if (patches.turns[other] != turn) {
          patches.has_one_side[patch] = true;
        }
      }
    }
  }
  for (std::size_t t = 0; t < triangles; ++t) {
    if (patches.has_one_side[patches.of[t]]) patches.turns[t] = false;
  }
  return patches;
}

// By patch at an edge: how often it runs forward, less how often back.
std::map<std::uint32_t, int> net_runs(std::span<const EdgeUse> uses,
                                      const ConsistentPatches& patches) {
  std::map<std::uint32_t, int> net;
  for (const EdgeUse& use : uses) {
    const bool is_forward = use.is_forward != patches.turns[use.triangle];
    net[patches.of[use.triangle]] += is_forward ? 1 : -1;
  }
  std::erase_if(net, [](const auto& run) { return run.second == 0; });
  return net;
}

// ---- Patches that are joined

// Groups of patches, and whether each is turned against the first of its group.
class PatchGroups {
 public:
  explicit PatchGroups(std::size_t patches) : parent_(patches), is_against_(patches, false) {
    for (std::size_t k = 0; k < patches; ++k) parent_[k] = static_cast<std::uint32_t>(k);
  }
  std::pair<std::uint32_t, bool> root(std::uint32_t patch) const {
    bool against = false;
    for (; parent_[patch] != patch; patch = parent_[patch]) against ^= is_against_[patch];
    return {patch, against};
  }
  /// False if the two are joined in the other way already.
  bool join(std::uint32_t a, std::uint32_t b, bool against) {
    const auto [x, x_against] = root(a);
    const auto [y, y_against] = root(b);
    const bool between = (x_against != y_against) != against;
    if (x == y) return !between;
    parent_[std::max(x, y)] = std::min(x, y);
    is_against_[std::max(x, y)] = between;
    return true;
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<bool> is_against_;  // the parent
};

// The signs, the first positive, with which runs along an edge add up to zero, if there is exactly
// one choice.
std::optional<std::vector<bool>> only_choice(const std::map<std::uint32_t, int>& net) {
  std::optional<std::vector<bool>> found;
  for (unsigned choice = 0; choice < 1u << (net.size() - 1); ++choice) {
    int sum = 0, k = 0;
    std::vector<bool> against;
    for (const auto& [patch, runs] : net) {
      const bool is_against = k > 0 && (choice >> (k - 1) & 1) != 0;
      against.push_back(is_against);
      sum += is_against ? -runs : runs;
      ++k;
    }
    if (sum != 0) continue;
    if (found) return std::nullopt;
    found = against;
  }
  return found;
}

void join_patches(const EdgeTable& edges, const ConsistentPatches& patches, PatchGroups& joins,
                  Orientation& orientation) {
  constexpr std::size_t kMostTriangles = 4;
  edges.for_each([&](std::span<const EdgeUse> uses) {
    if (uses.size() <= 2) return;
    const std::map<std::uint32_t, int> net = net_runs(uses, patches);
    if (net.empty()) return;
    const bool is_even = uses.size() % 2 == 0;  // an odd number never cancels: it is a border
    const auto choice = uses.size() <= kMostTriangles && net.size() > 1 && is_even
                            ? only_choice(net)
                            : std::nullopt;
    bool is_joined = choice.has_value();
    if (choice) {
      std::size_t k = 0;
      for (const auto& [patch, runs] : net) {
        is_joined = joins.join(net.begin()->first, patch, (*choice)[k++]) && is_joined;
      }
    }
    orientation.ambiguous_edges += is_joined || !is_even ? 0 : 1;
  });
}

// ---- The direction with the larger area

// Twice the areas of triangles, as doubles and as enclosures.
struct AreaSum {
  double value = 0, error = 0;
  std::vector<std::uint32_t> triangles;
};

// To first order a cross product is off by 8 u of the sizes of its products, a root and a sum by
// few u more; points that are no doubles are rounded before: 64 u of the sizes of all covers it.
void add_area(const Surface& surface, std::uint32_t t, AreaSum& sum) {
  const auto points = surface.points.doubles();
  const auto& [a, b, c] = surface.triangles[t];
  const Point& p = points[a.index()];
  const Point e = points[b.index()] - p, f = points[c.index()] - p;
  const double largest = std::max({p.cwiseAbs().maxCoeff(), points[b.index()].cwiseAbs().maxCoeff(),
                                   points[c.index()].cwiseAbs().maxCoeff()});
  sum.value += e.cross(f).norm();
  sum.error +=
      64 * kUnitRoundoff * (largest * (e.norm() + f.norm()) + e.norm() * f.norm()) + 0x1p-900;
  sum.triangles.push_back(t);
}

Enclosure enclosed(const Surface& surface, const AreaSum& sum, long bits) {
  Enclosure total(bits);
  for (const std::uint32_t t : sum.triangles) {
    const Rational squared = area_vector(surface.points, surface.triangles[t]).squaredNorm();
    total = total + sqrt(Enclosure(squared, bits));
  }
  return total;
}

// Positive if the first area is larger; zero if no enclosure tells them apart.
Sign compare_areas(const Surface& surface, const AreaSum& x, const AreaSum& y) {
  const double rounding = static_cast<double>(x.triangles.size() + y.triangles.size()) *
                          kUnitRoundoff * (x.value + y.value);
  const double error = 2 * (x.error + y.error + rounding);
  if (x.value - y.value > error) return Sign::Positive;
  if (y.value - x.value > error) return Sign::Negative;
  for (long bits = 128; bits <= kAreaBits; bits *= 2) {
    const auto sign = (enclosed(surface, x, bits) - enclosed(surface, y, bits)).sign();
    if (sign && *sign != Sign::Zero) return *sign;
  }
  return Sign::Zero;
}

// Turns each group so that most of its area stays.
void keep_larger_areas(const Surface& surface, const std::vector<std::uint32_t>& group,
                       std::vector<bool>& turns) {
  std::map<std::uint32_t, std::array<AreaSum, 2>> areas;  // staying, turned
  std::map<std::uint32_t, std::uint32_t> lowest;
  for (std::uint32_t t = 0; t < group.size(); ++t) {
    if (turns[t]) areas.try_emplace(group[t]);
    lowest.try_emplace(group[t], t);
  }
  for (std::uint32_t t = 0; t < group.size(); ++t) {
    const auto found = areas.find(group[t]);
    if (found != areas.end()) add_area(surface, t, found->second[turns[t] ? 1 : 0]);
  }
  std::map<std::uint32_t, bool> is_flipped;
  for (const auto& [root, sums] : areas) {
    const Sign larger = compare_areas(surface, sums[1], sums[0]);
    const std::size_t stay = sums[0].triangles.size(), turned = sums[1].triangles.size();
    is_flipped[root] = larger != Sign::Zero ? larger == Sign::Positive
                       : stay != turned     ? turned > stay
                                            : turns[lowest[root]];
  }
  for (std::uint32_t t = 0; t < group.size(); ++t) {
    const auto found = is_flipped.find(group[t]);
    if (found != is_flipped.end() && found->second) turns[t] = !turns[t];
  }
}

// ---- Closed groups

// The surface with groups in the place of components, turned so far.
Surface grouped(const Surface& surface, const std::vector<std::uint32_t>& group,
                const std::vector<bool>& turns, const std::vector<bool>& has_one_side) {
  Surface made;
  made.points = surface.points;
  made.triangles = surface.triangles;
  std::map<std::uint32_t, std::uint32_t> number;
  for (std::uint32_t t = 0; t < group.size(); ++t) {
    if (turns[t]) std::swap(made.triangles[t][1], made.triangles[t][2]);
    const auto [entry, is_new] =
        number.try_emplace(group[t], static_cast<std::uint32_t>(number.size()));
    if (is_new) {
      made.components.push_back({.is_closed = true, .is_orientable = true, .is_flat = true});
    }
    made.component.push_back(entry->second);
    SurfaceComponent& component = made.components[entry->second];
    component.is_orientable = component.is_orientable && !has_one_side[t];
    component.is_flat = component.is_flat && has_no_area(surface.points, surface.triangles[t]);
  }
  EdgeTable(made.triangles).for_each([&](std::span<const EdgeUse> uses) {
    std::map<std::uint32_t, int> net;
    for (const EdgeUse& use : uses) net[made.component[use.triangle]] += use.is_forward ? 1 : -1;
    for (const auto& [component, runs] : net) {
      if (runs != 0) made.components[component].is_closed = false;
    }
  });
  return made;
}

}  // namespace

Orientation find_orientation(const Surface& surface, const Watch& watch) {
  const EdgeTable edges(surface.triangles);
  const std::size_t count = surface.triangles.size();
  ConsistentPatches patches = consistent_patches(edges, count);
  watch.ask();
  Orientation orientation{std::vector(count, false), std::vector(surface.components.size(), false),
                          0};
  PatchGroups joins(patches.has_one_side.size());
  join_patches(edges, patches, joins, orientation);
  std::vector<std::uint32_t> group(count);
  std::vector<bool> has_one_side(count);
  for (std::uint32_t t = 0; t < count; ++t) {
    const auto [root, against] = joins.root(patches.of[t]);
    has_one_side[t] = patches.has_one_side[patches.of[t]];
    group[t] = root;
    orientation.turns[t] = patches.turns[t] != against;
    if (has_one_side[t]) orientation.has_one_side[surface.component[t]] = true;
  }
  keep_larger_areas(surface, group, orientation.turns);
  watch.ask();
  const Surface made = grouped(surface, group, orientation.turns, has_one_side);
  const std::vector<bool> is_inside_out = find_inside_out(made, watch);
  for (std::uint32_t t = 0; t < count; ++t) {
    if (is_inside_out[made.component[t]]) orientation.turns[t] = !orientation.turns[t];
  }
  return orientation;
}

}  // namespace convexact
