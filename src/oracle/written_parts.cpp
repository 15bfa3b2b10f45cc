// SPDX-License-Identifier: MIT
#include "oracle/written_parts.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "convexact/stored.hpp"
#include "convexact/verify_parts.hpp"
#include "io/json.hpp"
#include "number/text.hpp"
#include "scene/decompose_report.hpp"

namespace convexact {
namespace {

// Points and polygons one after another, an object for each part.
Mesh joined_parts(std::span<const WrittenPart> parts) {
  Mesh all;
  std::vector<Point> points;
  for (const WrittenPart& written : parts) {
    const Mesh& mesh = written.part->mesh;
    const auto first_point = static_cast<std::uint32_t>(points.size());
    const std::size_t first_polygon = all.polygons.size();
    points.insert(points.end(), mesh.points.doubles().begin(), mesh.points.doubles().end());
    for (std::vector<std::uint32_t> polygon : mesh.polygons) {
      for (std::uint32_t& corner : polygon) corner += first_point;
      all.polygons.push_back(std::move(polygon));
    }
    if (mesh.polygons.empty()) {  // a segment or a point; an object without a face would be lost
      const auto last = static_cast<std::uint32_t>(points.size() - 1);
      all.polygons.push_back({first_point, last, last});
    }
    all.parts.push_back({written.name, first_polygon, all.polygons.size()});
  }
  all.points = PointSet(std::move(points));
  return all;
}

// By the definition of a part, the hull of its points as a reader of the file takes them.
void require_parts(const std::string& bytes, const std::string& path,
                   std::span<const WrittenPart> parts) {
  const CandidateParts read = read_parts_bytes(bytes, path);
  if (const auto* error = std::get_if<Error>(&read)) reject_bytes(path, error->what());
  const auto& found = std::get<std::vector<NamedPart>>(read);
  if (found.size() != parts.size()) {
    reject_bytes(path, fmt::format("has {} parts instead of {}", found.size(), parts.size()));
  }
  for (std::size_t k = 0; k < parts.size(); ++k) {
    // The object of an OBJ with one part has the name of its file.
    if (parts.size() > 1 && found[k].name != parts[k].name) {
      reject_bytes(path, "calls " + in_quotes(parts[k].name) + " " + in_quotes(found[k].name));
    }
    require_held(path, parts[k], convex_part(found[k].mesh.points).halfspaces);
  }
}

}  // namespace

void reject_bytes(const std::string& path, const std::string& why) {
  throw Error(ErrorCode::Internal, "read back from its bytes, " + path + " " + why);
}

void require_held(const std::string& path, const WrittenPart& written,
                  std::span<const Halfspace> halfspaces) {
  const PointSet owned =
      subset(written.surface->points, points_of(*written.surface, written.part->owns));
  if (count_outside(halfspaces, owned) == 0) return;
  reject_bytes(path, "misses a corner of a triangle that " + in_quotes(written.name) + " owns");
}

std::string proven_parts_obj(std::span<const WrittenPart> parts, const std::string& path) {
  std::string bytes = write_mesh(joined_parts(parts), MeshFormat::Obj);
  require_parts(bytes, path, parts);
  return bytes;
}

std::string proven_parts_json(const nlohmann::ordered_json& document,
                              std::span<const WrittenPart> parts, const std::string& path) {
  std::string bytes = write_lines(document);
  require_parts(bytes, path, parts);
  const nlohmann::json read = nlohmann::json::parse(bytes);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    std::vector<Halfspace> halfspaces;
    for (const auto& halfspace : read.at("parts").at(k).at("halfspaces")) {
      halfspaces.push_back(nlohmann::adl_serializer<Halfspace>::from_json(halfspace));
    }
    if (halfspaces.size() < 4) {
      reject_bytes(path, "has no solid under the halfspaces of " + in_quotes(parts[k].name));
    }
    require_held(path, parts[k], halfspaces);
  }
  return bytes;
}

}  // namespace convexact
