// SPDX-License-Identifier: MIT
#include "scene/objects.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <unordered_map>

#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "convexact/overlay.hpp"
#include "convexact/scene.hpp"
#include "io/file_beside.hpp"
#include "io/file_kind.hpp"
#include "solid/solid.hpp"

namespace convexact {
namespace {

// A file with blanks around its name is named without them.
std::string stem_of(const std::string& path) {
  if (path == "-") return "input";
  const std::string stem = std::filesystem::path(path).stem().string();
  const std::size_t first = stem.find_first_not_of(" \t"), last = stem.find_last_not_of(" \t");
  return first == stem.npos ? "" : stem.substr(first, last - first + 1);
}

// Two objects with the same name would be one object in a file, or not say which is meant. The
// later one gets a number.
void make_names_distinct(std::vector<SceneObject>& objects, std::size_t first_of_file) {
  std::set<std::string> names;
  for (std::size_t k = 0; k < first_of_file; ++k) names.insert(objects[k].part);
  for (std::size_t k = first_of_file; k < objects.size(); ++k) {
    const std::string name = objects[k].part;
    for (int number = 2; !names.insert(objects[k].part).second; ++number) {
      objects[k].part = name + "-" + std::to_string(number);
    }
  }
}

// The points that a part's polygons use, renumbered in the order of the file; then its loose
// points.
SceneObject extract_part(const Mesh& mesh, const MeshPart& part, const std::string& file) {
  SceneObject object{file + ": " + part.name, part.name, {}, {}};
  std::unordered_map<std::uint32_t, std::uint32_t> renumbered;
  std::vector<Point> doubles;
  std::vector<RationalPoint> rationals;
  const auto number_of = [&](std::uint32_t point) {
    const auto [entry, is_new] =
        renumbered.try_emplace(point, static_cast<std::uint32_t>(renumbered.size()));
    if (is_new && mesh.points.is_binary()) doubles.push_back(mesh.points.doubles()[point]);
    if (is_new && !mesh.points.is_binary()) rationals.push_back(mesh.points[PointId(point)]);
    return entry->second;
  };
  for (std::size_t k = part.first_polygon; k < part.last_polygon; ++k) {
    auto& polygon = object.polygons.emplace_back(mesh.polygons[k]);
    for (std::uint32_t& corner : polygon) corner = number_of(corner);
  }
  for (const std::uint32_t point : part.loose) (void)number_of(point);
  object.groups = {{part.name, 0, object.polygons.size()}};
  object.shape =
      mesh.points.is_binary() ? PointSet(std::move(doubles)) : PointSet(std::move(rationals));
  return object;
}

void read_mesh_objects(const std::string& path, const std::string& bytes, MeshFormat format,
                       const SceneOptions& options, std::vector<SceneObject>& objects) {
  const std::string file = display_name(path);
  const bool only_used = options.points == MeshPoints::Used;
  Mesh mesh =
      read_mesh_bytes(bytes, {.decimal = options.decimal,
                              .format = format,
                              .skip_bad = options.skip_bad,
                              .points_only = options.points_only && !options.parts && !only_used,
                              .folder = folder_of_file(path)});
  if (options.on_note) {
    for (const std::string& note : mesh.notes) options.on_note(file, note);
  }
  if (!options.parts) {
    if (only_used) drop_unused_points(mesh);
    objects.push_back({.name = file,
                       .part = stem_of(path),
                       .shape = std::move(mesh.points),
                       .polygons = std::move(mesh.polygons),
                       .groups = std::move(mesh.parts)});
    return;
  }
  if (only_used) {
    for (MeshPart& part : mesh.parts) {
      if (part.first_polygon < part.last_polygon) part.loose.clear();
    }
  }
  for (SceneObject& part : parts_of(mesh, file)) objects.push_back(std::move(part));
}

}  // namespace

SceneObject halfspace_object(const std::string& path, HalfspaceList list) {
  if (list.impossible_row) {
    throw Error(ErrorCode::NoInterior, "the input is empty: halfspace " +
                                           std::to_string(*list.impossible_row) +
                                           " (counted from 0) has a zero normal and holds nowhere");
  }
  TypedRows rows = std::move(static_cast<TypedRows&>(list));
  return {.name = display_name(path),
          .part = stem_of(path),
          .shape = std::move(list.halfspaces),
          .polygons = {},
          .rows = std::move(rows)};
}

bool is_object(const MeshPart& part) {
  return part.first_polygon < part.last_polygon || !part.loose.empty();
}

std::size_t objects_in(const Mesh& mesh) {
  return static_cast<std::size_t>(std::count_if(mesh.parts.begin(), mesh.parts.end(), is_object));
}

std::vector<SceneObject> parts_of(const Mesh& mesh, const std::string& file) {
  std::vector<SceneObject> parts;
  for (const MeshPart& part : mesh.parts) {
    if (is_object(part)) parts.push_back(extract_part(mesh, part, file));
  }
  if (parts.empty()) {
    throw Error(ErrorCode::InvalidArgument, "the file has no faces, so no parts");
  }
  return parts;
}

std::vector<bool> used_flags(const SceneObject& object) {
  if (object.polygons.empty()) return {};
  return used_points(std::get<PointSet>(object.shape).size(), object.polygons);
}

std::variant<Mesh, NotSolid> mesh_of(SceneObject object) {
  if (auto* points = std::get_if<PointSet>(&object.shape)) {
    return Mesh{std::move(*points), std::move(object.polygons), std::move(object.groups)};
  }
  StageLog log;
  auto made = make_polytope(std::get<std::vector<Halfspace>>(object.shape), 1, log);
  if (auto* reason = std::get_if<NotSolid>(&made)) return of_typed_rows(*reason, object.rows);
  auto& solid = std::get<Polytope>(made);
  return Mesh{PointSet(std::move(solid.vertices)), std::move(solid.facets), {}};
}

namespace {

// The points of each object that has nothing else.
std::vector<PointSet> clouds_of(const Mesh& mesh) {
  std::vector<PointSet> clouds;
  for (const MeshPart& part : mesh.parts) {
    if (part.first_polygon < part.last_polygon || part.loose.empty()) continue;
    const std::vector<PointId> ids(part.loose.begin(), part.loose.end());
    clouds.push_back(subset(mesh.points, ids));
  }
  const bool is_one = clouds.empty() && mesh.polygons.empty() && mesh.points.size() > 0;
  if (is_one) clouds.push_back(mesh.points);
  return clouds;
}

}  // namespace

Mesh with_hulls_of_clouds(Mesh mesh) {
  for (const PointSet& cloud : clouds_of(mesh)) {
    const ConvexPart hull = convex_part(cloud);
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    const auto last = first + static_cast<std::uint32_t>(hull.vertices.size()) - 1;
    mesh.points = concatenated(mesh.points, PointSet(hull.vertices));
    if (hull.solid) {
      for (std::vector<std::uint32_t> facet : hull.solid->facets) {
        for (std::uint32_t& corner : facet) corner += first;
        mesh.polygons.push_back(std::move(facet));
      }
      continue;
    }
    auto& polygon = mesh.polygons.emplace_back();
    for (std::uint32_t corner = first; corner <= last; ++corner) polygon.push_back(corner);
    while (polygon.size() < 3) polygon.push_back(last);
  }
  return mesh;
}

Mesh joined(std::span<const NamedMesh> objects) {
  Mesh all;
  std::vector<Point> points;
  for (const auto& [name, mesh] : objects) {
    const auto first_point = static_cast<std::uint32_t>(points.size());
    const std::size_t first_polygon = all.polygons.size();
    points.insert(points.end(), mesh->points.doubles().begin(), mesh->points.doubles().end());
    for (std::vector<std::uint32_t> polygon : mesh->polygons) {
      for (std::uint32_t& corner : polygon) corner += first_point;
      all.polygons.push_back(std::move(polygon));
    }
    if (mesh->polygons.empty()) {
      const auto last = static_cast<std::uint32_t>(points.size() - 1);
      all.polygons.push_back({first_point, last, last});
    }
    all.parts.push_back({name, first_polygon, all.polygons.size()});
  }
  all.points = PointSet(std::move(points));
  return all;
}

void reject_bytes(const std::string& path, const std::string& why) {
  throw Error(ErrorCode::Internal, "read back from its bytes, " + path + " " + why);
}

std::vector<std::size_t> to_typed_rows(std::vector<std::size_t> redundant, const TypedRows& rows) {
  if (rows.rows.empty()) return redundant;
  for (std::size_t& row : redundant) row = rows.rows[row];
  return redundant;
}

std::vector<SceneObject> read_scene(const std::vector<std::string>& paths,
                                    const SceneOptions& options) {
  if (std::count(paths.begin(), paths.end(), "-") > 1) {
    throw Error(ErrorCode::InvalidArgument, "standard input, -, can be read only once");
  }
  std::vector<SceneObject> objects;
  for (const std::string& path : paths) {
    const std::size_t before = objects.size();
    const auto kept = std::make_shared<const std::string>(read_bytes(path));
    if (options.on_read) options.on_read(display_name(path), kept);
    const std::string& bytes = *kept;
    try {
      const FileKind kind = kind_of_file(bytes, path);
      if (kind.halfspaces) {
        objects.push_back(halfspace_object(
            path, read_halfspaces_bytes(bytes, *kind.halfspaces, options.decimal)));
      } else {
        read_mesh_objects(path, bytes, *kind.mesh, options, objects);
      }
      make_names_distinct(objects, before);
    } catch (const Error& error) {
      throw error.in_file(display_name(path));
    }
  }
  return objects;
}

}  // namespace convexact
