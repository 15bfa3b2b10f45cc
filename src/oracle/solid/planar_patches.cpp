// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "convexact/linear_program.hpp"
#include "convexact/measure.hpp"
#include "convexact/number.hpp"
#include "convexact/verify.hpp"
#include "number/arithmetic.hpp"
#include "number/roundoff.hpp"

namespace convexact {
namespace {

using Corner = std::uint32_t;
using PatchCorners = std::span<const Corner>;
using Facet = std::uint32_t;

constexpr int kThinnest = 1024;  // of a solid whose facets are merged, in units of its slack

// For each vertex u for each of its coordinates.
std::vector<RationalVector3> slack_of(const Polytope& polytope, const Slack& slack) {
  const std::vector<RationalPoint>& vertices = polytope.vertices;
  if (slack.ulps_of_largest > 0) {
    const Rational ulp =
        unit_in_last_place(slack.precision, bounding_box(vertices).largest_coordinate());
    const Rational u = slack.ulps_of_largest * ulp;
    return std::vector<RationalVector3>(vertices.size(), RationalVector3(u, u, u));
  }
  std::vector<RationalVector3> result;
  for (const RationalPoint& v : vertices) {
    RationalVector3& u = result.emplace_back();
    for (int k = 0; k < 3; ++k) u[k] = unit_in_last_place(slack.precision, v[k]) / 2;
  }
  return result;
}

// Edges at which two facets meet at an angle that no rounding explains: decides in doubles which
// pairs of neighbouring facets can never be in one patch.
class HardEdges {
 public:
  HardEdges(const Polytope& polytope, std::span<const RationalVector3> slack) {
    const Rational largest = bounding_box(polytope.vertices).largest_coordinate();
    // By a power of two into [-1, 1], where products do not overflow.
    const int exponent = exponent_of(to_double(largest, Rounding::Down));
    const auto scaled = [&](const Rational& x) {
      return to_double(scale_by_power_of_two(x, -exponent), Rounding::Nearest);
    };
    for (std::size_t v = 0; v < slack.size(); ++v) {
      Point& p = points_.emplace_back();
      Point& u = errors_.emplace_back();
      for (int k = 0; k < 3; ++k) {
        p[k] = scaled(polytope.vertices[v][k]);
        u[k] = scaled(slack[v][k]) + kUnit * std::abs(p[k]) + kTiny;
      }
    }
  }

  // Whether the four points are not coplanar wherever they are within their errors.
  bool separates(Corner a, Corner b, Corner c, Corner d) const {
    const Corner others[] = {b, c, d};
    double m[3][3], e[3][3];
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        m[i][k] = points_[others[i]][k] - points_[a][k];
        e[i][k] = errors_[others[i]][k] + errors_[a][k];
      }
    }
    double determinant = 0, size = 0, change = 0;
    constexpr int kOrders[6][4] = {{0, 1, 2, 1},  {1, 2, 0, 1},  {2, 0, 1, 1},
                                   {0, 2, 1, -1}, {2, 1, 0, -1}, {1, 0, 2, -1}};
    for (const auto& [i, j, k, sign] : kOrders) {
      const double x = m[0][i], y = m[1][j], z = m[2][k];
      determinant += sign * (x * y * z);
      size += std::abs(x * y * z);
      change += e[0][i] * (std::abs(y) + e[1][j]) * (std::abs(z) + e[2][k]) +
                std::abs(x) * e[1][j] * (std::abs(z) + e[2][k]) + std::abs(x * y) * e[2][k];
    }
    // The rounding errors here are below 2^-49 of the sum of the sizes.
    return std::abs(determinant) > change + 16 * kUnit * size + kTiny;
  }

  // Four times the square of the area, in arbitrary units.
  double squared_area(PatchCorners corners) const {
    Vector3<double> sum(0, 0, 0);
    for (std::size_t k = 2; k < corners.size(); ++k) {
      const Vector3<double> u = points_[corners[k - 1]] - points_[corners[0]];
      const Vector3<double> v = points_[corners[k]] - points_[corners[0]];
      sum += u.cross(v);
    }
    return sum.dot(sum);
  }

 private:
  static constexpr double kUnit = 2 * kUnitRoundoff, kTiny = 0x1p-1000;
  std::vector<Point> points_, errors_;
};

struct Plane {
  RationalVector3 normal;
  Rational offset;

