// SPDX-License-Identifier: MIT
#include "wire/json_mesh.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "convexact/error.hpp"
#include "io/json_text.hpp"
#include "number/text.hpp"
#include "wire/field.hpp"

namespace convexact {

using nlohmann::json;

Rational coordinate_of_json(const json& value, Decimal decimal) {
  const std::string_view text = spelling_of(value);
  if (text.empty()) {
    throw Error(ErrorCode::Malformed, "expected a number, or a string that holds one");
  }
  const bool is_hex = is_hex_float(text);
  const bool is_fraction = text.find('/') != std::string_view::npos;
  if (!is_hex && !is_fraction && decimal != Decimal::Exact) {
    return to_rational(decimal == Decimal::Nearest ? nearest_double(text) : nearest_float(text));
  }
  Rational spelled = is_hex ? parse_hex_float(text) : parse_number(text, Decimal::Exact);
  if (decimal != Decimal::Nearest32) return spelled;
  const float rounded = to_float(spelled, Rounding::Nearest);
  if (!std::isfinite(rounded)) {
    throw Error(ErrorCode::NotFinite,
                "expected a number within binary32, found " + in_quotes(text));
  }
  return to_rational(rounded);
}

Mesh mesh_of_json(const json& object, Decimal decimal) {
  Mesh mesh;
  mesh.points = points_of_json(object["vertices"], "vertex",
                               [&](const json& x) { return coordinate_of_json(x, decimal); });
  if (object.contains("faces")) {
    mesh.polygons = polygons_of_json(object["faces"], mesh.points.size());
  }
  return mesh;
}

namespace {

[[noreturn]] void reject_entry(const std::string& expected) {
  throw Error(ErrorCode::Malformed, "expected " + expected);
}

std::optional<std::size_t> index_of(const json& node, const char* key, std::size_t number) {
  if (!node.contains(key) || node[key].is_null()) return {};
  if (!node[key].is_number_unsigned()) {
    reject_entry(fmt::format("the {} of node {} as an index or null", key, number));
  }
  return narrowed<std::size_t>(node[key].get<std::uint64_t>());
}

std::vector<std::size_t> indices_of(const json& list, std::size_t number) {
  std::vector<std::size_t> indices;
  for (const json& entry : list) {
    if (!entry.is_number_unsigned()) {
      reject_entry(fmt::format("the children of node {} as indices", number));
    }
    indices.push_back(narrowed<std::size_t>(entry.get<std::uint64_t>()));
  }
  return indices;
}

HullTreeNode node_of_json(const json& entry, std::size_t number, Decimal decimal) {
  if (!entry.is_object()) reject_entry(fmt::format("node {} as an object", number));
  if (index_of(entry, "node", number).value_or(number) != number) {
    reject_entry(
        fmt::format("node {} in its place, found node {}", number, dump_json(entry["node"])));
  }
  HullTreeNode node{.parent = index_of(entry, "parent", number),
                    .children = {},
                    .part = index_of(entry, "part", number),
                    .mesh = {}};
  if (entry.contains("children") && !entry["children"].is_null()) {
    if (!entry["children"].is_array()) {
      reject_entry(fmt::format("the children of node {} as a list", number));
    }
    node.children = indices_of(entry["children"], number);
  }
  const bool has_points = entry.contains("vertices");
  if (node.part.has_value() == has_points || (has_points && entry["vertices"].empty())) {
    reject_entry(fmt::format("node {} with a part or with vertices of its own", number));
  }
  if (has_points) node.mesh = mesh_of_json(entry, decimal);
  return node;
}

}  // namespace

NamedPart part_of_json(const json& part, std::size_t number, Decimal decimal) {
  if (!part.is_object() || !part.contains("vertices")) {
    reject_entry(fmt::format("part {} as an object with 'vertices'", number));
  }
  std::string name = fmt::format("part_{:03}", number);
  if (part.contains("name")) {
    if (!part["name"].is_string())
      reject_entry(fmt::format("the name of part {} as a text", number));
    name = part["name"].get<std::string>();
  }
  if (part["vertices"].is_array() && part["vertices"].empty()) {
    reject_entry(fmt::format("points in part {}, which has none", number));
  }
  try {
    return {std::move(name), mesh_of_json(part, decimal)};
  } catch (const Error& error) {
    throw Error(error.code(), fmt::format("part {}: {}", number, error.what()));
  }
}

std::vector<HullTreeNode> nodes_of_json(const json& nodes, Decimal decimal) {
  if (!nodes.is_array()) reject_entry("the nodes of the tree as a list");
  std::vector<HullTreeNode> list;
  for (const json& node : nodes) {
    try {
      list.push_back(node_of_json(node, list.size(), decimal));
    } catch (const Error& error) {
      throw Error(error.code(), fmt::format("node {}: {}", list.size(), error.what()));
    }
  }
  return list;
}

}  // namespace convexact
