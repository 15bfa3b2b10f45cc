// SPDX-License-Identifier: MIT
#include "oracle/solid/mesh_surface.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "convexact/geometry.hpp"
#include "geometry/area_vector.hpp"
#include "number/arithmetic.hpp"
#include "oracle/solid/excess.hpp"
#include "oracle/solid/facet_planes.hpp"

namespace convexact {
namespace {

// ---- Simple polygons

using PlanarPoint = std::array<Rational, 2>;
using Outline = std::span<const PlanarPoint>;

// Positive if a, b, c turn left.
int turn(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c) {
  return Rational((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).sign();
}

// Whether the path a, b, c on one line turns back at b.
bool runs_back(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c) {
  return Rational((b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1])) < 0;
}

// Whether the direction from a to b is in the upper half of the circle, [0, 180) degrees.
bool is_upward(const PlanarPoint& a, const PlanarPoint& b) {
  return b[1] > a[1] || (b[1] == a[1] && b[0] > a[0]);
}

// A polygon that turns to one side only, and by 360 degrees in all, is convex and simple.
bool is_convex(Outline p) {
  const std::size_t n = p.size();
  int side = 0;
  std::size_t changes = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const PlanarPoint &a = p[k], &b = p[(k + 1) % n], &c = p[(k + 2) % n];
    const int here = turn(a, b, c);
    if (here == 0 ? runs_back(a, b, c) : here == -side) return false;
    if (here != 0) side = here;
    changes += is_upward(a, b) != is_upward(b, c) ? 1 : 0;
  }
  return side != 0 && changes == 2;
}

bool is_between(const Rational& x, const Rational& a, const Rational& b) {
  return std::min(a, b) <= x && x <= std::max(a, b);
}

// Whether p, on the line through a and b, is between them.
bool is_on(const PlanarPoint& p, const PlanarPoint& a, const PlanarPoint& b) {
  return is_between(p[0], a[0], b[0]) && is_between(p[1], a[1], b[1]);
}

bool do_meet(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c,
             const PlanarPoint& d) {
  const int a_side = turn(c, d, a), b_side = turn(c, d, b);
  const int c_side = turn(a, b, c), d_side = turn(a, b, d);
  if (a_side * b_side < 0 && c_side * d_side < 0) return true;
  return (a_side == 0 && is_on(a, c, d)) || (b_side == 0 && is_on(b, c, d)) ||
         (c_side == 0 && is_on(c, a, b)) || (d_side == 0 && is_on(d, a, b));
}

// Whether edges i < j have more in common than the corner between neighbours.
bool do_touch(Outline p, std::size_t i, std::size_t j) {
  const std::size_t n = p.size();
  const auto folds = [&](std::size_t k) {  // at the end of edge k
    const PlanarPoint &a = p[k], &b = p[(k + 1) % n], &c = p[(k + 2) % n];
    return turn(a, b, c) == 0 && runs_back(a, b, c);
  };
  if (j == i + 1) return folds(i);
  if (i == 0 && j == n - 1) return folds(j);
  return do_meet(p[i], p[i + 1], p[j], p[(j + 1) % n]);
}

// Two edges of a closed polygon, by their first corners, the lower one first.
using EdgePair = std::pair<std::size_t, std::size_t>;

// A line that sweeps over a polygon from left to right, and the edges that it crosses, from below.
// Before it gets to the leftmost point where two edges touch, two that touch there are neighbours
// on it, so that only neighbours need to be tested [ShamosHoey1976]. Of corners one above the other
// it passes the lower one first, as if it were tilted, so that no edge lies in it.
class EdgeSweep {
 public:
  // Corners at different places.
  explicit EdgeSweep(Outline corners)
      : corners_(corners), crossed_(Below{*this}), place_(corners.size(), crossed_.end()) {}

