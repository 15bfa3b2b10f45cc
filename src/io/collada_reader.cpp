// SPDX-License-Identifier: MIT
// COLLADA 1.4 and 1.5: every instance of a geometry is an object, where the nodes above it put it.
// Points are those that a primitive uses. Names of elements are those of the COLLADA Specification
// of the Khronos Group, 1.4.1.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "convexact/error.hpp"
#include "io/collada_document.hpp"
#include "io/file_kind.hpp"
#include "io/mesh_readers.hpp"
#include "io/placed_meshes.hpp"
#include "number/text.hpp"

namespace convexact {
namespace {

using pugi::xml_node;

// A short file may instance nodes within nodes many times over.
constexpr std::size_t kMostVisits = 1'000'000;

// Reads a geometry, when an instance first asks for it.
class Geometries {
 public:
  Geometries(const ColladaDocument& document, const ReadOptions& options)
      : document_(document), options_(options) {}

  const LocalMesh& mesh(const xml_node& geometry) {
    const auto found = meshes_.find(geometry);
    if (found != meshes_.end()) return found->second;
    return meshes_.emplace(geometry, read(geometry)).first->second;
  }
  std::size_t skipped_faces() const { return skipped_faces_; }

 private:
  // The words of the positions that a primitive indexes; a point is parsed when it is first used.
  struct Positions {
    xml_node array;
    std::vector<std::string_view> words;
    std::size_t count = 0, stride = 3, first = 0;
    std::array<std::size_t, 3> places{0, 1, 2};  // of x, y and z in an element
    std::vector<std::uint32_t> numbers;          // by index, of the point in the mesh
  };
  struct Reading {
    std::map<xml_node, Positions> positions;  // by source
    std::vector<RationalPoint> points;
    LocalMesh mesh;
  };
  static constexpr std::uint32_t kNew = ~std::uint32_t{0};

  LocalMesh read(const xml_node& geometry) {
    const xml_node mesh = geometry.child("mesh");
    if (!mesh) {
      document_.fail(geometry,
                     "a mesh; splines, convex hulls of others and curved surfaces are "
                     "not read",
                     ErrorCode::Unreadable);
    }
    Reading reading;
    for (const xml_node& primitive : mesh.children()) read_primitive(primitive, reading);
    reading.mesh.points = PointSet(std::move(reading.points));
    return std::move(reading.mesh);
  }

  void read_primitive(const xml_node& primitive, Reading& reading) {
    const std::string_view kind = primitive.name();
    const bool is_line = kind == "lines" || kind == "linestrips";
    if (!is_line && kind != "triangles" && kind != "polylist" && kind != "polygons" &&
        kind != "tristrips" && kind != "trifans") {
      return;  // source, vertices, extra
    }
    std::size_t stride = 1, offset = 0;
    xml_node vertices;
    for (const xml_node& input : primitive.children("input")) {
      const std::size_t place = document_.count_or(input, "offset", 0);
      stride = std::max(stride, place + 1);
      if (attribute_of(input, "semantic") != "VERTEX") continue;
      vertices = document_.referred(input, "source", "vertices");
      offset = place;
    }
    if (primitive.child("ph")) {
      document_.fail(primitive, "polygons without holes", ErrorCode::Unreadable);
    }
    if (!primitive.child("p")) return;
    if (!vertices) document_.fail(primitive, "an input of the semantic VERTEX");
    Positions& positions = positions_of(vertices, reading);
    for (const xml_node& p : primitive.children("p")) {
      const std::vector<std::size_t> all = document_.counts(p);
      if (all.size() % stride != 0) {
        document_.fail(p, "a multiple of " + counted(stride, "index", "indices") + ", found " +
                              std::to_string(all.size()));
      }
      std::vector<std::uint32_t> corners;
      for (std::size_t k = offset; k < all.size(); k += stride) {
        corners.push_back(point(positions, p, all[k], reading));
      }
      add_polygons(primitive, p, corners, reading.mesh);
    }
  }

  void add_polygons(const xml_node& primitive, const xml_node& p,
                    const std::vector<std::uint32_t>& corners, LocalMesh& mesh) {
    const std::string_view kind = primitive.name();
    const std::size_t count = corners.size();
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      mesh.polygons.push_back({corners[a], corners[b], corners[c]});
    };
    if (kind == "polylist") {
      add_lists(primitive, corners, mesh);
    } else if (kind == "polygons") {
      add_polygon(corners, mesh);
    } else if (kind == "triangles") {
      if (count % 3 != 0) {
        document_.fail(p, "three corners for each triangle, found " + std::to_string(count));
      }
      for (std::size_t k = 2; k < count; k += 3) add(k - 2, k - 1, k);
    } else if (kind == "tristrips") {
      for (std::size_t k = 0; k + 2 < count; ++k) add(k, k + 1 + k % 2, k + 2 - k % 2);
    } else if (kind == "trifans") {
      for (std::size_t k = 1; k + 1 < count; ++k) add(0, k, k + 1);
    } else {
      mesh.loose.insert(mesh.loose.end(), corners.begin(), corners.end());  // of lines
    }
  }