  // The largest error of n.p.
  Rational reach(const RationalVector3& slack) const {
    Rational sum = 0;
    for (int k = 0; k < 3; ++k) sum += abs(normal[k]) * slack[k];
    return sum;
  }
  // By how much more than that a point is off the plane; positive if it is not near.
  Rational excess(const RationalPoint& p, const RationalVector3& slack) const {
    return abs(Rational(normal.dot(p) + offset)) - reach(slack);
  }
};

class PatchSearch {
 public:
  PatchSearch(const Polytope& polytope, const Slack& slack, const Watch& watch)
      : polytope_(polytope),
        watch_(watch),
        slack_(slack_of(polytope, slack)),
        around_(polytope.vertices.size()),
        member_of_(polytope.vertices.size()),
        refused_by_(polytope.facets.size()) {
    find_soft_edges();
  }

  std::vector<std::vector<Facet>> from_largest() { return find(by_area_); }
  std::vector<std::vector<Facet>> from_smallest() {
    return find({by_area_.rbegin(), by_area_.rend()});
  }
  bool has_thin_patch() const {
    return std::find(is_thin_.begin(), is_thin_.end(), true) != is_thin_.end();
  }

 private:
  static constexpr Facet kNone = ~Facet{0};
  void find_soft_edges();
  std::vector<std::vector<Facet>> find(const std::vector<Facet>& order);
  void grow(Facet seed);
  bool may_join(Facet facet) const;
  void accept(Facet facet);
  bool fits(Facet facet) const;
  bool tilt_to(Facet facet);
  std::optional<Plane> plane_near(PatchCorners all) const;
  std::optional<Plane> plane_near(PatchCorners all, int axis, int first_sign,
                                  int second_sign) const;
  bool is_thin_along_plane() const;
  std::size_t patches_at(Corner corner) const;
  bool keeps_corners(Facet facet) const;

  const Polytope& polytope_;
  const Watch& watch_;
  std::vector<RationalVector3> slack_;
  std::vector<std::vector<Facet>> soft_;    // neighbours that may be in the same patch
  std::vector<std::vector<Facet>> around_;  // by corner, its facets
  std::vector<Facet> by_area_;              // the largest first
  std::vector<Facet> patch_of_;             // by facet
  std::vector<bool> is_thin_;               // by patch
  Facet patch_count_ = 0;
  // Of the patch that grows, the last one:
  std::vector<Facet> member_of_;   // by corner, the last patch that has it
  std::vector<Facet> refused_by_;  // by facet, the last patch that cannot have it
  std::vector<Facet> fresh_;       // its neighbours still to be compared with the plane
  std::vector<Corner> corners_;    // each once
  std::vector<Corner> decisive_;   // those that determine the plane
  Plane plane_;                    // near all of these
};

void PatchSearch::find_soft_edges() {
  const HardEdges hard(polytope_, slack_);
  struct Edge {
    Corner low, high, before;  // `before` precedes the edge on the facet
    Facet facet;
  };
  std::vector<Edge> edges;
  std::vector<double> areas;
  for (Facet f = 0; f < polytope_.facets.size(); ++f) {
    const auto& c = polytope_.facets[f];
    areas.push_back(hard.squared_area(c));
    for (std::size_t k = 0, n = c.size(); k < n; ++k) {
      const auto [low, high] = std::minmax(c[(k + 1) % n], c[(k + 2) % n]);
      edges.push_back({low, high, c[k], f});
      around_[c[k]].push_back(f);
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::tie(a.low, a.high, a.facet) < std::tie(b.low, b.high, b.facet);
  });
  soft_.resize(polytope_.facets.size());
  for (std::size_t e = 0; e + 1 < edges.size(); e += 2) {
    const Edge &a = edges[e], &b = edges[e + 1];
    if (hard.separates(a.low, a.high, a.before, b.before)) continue;
    soft_[a.facet].push_back(b.facet);
    soft_[b.facet].push_back(a.facet);
  }
  by_area_.resize(areas.size());
  std::iota(by_area_.begin(), by_area_.end(), Facet{0});
  std::stable_sort(by_area_.begin(), by_area_.end(),
                   [&](Facet a, Facet b) { return areas[a] > areas[b]; });
}

// Whether all corners of the facet are near the plane.
bool PatchSearch::fits(Facet facet) const {
  const auto& corners = polytope_.facets[facet];
  return std::all_of(corners.begin(), corners.end(), [&](Corner c) {
    return plane_.excess(polytope_.vertices[c], slack_[c]) <= 0;
  });
}

