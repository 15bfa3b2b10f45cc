// SPDX-License-Identifier: MIT
#include "wire/mesh_file.hpp"

#include <fmt/format.h>

#include <iterator>

#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "io/file_kind.hpp"
#include "io/json.hpp"
#include "scene/objects.hpp"

namespace convexact {
namespace {

// Written directly: as a document, the rows of a large mesh would take ten times their memory.
template <class Rows, class Append>
void append_rows(std::string& text, const char* key, const Rows& rows, const Append& append) {
  text += fmt::format("\"{}\":[", key);
  bool is_first_row = true;
  for (const auto& row : rows) {
    text += is_first_row ? "[" : ",[";
    is_first_row = false;
    bool is_first = true;
    for (const auto& number : row) {
      if (!is_first) text += ',';
      is_first = false;
      append(number);
    }
    text += ']';
  }
  text += ']';
}

// The objects of a file with several: which triangles are theirs, and points that no triangle uses.
Json objects_of(const Mesh& mesh) {
  Json objects = Json::array();
  for (const MeshPart& part : mesh.parts) {
    if (!is_object(part)) continue;
    objects.push_back({{"name", part.name},
                       {"first", part.first_polygon},
                       {"end", part.last_polygon},
                       {"loose", part.loose}});
  }
  return objects;
}

std::string mesh_text(const Mesh& mesh) {
  std::string text = "{";
  const auto append = [&](const auto& x) { fmt::format_to(std::back_inserter(text), "{}", x); };
  if (mesh.points.is_binary()) {
    append_rows(text, "points", mesh.points.doubles(), append);
  } else {
    std::vector<RationalPoint> points;
    for (std::size_t k = 0; k < mesh.points.size(); ++k) {
      points.push_back(mesh.points[PointId(static_cast<std::uint32_t>(k))]);
    }
    append_rows(text, "points", points,
                [&](const Rational& x) { text += '"' + to_string(x) + '"'; });
  }
  text += ',';
  append_rows(text, "triangles", mesh.polygons, append);
  if (objects_in(mesh) > 1) text += ",\"objects\":" + write_json(objects_of(mesh));
  return text + ",\"notes\":" + write_json(Json(mesh.notes)) + "}";
}

}  // namespace

std::string shape_in_file(const std::string& name, std::string_view bytes) {
  const FileKind kind = kind_of_file(bytes, name);
  try {
    if (kind.mesh) return mesh_text(read_mesh_bytes(bytes, {.format = kind.mesh}));
    return write_json(Json{{"planes", read_halfspaces_bytes(bytes, *kind.halfspaces).halfspaces}});
  } catch (const Error& error) {
    throw error.in_file(name);
  }
}

}  // namespace convexact