  std::optional<EdgePair> find_touching(const Watch& watch) {
    const std::size_t n = corners_.size();
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return corners_[a] < corners_[b]; });
    for (const std::size_t corner : order) {
      watch.ask();
      const std::array edges{(corner + n - 1) % n, corner};
      for (const std::size_t e : edges) {
        if (right(e) == corner && ends(e)) return found_;
      }
      for (const std::size_t e : edges) {
        if (left(e) == corner && begins(e)) return found_;
      }
    }
    return std::nullopt;
  }

 private:
  std::size_t next(std::size_t k) const { return (k + 1) % corners_.size(); }
  std::size_t left(std::size_t e) const { return corners_[e] < corners_[next(e)] ? e : next(e); }
  std::size_t right(std::size_t e) const { return left(e) == e ? next(e) : e; }

  // Where `late` begins, or if that is on `early`, where it leaves that: positive if above.
  int side_of(std::size_t late, std::size_t early) const {
    const PlanarPoint &a = corners_[left(early)], &b = corners_[right(early)];
    const int side = turn(a, b, corners_[left(late)]);
    return side != 0 ? side : turn(a, b, corners_[right(late)]);
  }

  // Of edges that the line crosses; neither of two is below the other only if they touch.
  bool is_below(std::size_t a, std::size_t b) const {
    const bool a_is_late = !(corners_[left(a)] < corners_[left(b)]);
    return a_is_late ? side_of(a, b) < 0 : side_of(b, a) > 0;
  }
  struct Below {
    const EdgeSweep& sweep;
    bool operator()(std::size_t a, std::size_t b) const { return sweep.is_below(a, b); }
  };
  using Crossed = std::set<std::size_t, Below>;

  // These two return whether two edges were found that touch.
  bool begins(std::size_t e) {
    const auto [place, is_new] = crossed_.insert(e);
    if (!is_new) return do_they_touch(e, *place);
    place_[e] = place;
    return (place != crossed_.begin() && do_they_touch(e, *std::prev(place))) ||
           (std::next(place) != crossed_.end() && do_they_touch(e, *std::next(place)));
  }
  bool ends(std::size_t e) {
    const auto above = crossed_.erase(place_[e]);
    return above != crossed_.begin() && above != crossed_.end() &&
           do_they_touch(*std::prev(above), *above);
  }

  bool do_they_touch(std::size_t a, std::size_t b) {
    found_ = std::minmax(a, b);
    return do_touch(corners_, found_.first, found_.second);
  }

  Outline corners_;
  Crossed crossed_;
  std::vector<Crossed::const_iterator> place_;  // by edge
  EdgePair found_;
};

// Two edges that begin at one place, or if these are neighbours, end and begin there.
std::optional<EdgePair> edges_at_one_place(Outline corners) {
  const std::size_t n = corners.size();
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return corners[a] < corners[b]; });
  const auto twice =
      std::adjacent_find(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return corners[a] == corners[b]; });
  if (twice == order.end()) return std::nullopt;
  const std::size_t first = *twice, second = *std::next(twice);
  const auto follows = [&](std::size_t a, std::size_t b) { return b == (a + 1) % n; };
  if (follows(first, second)) return std::minmax({(first + n - 1) % n, second});
  if (follows(second, first)) return std::minmax({(second + n - 1) % n, first});
  return EdgePair{first, second};
}

// Two edges of a closed polygon that have a point in common which is not the corner between
// neighbours; nothing if the polygon is simple. At least four corners. O(n log n), linear for
// convex polygons.
std::optional<EdgePair> touching_edges(Outline corners, const Watch& watch) {
  if (is_convex(corners)) return std::nullopt;
  const std::size_t n = corners.size();
  for (std::size_t k = 0; k < n; ++k) {
    const EdgePair neighbours = std::minmax({k, (k + 1) % n});
    if (do_touch(corners, neighbours.first, neighbours.second)) return neighbours;
  }
  if (const auto edges = edges_at_one_place(corners)) return edges;
  return EdgeSweep(corners).find_touching(watch);
}

// ---- The faces of a mesh

// For each point the lowest id of those at the same place.
template <class GetPoint>
std::vector<std::uint32_t> weld(std::size_t count, const GetPoint& point) {
  std::vector<std::uint32_t> order(count), first(count);
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return precedes(point(a), point(b)); });
  for (std::size_t k = 0; k < count; ++k) {
    const bool repeats = k > 0 && !precedes(point(order[k - 1]), point(order[k]));
    first[order[k]] = repeats ? first[order[k - 1]] : order[k];
  }
  return first;
}

std::vector<std::uint32_t> weld(const PointSet& points) {
  if (points.is_binary()) {
    return weld(points.size(),
                [&](std::uint32_t i) -> const Point& { return points.doubles()[i]; });
  }
  return weld(points.size(), [&](std::uint32_t i) { return points[PointId(i)]; });
}

// Whether there are three different corners; neighbours differ.
bool has_three(std::span<const std::uint32_t> corners) {
  return std::any_of(corners.begin(), corners.end(),
                     [&](std::uint32_t c) { return c != corners[0] && c != corners[1]; });
}

}  // namespace

