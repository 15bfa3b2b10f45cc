// SPDX-License-Identifier: MIT
#include "wire/robot_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <pugixml.hpp>

#include "convexact/error.hpp"
#include "io/file_beside.hpp"
#include "number/text.hpp"

namespace convexact {
namespace {

namespace fs = std::filesystem;
using pugi::xml_node;

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

std::size_t line_at(std::string_view bytes, std::size_t offset) {
  return 1 + static_cast<std::size_t>(
                 std::count(bytes.begin(), bytes.begin() + std::ptrdiff_t(offset), '\n'));
}

// Behind a piece of markup that begins at `at` and parses: a tag, a comment, CDATA, an instruction.
std::size_t end_of_markup(std::string_view bytes, std::size_t at) {
  const auto behind = [&](std::string_view end) { return bytes.find(end, at) + end.size(); };
  const std::string_view rest = bytes.substr(at);
  if (rest.starts_with("<!--")) return behind("-->");
  if (rest.starts_with("<![CDATA[")) return behind("]]>");
  if (rest.starts_with("<?")) return behind("?>");
  char quote = 0;
  while (quote != 0 || bytes[at] != '>') {
    const char c = bytes[at++];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    }
  }
  return at + 1;
}

// Behind the element that begins at `at`.
std::size_t end_of_element(std::string_view bytes, std::size_t at) {
  std::size_t depth = 0;
  while (true) {
    const std::size_t end = end_of_markup(bytes, at);
    const bool is_tag = bytes[at + 1] != '!' && bytes[at + 1] != '?';
    const bool closes = bytes[at + 1] == '/', is_empty = bytes[end - 2] == '/';
    if (is_tag && closes) --depth;
    if (is_tag && !closes && !is_empty) ++depth;
    if (depth == 0) return end;
    at = bytes.find('<', end);
  }
}

// The value of an attribute, between its quotes; nothing if the tag at `at` lacks it.
std::optional<std::pair<std::size_t, std::size_t>> value_in_tag(std::string_view bytes,
                                                                std::size_t at,
                                                                std::string_view name) {
  const std::size_t end = end_of_markup(bytes, at);
  constexpr std::string_view kBlanks = " \t\r\n";
  for (std::size_t quote = bytes.find_first_of("\"'", at); quote < end;) {
    const std::size_t close = bytes.find(bytes[quote], quote + 1);
    std::size_t last = bytes.find_last_not_of(kBlanks, quote - 1);  // at =
    last = bytes.find_last_not_of(kBlanks, last - 1) + 1;           // behind the name
    const std::size_t first = bytes.find_last_of(kBlanks, last - 1) + 1;
    if (bytes.substr(first, last - first) == name) return std::pair{quote + 1, close};
    quote = bytes.find_first_of("\"'", close + 1);
  }
  return {};
}

// Text with some of its pieces replaced; the later ones first, so that places stay right.
struct Replacement {
  std::size_t first, last;
  std::string text;
};

std::string replaced(std::string text, std::vector<Replacement> replacements) {
  std::sort(replacements.begin(), replacements.end(),
            [](const Replacement& a, const Replacement& b) { return a.first > b.first; });
  for (const auto& [first, last, by] : replacements) text.replace(first, last - first, by);
  return text;
}

// "1 2 3" times a unit.
std::string scaled(const std::string& scale, double unit) {
  double x = 1, y = 1, z = 1;
  if (std::sscanf(scale.c_str(), "%lf %lf %lf", &x, &y, &z) != 3) x = y = z = 1;
  return fmt::format("{} {} {}", x * unit, y * unit, z * unit);
}

// The text of a collision for one part.
std::string of_part(const std::string& bytes, const RobotCollision& collision, const PartFile& part,
                    double unit) {
  std::vector<Replacement> changes;
  const auto replace = [&](std::size_t tag, std::string_view attribute, const auto& by) {
    const auto value = value_in_tag(bytes, tag, attribute);
    if (!value) return false;
    const auto [first, last] = *value;
    changes.push_back(
        {first - collision.first, last - collision.first, by(bytes.substr(first, last - first))});
    return true;
  };
  const bool is_named = replace(collision.mesh_tag, "filename",
                                [&](const std::string&) { return escaped_markup(part.path); });
  if (!is_named) throw Error(ErrorCode::Internal, "a mesh of a collision has no file name");
  replace(collision.first, "name",
          [&](const std::string& name) { return name + "_" + escaped_markup(part.name); });
  if (unit != 1 && !replace(collision.mesh_tag, "scale",
                            [&](const std::string& scale) { return scaled(scale, unit); })) {
    const std::size_t behind_name = collision.mesh_tag + 5 - collision.first;  // <mesh
    changes.push_back({behind_name, behind_name, " scale=\"" + scaled("", unit) + "\""});
  }
  return replaced(bytes.substr(collision.first, collision.last - collision.first),
                  std::move(changes));
}

[[noreturn]] void refuse_robot(const std::string& why, std::optional<std::size_t> line = {}) {
  throw Error(ErrorCode::Unreadable, why, line);
}

// Outside of comments, everything that xacro would still expand.
bool has_xacro(const xml_node& node) {
  struct Walker : pugi::xml_tree_walker {
    bool found = false;
    bool for_each(xml_node& element) override {
      found = found || std::string_view(element.name()).starts_with("xacro:");
      return !found;
    }
  } walker;
  xml_node start = node;
  start.traverse(walker);
  return walker.found;
}

}  // namespace

