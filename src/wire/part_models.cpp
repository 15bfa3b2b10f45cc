// SPDX-License-Identifier: MIT
#include "wire/part_models.hpp"

#include <fmt/format.h>

#include <algorithm>

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

}  // namespace convexact