MeshSurface::MeshSurface(const Mesh& mesh) : mesh_(mesh), faces_(mesh.polygons) {
  const std::vector<std::uint32_t> first = weld(mesh.points);
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    std::vector<std::uint32_t>& face = faces_[f];
    for (std::uint32_t& corner : face) corner = first[corner];
    const std::size_t before = face.size();
    face.erase(std::unique(face.begin(), face.end()), face.end());
    while (face.size() > 1 && face.front() == face.back()) face.pop_back();
    if (has_three(face)) {
      surplus_.zero_edges += before - face.size();
    } else {
      surplus_.degenerate_faces.push_back(f);
      face.clear();
    }
    for (std::size_t k = 0; k < face.size(); ++k) {
      edges_.push_back({face[k], face[(k + 1) % face.size()], f});
    }
    area_vectors_.push_back(area_vector(mesh.points, face));
    if (!face.empty() && is_on_a_line(f)) surplus_.slivers.push_back(f);
  }
  const auto key = [](const DirectedEdge& e) {
    return std::tuple(std::min(e.from, e.to), std::max(e.from, e.to), e.from, e.face);
  };
  std::sort(edges_.begin(), edges_.end(),
            [&](const DirectedEdge& a, const DirectedEdge& b) { return key(a) < key(b); });
}

// The first edge that is a fault, with all edges that run along it in either direction.
template <class IsFault>
std::optional<MeshEdge> MeshSurface::find_edge(const IsFault& is_fault) const {
  const auto along = [](const DirectedEdge& a, const DirectedEdge& b) {
    return std::minmax(a.from, a.to) == std::minmax(b.from, b.to);
  };
  for (std::size_t first = 0, last = 0; first < edges_.size(); first = last) {
    while (last < edges_.size() && along(edges_[first], edges_[last])) ++last;
    const Edges edges = Edges(edges_).subspan(first, last - first);
    if (!is_fault(edges)) continue;
    MeshEdge found{edges[0].from, edges[0].to, {}};
    for (const DirectedEdge& e : edges) found.faces.push_back(e.face);
    return found;
  }
  return {};
}

std::optional<MeshEdge> MeshSurface::open_edge() const {
  return find_edge([](Edges edges) { return edges.size() != 2 || edges[0].face == edges[1].face; });
}

std::optional<MeshEdge> MeshSurface::twisted_edge() const {
  return find_edge([](Edges edges) {
    const auto forward = std::count_if(
        edges.begin(), edges.end(), [&](const DirectedEdge& e) { return e.from == edges[0].from; });
    return forward > 1 || static_cast<std::ptrdiff_t>(edges.size()) - forward > 1;
  });
}

bool MeshSurface::is_on_a_line(std::size_t face) const {
  if (!area_vectors_[face].isZero(0)) return false;
  const std::vector<std::uint32_t>& corners = faces_[face];
  const RationalPoint origin = mesh_.points[PointId(corners[0])];
  const RationalVector3 along = mesh_.points[PointId(corners[1])] - origin;
  return std::all_of(corners.begin(), corners.end(), [&](std::uint32_t c) {
    const RationalVector3 here = mesh_.points[PointId(c)] - origin;
    return along.cross(here).isZero(0);
  });
}

// For a face on a line: whether all corners differ and it turns round twice.
bool MeshSurface::goes_to_and_fro(std::size_t face) const {
  const std::vector<std::uint32_t>& corners = faces_[face];
  std::vector<std::uint32_t> sorted = corners;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return false;
  const std::size_t n = corners.size();
  std::size_t turns = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const RationalPoint here = mesh_.points[PointId(corners[(k + 1) % n])];
    const RationalVector3 before = here - mesh_.points[PointId(corners[k])];
    const RationalVector3 after = mesh_.points[PointId(corners[(k + 2) % n])] - here;
    turns += before.dot(after) < 0 ? 1 : 0;
  }
  return turns == 2;
}