RobotModel::RobotModel(std::string bytes) : bytes_(std::move(bytes)) {
  const std::size_t skipped = bytes_.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
  pugi::xml_document document;
  const auto parsed =
      document.load_buffer(bytes_.data() + skipped, bytes_.size() - skipped,
                           pugi::parse_default | pugi::parse_doctype, pugi::encoding_utf8);
  if (!parsed) {
    throw Error(ErrorCode::Malformed, "expected XML, " + std::string(parsed.description()),
                line_at(bytes_, skipped + static_cast<std::size_t>(parsed.offset)));
  }
  for (const xml_node& child : document.children()) {
    if (child.type() == pugi::node_doctype)
      refuse_robot("document types, and entities, are not read");
  }
  const xml_node robot = document.child("robot");
  if (!robot) refuse_robot("this is no robot model: expected an element robot");
  if (has_xacro(robot))
    refuse_robot("this is a xacro: run xacro first, and name the URDF that it makes");
  name_ = robot.attribute("name").value();
  const auto place = [&](const xml_node& node) {
    return skipped + static_cast<std::size_t>(node.offset_debug()) - 1;  // at <
  };
  for (const xml_node& link : robot.children("link")) {
    ++links_;
    for (const xml_node& collision : link.children("collision")) {
      const xml_node mesh = collision.child("geometry").child("mesh");
      if (!mesh) continue;
      const std::size_t first = place(collision);
      collisions_.push_back({link.attribute("name").value(), mesh.attribute("filename").value(),
                             line_at(bytes_, first), first, end_of_element(bytes_, first),
                             place(mesh)});
    }
  }
}

std::string RobotModel::with_parts(std::span<const RobotParts> parts) const {
  std::vector<Replacement> changes;
  for (std::size_t k = 0; k < collisions_.size(); ++k) {
    if (parts[k].parts.empty()) continue;
    const RobotCollision& collision = collisions_[k];
    // Each on lines of its own, if the first is.
    const std::size_t before = bytes_.find_last_not_of(" \t", collision.first - 1) + 1;
    const bool begins_line = before > 0 && bytes_[before - 1] == '\n';
    const std::string between =
        begins_line ? "\n" + bytes_.substr(before, collision.first - before) : "";
    std::string text;
    for (const PartFile& part : parts[k].parts) {
      require_model_text(part.path);
      text += (text.empty() ? "" : between) + of_part(bytes_, collision, part, parts[k].unit);
    }
    changes.push_back({collision.first, collision.last, std::move(text)});
  }
  return replaced(bytes_, std::move(changes));
}

namespace {

// The folder of that name above a file.
std::string folder_above(const std::string& file, std::string_view name) {
  fs::path folder = fs::weakly_canonical(fs::absolute(file)).parent_path();
  while (folder.has_relative_path() && folder.filename() != name) folder = folder.parent_path();
  return folder.has_relative_path() ? folder.string() : "";
}

}  // namespace

std::string robot_mesh_path(const std::string& urdf, std::string_view spelled,
                            std::span<const RobotPackage> packages) {
  constexpr std::string_view kScheme = "package://";
  const std::string own = folder_of_file(urdf);
  const auto refuse_name = [&](const std::string& why) {
    refuse_robot("it names the file " + in_quotes(spelled) + why);
  };
  if (own.empty()) refuse_name(", but was itself read without a folder: give its path");
  if (spelled.starts_with(kScheme)) {
    std::string_view rest = spelled.substr(kScheme.size());
    while (rest.starts_with('/')) rest.remove_prefix(1);  // package:///NAME, as some write
    const std::string name(rest.substr(0, rest.find('/')));
    const auto known = std::find_if(packages.begin(), packages.end(),
                                    [&](const RobotPackage& p) { return p.name == name; });
    const std::string folder = known != packages.end() ? known->folder : folder_above(urdf, name);
    if (folder.empty() || rest.size() == name.size()) {
      refuse_name(": --package " + name + "=DIR says where that package lies");
    }
    return file_inside(folder, rest.substr(name.size() + 1), {});
  }
  std::vector<std::string> others;
  for (const RobotPackage& package : packages) others.push_back(package.folder);
  return file_inside(own, spelled, others);
}

}  // namespace convexact
