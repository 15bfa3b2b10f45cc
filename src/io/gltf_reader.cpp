// SPDX-License-Identifier: MIT
// glTF 2.0, as .gltf and .glb: every node that has a mesh is an object, where the nodes above it
// put it. Points are those that a primitive uses. Skins and morph targets are passed over.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "convexact/error.hpp"
#include "io/gltf_document.hpp"
#include "io/mesh_readers.hpp"
#include "io/placed_meshes.hpp"
#include "number/text.hpp"

namespace convexact {
namespace {

using nlohmann::json;

std::string name_of(const json& item) {
  const auto name = item.find("name");
  return name != item.end() && name->is_string() ? name->get<std::string>() : "";
}

// The topologies of primitives. (Section 3.7.2.1.)
enum Mode { kPoints = 0, kLines = 1, kLineLoop = 2, kLineStrip = 3, kTriangles = 4, kStrip, kFan };

// The triangles among so many corners, in the order that keeps their orientation.
std::vector<std::array<std::size_t, 3>> triangles_of(Mode mode, std::size_t corners) {
  std::vector<std::array<std::size_t, 3>> triangles;
  if (mode == kTriangles) {
    for (std::size_t k = 2; k < corners; k += 3) triangles.push_back({k - 2, k - 1, k});
  }
  for (std::size_t k = 0; k + 2 < corners && mode == kStrip; ++k) {
    triangles.push_back({k, k + 1 + k % 2, k + 2 - k % 2});
  }
  for (std::size_t k = 1; k + 1 < corners && mode == kFan; ++k) triangles.push_back({k, k + 1, 0});
  return triangles;
}

// Reads the meshes of a document, each when a node first asks for it.
class GltfMeshes {
 public:
  GltfMeshes(GltfDocument& document, bool skip_bad) : document_(document), skip_bad_(skip_bad) {}

  const LocalMesh& mesh(std::size_t index) {
    const auto found = meshes_.find(index);
    if (found != meshes_.end()) return found->second;
    return meshes_.emplace(index, read(index)).first->second;
  }
  std::size_t skipped_facets() const { return skipped_facets_; }
  std::size_t with_targets() const { return with_targets_; }

 private:
  // The points of a mesh so far, and where those of one accessor are.
  struct Reading {
    std::vector<Point> doubles;
    std::vector<RationalPoint> rationals;  // of normalized integers; as long as `doubles`, or empty
    LocalMesh mesh;
  };

  LocalMesh read(std::size_t index) {
    const std::string where = gltf_place("meshes", index);
    const json& item = document_.list("meshes")[index];
    if (!item.contains("primitives") || !item["primitives"].is_array()) {
      gltf_fail(where, "an array of primitives");
    }
    Reading reading;
    std::size_t number = 0;
    for (const json& primitive : item["primitives"]) {
      read_primitive(primitive, gltf_place(where + ".primitives", number++), reading);
    }
    if (item.contains("weights")) ++with_targets_;
    reading.mesh.points = reading.rationals.empty() ? PointSet(std::move(reading.doubles))
                                                    : PointSet(std::move(reading.rationals));
    return std::move(reading.mesh);
  }

  void read_primitive(const json& item, const std::string& where, Reading& reading) {
    if (!item.is_object() || !item.contains("attributes") || !item["attributes"].is_object()) {
      gltf_fail(where, "an object with attributes");
    }
    const auto position = item["attributes"].find("POSITION");
    if (position == item["attributes"].end()) return;  // Section 3.7.2.1: it is not drawn
    const GltfAccessor points = positions(*position, where);
    const auto mode =
        static_cast<Mode>(item.contains("mode") ? gltf_unsigned(item["mode"], 7, where + ".mode")
                                                : std::uint64_t{kTriangles});
    const std::vector<std::size_t> corners = item.contains("indices")
                                                 ? indices(item["indices"], points.count, where)
                                                 : first_numbers(points.count);
    if (mode == kTriangles && corners.size() % 3 != 0) {
      gltf_fail(where, "a multiple of 3 corners, found " + std::to_string(corners.size()));
    }
    add_corners(mode, points, corners, reading);
  }

