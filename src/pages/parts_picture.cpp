// SPDX-License-Identifier: MIT
#include "pages/parts_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <span>

#include "io/json.hpp"
#include "number/groups.hpp"
#include "number/text.hpp"
#include "pages/part_colors.hpp"
#include "wire/decompose_report.hpp"

namespace convexact {
namespace {

constexpr std::size_t kMostSeparate = 400;  // parts with a switch and a direction of their own

PictureLayer uncovered_layer(const SurfaceCoverage& coverage) {
  PictureLayer layer{
      .name = "in no part", .color = kOutsideColor, .edges = true, .faces_reader = true};
  for (const UncoveredPiece& piece : coverage.uncovered) {
    if (piece.corners.size() < 3) continue;
    std::vector<Point> corners;
    for (const RationalPoint& c : piece.corners) {
      corners.push_back(drawn_at(c));
    }
    std::vector<std::uint32_t> polygon(corners.size());
    std::iota(polygon.begin(), polygon.end(), 0);
    layer.add(corners, {polygon});
  }
  return layer;
}

PictureLayer input_layer(const Surface& surface, std::string name) {
  PictureLayer layer{.name = std::move(name), .color = "#b8b8b8", .shown = false};
  std::vector<std::vector<std::uint32_t>> triangles;
  for (const auto& [a, b, c] : surface.triangles) triangles.push_back({a.value, b.value, c.value});
  layer.add(surface.points.doubles(), triangles);
  return layer;
}

// Pairs of groups that join, one after another. Names are the lowest triangles.
class Joins {
 public:
  explicit Joins(std::size_t triangles) : groups_(triangles) {}

  void join(TriangleId a, TriangleId b) {
    const auto [low, high] = std::minmax({groups_.root(a.value), groups_.root(b.value)});
    if (groups_.join(low, high)) joins_.push_back({low, high});
  }
  // A step that changes no colour.
  void join_nothing() { joins_.push_back({0, 0}); }
  std::vector<std::array<std::uint32_t, 2>> take() { return std::move(joins_); }

