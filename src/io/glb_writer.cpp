// SPDX-License-Identifier: MIT
#include "io/glb_writer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "convexact/error.hpp"
#include "io/json_document.hpp"
#include "io/output_buffer.hpp"

namespace convexact {
namespace {

// Colours that neighbours in a list do not share: hues a golden section of the circle apart.
std::array<double, 4> color_of(std::size_t part) {
  const double hue = 6 * std::fmod(0.55 + 0.6180339887 * double(part), 1.0);
  std::array<double, 4> color{0, 0, 0, 1};
  for (int k = 0; k < 3; ++k) {
    const double distance = std::abs(std::fmod(hue - 2 * k + 9, 6.0) - 3);  // of this channel's hue
    color[std::size_t(k)] =
        std::round(100 * (0.35 + 0.5 * std::clamp(2 - distance, 0.0, 1.0))) / 100;
  }
  return color;
}

// The lists of a document that grow with the parts, and the bytes that they describe.
struct Glb {
  Json nodes = Json::array(), meshes = Json::array(), materials = Json::array(),
       accessors = Json::array(), views = Json::array();
  OutputBuffer binary;
  std::size_t size = 0;  // of `binary`

  // The number of the view of the next bytes. (Targets of glTF 2.0, sec. 5.11.5: 34962 for
  // attributes of vertices, 34963 for indices.)
  std::size_t add_view(std::size_t bytes, int target) {
    views.push_back(
        {{"buffer", 0}, {"byteOffset", size}, {"byteLength", bytes}, {"target", target}});
    size += bytes;
    return views.size() - 1;
  }
};

std::size_t add_positions(const std::vector<Point>& points, Glb& glb) {
  constexpr int kFloat = 5126;
  Point low = points[0], high = points[0];
  for (const Point& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
    for (const double x : p) glb.binary.little_endian(static_cast<float>(x));
  }
  glb.accessors.push_back({{"bufferView", glb.add_view(12 * points.size(), 34962)},
                           {"componentType", kFloat},
                           {"count", points.size()},
                           {"type", "VEC3"},
                           {"min", Json::array({low[0], low[1], low[2]})},
                           {"max", Json::array({high[0], high[1], high[2]})}});
  return glb.accessors.size() - 1;
}

std::size_t add_indices(const std::vector<std::uint32_t>& corners, Glb& glb) {
  constexpr int kUnsignedInt = 5125;
  for (const std::uint32_t corner : corners) glb.binary.little_endian(corner);
  glb.accessors.push_back({{"bufferView", glb.add_view(4 * corners.size(), 34963)},
                           {"componentType", kUnsignedInt},
                           {"count", corners.size()},
                           {"type", "SCALAR"}});
  return glb.accessors.size() - 1;
}

void add_part(const Mesh& mesh, const MeshPart& part, Glb& glb) {
  constexpr std::uint32_t kNew = ~std::uint32_t{0};
  std::vector<std::uint32_t> numbers(mesh.points.size(), kNew), corners;
  std::vector<Point> points;
  const auto number_of = [&](std::uint32_t point) {
    if (numbers[point] == kNew) {
      numbers[point] = static_cast<std::uint32_t>(points.size());
      points.push_back(mesh.points.doubles()[point]);
    }
    return numbers[point];
  };
  for (std::size_t f = part.first_polygon; f < part.last_polygon; ++f) {
    const auto& polygon = mesh.polygons[f];
    for (std::size_t k = 2; k < polygon.size(); ++k) {
      for (const std::size_t c : {std::size_t{0}, k - 1, k}) {
        corners.push_back(number_of(polygon[c]));
      }
    }
  }
  const std::size_t number = glb.nodes.size();
  const std::string name = part.name.empty() ? "convexact" : part.name;
  const std::size_t positions = add_positions(points, glb), indices = add_indices(corners, glb);
  glb.nodes.push_back({{"name", name}, {"mesh", number}});
  glb.meshes.push_back({{"name", name},
                        {"primitives", Json::array({{{"attributes", {{"POSITION", positions}}},
                                                     {"indices", indices},
                                                     {"material", number}}})}});
  glb.materials.push_back(
      {{"name", name},
       {"pbrMetallicRoughness",
        {{"baseColorFactor", color_of(number)}, {"metallicFactor", 0}, {"roughnessFactor", 0.8}}}});
}

Json document_of(Glb& glb) {
  Json roots = Json::array();
  for (std::size_t k = 0; k < glb.nodes.size(); ++k) roots.push_back(k);
  Json document = {{"asset", {{"version", "2.0"}, {"generator", "convexact"}}},
                   {"scene", 0},
                   {"scenes", Json::array({{{"nodes", roots}}})},
                   {"nodes", glb.nodes},
                   {"meshes", glb.meshes},
                   {"materials", glb.materials},
                   {"accessors", glb.accessors},
                   {"bufferViews", glb.views},
                   {"buffers", Json::array({{{"byteLength", glb.size}}})}};
  return document;
}

}  // namespace

std::string write_glb(const Mesh& mesh, const std::vector<MeshPart>& parts) {
  Glb glb;
  for (const MeshPart& part : parts) {
    if (part.first_polygon < part.last_polygon) add_part(mesh, part, glb);
  }
  if (glb.nodes.empty()) {
    throw Error(ErrorCode::Unrepresentable, "a GLB holds triangles, and there are none");
  }
  std::string text = write_json(document_of(glb));
  text.append((4 - text.size() % 4) % 4, ' ');  // chunks are multiples of four bytes
  const std::size_t size = 12 + 8 + text.size() + 8 + glb.size;
  if (size > std::numeric_limits<std::uint32_t>::max()) {
    throw Error(ErrorCode::Unrepresentable, "a GLB is shorter than 4 GiB");
  }
  const auto length = [](std::size_t bytes) { return static_cast<std::uint32_t>(bytes); };
  OutputBuffer out;
  out.text("glTF").little_endian(std::uint32_t{2}).little_endian(length(size));
  out.little_endian(length(text.size())).text("JSON").text(text);
  out.little_endian(length(glb.size)).text(std::string_view("BIN\0", 4));
  return out.text(glb.binary.finish()).finish();
}

}  // namespace convexact
