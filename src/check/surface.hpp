// SPDX-License-Identifier: MIT
// surface.hpp - what all proofs about convex parts have in common: the triangles that they are
// about, hulls of stored corners, and how far parts reach.
//
// The numbers in parentheses are the steps of docs/decomposition-proof.md.
#pragma once
#include <map>
#include <set>

#include "mesh_file.hpp"
#include "reach.hpp"

namespace check {

class SurfaceProof {
 public:
  explicit SurfaceProof(const std::string& bytes) : words_(bytes) {}
  virtual ~SurfaceProof() = default;

  // The proven facts, in sentences.
  // @throws Failure with its line.
  std::string check() {
    return with_line(words_, [&] { return check_statements(); });
  }

  // (9) The faces are those of a file. Decimals mean the same in the whole file.
  std::string require_same(const std::string& path) const {
    const std::string bytes = bytes_of_file(path);
    std::string first;
    for (const Decimals decimals : {Decimals::Nearest, Decimals::Spelt}) {
      std::size_t turned = 0;
      const MeshFile file = parse_mesh_file(bytes, path, decimals, true);
      const std::string why = difference_to(file, turned);
      if (why.empty()) {
        return "proven: the faces are those of " + path + ", " + std::to_string(turned) +
               " of them turned, decimals as " +
               (decimals == Decimals::Nearest ? "the nearest doubles\n" : "spelt\n");
      }
      if (first.empty()) first = why;
    }
    throw Failure{1, "not proven: that the proof is about this file: " + first, path};
  }

 protected:
  using Corners = std::array<std::size_t, 3>;
  using IdSet = std::set<std::size_t>;
  using Pair = std::pair<std::size_t, std::size_t>;  // of points or of clusters

  virtual std::string check_statements() = 0;

  static Pair sorted(std::size_t a, std::size_t b) { return {std::min(a, b), std::max(a, b)}; }
  static std::string count(std::size_t n, const char* what) { return std::to_string(n) + what; }

  // (1) The points are distinct corners of triangles. So triangles have a common edge if and only
  // if it has the same ids in both; one with two equal corners has no edge.
  void read_triangles() {
    std::set<Row> distinct;
    while (words_.take_if("point")) {
      points_.push_back(words_.point());
      require(distinct.insert(points_.back()).second, "a point is repeated");
    }
    IdSet used;
    while (words_.take_if("triangle")) {
      const Corners t = corners(points_.size());
      used.insert(t.begin(), t.end());
      triangles_.push_back(t);
      face_.push_back(words_.id(1000000000));
    }
    require(used.size() == points_.size() && !used.empty(), "a point is no corner");
  }
  Corners corners(std::size_t limit) {
    return {words_.id(limit), words_.id(limit), words_.id(limit)};
  }
  static bool has_repeats(const Corners& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }
  // The squared diagonal of the box of the points.
  Rational squared_diameter() const {
    Numbers low{0, 0, 0, 1}, high{0, 0, 0, 1};
    for (int k = 0; k < 3; ++k) {
      const auto less = [k](const Row& p, const Row& q) { return p[k] * q[3] < q[k] * p[3]; };
      const auto [first, last] = std::minmax_element(points_.begin(), points_.end(), less);
      low[k] = quotient((*first)[k], (*first)[3]);
      high[k] = quotient((*last)[k], (*last)[3]);
    }
    return squared_distance(scaled(low), scaled(high));
  }

  // The plane through three points, its normal towards where they turn counter-clockwise.
  static Row plane_of(const Row& a, const Row& b, const Row& c) { return meet(a, c, b); }
  static bool has_normal(const Row& plane) {
    return plane[0] != 0 || plane[1] != 0 || plane[2] != 0;
  }

  // (4) The facets are the whole boundary of the hull: all points are on the plane of each or
  // behind it, one of them strictly behind; and every edge runs once in each direction.
  static std::vector<Row> planes_of_hull(const std::vector<Row>& points,
                                         const std::vector<std::array<Row, 3>>& facets) {
    std::vector<Row> planes;
    std::set<std::pair<Row, Row>> edges;
    for (const auto& [a, b, c] : facets) {
      const Row plane = plane_of(a, b, c);
      require(has_normal(plane), "a facet has no normal");
      bool is_flat = true;
      for (const Row& p : points) {
        const Integer side = dot(plane, p);
        require(side <= 0, "a point is beyond a facet");
        is_flat = is_flat && side == 0;
      }
      require(!is_flat, "the points lie in the plane of a facet");
      for (const auto& edge : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
        require(edges.insert(edge).second, "two facets lie on the same side of an edge");
      }
      planes.push_back(primitive(plane));
    }
    require(!facets.empty(), "there are no facets");
    for (const auto& [from, to] : edges) {
      require(edges.count({to, from}) == 1, "an edge has a facet on one side only");
    }
    return planes;
  }