std::vector<std::vector<Facet>> PatchSearch::find(const std::vector<Facet>& order) {
  patch_count_ = 0;
  is_thin_.clear();
  patch_of_.assign(polytope_.facets.size(), kNone);
  std::fill(member_of_.begin(), member_of_.end(), kNone);
  std::fill(refused_by_.begin(), refused_by_.end(), kNone);
  for (const Facet seed : order) {
    watch_.ask();
    if (patch_of_[seed] == kNone) grow(seed);
  }
  std::vector<bool> is_broken(patch_count_, false);
  for (Facet f = 0; f < patch_of_.size(); ++f) {
    if (is_thin_[patch_of_[f]] && !keeps_corners(f)) is_broken[patch_of_[f]] = true;
  }
  std::vector<std::vector<Facet>> patches(patch_count_);
  for (Facet f = 0; f < patch_of_.size(); ++f) {
    const Facet patch = patch_of_[f];
    if (is_broken[patch] && !patches[patch].empty()) {
      patches.push_back({f});
    } else {
      patches[patch].push_back(f);
    }
  }
  return patches;
}

void PatchSearch::grow(Facet seed) {
  const Halfspace& plane = polytope_.planes[seed];
  plane_ = {plane.normal().cast<Rational>(), Rational(plane.offset())};
  corners_.clear();
  const auto& c = polytope_.facets[seed];
  decisive_ = {c[0], c[c.size() / 3], c[2 * c.size() / 3]};
  ++patch_count_;
  is_thin_.push_back(false);
  accept(seed);
  is_thin_.back() = !fresh_.empty() && is_thin_along_plane();
  std::vector<Facet> off_plane;
  while (!fresh_.empty() || !off_plane.empty()) {
    std::vector<Facet>& list = fresh_.empty() ? off_plane : fresh_;
    const bool is_fresh = !fresh_.empty();
    const Facet facet = list.back();
    list.pop_back();
    if (!may_join(facet)) continue;
    if (is_fresh && !fits(facet)) {
      off_plane.push_back(facet);
    } else if (is_fresh || tilt_to(facet)) {
      accept(facet);
      if (is_fresh) continue;
      fresh_.insert(fresh_.end(), off_plane.begin(), off_plane.end());
      off_plane.clear();
    } else {
      refused_by_[facet] = patch_count_ - 1;  // for good: more corners leave fewer planes
    }
  }
  const bool is_merged = corners_.size() > polytope_.facets[seed].size();
  is_thin_.back() = is_merged && is_thin_along_plane();
}

// Whether the facet is still available, and whether in a thin patch all its corners can remain
// corners of the solid meant.
bool PatchSearch::may_join(Facet facet) const {
  if (patch_of_[facet] != kNone || refused_by_[facet] == patch_count_ - 1) return false;
  if (!is_thin_.back()) return true;
  const auto& corners = polytope_.facets[facet];
  return std::all_of(corners.begin(), corners.end(), [&](Corner c) {
    return patches_at(c) > (member_of_[c] == patch_count_ - 1 ? 3u : 2u);
  });
}

void PatchSearch::accept(Facet facet) {
  patch_of_[facet] = patch_count_ - 1;
  for (const Corner c : polytope_.facets[facet]) {
    if (std::exchange(member_of_[c], patch_count_ - 1) != patch_count_ - 1) corners_.push_back(c);
  }
  fresh_.insert(fresh_.end(), soft_[facet].begin(), soft_[facet].end());
}

// How many patches meet in a corner; a facet that is in none so far counts as one.
std::size_t PatchSearch::patches_at(Corner corner) const {
  std::vector<Facet> patches;
  std::size_t single = 0;
  for (const Facet f : around_[corner]) {
    if (patch_of_[f] == kNone) {
      ++single;
    } else {
      patches.push_back(patch_of_[f]);
    }
  }
  std::sort(patches.begin(), patches.end());
  patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
  return single + patches.size();
}

// Whether three patches meet in each corner of the facet.
bool PatchSearch::keeps_corners(Facet facet) const {
  const auto& corners = polytope_.facets[facet];
  return std::all_of(corners.begin(), corners.end(), [&](Corner c) { return patches_at(c) >= 3; });
}