  void add_lists(const xml_node& primitive, const std::vector<std::uint32_t>& corners,
                 LocalMesh& mesh) {
    std::size_t next = 0;
    for (const std::size_t count : document_.counts(primitive.child("vcount"))) {
      if (count > corners.size() - next) {
        document_.fail(primitive,
                       "as many corners as vcount says, found " + std::to_string(corners.size()));
      }
      add_polygon(
          {corners.begin() + std::ptrdiff_t(next), corners.begin() + std::ptrdiff_t(next + count)},
          mesh);
      next += count;
    }
    if (next != corners.size()) {
      document_.fail(primitive, std::to_string(next) + " corners, as vcount says, found " +
                                    std::to_string(corners.size()));
    }
  }

  void add_polygon(const std::vector<std::uint32_t>& corners, LocalMesh& mesh) {
    if (corners.size() >= 3) {
      mesh.polygons.push_back(corners);
      return;
    }
    mesh.loose.insert(mesh.loose.end(), corners.begin(), corners.end());
    ++skipped_faces_;
  }

  Positions& positions_of(const xml_node& vertices, Reading& reading) {
    for (const xml_node& input : vertices.children("input")) {
      if (attribute_of(input, "semantic") != "POSITION") continue;
      const xml_node source = document_.referred(input, "source", "source");
      const auto found = reading.positions.find(source);
      if (found != reading.positions.end()) return found->second;
      return reading.positions.emplace(source, read_positions(source)).first->second;
    }
    document_.fail(vertices, "an input of the semantic POSITION");
  }

  Positions read_positions(const xml_node& source) const {
    const xml_node accessor = source.child("technique_common").child("accessor");
    if (!accessor) document_.fail(source, "an accessor");
    Positions positions;
    positions.array = document_.referred(accessor, "source", "float_array");
    positions.count = document_.count_or(accessor, "count", 0);
    positions.stride = document_.count_or(accessor, "stride", 1);
    positions.first = document_.count_or(accessor, "offset", 0);
    // Parameters without a name are passed over.
    std::size_t place = 0, named = 0;
    for (const xml_node& parameter : accessor.children("param")) {
      if (!attribute_of(parameter, "name").empty() && named < 3) positions.places[named++] = place;
      ++place;
    }
    if ((named != 3 && place > 0) || positions.stride < 1 + positions.places[2]) {
      document_.fail(accessor, "x, y and z in each element");
    }
    Words words(text_of(positions.array));
    for (auto word = words.next(); !word.empty(); word = words.next()) {
      positions.words.push_back(word);
    }
    const std::size_t needed =
        positions.count == 0
            ? 0
            : positions.first + (positions.count - 1) * positions.stride + positions.places[2] + 1;
    if (needed > positions.words.size()) {
      document_.fail(positions.array, std::to_string(needed) + " numbers, found " +
                                          std::to_string(positions.words.size()));
    }
    positions.numbers.assign(positions.count, kNew);
    return positions;
  }

  std::uint32_t point(Positions& positions, const xml_node& p, std::size_t index,
                      Reading& reading) const {
    if (index >= positions.count) {
      document_.fail(p, "indices of " + counted(positions.count, "point", "points") + ", found " +
                            std::to_string(index));
    }
    std::uint32_t& number = positions.numbers[index];
    if (number != kNew) return number;
    number = static_cast<std::uint32_t>(reading.points.size());
    RationalPoint& point = reading.points.emplace_back();
    for (int k = 0; k < 3; ++k) {
      const std::size_t word =
          positions.first + index * positions.stride + positions.places[std::size_t(k)];
      point[k] = document_.number(positions.array, positions.words[word], options_.decimal);
    }
    return number;
  }

  const ColladaDocument& document_;
  const ReadOptions& options_;
  std::map<xml_node, LocalMesh> meshes_;
  std::size_t skipped_faces_ = 0;
};

class ColladaReader {
 public:
  ColladaReader(std::string_view bytes, const ReadOptions& options)
      : decimal_(options.decimal),
        document_(bytes),
        geometries_(document_, options),
        placed_(options) {}

  Mesh read() {
    const xml_node root = document_.root();
    if (!root) document_.fail(root, "an element COLLADA");
    const xml_node instance = root.child("scene").child("instance_visual_scene");
    if (instance) {
      visit_children(document_.referred(instance, "url", "visual_scene"), Placement{}, 0);
    } else {
      for (const xml_node& library : root.children("library_geometries")) {
        for (const xml_node& geometry : library.children("geometry"))
          add(geometry, Placement{}, "");
      }
    }
    Mesh mesh = placed_.finish();
    add_notes(root, !instance, mesh);
    return mesh;
  }