// For a face with corners that are not all on a line.
std::optional<CrossedFace> MeshSurface::crossing_of(std::size_t face, const Watch& watch) const {
  const std::vector<std::uint32_t>& corners = faces_[face];
  const auto next = [&](std::size_t k) { return corners[(k + 1) % corners.size()]; };
  // A corner that occurs again: seen along the normal, a spike out of the plane may be hidden
  // behind it.
  std::vector<std::uint32_t> sorted = corners;
  std::sort(sorted.begin(), sorted.end());
  if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end()) {
    const auto first = std::find(corners.begin(), corners.end(), *twice);
    const auto second = std::find(first + 1, corners.end(), *twice);
    const auto i = static_cast<std::size_t>(first - corners.begin()),
               j = static_cast<std::size_t>(second - corners.begin());
    return CrossedFace{face, {corners[i], next(i), corners[j], next(j)}};
  }
  RationalVector3 n = area_vectors_[face];
  // The parts cancel each other: any normal can be used, since no simple polygon has the area 0.
  for (std::size_t k = 2; n.isZero(0) && k < corners.size(); ++k) {
    n = area_vector(mesh_.points, std::array{corners[0], corners[1], corners[k]});
  }
  int axis = 0;
  n.cwiseAbs().maxCoeff(&axis);
  std::vector<PlanarPoint> seen;
  for (const std::uint32_t c : corners) {
    const RationalPoint p = mesh_.points[PointId(c)];
    seen.push_back({p[(axis + 1) % 3], p[(axis + 2) % 3]});
  }
  const auto edges = touching_edges(seen, watch);
  if (!edges) return {};
  const auto [i, j] = *edges;
  return CrossedFace{face, {corners[i], next(i), corners[j], next(j)}};
}

std::optional<CrossedFace> MeshSurface::crossed_face(const Watch& watch) const {
  auto sliver = surplus_.slivers.begin();
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const bool is_sliver = sliver != surplus_.slivers.end() && *sliver == f;
    if (is_sliver) ++sliver;
    if (faces_[f].size() <= 3) continue;
    if (is_sliver && !goes_to_and_fro(f)) return CrossedFace{f, {}};
    if (is_sliver) continue;
    if (auto crossed = crossing_of(f, watch)) return crossed;
  }
  return {};
}

std::optional<PointOffFace> MeshSurface::bend_of(std::size_t face) const {
  std::optional<PointOffFace> worst;
  const RationalVector3& n = area_vectors_[face];
  if (faces_[face].size() <= 3 || n.isZero(0)) return worst;
  const RationalPoint origin = mesh_.points[PointId(faces_[face][0])];
  for (const std::uint32_t corner : faces_[face]) {
    const Rational off = n.dot(RationalVector3(mesh_.points[PointId(corner)] - origin));
    if (off == 0) continue;
    const Rational squared = off * off / n.squaredNorm();
    if (worst && squared <= worst->squared_distance) continue;
    worst = PointOffFace{face, PointId(corner), Halfspace(n, Rational(-n.dot(origin))), squared};
  }
  return worst;
}

std::optional<PointOffFace> MeshSurface::most_bent() const {
  std::optional<PointOffFace> worst;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    auto bend = bend_of(f);
    if (!bend || (worst && bend->squared_distance <= worst->squared_distance)) continue;
    worst = std::move(bend);
  }
  return worst;
}

const Rational& MeshSurface::enclosed() const {
  return enclosed_.get([&] {
    std::vector<Rational> terms;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      if (faces_[f].empty()) continue;
      terms.push_back(area_vectors_[f].dot(mesh_.points[PointId(faces_[f][0])]));
    }
    return balanced_sum(std::move(terms));
  });
}

MeshSurface::OffHull MeshSurface::faces_off(const Hull& hull,
                                            std::span<const Halfspace> planes) const {
  FacetPlanes facet_planes(hull, planes);
  std::vector<Halfspace> off;
  std::vector<std::size_t> face_of;
  std::optional<PointOffFace> most_bent;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const RationalVector3& n = area_vectors_[f];
    if (n.isZero(0) || facet_planes.surely_have(faces_[f], n)) continue;
    const Rational offset = -n.dot(mesh_.points[PointId(faces_[f][0])]);
    Halfspace plane(n, offset);
    auto bend = bend_of(f);
    if (!bend && facet_planes.have(plane)) continue;
    off.push_back(std::move(plane));
    face_of.push_back(f);
    if (bend && (!most_bent || bend->squared_distance > most_bent->squared_distance)) {
      most_bent = std::move(bend);
    }
  }
  OffHull result{off.size(), {}};
  const PointSet corners = subset(mesh_.points, hull.vertices);
  if (const auto excess = find_excess(off, corners)) {
    result.worst = PointOffFace{face_of[excess->plane], hull.vertices[excess->point.index()],
                                off[excess->plane], excess->squared_distance};
  } else if (most_bent) {
    // A plane that no point is beyond holds a facet unless its face is bent.
    result.worst = std::move(most_bent);
  }
  return result;
}

}  // namespace convexact
