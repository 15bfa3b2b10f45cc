// SPDX-License-Identifier: MIT
#include "wire/part_models.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <pugixml.hpp>

#include "convexact/error.hpp"
#include "io/json.hpp"
#include "number/text.hpp"

namespace convexact {

void require_model_text(const std::string& text) {
  const bool has_control = std::any_of(text.begin(), text.end(), [](char c) {
    return static_cast<unsigned char>(c) < ' ' || c == '\x7f';
  });
  // XML does not allow U+FFFE and U+FFFF, escaped or not.
  const bool has_noncharacter =
      text.find("\xEF\xBF\xBE") != text.npos || text.find("\xEF\xBF\xBF") != text.npos;
  if (!has_control && !has_noncharacter && as_utf8(text) == text) return;
  throw Error(ErrorCode::Unrepresentable,
              "a model for a simulator holds names and paths in UTF-8 without control characters, "
              "and " +
                  in_quotes(text) + " is none");
}

namespace {

constexpr const char* kXmlHead = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

// Roll, pitch, yaw: from y upward to z upward.
constexpr const char* kTurnUp = "1.5707963267948966 0 0";

// The value of an attribute, with its quotes.
std::string xml_value(const std::string& text) {
  require_model_text(text);
  return "\"" + escaped_markup(text) + "\"";
}

// Shortest decimals, with blanks between.
std::string words(const auto& numbers) {
  return fmt::format("{}", fmt::join(std::begin(numbers), std::end(numbers), " "));
}

std::string scale_attribute(const ModelBody& body) {
  return body.scale == 1 ? "" : fmt::format(" scale=\"{0} {0} {0}\"", body.scale);
}

}  // namespace

std::string write_mjcf(const ModelBody& body, std::span<const PartFile> parts) {
  std::string text = kXmlHead;
  text += "<mujoco model=" + xml_value(body.name) + ">\n  <asset>\n";
  const std::string size = scale_attribute(body);
  for (const PartFile& part : parts) {
    text += fmt::format("    <mesh name={} file={}{}/>\n", xml_value(part.name),
                        xml_value(part.path), size);
  }
  text += "  </asset>\n  <worldbody>\n    <body";
  if (body.up == UpAxis::Y) text += " quat=\"0.7071067811865476 0.7071067811865476 0 0\"";
  text += ">\n";
  if (const auto& mass = body.mass) {
    text += fmt::format("      <inertial pos=\"{}\" mass=\"{}\" fullinertia=\"{}\"/>\n",
                        words(mass->center), mass->mass, words(mass->inertia));
  }
  for (const PartFile& part : parts) {
    text += fmt::format("      <geom name={0} type=\"mesh\" mesh={0}/>\n", xml_value(part.name));
  }
  return text + "    </body>\n  </worldbody>\n</mujoco>\n";
}

namespace {

// How a mesh stands and how large it is, as a shape of a link.
std::string urdf_mesh(const ModelBody& body, const std::string& path) {
  const std::string turn = body.up == UpAxis::Y
                               ? fmt::format("      <origin xyz=\"0 0 0\" rpy=\"{}\"/>\n", kTurnUp)
                               : "";
  return turn + fmt::format("      <geometry>\n        <mesh filename={}{}/>\n      </geometry>\n",
                            xml_value(path), scale_attribute(body));
}

std::string urdf_inertial(const ModelBody& body) {
  if (!body.mass) return "";
  const bool is_turned = body.up == UpAxis::Y;
  const Point& c = body.mass->center;
  const Point center = is_turned ? Point(c.x(), -c.z(), c.y()) : c;
  const auto& [xx, yy, zz, xy, xz, yz] = body.mass->inertia;
  return fmt::format(
      "    <inertial>\n      <origin xyz=\"{}\" rpy=\"{}\"/>\n      <mass value=\"{}\"/>\n"
      "      <inertia ixx=\"{}\" iyy=\"{}\" izz=\"{}\" ixy=\"{}\" ixz=\"{}\" iyz=\"{}\"/>\n"
      "    </inertial>\n",
      words(center), is_turned ? kTurnUp : "0 0 0", body.mass->mass, xx, yy, zz, xy, xz, yz);
}

}  // namespace

std::string write_urdf(const ModelBody& body, std::span<const PartFile> parts) {
  std::string text = kXmlHead;
  text += fmt::format("<robot name={0}>\n  <link name={0}>\n", xml_value(body.name));
  text += urdf_inertial(body);
  if (!body.visual.empty()) {
    text += "    <visual>\n" + urdf_mesh(body, body.visual) + "    </visual>\n";
  }
  for (const PartFile& part : parts) {
    text += fmt::format("    <collision name={}>\n", xml_value(part.name)) +
            urdf_mesh(body, part.path) + "    </collision>\n";
  }
  return text + "  </link>\n</robot>\n";
}

namespace {

using pugi::xml_node;

bool has_attribute(const xml_node& element, std::initializer_list<const char*> names) {
  return std::any_of(names.begin(), names.end(),
                     [&](const char* name) { return !element.attribute(name).empty(); });
}

std::optional<std::vector<PartFile>> part_files_of_urdf(const xml_node& robot) {
  const xml_node link = robot.child("link");
  if (!link || link.next_sibling("link")) return {};
  std::vector<PartFile> parts;
  for (const xml_node& collision : link.children("collision")) {
    const xml_node mesh = collision.child("geometry").child("mesh");
    if (!mesh || collision.child("origin") || has_attribute(mesh, {"scale"})) return {};
    parts.push_back({collision.attribute("name").value(), mesh.attribute("filename").value()});
  }
  return parts;
}

// Elements that no model of ours has, such as compiler or default, could move or rename meshes.
std::optional<std::vector<PartFile>> part_files_of_mjcf(const xml_node& model) {
  std::map<std::string, std::string> path_of;
  for (const xml_node& child : model.children()) {
    const std::string_view name = child.name();
    if (name != "asset" && name != "worldbody") return {};
  }
  for (const xml_node& mesh : model.child("asset").children()) {
    if (has_attribute(mesh, {"scale", "refpos", "refquat"})) return {};
    path_of[mesh.attribute("name").value()] = mesh.attribute("file").value();
  }
  const xml_node body = model.child("worldbody").first_child();
  if (!body || body.next_sibling() || has_attribute(body, {"pos", "quat", "euler"})) return {};
  std::vector<PartFile> parts;
  for (const xml_node& geom : body.children()) {
    if (std::string_view(geom.name()) == "inertial") continue;
    const auto path = path_of.find(geom.attribute("mesh").value());
    const bool is_mesh = std::string_view(geom.attribute("type").value()) == "mesh";
    if (!is_mesh || path == path_of.end() || has_attribute(geom, {"pos", "quat", "euler"})) {
      return {};
    }
    parts.push_back({geom.attribute("name").value(), path->second});
  }
  return parts;
}

}  // namespace

std::optional<std::vector<PartFile>> part_files_of_model(std::string_view bytes) {
  pugi::xml_document document;
  if (!document.load_buffer(bytes.data(), bytes.size())) return {};
  auto parts = document.child("mujoco") ? part_files_of_mjcf(document.child("mujoco"))
                                        : part_files_of_urdf(document.child("robot"));
  const bool is_one = parts && !parts->empty();
  return is_one ? std::move(parts) : std::nullopt;
}

bool is_part_model(const std::string& path) {
  return path.ends_with(".mjcf.xml") || path.ends_with(".urdf") || path.ends_with(".usda");
}

}  // namespace convexact