  // (11) to (13), (18) and (19) No point of a part is farther from the surface, or what it winds
  // about, than that.
  std::string read_reach(const std::vector<PlacedPart>& parts) {
    if (!words_.take_if("reach")) return "";
    const bool is_share = words_.take_if("share");
    expect(is_share || words_.take_if("length"), "share or length");
    const Rational distance = words_.rational();
    expect(distance > 0, "a distance above 0");
    Rational squared = distance * distance;
    if (is_share) squared *= squared_diameter();
    ReachProof proof(words_, points_, triangles_);
    const std::size_t cells = proof.check(squared, parts);
    return "proven: no point of a part is farther than " + distance.get_str() +
           (is_share ? " of the diameter" : "") + " from the " +
           (proof.has_inside() ? "solid" : "surface") + ", by " +
           count(cells, cells == 1 ? " cell\n" : " cells\n");
  }

  Words words_;
  std::vector<Row> points_;
  std::vector<Corners> triangles_;

 private:
  // For (9): each face of the file has the corners of its triangles, and its boundary is theirs.
  // That means: each edge among those of the face and of its triangles occurs an even number of
  // times, and there are as many triangles as a polygon with these corners needs, so that none of
  // them cancel. Empty if so. Counts faces whose triangles do not all run as the file says.
  std::string difference_to(const MeshFile& file, std::size_t& turned) const {
    if (!file.is_mesh) return "it is of another kind";
    std::map<Row, std::size_t> ids;
    for (std::size_t p = 0; p < points_.size(); ++p) ids[points_[p]] = p;
    struct Edge {
      std::size_t uses = 0;
      long along = 0;  // how often triangles, less how often the face, run along it
    };
    struct Face {
      IdSet corners;
      std::size_t triangles = 0;
      std::map<Pair, Edge> edges;

      void run_along(std::size_t from, std::size_t to, bool is_of_file) {
        if (from == to) return;
        Edge& edge = edges[sorted(from, to)];
        ++edge.uses;
        edge.along += (from < to) != is_of_file ? 1 : -1;
      }
      // Compares with the face of the file that is this cycle of corners.
      bool is_face(const Ids& cycle) const {
        if (corners != IdSet(cycle.begin(), cycle.end())) return false;
        if (triangles + 2 != std::max<std::size_t>(cycle.size(), 3)) return false;
        for (const auto& [ends, edge] : edges) {
          if (edge.uses % 2 != 0) return false;
        }
        return true;
      }
      bool runs_alike() const {
        return std::all_of(edges.begin(), edges.end(),
                           [](const auto& edge) { return edge.second.along == 0; });
      }
    };
    std::vector<Face> faces(file.faces.size());
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (face_[t] >= faces.size()) return "it has fewer faces than the proof";
      Face& face = faces[face_[t]];
      ++face.triangles;
      for (std::size_t e = 0; e < 3; ++e) {
        face.corners.insert(triangles_[t][e]);
        face.run_along(triangles_[t][e], triangles_[t][(e + 1) % 3], false);
      }
    }
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const std::string which = "its face " + std::to_string(f + 1);
      Ids cycle;  // each corner once in a row
      for (const std::size_t corner : file.faces[f]) {
        const auto found = ids.find(file.rows[corner]);
        if (found == ids.end()) return which + " has a corner that is not in the proof";
        if (cycle.empty() || cycle.back() != found->second) cycle.push_back(found->second);
      }
      while (cycle.size() > 1 && cycle.front() == cycle.back()) cycle.pop_back();
      Face& face = faces[f];
      for (std::size_t k = 0; k < cycle.size(); ++k) {
        face.run_along(cycle[k], cycle[(k + 1) % cycle.size()], true);
      }
      if (!face.is_face(cycle)) return which + " is not the one of the proof";
      turned += face.runs_alike() ? 0 : 1;
    }
    return "";
  }

  Ids face_;  // of the file, by triangle
};

}  // namespace check
