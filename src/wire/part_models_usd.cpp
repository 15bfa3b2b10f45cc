// SPDX-License-Identifier: MIT
// Parts as text of USD, and the proof of its bytes.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string_view>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "convexact/overlay.hpp"
#include "io/output_buffer.hpp"
#include "scene/objects.hpp"
#include "wire/part_models.hpp"

namespace convexact {
namespace {

constexpr std::string_view kMeshLine = "    def Mesh \"",
                           kPointsLine = "        point3f[] points = [",
                           kCountsLine = "        int[] faceVertexCounts = [",
                           kIndicesLine = "        int[] faceVertexIndices = [",
                           kUnitLine = "    metersPerUnit = ", kUpLine = "    upAxis = ",
                           kCenterLine = "    point3f physics:centerOfMass = ",
                           kMassLine = "    float physics:mass = ",
                           kMassSchema = "    prepend apiSchemas = [\"PhysicsMassAPI\"]";

// A letter or _, then letters, digits and _, as every version of USD takes them. Each other
// character becomes a _.
std::string identifier_of(const std::string& name) {
  std::string identifier;
  for (const char c : name) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    const bool is_digit = c >= '0' && c <= '9';
    const bool continues_character = (static_cast<unsigned char>(c) & 0xC0) == 0x80;
    if (is_digit && identifier.empty()) identifier = "_";
    if (!continues_character) identifier += is_letter || is_digit ? c : '_';
  }
  return identifier.empty() ? "_" : identifier;
}

std::string quoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

void append_point(OutputBuffer& out, const Point& p) {
  out.text("(").number(p.x()).text(", ").number(p.y()).text(", ").number(p.z()).text(")");
}

// "first, second, third]", each by `append`.
template <class List, class Append>
void append_list(OutputBuffer& out, const List& list, Append&& append) {
  bool is_first = true;
  for (const auto& each : list) {
    if (!is_first) out.text(", ");
    is_first = false;
    append(each);
  }
  out.text("]\n");
}

// The smallest and the largest coordinates: the extent of a mesh in USD.
std::array<Point, 2> extent_of(std::span<const Point> points) {
  Point low = points[0], high = points[0];
  for (const Point& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return {low, high};
}

void append_mesh(OutputBuffer& out, const WrittenPart& part, const std::string& prim) {
  out.text(kMeshLine).text(prim).text("\" (\n");
  out.text("        prepend apiSchemas = [\"PhysicsCollisionAPI\", \"PhysicsMeshCollisionAPI\"]\n");
  if (prim != part.name) out.text("        displayName = ").text(quoted(part.name)).text("\n");
  out.text("    )\n    {\n");
  const Mesh& mesh = part.part->mesh;
  const auto append_corner = [&](const Point& p) { append_point(out, p); };
  const auto append_number = [&](std::integral auto n) { out.number(n); };
  out.text("        float3[] extent = [");
  append_list(out, extent_of(mesh.points.doubles()), append_corner);
  std::vector<std::size_t> counts;
  std::vector<std::uint32_t> corners;
  for (const auto& polygon : mesh.polygons) {
    counts.push_back(polygon.size());
    corners.insert(corners.end(), polygon.begin(), polygon.end());
  }
  out.text(kCountsLine);
  append_list(out, counts, append_number);
  out.text(kIndicesLine);
  append_list(out, corners, append_number);
  out.text(kPointsLine);
  append_list(out, mesh.points.doubles(), append_corner);
  out.text("        uniform token physics:approximation = \"convexHull\"\n");
  out.text("        uniform token subdivisionScheme = \"none\"\n    }\n");
}

// In MJCF and URDF the same numbers mean metres, with z upward; without these two lines USD would
// mean centimetres and y upward.
std::string write_usd(const ModelBody& body, std::span<const WrittenPart> parts) {
  const std::string& model = body.name;
  require_model_text(model);
  for (const WrittenPart& part : parts) require_model_text(part.name);
  const std::string root = identifier_of(model);
  OutputBuffer out;
  out.text("#usda 1.0\n(\n    defaultPrim = \"").text(root).text("\"\n");
  out.text(kUnitLine).number(body.scale).text("\n").text(kUpLine);
  out.text(body.up == UpAxis::Y ? "\"Y\"" : "\"Z\"")
      .text("\n)\n\ndef Xform \"")
      .text(root)
      .text("\"");
  if (root != model || body.mass) out.text(" (\n");
  if (body.mass) out.text(kMassSchema).text("\n");
  if (root != model) out.text("    displayName = ").text(quoted(model)).text("\n");
  out.text(root != model || body.mass ? ")\n{\n" : "\n{\n");
  if (const auto& mass = body.mass) {
    append_point(out.text(kCenterLine), Point(mass->center / body.scale));
    out.text("\n").text(kMassLine).number(mass->mass).text("\n\n");
  }
  const std::vector<std::string> prims = prim_names(parts);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (k > 0) out.text("\n");
    append_mesh(out, parts[k], prims[k]);
  }
  out.text("}\n");
  return out.finish();
}

std::optional<double> finite_number(std::string_view text) {
  try {
    return nearest_double(text);
  } catch (const Error&) {
    return {};
  }
}

// "(x, y, z), (x, y, z)]": each number as USD reads it, to the nearest double and from there to the
// nearest float. Nothing if the text is of another form, or a number beyond the largest float.
std::optional<PointSet> points_of_line(std::string_view text) {
  std::vector<Point> points;
  const auto skip = [&](std::string_view expected) {
    if (!text.starts_with(expected)) return false;
    text.remove_prefix(expected.size());
    return true;
  };
  do {
    Point point;
    for (int axis = 0; axis < 3; ++axis) {
      if (!skip(axis == 0 ? "(" : ", ")) return {};
      const std::string_view word = text.substr(0, text.find_first_of(",)"));
      const std::optional<double> number = finite_number(word);
      if (!number || std::abs(*number) > std::numeric_limits<float>::max()) return {};
      text.remove_prefix(word.size());
      point[axis] = static_cast<float>(*number);
    }
    if (!skip(")")) return {};
    points.push_back(point);
  } while (skip(", "));
  if (text != "]") return {};
  return PointSet(std::move(points));
}

}  // namespace