  GltfAccessor positions(const json& index, const std::string& where) {
    GltfAccessor points =
        document_.accessor(document_.index(index, "accessors", where + ".attributes.POSITION"));
    constexpr unsigned kUnsignedInt = 5125;
    if (points.components != 3 || points.type == kUnsignedInt) {
      gltf_fail(points.where, "positions: VEC3 of binary32, or of bytes or shorts");
    }
    return points;
  }

  std::vector<std::size_t> indices(const json& index, std::size_t count, const std::string& where) {
    const GltfAccessor accessor =
        document_.accessor(document_.index(index, "accessors", where + ".indices"));
    const bool is_unsigned =
        accessor.type == 5121 || accessor.type == 5123 || accessor.type == 5125;
    if (accessor.components != 1 || !is_unsigned) {
      gltf_fail(accessor.where, "indices: SCALAR of unsigned integers");
    }
    std::vector<std::size_t> corners(accessor.count);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      corners[k] = static_cast<std::size_t>(accessor.stored(k, 0));
      if (corners[k] < count) continue;
      gltf_fail(accessor.where, "indices of " + counted(count, "point", "points") + ", found " +
                                    std::to_string(corners[k]) + " at place " + std::to_string(k));
    }
    return corners;
  }

  static std::vector<std::size_t> first_numbers(std::size_t count) {
    std::vector<std::size_t> numbers(count);
    for (std::size_t k = 0; k < count; ++k) numbers[k] = k;
    return numbers;
  }

  // Points of a primitive become those of the mesh when they are first used.
  void add_corners(Mode mode, const GltfAccessor& points, const std::vector<std::size_t>& corners,
                   Reading& reading) {
    constexpr std::uint32_t kNew = ~std::uint32_t{0}, kBad = kNew - 1;
    std::vector<std::uint32_t> numbers(points.count, kNew);
    const auto number_of = [&](std::size_t index) {
      std::uint32_t& number = numbers[index];
      if (number == kNew) number = add_point(points, index, reading) ? last_number(reading) : kBad;
      return number;
    };
    std::vector<bool> is_corner(corners.size(), false);
    for (const auto& [a, b, c] : triangles_of(mode, corners.size())) {
      // Strips are sewn together by triangles without area.
      const bool is_seam =
          corners[a] == corners[b] || corners[b] == corners[c] || corners[c] == corners[a];
      const std::vector<std::uint32_t> polygon = {number_of(corners[a]), number_of(corners[b]),
                                                  number_of(corners[c])};
      if (std::find(polygon.begin(), polygon.end(), kBad) != polygon.end()) {
        ++skipped_facets_;
        continue;
      }
      if (is_seam && mode != kTriangles) continue;
      reading.mesh.polygons.push_back(polygon);
      is_corner[a] = is_corner[b] = is_corner[c] = true;
    }
    for (std::size_t k = 0; k < corners.size(); ++k) {
      if (is_corner[k]) continue;
      const std::uint32_t number = number_of(corners[k]);
      if (number != kBad) reading.mesh.loose.push_back(number);
    }
  }

  static std::uint32_t last_number(const Reading& reading) {
    return static_cast<std::uint32_t>(reading.doubles.size() - 1);
  }

  // Whether the point is finite.
  bool add_point(const GltfAccessor& points, std::size_t index, Reading& reading) {
    Point point;
    for (std::size_t k = 0; k < 3; ++k) point[Eigen::Index(k)] = points.stored(index, k);
    if (!point.allFinite()) {
      if (skip_bad_) return false;
      gltf_fail(gltf_place(points.where, index),
                "three finite numbers, found NaN or infinity; --skip-bad leaves such facets out",
                ErrorCode::NotFinite);
    }
    const long divisor = points.divisor();
    if (divisor != 1 && reading.rationals.size() < reading.doubles.size()) {
      for (const Point& before : reading.doubles) reading.rationals.push_back(to_rational(before));
    }
    if (divisor != 1 || !reading.rationals.empty()) {
      RationalPoint exact = to_rational(point);
      // Of signed integers, the lowest one and the next mean -1. (Section 3.11.)
      for (Rational& x : exact) x = std::max(Rational(x / divisor), Rational(-1));
      reading.rationals.push_back(divisor == 1 ? to_rational(point) : exact);
    }
    reading.doubles.push_back(point);
    return true;
  }