 private:
  void visit(const xml_node& node, const Placement& outer, std::size_t depth) {
    if (depth >= kMaxSceneDepth) {
      document_.fail(node, "at most " + std::to_string(kMaxSceneDepth) +
                               " nodes within each other, and none within itself");
    }
    if (++visits_ > kMostVisits) {
      document_.fail(node, "at most " + with_separators(kMostVisits) + " instances of nodes");
    }
    Placement placement = outer;
    for (const xml_node& child : node.children()) {
      if (const auto transform = transform_of(child)) placement = placement * *transform;
    }
    visit_children(node, placement, depth);
  }

  void visit_children(const xml_node& node, const Placement& placement, std::size_t depth) {
    for (const xml_node& child : node.children()) {
      const std::string_view kind = child.name();
      if (kind == "node") {
        visit(child, placement, depth + 1);
      } else if (kind == "instance_node") {
        visit(document_.referred(child, "url", "node"), placement, depth + 1);
      } else if (kind == "instance_geometry") {
        const std::string_view name = attribute_of(node, "name");
        add(document_.referred(child, "url", "geometry"), placement,
            name.empty() ? attribute_of(node, "id") : name);
      } else if (kind == "instance_controller") {
        document_.fail(child, "geometry; a skin or a morph as geometry is not read",
                       ErrorCode::Unreadable);
      }
    }
  }

  void add(const xml_node& geometry, const Placement& placement, std::string_view node_name) {
    std::string_view name = node_name;
    for (const char* attribute : {"name", "id"}) {
      if (name.empty()) name = attribute_of(geometry, attribute);
    }
    try {
      placed_.add(std::string(name), geometries_.mesh(geometry), placement);
    } catch (const Error& error) {
      if (error.line()) throw;
      document_.fail(geometry, error.what());
    }
  }

  // Of an element that moves what its node holds; nothing for any other.
  std::optional<Placement> transform_of(const xml_node& element) const {
    const std::string_view kind = element.name();
    const auto numbers = [&](std::size_t count) {
      return document_.numbers(element, count,
                               decimal_ == Decimal::Exact ? decimal_ : Decimal::Nearest);
    };
    if (kind == "translate" || kind == "scale") {
      const auto x = numbers(3);
      const RationalVector3 by(x[0], x[1], x[2]);
      return kind == "scale" ? scaling(by) : translation(by);
    }
    if (kind == "rotate") {
      const auto x = numbers(4);
      const RationalVector3 axis(x[0], x[1], x[2]);
      if (axis.isZero()) {
        if (x[3] == 0) return Placement{};
        document_.fail(element, "an axis, found 0 0 0");
      }
      return rotation_about(axis, x[3]);
    }
    if (kind == "matrix") {
      const auto rows = numbers(16);
      try {
        return affine(std::span<const Rational, 16>(rows));
      } catch (const Error&) {
        document_.fail(element, "a matrix whose last row is 0 0 0 1");
      }
    }
    if (kind == "skew" || kind == "lookat") {
      document_.fail(element,
                     "translate, rotate, scale or matrix; " + std::string(kind) + " is not read",
                     ErrorCode::Unreadable);
    }
    return {};
  }

  // Coordinates are taken as written; what the file says of their meaning is told.
  void add_notes(const xml_node& root, bool has_no_scene, Mesh& mesh) const {
    const xml_node asset = root.child("asset");
    const std::string axis(text_of(asset.child("up_axis")));
    const std::string meters(attribute_of(asset.child("unit"), "meter"));
    if (!axis.empty() && axis != "Z_UP") {
      mesh.notes.push_back("the file says " + in_quotes(axis) +
                           ": coordinates are taken as written, not turned");
    }
    if (!meters.empty() && Words(meters).next() != "1" && meters != "1.0") {
      mesh.notes.push_back("the file says that a unit is " + in_quotes(meters) +
                           " meters: coordinates are taken as written, not scaled");
    }
    if (has_no_scene) mesh.notes.push_back("no scene: every geometry is taken as it lies");
    const std::size_t skipped = geometries_.skipped_faces();
    if (skipped > 0) mesh.notes.push_back(skipped_faces_note(skipped));
  }

  Decimal decimal_;
  ColladaDocument document_;
  Geometries geometries_;
  PlacedMeshes placed_;
  std::size_t visits_ = 0;
};

}  // namespace

bool is_collada(std::string_view bytes) {
  const std::string start = lower_case(bytes.substr(0, 4096));
  const std::size_t first = start.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  return first != start.npos && start[first] == '<' && start.find("<collada") != start.npos;
}

double collada_unit(std::string_view bytes) {
  pugi::xml_document document;
  if (!document.load_buffer(bytes.data(), bytes.size())) return 1;
  const xml_node unit = document.child("COLLADA").child("asset").child("unit");
  const double meters = unit.attribute("meter").as_double(1);
  return meters > 0 && std::isfinite(meters) ? meters : 1;
}

Mesh read_collada(std::string_view bytes, const ReadOptions& options) {
  return ColladaReader(bytes, options).read();
}

}  // namespace convexact