 private:
  Groups groups_;
  std::vector<std::array<std::uint32_t, 2>> joins_;
};

// By node of a partition: the lowest triangle of those that are painted with it.
using LowestTriangles = std::vector<std::optional<TriangleId>>;

// The cuts undone, the last one first. A triangle that planes cut goes with the first leaf that has
// a piece of it.
LowestTriangles add_cuts(const Partition& partition, Joins& joins) {
  LowestTriangles lowest(partition.nodes.size());
  std::set<TriangleId> seen;
  for (const PartitionLeaf& leaf : partition.leaves) {
    for (const TriangleId t : leaf.triangles) {
      if (!seen.insert(t).second) continue;
      if (!lowest[leaf.node]) lowest[leaf.node] = t;
      joins.join(*lowest[leaf.node], t);
    }
  }
  for (std::size_t n = partition.nodes.size(); n-- > 0;) {
    if (!partition.nodes[n].plane) continue;
    const auto [a, b] = partition.nodes[n].children;
    lowest[n] = lowest[a] ? lowest[a] : lowest[b];
    if (lowest[a] && lowest[b]) {
      joins.join(*lowest[a], *lowest[b]);
    } else {
      joins.join_nothing();
    }
  }
  return lowest;
}

// The leaves that share a part, part after part: those that were merged, and those that a part took
// over as it holds them. A step for each; one without triangles to paint changes nothing.
std::vector<std::array<std::uint32_t, 2>> joined_leaves(const Decomposition& decomposition,
                                                        const Partition& partition,
                                                        const LowestTriangles& lowest) {
  std::vector<std::array<std::uint32_t, 2>> joined;
  for (const Part& part : decomposition.parts) {
    std::optional<std::uint32_t> group;
    for (std::size_t k = 0; k < part.leaves.size(); ++k) {
      const auto& triangle = lowest[partition.leaves[part.leaves[k]].node];
      if (k > 0) joined.push_back({0, 0});
      if (!triangle) continue;
      const std::uint32_t other = group.value_or(triangle->value);
      group = std::min(other, triangle->value);
      if (k > 0 && other != triangle->value) {
        joined.back() = {*group, std::max(other, triangle->value)};
      }
    }
  }
  return joined;
}

// Merges in their order, after triangles without area have joined; or, from the leaves of a tree,
// the splits undone, the last one first.
void add_steps(const Decomposition& decomposition, PictureLayer& layer) {
  Joins joins(decomposition.surface.triangles.size());
  if (const auto* clustering = std::get_if<Clustering>(&decomposition.origin)) {
    for (const auto& [triangle, into] : clustering->united) joins.join(triangle, into);
    for (const Merge& step : clustering->merges) joins.join(step.kept, step.gone);
    layer.merges = joins.take();
    return;
  }
  if (const auto* partition = std::get_if<Partition>(&decomposition.origin)) {
    const LowestTriangles lowest = add_cuts(*partition, joins);
    layer.merges = joins.take();
    layer.splits = partition->nodes.size() / 2;
    layer.joined = joined_leaves(decomposition, *partition, lowest);
    return;
  }
  const auto& tree = std::get<SplitTree>(decomposition.origin);
  for (const SplitLeaf& leaf : tree.leaves) {
    for (const TriangleId t : leaf.triangles) joins.join(leaf.triangles.front(), t);
  }
  for (auto split = tree.splits.rbegin(); split != tree.splits.rend(); ++split) {
    const auto& [kept, gone] = tree.nodes[split->node].children;
    joins.join(tree.nodes[kept].lowest, tree.nodes[gone].lowest);
  }
  layer.merges = joins.take();
  layer.splits = tree.splits.size();
}

// The ray from the middle of a triangle to where it leaves the hull, in doubles.
double ray_from_middle(const Surface& surface, TriangleId triangle,
                       const std::vector<Eigen::Vector4d>& planes) {
  const auto points = surface.points.doubles();
  const auto& [a, b, c] = surface.triangles[triangle.index()];
  const Point from = (points[a.index()] + points[b.index()] + points[c.index()]) / 3;
  const Point normal =
      (points[b.index()] - points[a.index()]).cross(points[c.index()] - points[a.index()]);
  const double length = normal.norm();
  if (!(length > 0)) return 0;
  double least = HUGE_VAL;
  for (const Eigen::Vector4d& plane : planes) {
    const double along = plane.head<3>().dot(normal) / length;
    if (along <= 1e-9 * plane.head<3>().norm()) continue;
    least = std::min(least, -(plane.head<3>().dot(from) + plane[3]) / along);
  }
  return std::isfinite(least) ? std::max(0.0, least) : 0;
}

std::vector<double> rays(const Decomposition& decomposition) {
  std::vector<double> found(decomposition.surface.triangles.size(), 0);
  for (const Part& part : decomposition.parts) {
    std::vector<Eigen::Vector4d> planes;
    for (const Halfspace& plane : part.hull.halfspaces) {
      // Only their ratio counts, and integers may be beyond the doubles.
      Integer most = abs(plane.offset());
      for (const Integer& x : plane.normal()) most = std::max<Integer>(most, abs(x));
      const auto share = [&](const Integer& x) {
        return to_double(Rational(x, most), Rounding::Nearest);
      };
      const auto& n = plane.normal();
      planes.emplace_back(share(n[0]), share(n[1]), share(n[2]), share(plane.offset()));
    }
    for (const TriangleId t : part.cluster) {
      found[t.index()] = ray_from_middle(decomposition.surface, t, planes);
    }
  }
  return found;
}

// The input coloured by rays; none where all have length 0 but for rounding, as with parts by cut.
std::optional<PictureLayer> heat_layer(const Decomposition& decomposition) {
  PictureLayer heat = input_layer(decomposition.surface, "");
  heat.heat = rays(decomposition);
  const double longest = *std::max_element(heat.heat.begin(), heat.heat.end());
  const double diameter = sqrt(Enclosure(decomposition.squared_diameter(), 64)).high_double();
  if (!(longest > 1e-9 * diameter)) return {};
  for (double& x : heat.heat) x /= longest;
  heat.name = fmt::format(
      "input by rays inside the hulls: blue is 0, yellow half of red, red {:.3g} ({:.2g}% of the "
      "diameter)",
      longest, 100 * longest / diameter);
  return heat;
}

Point middle(const Mesh& mesh) {
  Point sum = Point::Zero();
  for (const Point& p : mesh.points.doubles()) sum += p / static_cast<double>(mesh.points.size());
  return sum;
}

// Of a closed surface, by the divergence theorem.
double volume_of(const Mesh& mesh) {
  const auto points = mesh.points.doubles();
  const Point from = middle(mesh);
  double sum = 0;
  for (const auto& polygon : mesh.polygons) {
    for (std::size_t k = 2; k < polygon.size(); ++k) {
      const Point a = points[polygon[0]] - from, b = points[polygon[k - 1]] - from;
      sum += a.cross(b).dot(points[polygon[k]] - from);
    }
  }
  return std::isfinite(sum) ? sum / 6 : 0;
}

// A part with its planes by polygon, if they are known: flat parts and files do not have them.
struct DrawnPart {
  const Mesh* mesh;
  std::span<const Halfspace> planes = {};
};

std::vector<std::size_t> colors_of(const std::vector<DrawnPart>& drawn) {
  std::vector<const PointSet*> points;
  for (std::size_t k = 0; k < drawn.size() && k < kMostSeparate; ++k)
    points.push_back(&drawn[k].mesh->points);
  return colors_by_contact(points);
}

// The parts, most of them with a separate direction away from the middle of all.
void add_apart(const std::vector<DrawnPart>& drawn, Picture& picture) {
  Point center = Point::Zero();
  for (const DrawnPart& part : drawn) {
    center += middle(*part.mesh) / static_cast<double>(drawn.size());
  }
  const std::vector<std::size_t> colors = colors_of(drawn);
  std::vector<PictureLayer> parts;
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    const auto& [mesh, planes] = drawn[k];
    if (k < kMostSeparate) {
      parts.push_back({.name = fmt::format("part {}", k),
                       .color = part_color(colors[k]),
                       .edges = true,
                       .right = true,
                       .rank = colors[k],
                       .volume = volume_of(*mesh)});
      parts.back().away = 0.8 * (middle(*mesh) - center);
    } else if (k == kMostSeparate) {
      parts.push_back({.name = "other parts", .color = "#bab0ac", .edges = true, .right = true});
    }
    // A part that is a segment or a point has no polygon, and is not drawn.
    if (k < kMostSeparate && planes.size() == mesh->polygons.size()) {
      parts.back().add_to_pick(mesh->points.doubles(), mesh->polygons, planes,
                               fmt::format("part {}", k));
    } else {
      parts.back().add(mesh->points.doubles(), mesh->polygons);
    }
  }
  std::erase_if(parts, [](const PictureLayer& layer) { return layer.polygons.empty(); });
  std::move(parts.begin(), parts.end(), std::back_inserter(picture.layers));
}

}  // namespace

