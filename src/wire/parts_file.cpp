// SPDX-License-Identifier: MIT
// Parts of a decomposition, from a mesh, a folder of meshes, or JSON.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "convexact/decompose.hpp"
#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "io/file_beside.hpp"
#include "io/file_kind.hpp"
#include "io/json_text.hpp"
#include "scene/objects.hpp"
#include "wire/json_mesh.hpp"
#include "wire/part_models.hpp"

namespace convexact {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

[[noreturn]] void reject_parts(const std::string& expected) {
  throw Error(ErrorCode::Malformed, "expected " + expected);
}

CandidateParts parts_of_json(std::string_view bytes, Decimal decimal) {
  JsonDocument reader({"vertices"});
  parse_json_events(bytes, reader);
  const json& document = reader.document;
  if (!document.is_object() || !document.contains("parts") || !document["parts"].is_array()) {
    reject_parts("an object with a list of 'parts'");
  }
  std::vector<NamedPart> parts;
  for (const json& part : document["parts"]) {
    parts.push_back(part_of_json(part, parts.size(), decimal));
  }
  if (!document.contains("hull_tree")) return parts;
  return HullTree{std::move(parts), nodes_of_json(document["hull_tree"], decimal)};
}

std::vector<NamedPart> parts_of_mesh(Mesh mesh, const std::string& stem) {
  if (objects_in(mesh) < 2) {
    if (mesh.points.size() == 0) return {};
    return {{stem, std::move(mesh)}};
  }
  std::vector<NamedPart> parts;
  for (SceneObject& object : parts_of(mesh, stem)) {
    parts.push_back(
        {object.part,
         {std::get<PointSet>(std::move(object.shape)), std::move(object.polygons), {}}});
  }
  return parts;
}

bool is_json(std::string_view bytes, const std::string& path) {
  if (mesh_format_of_path(path)) return false;
  if (halfspace_format_of_path(path) == HalfspaceFormat::Json) return true;
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return first != bytes.npos && bytes[first] == '{';
}

// "part_2" before "part_10": runs of digits compare as numbers, other characters one by one.
bool comes_before(const std::string& a, const std::string& b) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  std::size_t i = 0, k = 0;
  while (i < a.size() && k < b.size()) {
    if (!is_digit(a[i]) || !is_digit(b[k])) {
      if (a[i] != b[k]) return a[i] < b[k];
      ++i, ++k;
      continue;
    }
    const auto run = [&](const std::string& text, std::size_t& at) {
      while (at < text.size() && text[at] == '0') ++at;
      const std::size_t from = at;
      while (at < text.size() && is_digit(text[at])) ++at;
      return text.substr(from, at - from);
    };
    const std::string x = run(a, i), y = run(b, k);
    if (x.size() != y.size()) return x.size() < y.size();
    if (x != y) return x < y;
  }
  if ((i < a.size()) != (k < b.size())) return k < b.size();
  return a < b;  // they differ in zeros before a number, if at all
}

std::vector<std::string> meshes_in(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (name.front() != '.' && readable_mesh_format(name)) names.push_back(name);
  }
  if (error) {
    throw Error(ErrorCode::Unreadable, "the folder cannot be read: " + error.message())
        .in_file(folder);
  }
  if (names.empty()) {
    throw Error(ErrorCode::Unreadable,
                "the folder holds no mesh: expected .obj, .off, .ply, .stl or .xyz files")
        .in_file(folder);
  }
  std::sort(names.begin(), names.end(), comes_before);
  return names;
}

}  // namespace

CandidateParts read_parts_bytes(std::string_view bytes, const std::string& path, Decimal decimal) {
  try {
    if (is_json(bytes, path)) return parts_of_json(bytes, decimal);
    const std::string stem = path == "-" ? "input" : fs::path(path).stem().string();
    const FileKind kind = kind_of_file(bytes, path);
    if (!kind.mesh) reject_parts("a mesh with an object per part, found halfspaces");
    return parts_of_mesh(read_mesh_bytes(bytes, {.decimal = decimal,
                                                 .format = kind.mesh,
                                                 .strict = true,
                                                 .folder = folder_of_file(path)}),
                         stem);
  } catch (const Error& error) {
    return fault_of_candidate(error, path);
  }
}

const std::vector<NamedPart>* parts_of(const CandidateParts& candidate) {
  if (const auto* tree = std::get_if<HullTree>(&candidate)) return &tree->parts;
  return std::get_if<std::vector<NamedPart>>(&candidate);
}

namespace {

// The parts of a model for simulators that convexact wrote.
CandidateParts read_part_model(const std::string& path, Decimal decimal) {
  const std::string bytes = read_bytes(path);
  const auto refuse = [&]() -> Error {
    return Error(ErrorCode::Unreadable,
                 "this is a model for simulators that convexact did not write, which may place and "
                 "scale its meshes: name a mesh with an object per part, or a folder of meshes")
        .in_file(path);
  };
  if (path.ends_with(".usda")) {
    if (auto parts = parts_of_usd(bytes)) return std::move(*parts);
    throw refuse();
  }
  const auto files = part_files_of_model(bytes);
  if (!files) throw refuse();
  std::vector<NamedPart> all;
  for (const auto& [name, relative] : *files) {
    const fs::path inside = fs::path(relative).lexically_normal();
    if (inside.is_absolute() || inside.begin() == inside.end() || *inside.begin() == "..") {
      throw Error(ErrorCode::Unreadable, "a path in it leaves its folder: " + relative)
          .in_file(path);
    }
    const std::string file = (fs::path(path).parent_path() / inside).string();
    CandidateParts some = read_parts_bytes(read_bytes(file), file, decimal);
    if (auto* error = std::get_if<Error>(&some)) return std::move(*error);
    for (NamedPart& part : std::get<std::vector<NamedPart>>(some)) {
      part.name = name;
      all.push_back(std::move(part));
    }
  }
  return all;
}

}  // namespace

CandidateParts read_parts(const std::string& path, Decimal decimal) {
  std::error_code ignored;
  if (is_part_model(path)) return read_part_model(path, decimal);
  if (path == "-" || !fs::is_directory(path, ignored)) {
    return read_parts_bytes(read_bytes(path), path, decimal);
  }
  std::vector<NamedPart> all;
  for (const std::string& name : meshes_in(path)) {
    const std::string file = (fs::path(path) / name).string();
    CandidateParts some = read_parts_bytes(read_bytes(file), file, decimal);
    if (auto* error = std::get_if<Error>(&some)) return std::move(*error);
    if (std::get<std::vector<NamedPart>>(some).empty()) {
      return Error(ErrorCode::Malformed, "expected points, and there is none").in_file(file);
    }
    for (NamedPart& part : std::get<std::vector<NamedPart>>(some)) {
      const std::string stem = fs::path(name).stem().string();
      if (part.name != stem) part.name = stem + ": " + part.name;
      all.push_back(std::move(part));
    }
  }
  return all;
}

}  // namespace convexact
