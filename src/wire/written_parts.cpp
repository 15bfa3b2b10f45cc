// SPDX-License-Identifier: MIT
#include "wire/written_parts.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "convexact/decompose.hpp"
#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "io/json_document.hpp"
#include "io/json_text.hpp"
#include "number/text.hpp"
#include "scene/objects.hpp"
#include "stored/prepared_halfspaces.hpp"
#include "task/parallel.hpp"

namespace convexact {
namespace {

// By the definition of a part, the hull of its points as a reader of the file takes them.
void require_parts(const std::string& bytes, const std::string& path,
                   std::span<const WrittenPart> parts, std::size_t jobs) {
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
  }
  for_each_in_parallel(parts.size(), jobs, [&](std::size_t k) {
    require_held(path, parts[k], convex_part(found[k].mesh.points).halfspaces);
  });
}

}  // namespace

std::vector<WrittenPart> written_parts(std::span<const DecomposedObject> objects) {
  std::vector<WrittenPart> parts;
  for (const DecomposedObject& object : objects) {
    for (std::size_t k = 0; k < object.result.parts.size(); ++k) {
      parts.push_back({object.part_names[k], &object.result.parts[k], &object.result.surface,
                       std::get_if<Partition>(&object.result.origin)});
    }
  }
  return parts;
}

void require_held(const std::string& path, const WrittenPart& written,
                  std::span<const Halfspace> halfspaces) {
  const PreparedHalfspaces prepared(halfspaces);
  const PointSet owned =
      subset(written.surface->points, points_of(*written.surface, written.part->owns));
  for (const std::uint32_t leaf : written.part->leaves) {
    if (!find_outside(prepared, written.partition->leaves[leaf].corners).empty()) {
      reject_bytes(path, "misses a corner of a leaf that " + in_quotes(written.name) + " holds");
    }
  }
  if (find_outside(prepared, owned).empty()) return;
  reject_bytes(path, "misses a corner of a triangle that " + in_quotes(written.name) + " owns");
}

std::string proven_parts_mesh(std::span<const WrittenPart> parts, MeshFormat format,
                              const std::string& path, std::optional<std::size_t> jobs) {
  std::vector<NamedMesh> objects;
  for (const WrittenPart& part : parts) objects.push_back({part.name, &part.part->mesh});
  std::string bytes = write_mesh(joined(objects), format);
  require_parts(bytes, path, parts, jobs.value_or(all_cores()));
  return bytes;
}

std::string proven_parts_json(const Json& document, std::span<const WrittenPart> parts,
                              const std::string& path, std::optional<std::size_t> jobs) {
  std::string bytes = write_lines(document);
  require_parts(bytes, path, parts, jobs.value_or(all_cores()));
  const nlohmann::json read = parse_json(bytes);
  for_each_in_parallel(parts.size(), jobs.value_or(all_cores()), [&](std::size_t k) {
    std::vector<Halfspace> halfspaces;
    for (const auto& halfspace : read.at("parts").at(k).at("halfspaces")) {
      halfspaces.push_back(halfspace.get<Halfspace>());
    }
    if (halfspaces.size() < 4) {
      reject_bytes(path, "has no solid under the halfspaces of " + in_quotes(parts[k].name));
    }
    require_held(path, parts[k], halfspaces);
  });
  return bytes;
}

}  // namespace convexact