  GltfDocument& document_;
  bool skip_bad_;
  std::map<std::size_t, LocalMesh> meshes_;
  std::size_t skipped_facets_ = 0;
  std::size_t with_targets_ = 0;
};

class GltfReader {
 public:
  GltfReader(std::string_view bytes, const ReadOptions& options)
      : options_(options),
        document_(bytes, options.folder),
        meshes_(document_, options.skip_bad),
        placed_(options) {}

  Mesh read() {
    const std::vector<std::size_t> roots = roots_of_scene();
    is_reached_.resize(document_.list("nodes").size(), false);
    for (const std::size_t root : roots) visit(root, Placement{}, 0);
    if (document_.list("nodes").empty()) {
      for (std::size_t k = 0; k < document_.list("meshes").size(); ++k)
        add_mesh(k, "", Placement{});
    }
    Mesh mesh = placed_.finish();
    const auto note = [&](std::size_t count, const std::string& text) {
      if (count > 0) mesh.notes.push_back(text);
    };
    note(skinned_, counted(skinned_, "skin was", "skins were") +
                       " passed over: meshes are taken as stored, where their nodes put them");
    note(meshes_.with_targets(), counted(meshes_.with_targets(), "mesh has", "meshes have") +
                                     " morph targets, which were passed over");
    note(meshes_.skipped_facets(),
         counted(meshes_.skipped_facets(), "facet was", "facets were") +
             " skipped: a coordinate is not finite; the other corners stay as points");
    note(document_.trailing(), counted(document_.trailing(), "byte", "bytes") +
                                   " behind the end of the GLB were skipped");
    note(other_scenes_,
         counted(other_scenes_, "other scene was", "other scenes were") + " skipped");
    return mesh;
  }

 private:
  // Of the scene to show, or of all nodes if there is none. (Section 3.5.1.)
  std::vector<std::size_t> roots_of_scene() {
    const json& scenes = document_.list("scenes");
    if (scenes.empty()) return nodes_without_parent();
    const auto chosen = document_.root().find("scene");
    const std::size_t scene =
        chosen == document_.root().end() ? 0 : document_.index(*chosen, "scenes", "scene");
    other_scenes_ = scenes.size() - 1;
    if (!scenes[scene].is_object()) gltf_fail(gltf_place("scenes", scene), "an object");
    return children(scenes[scene], "nodes", gltf_place("scenes", scene));
  }

