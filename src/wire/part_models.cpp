// SPDX-License-Identifier: MIT
#include "wire/part_models.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

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

// The value of an attribute, with its quotes.
std::string xml_value(const std::string& text) {
  require_model_text(text);
  return "\"" + escaped_markup(text) + "\"";
}

}  // namespace

std::string write_mjcf(const std::string& model, std::span<const PartFile> parts) {
  std::string text = kXmlHead;
  text += "<mujoco model=" + xml_value(model) + ">\n  <asset>\n";
  for (const PartFile& part : parts) {
    text +=
        fmt::format("    <mesh name={} file={}/>\n", xml_value(part.name), xml_value(part.path));
  }
  text += "  </asset>\n  <worldbody>\n    <body>\n";
  for (const PartFile& part : parts) {
    text += fmt::format("      <geom name={0} type=\"mesh\" mesh={0}/>\n", xml_value(part.name));
  }
  return text + "    </body>\n  </worldbody>\n</mujoco>\n";
}

std::string write_urdf(const std::string& model, std::span<const PartFile> parts) {
  std::string text = kXmlHead;
  text += fmt::format("<robot name={0}>\n  <link name={0}>\n", xml_value(model));
  for (const PartFile& part : parts) {
    text += fmt::format(
        "    <collision name={}>\n      <geometry>\n        <mesh filename={}/>\n"
        "      </geometry>\n    </collision>\n",
        xml_value(part.name), xml_value(part.path));
  }
  return text + "  </link>\n</robot>\n";
}

namespace {

// The text that escaped_markup() made this of.
std::string unescaped(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, char>, 4> kEscapes = {
      {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}}};
  std::string plain;
  while (!text.empty()) {
    const auto escape = std::find_if(kEscapes.begin(), kEscapes.end(),
                                     [&](const auto& e) { return text.starts_with(e.first); });
    const bool is_escape = escape != kEscapes.end();
    plain += is_escape ? escape->second : text.front();
    text.remove_prefix(is_escape ? escape->first.size() : 1);
  }
  return plain;
}

// The values that stand between `before` and the next quote, one after another.
std::vector<std::string> values_after(std::string_view bytes, std::string_view before) {
  std::vector<std::string> values;
  for (std::size_t at = bytes.find(before); at != bytes.npos; at = bytes.find(before, at)) {
    at += before.size();
    const std::size_t end = std::min(bytes.find('"', at), bytes.size());
    values.push_back(unescaped(bytes.substr(at, end - at)));
  }
  return values;
}

}  // namespace

std::optional<std::vector<PartFile>> part_files_of_model(std::string_view bytes) {
  const bool is_mjcf = bytes.find("<mujoco") != bytes.npos;
  const auto models = values_after(bytes, is_mjcf ? "<mujoco model=\"" : "<robot name=\"");
  const auto names = values_after(bytes, is_mjcf ? "    <mesh name=\"" : "<collision name=\"");
  const auto paths = values_after(bytes, is_mjcf ? " file=\"" : "<mesh filename=\"");
  if (models.size() != 1 || names.size() != paths.size()) return std::nullopt;
  std::vector<PartFile> parts;
  for (std::size_t k = 0; k < names.size(); ++k) parts.push_back({names[k], paths[k]});
  // Whatever else a model says, such as a pose or a scale, makes it another text.
  const std::string again = is_mjcf ? write_mjcf(models[0], parts) : write_urdf(models[0], parts);
  return again == bytes ? std::optional(parts) : std::nullopt;
}

bool is_part_model(const std::string& path) {
  return path.ends_with(".mjcf.xml") || path.ends_with(".urdf") || path.ends_with(".usda");
}

}  // namespace convexact