std::vector<std::string> prim_names(std::span<const WrittenPart> parts) {
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (const WrittenPart& part : parts) {
    const std::string identifier = identifier_of(part.name);
    std::string name = identifier;
    for (int turn = 2; !taken.insert(name).second; ++turn) {
      name = fmt::format("{}_{}", identifier, turn);
    }
    names.push_back(name);
  }
  return names;
}

std::string proven_parts_usd(const ModelBody& body, std::span<const WrittenPart> parts,
                             const std::string& path) {
  std::string bytes = write_usd(body, parts);
  std::size_t meshes = 0, proven = 0;
  for (std::string_view rest = bytes; !rest.empty();) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    if (line.starts_with(kMeshLine)) ++meshes;
    if (!line.starts_with(kPointsLine)) continue;
    const auto points = points_of_line(line.substr(kPointsLine.size()));
    if (!points) reject_bytes(path, "has points that USD does not read");
    if (proven == parts.size() || proven + 1 != meshes) {
      reject_bytes(path, "has points that belong to no part");
    }
    require_held(path, parts[proven++], convex_part(*points).halfspaces);
  }
  if (proven != parts.size()) {
    reject_bytes(path, fmt::format("has points for {} parts instead of {}", proven, parts.size()));
  }
  return bytes;
}

namespace {

// "1, 2, 3]".
std::vector<std::uint32_t> numbers_of_line(std::string_view text) {
  std::vector<std::uint32_t> numbers;
  while (!text.empty() && text != "]") {
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc()) return {};
    numbers.push_back(number);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (text.starts_with(", ")) text.remove_prefix(2);
  }
  return numbers;
}

// What quoted() made this of, up to the closing quote.
std::string unquoted(std::string_view text) {
  std::string plain;
  for (std::size_t k = 0; k < text.size() && text[k] != '"'; ++k) {
    if (text[k] == '\\' && k + 1 < text.size()) ++k;
    plain += text[k];
  }
  return plain;
}

}  // namespace

namespace {

// What write_usd() would write of the same body without its mass.
std::string without_mass(std::string bytes) {
  const auto cut = [&](std::string_view start, std::string_view end, std::string_view instead) {
    const std::size_t first = bytes.find(start);
    if (first == bytes.npos) return;
    const std::size_t last = bytes.find(end, first + start.size());
    if (last != bytes.npos) bytes.replace(first, last + end.size() - first, instead);
  };
  cut(kMassLine, "\n\n", "");
  cut(kCenterLine, "\n", "");
  cut(kMassSchema, "\n", "");
  cut("\" (\n)", "\n{", "\"\n{");
  return bytes;
}

}  // namespace

std::optional<std::vector<NamedPart>> parts_of_usd(const std::string& bytes) {
  ModelBody body;
  std::vector<std::string> names;
  std::vector<Part> parts;
  std::vector<std::uint32_t> counts, corners;
  for (std::string_view rest = bytes; !rest.empty();) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    const auto after = [&](std::string_view start) -> std::optional<std::string_view> {
      return line.starts_with(start) ? std::optional(line.substr(start.size())) : std::nullopt;
    };
    if (const auto root = after("def Xform \"")) body.name = unquoted(*root);
    if (const auto display = after("    displayName = \"")) body.name = unquoted(*display);
    if (const auto up = after(kUpLine)) body.up = *up == "\"Y\"" ? UpAxis::Y : UpAxis::Z;
    if (const auto unit = after(kUnitLine)) {
      body.scale = finite_number(*unit).value_or(body.scale);
    }
    if (const auto prim = after(kMeshLine)) names.push_back(unquoted(*prim));
    if (const auto display = after("        displayName = \""); display && !names.empty()) {
      names.back() = unquoted(*display);
    }
    if (const auto list = after(kCountsLine)) counts = numbers_of_line(*list);
    if (const auto list = after(kIndicesLine)) corners = numbers_of_line(*list);
    if (const auto list = after(kPointsLine)) {
      auto points = points_of_line(*list);
      if (!points) return std::nullopt;
      Part& part = parts.emplace_back();
      part.mesh.points = std::move(*points);
      std::size_t first = 0;
      for (const std::uint32_t count : counts) {
        if (first + count > corners.size()) return std::nullopt;
        part.mesh.polygons.emplace_back(
            corners.begin() + static_cast<std::ptrdiff_t>(first),
            corners.begin() + static_cast<std::ptrdiff_t>(first + count));
        first += count;
      }
    }
  }
  if (parts.empty() || parts.size() != names.size()) return std::nullopt;
  std::vector<WrittenPart> written;
  for (std::size_t k = 0; k < parts.size(); ++k) written.push_back({names[k], &parts[k], nullptr});
  // Whatever else a scene says, such as a transform, makes it another text.
  if (write_usd(body, written) != without_mass(bytes)) return std::nullopt;
  std::vector<NamedPart> read;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    read.push_back({names[k], std::move(parts[k].mesh)});
  }
  return read;
}

}  // namespace convexact