  std::vector<std::size_t> nodes_without_parent() {
    const json& nodes = document_.list("nodes");
    std::vector<bool> is_child(nodes.size(), false);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      if (!nodes[k].is_object()) gltf_fail(gltf_place("nodes", k), "an object");
      for (const std::size_t child : children(nodes[k], "children", gltf_place("nodes", k))) {
        is_child[child] = true;
      }
    }
    std::vector<std::size_t> roots;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      if (!is_child[k]) roots.push_back(k);
    }
    if (roots.empty() && !nodes.empty()) gltf_fail("nodes", "a tree, found cycles only");
    return roots;
  }

  std::vector<std::size_t> children(const json& item, const char* key, const std::string& where) {
    std::vector<std::size_t> list;
    if (!item.contains(key)) return list;
    if (!item[key].is_array()) gltf_fail(where + "." + key, "an array");
    for (const json& child : item[key]) {
      list.push_back(document_.index(child, "nodes", where + "." + key));
    }
    return list;
  }

  void visit(std::size_t node, const Placement& outer, std::size_t depth) {
    const std::string where = gltf_place("nodes", node);
    if (is_reached_[node])
      gltf_fail(where, "a tree of nodes, found this one below two others or itself");
    is_reached_[node] = true;
    if (depth >= kMaxSceneDepth) {
      gltf_fail(where, "at most " + std::to_string(kMaxSceneDepth) + " nodes above each other");
    }
    const json& item = document_.list("nodes")[node];
    const Placement placement = outer * placement_of(item, where);
    if (item.contains("mesh")) {
      if (item.contains("skin")) ++skinned_;
      if (item.contains("extensions") && item["extensions"].contains("EXT_mesh_gpu_instancing")) {
        throw Error(ErrorCode::Unreadable,
                    where +
                        ": its instances are given by EXT_mesh_gpu_instancing, which is not "
                        "read; export them as nodes");
      }
      add_mesh(document_.index(item["mesh"], "meshes", where + ".mesh"), name_of(item), placement);
    }
    for (const std::size_t child : children(item, "children", where)) {
      visit(child, placement, depth + 1);
    }
  }

  void add_mesh(std::size_t index, const std::string& node_name, const Placement& placement) {
    const std::string of_mesh = name_of(document_.list("meshes")[index]);
    const std::string name = node_name.empty() ? of_mesh : node_name;
    placed_.add(name.empty() ? "mesh_" + std::to_string(index) : name, meshes_.mesh(index),
                placement);
  }

  Placement placement_of(const json& node, const std::string& where) const {
    if (node.contains("matrix")) {
      const std::vector<Rational> columns = numbers(node, "matrix", 16, {}, where);
      std::array<Rational, 16> rows;
      for (std::size_t k = 0; k < 16; ++k) rows[k] = columns[4 * (k % 4) + k / 4];
      try {
        return checked(affine(rows), where);
      } catch (const Error& error) {
        throw Error(error.code(), where + ".matrix: " + error.what());
      }
    }
    const auto shift = numbers(node, "translation", 3, {0, 0, 0}, where);
    const auto turn = numbers(node, "rotation", 4, {0, 0, 0, 1}, where);
    const auto size = numbers(node, "scale", 3, {1, 1, 1}, where);
    if (std::all_of(turn.begin(), turn.end(), [](const Rational& x) { return x == 0; })) {
      gltf_fail(where + ".rotation", "a quaternion, found 0 0 0 0");
    }
    return checked(translation({shift[0], shift[1], shift[2]}) *
                       rotation({turn[0], turn[1], turn[2], turn[3]}) *
                       scaling({size[0], size[1], size[2]}),
                   where);
  }

  static Placement checked(const Placement& placement, const std::string& where) {
    if (placement.orientation() == Sign::Zero) {
      gltf_fail(where, "a transform that keeps three dimensions, found one that flattens");
    }
    return placement;
  }

  // Each as its nearest double, or as spelled.
  std::vector<Rational> numbers(const json& node, const char* key, std::size_t count,
                                std::vector<Rational> missing, const std::string& where) const {
    if (!node.contains(key)) return missing;
    const json& list = node[key];
    const std::string place = where + "." + key;
    if (!list.is_array() || list.size() != count) {
      gltf_fail(place, "an array of " + std::to_string(count) + " numbers");
    }
    std::vector<Rational> found;
    for (const json& value : list) {
      const std::string_view text = value.is_binary() ? spelling_of(value) : std::string_view{};
      if (text.empty()) gltf_fail(place, "numbers, found " + in_quotes(dump_json(value)));
      const bool is_exact = options_.decimal == Decimal::Exact;
      found.push_back(is_exact ? parse_rational(text) : to_rational(nearest_double(text)));
    }
    return found;
  }

  const ReadOptions& options_;
  GltfDocument document_;
  GltfMeshes meshes_;
  PlacedMeshes placed_;
  std::vector<bool> is_reached_;
  std::size_t skinned_ = 0;
  std::size_t other_scenes_ = 0;
};

}  // namespace

Mesh read_gltf(std::string_view bytes, const ReadOptions& options) {
  return GltfReader(bytes, options).read();
}

}  // namespace convexact