namespace {

// The parts that a program gave, as far as they span a volume.
void add_judged(const PartsVerdict& verdict, Picture& picture) {
  std::vector<PointSet> corners;
  for (const ConvexPart& hull : verdict.hulls) {
    if (corners.size() < kMostSeparate) corners.push_back(PointSet(hull.vertices));
  }
  std::vector<const PointSet*> points;
  for (const PointSet& each : corners) points.push_back(&each);
  const std::vector<std::size_t> colors = colors_by_contact(points);
  PictureLayer others{
      .name = "other parts", .color = "#bab0ac", .opacity = 0.55, .edges = true, .right = true};
  for (std::size_t k = 0; k < verdict.hulls.size(); ++k) {
    const auto& solid = verdict.hulls[k].solid;
    if (!solid) continue;
    const std::string name = as_utf8(verdict.parts[k].name);
    if (k >= kMostSeparate) {
      others.add_to_pick(*solid, name);
      continue;
    }
    PictureLayer& layer = picture.layers.emplace_back(PictureLayer{.name = name,
                                                                   .color = part_color(colors[k]),
                                                                   .opacity = 0.55,
                                                                   .edges = true,
                                                                   .right = true,
                                                                   .rank = colors[k]});
    layer.add_to_pick(*solid, name);
  }
  if (!others.polygons.empty()) picture.layers.push_back(std::move(others));
}

// Of the point of a part that is found to be farthest: within this ball there is nothing of the
// solid.
std::optional<PictureLayer> ball_of_reach(const PartsVerdict& verdict) {
  const Claim& claim = verdict[ClaimCode::WithinSolid];
  if (claim.status != Status::Violated || !claim.witness.point || !claim.witness.squared_distance) {
    return {};
  }
  const Point center = drawn_at(*claim.witness.point);
  const double radius = std::sqrt(to_double(*claim.witness.squared_distance, Rounding::Nearest));
  PictureLayer ball{
      .name = fmt::format("nothing of the input is in this ball, of radius {:.4g}", radius),
      .color = kOutsideColor,
      .opacity = 0.35,
      .right = true,
      .faces_reader = true};
  ball.add_ball(center, radius);
  return ball;
}

// What was found of the parts: what fails, or what holds.
std::string judged_text(const PartsVerdict& verdict, std::size_t pieces) {
  const std::string parts = counted(verdict.hulls.size(), "part", "parts");
  const Claim& within = verdict[ClaimCode::WithinSolid];
  if (pieces > 0) {
    return parts + "; " + counted(pieces, "piece", "pieces") + " of the surface in none of them";
  }
  if (within.status == Status::Violated) return parts + "; " + within.sentence;
  const bool is_solid = verdict[ClaimCode::CoversSolid].status == Status::Holds;
  if (!is_solid && verdict[ClaimCode::CoversSurface].status != Status::Holds) {
    return parts + "; no piece of the surface was found outside of them";
  }
  std::string text = fmt::format("{} hold{} the {}", parts, verdict.hulls.size() == 1 ? "s" : "",
                                 is_solid ? "solid" : "surface");
  if (within.status == Status::Holds) text += "; " + within.sentence;
  return text;
}

}  // namespace