// Moves the plane so that it is near the corners of one more facet as well, if any plane is. Few
// corners decide: starting with those that decided before, the worst corner is added until the
// plane that is best for these is near all, or no plane is.
bool PatchSearch::tilt_to(Facet facet) {
  std::vector<Corner> all = corners_;
  all.insert(all.end(), polytope_.facets[facet].begin(), polytope_.facets[facet].end());
  std::vector<Corner> decisive = decisive_;
  for (Plane plane = plane_;;) {
    watch_.ask();
    Rational worst = 0;
    std::optional<Corner> added;
    for (const Corner c : all) {
      Rational excess = plane.excess(polytope_.vertices[c], slack_[c]);
      if (excess <= worst) continue;
      worst = std::move(excess);
      added = c;
    }
    if (!added) {
      plane_ = std::move(plane);
      decisive_ = std::move(decisive);
      return true;
    }
    decisive.push_back(*added);
    const auto better = plane_near(decisive);
    if (!better) return false;
    plane = *better;
  }
}

// A plane near all these corners; best in one of the octants in which its normal may lie.
std::optional<Plane> PatchSearch::plane_near(PatchCorners all) const {
  int axis = 0;
  plane_.normal.cwiseAbs().maxCoeff(&axis);
  const auto signs_of = [&](int column) {
    const Rational x = plane_.normal[column] / plane_.normal[axis];
    if (8 * abs(x) > 1) return std::vector<int>{x.sign()};
    return x < 0 ? std::vector<int>{-1, 1} : std::vector<int>{1, -1};
  };
  for (const int first : signs_of((axis + 1) % 3)) {
    for (const int second : signs_of((axis + 2) % 3)) {
      if (auto plane = plane_near(all, axis, first, second)) return plane;
    }
  }
  return std::nullopt;
}

// The plane that is nearest to all corners among those whose normal has component 1 along the axis
// and at most 2, of the signs given, along the next two: in variables these two, the offset and s,
//   maximise s,  |n.p + d| + s <= n_1 u_1 + n_2 u_2 + n_3 u_3  with |n_k| for n_k.
std::optional<Plane> PatchSearch::plane_near(PatchCorners all, int axis, int first_sign,
                                             int second_sign) const {
  const int first = (axis + 1) % 3, second = (axis + 2) % 3;
  const RationalPoint& origin = polytope_.vertices[all[0]];
  LinearProgram lp;
  lp.normals.resize(2 * static_cast<Eigen::Index>(all.size()) + 4, 4);
  lp.offsets.resize(lp.normals.rows());
  Eigen::Index row = 0;
  for (const Corner c : all) {
    const RationalVector3 p = polytope_.vertices[c] - origin;
    const RationalVector3& u = slack_[c];
    for (const int side : {1, -1}) {
      lp.normals.row(row) << side * p[first] - first_sign * u[first],
          side * p[second] - second_sign * u[second], Rational(side), Rational(1);
      lp.offsets[row++] = side * p[axis] - u[axis];
    }
  }
  const auto between = [&](int column, int sign) {  // 0 <= sign * x <= 2
    for (const int side : {1, -1}) {
      lp.normals.row(row).setConstant(Rational(0));
      lp.normals(row, column) = side * sign;
      lp.offsets[row++] = side > 0 ? -2 : 0;
    }
  };
  between(0, first_sign);
  between(1, second_sign);
  lp.objective = RationalVector::Zero(4);
  lp.objective[3] = 1;
  const LpOutcome outcome = maximise(lp);
  const auto& best = std::get<Optimal>(outcome).x;  // a small s is feasible, a large one is not
  if (best[3] < 0) return std::nullopt;
  Plane plane;
  plane.normal[axis] = 1;
  plane.normal[first] = best[0];
  plane.normal[second] = best[1];
  plane.offset = best[2] - plane.normal.dot(origin);
  return plane;
}

// Whether the solid is thinner along the patch's normal than what rounding may explain.
bool PatchSearch::is_thin_along_plane() const {
  Rational slack = 0;
  for (const Corner c : corners_) slack = std::max(slack, plane_.reach(slack_[c]));
  std::optional<Rational> least, most;
  for (const RationalPoint& v : polytope_.vertices) {
    const Rational value = plane_.normal.dot(v);
    if (!least || value < *least) least = value;
    if (!most || value > *most) most = value;
    if (*most - *least >= kThinnest * slack) return false;
  }
  return true;
}

}  // namespace

std::vector<std::vector<std::uint32_t>> planar_patches(const Polytope& polytope, const Slack& slack,
                                                       const Watch& watch) {
  PatchSearch search(polytope, slack, watch);
  auto patches = search.from_largest();
  if (!search.has_thin_patch()) return patches;
  auto others = search.from_smallest();
  return others.size() < patches.size() ? others : patches;
}

}  // namespace convexact
