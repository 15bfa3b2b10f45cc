// SPDX-License-Identifier: MIT
#include "cli/keep_option.hpp"

#include <array>
#include <optional>

#include "cli/options.hpp"
#include "convexact/error.hpp"
#include "number/text.hpp"

namespace convexact::cli {
namespace {

constexpr std::array<std::string_view, 4> kKinds = {"id:", "plane:", "normal:", "group:"};

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  throw Error(ErrorCode::InvalidArgument, "--keep " + text + ": " + why);
}

// KIND:WHAT.
struct KeepText {
  std::string_view kind;
  std::string what;
};

std::optional<KeepText> parse(std::string_view selector) {
  for (const std::string_view kind : kKinds) {
    if (selector.starts_with(kind))
      return KeepText{kind, std::string(selector.substr(kind.size()))};
  }
  return std::nullopt;
}

// The text after the name of the part and a slash.
std::optional<KeepText> parse_for(const SceneObject& object, std::string_view text) {
  if (!text.starts_with(object.part) || !text.substr(object.part.size()).starts_with('/')) {
    return std::nullopt;
  }
  return parse(text.substr(object.part.size() + 1));
}

std::string names_of(const std::vector<SceneObject>& scene) {
  constexpr std::size_t kMost = 8;
  std::string names;
  for (std::size_t k = 0; k < scene.size() && k < kMost; ++k) {
    names += (k == 0 ? "" : ", ") + in_quotes(scene[k].part);
  }
  return names + (scene.size() > kMost ? " and more" : "");
}

// `count` numbers with commas between them.
std::vector<Rational> numbers(const std::string& text, const std::string& list, std::size_t count) {
  const std::vector<std::string> words = words_of(list);
  const std::string expected =
      "expected " + std::to_string(count) + " numbers, found '" + list + "'";
  if (words.size() != count) refuse(text, expected);
  std::vector<Rational> values;
  try {
    for (const std::string& word : words) values.push_back(parse_rational(word));
  } catch (const Error&) {
    refuse(text, expected);
  }
  return values;
}

KeepPlane parse_plane(const std::string& text, const std::string& list) {
  const std::vector<Rational> x = numbers(text, list, 4);
  return {{x[0], x[1], x[2]}, x[3]};
}

KeepNormal parse_normal(const std::string& text, const std::string& what) {
  const std::size_t colon = what.find(':');
  const std::vector<Rational> x = numbers(text, what.substr(0, colon), 3);
  KeepNormal wanted{{x[0], x[1], x[2]}, std::nullopt};
  if (colon != what.npos) wanted.degrees = parse_decimal("--keep " + text, what.substr(colon + 1));
  return wanted;
}

KeepFaces faces_of_group(const std::string& text, const std::string& name,
                         const SceneObject& object) {
  KeepFaces wanted;
  bool is_found = false;
  for (const MeshPart& group : object.groups) {
    if (group.name != name) continue;
    is_found = true;
    for (std::size_t k = group.first_polygon; k < group.last_polygon; ++k) {
      wanted.polygons.push_back(object.polygons[k]);
    }
  }
  if (!is_found) refuse(text, "the file " + object.name + " has no group of that name");
  return wanted;
}

KeepSelector selector_of(const std::string& text, const KeepText& parsed,
                         const SceneObject& object) {
  KeepSelector selector{KeepIds{}, "--keep " + text};
  if (parsed.kind == "id:") {
    selector.facets = KeepIds{parse_ids("--keep " + text, parsed.what)};
  } else if (parsed.kind == "plane:") {
    selector.facets = parse_plane(text, parsed.what);
  } else if (parsed.kind == "normal:") {
    selector.facets = parse_normal(text, parsed.what);
  } else {
    selector.facets = faces_of_group(text, parsed.what, object);
  }
  return selector;
}

}  // namespace

Option add_keep_option(Command& command, std::vector<std::string>& texts) {
  return command
      .add_option("--keep", texts,
                  "facets that stay, by id:N,..., plane:NX,NY,NZ,D, normal:X,Y,Z[:DEGREES] or "
                  "group:NAME; with several objects PART/id:N; may be repeated")
      ->expected(1)
      ->allow_extra_args(false)  // an INPUT that need not be there may follow
      ->take_all()
      ->type_name("SELECTOR");
}

std::vector<std::vector<KeepSelector>> keep_selectors(const std::vector<std::string>& texts,
                                                      const std::vector<SceneObject>& scene) {
  std::vector<std::vector<KeepSelector>> selectors(scene.size());
  for (const std::string& text : texts) {
    const std::optional<KeepText> whole = parse(text);
    bool is_used = scene.size() == 1 && whole;
    if (is_used) selectors[0].push_back(selector_of(text, *whole, scene[0]));
    for (std::size_t k = 0; k < scene.size() && !(is_used && scene.size() == 1); ++k) {
      const std::optional<KeepText> parsed = parse_for(scene[k], text);
      if (!parsed) continue;
      selectors[k].push_back(selector_of(text, *parsed, scene[k]));
      is_used = true;
    }
    if (is_used) continue;
    const std::string selector = "id:N,..., plane:NX,NY,NZ,D, normal:X,Y,Z[:DEGREES] or group:NAME";
    if (scene.size() == 1) refuse(text, "expected " + selector);
    refuse(text, "expected PART/SELECTOR, the part one of " + names_of(scene) +
                     ", the selector one of " + selector);
  }
  return selectors;
}

}  // namespace convexact::cli