Picture parts_picture(const Mesh& input, const PartsVerdict& verdict, const std::string& title) {
  Picture picture;
  picture.title = as_utf8(title);
  PictureLayer surface{.name = "input", .color = "#b8b8b8", .shown = false};
  surface.add(input.points.doubles(), input.polygons);
  picture.layers.push_back(std::move(surface));
  std::size_t pieces = 0;
  if (verdict.coverage && !verdict.coverage->uncovered.empty()) {
    pieces = verdict.coverage->uncovered.size();
    picture.layers.push_back(uncovered_layer(*verdict.coverage));
  }
  add_judged(verdict, picture);
  if (auto ball = ball_of_reach(verdict)) picture.layers.push_back(std::move(*ball));
  picture.answer = judged_text(verdict, pieces);
  return picture;
}

namespace {

// How much of the parts is outside of the solid, and of the solid outside of the parts, as far as
// that was measured; and whether a budget ended the run.
std::string measures_text(const Decomposition& decomposition) {
  std::string text;
  const auto& measures = decomposition.measures;
  if (measures && measures->solid_volume) {
    const auto share = [&](const Measured& volume) {
      return 100 * volume.bounds.high_double() / measures->solid_volume->bounds.low_double();
    };
    if (measures->uncovered_volume && measures->uncovered_volume->bounds.high() > 0) {
      text += fmt::format("; {:.2g}% of the solid is in none", share(*measures->uncovered_volume));
    }
    if (measures->excess_volume) {
      text +=
          fmt::format("; their excess is {:.2g}% of its volume", share(*measures->excess_volume));
    }
  }
  return text + (decomposition.stopped_by_count() ? "; the number of parts ended the run" : "");
}

}  // namespace

Picture decomposition_picture(const Decomposition& decomposition, const std::string& title) {
  const Surface& surface = decomposition.surface;
  Picture picture;
  picture.title = as_utf8(title);
  PictureLayer steps = input_layer(surface, "input by clusters");
  add_steps(decomposition, steps);
  picture.layers.push_back(input_layer(surface, "input"));
  picture.layers.push_back(std::move(steps));
  if (auto heat = heat_layer(decomposition)) picture.layers.push_back(std::move(*heat));

  std::vector<DrawnPart> drawn;
  for (const Part& part : decomposition.parts) drawn.push_back({&part.mesh, part.halfspaces});
  add_apart(drawn, picture);
  picture.answer = proven_of_parts(decomposition) + measures_text(decomposition);
  return picture;
}

std::vector<PictureLayer> tree_layers(const BuiltTree& built) {
  std::vector<PictureLayer> layers;
  std::size_t node = 0;  // nodes are in the order of their levels
  for (const TreeLevel& level : built.levels) {
    PictureLayer layer{.name = fmt::format("hulls of level {}", layers.size()),
                       .color = part_color(layers.size()),
                       .opacity = 0.3,
                       .edges = true,
                       .shown = false,
                       .right = true};
    for (std::size_t i = 0; i < level.nodes; ++i, ++node) {
      const Mesh& mesh = built.tree.mesh_of(node);
      layer.add(mesh.points.doubles(), mesh.polygons);
    }
    layers.push_back(std::move(layer));
  }
  return layers;
}

Picture tree_picture(const BuiltTree& built, const std::string& title) {
  Picture picture;
  picture.title = as_utf8(title);
  std::vector<DrawnPart> drawn;
  for (const NamedPart& part : built.tree.parts) drawn.push_back({&part.mesh});
  add_apart(drawn, picture);
  for (PictureLayer& layer : tree_layers(built)) picture.layers.push_back(std::move(layer));
  if (built.levels.size() > 1)
    picture.layers[picture.layers.size() - built.levels.size() + 1].shown = true;
  picture.answer =
      fmt::format("{} parts under a tree of {} nodes on {} levels: each hull holds those below it",
                  with_separators(built.tree.parts.size()),
                  with_separators(built.tree.nodes.size()), built.levels.size());
  return picture;
}

}  // namespace convexact
