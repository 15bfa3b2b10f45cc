// SPDX-License-Identifier: MIT
#include "wire/keep_selectors.hpp"

#include <array>
#include <limits>
#include <optional>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "number/text.hpp"
#include "wire/field.hpp"

namespace convexact {
namespace {

constexpr std::array<std::string_view, 4> kSelectorKinds = {"id:", "plane:", "normal:", "group:"};

// `named` is the option and its text.
[[noreturn]] void refuse(const std::string& named, const std::string& why) {
  throw Error(ErrorCode::InvalidArgument, named + ": " + why);
}

// KIND:WHAT.
struct KeepText {
  std::string_view kind;
  std::string what;
};

std::optional<KeepText> parse(std::string_view selector) {
  for (const std::string_view kind : kSelectorKinds) {
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

std::string names_of(std::span<const SceneObject> scene) {
  constexpr std::size_t kMost = 8;
  std::string names;
  for (std::size_t k = 0; k < scene.size() && k < kMost; ++k) {
    names += (k == 0 ? "" : ", ") + in_quotes(scene[k].part);
  }
  return names + (scene.size() > kMost ? " and more" : "");
}

// `count` numbers with commas between them.
std::vector<Rational> numbers(const std::string& named, const std::string& list,
                              std::size_t count) {
  const std::vector<std::string> words = words_of(list);
  const std::string expected =
      "expected " + std::to_string(count) + " numbers, found '" + list + "'";
  if (words.size() != count) refuse(named, expected);
  std::vector<Rational> values;
  try {
    for (const std::string& word : words) values.push_back(parse_rational(word));
  } catch (const Error&) {
    refuse(named, expected);
  }
  return values;
}

KeepPlane parse_plane(const std::string& named, const std::string& list) {
  const std::vector<Rational> x = numbers(named, list, 4);
  return {{x[0], x[1], x[2]}, x[3]};
}

KeepNormal parse_normal(const std::string& named, const std::string& what) {
  const std::size_t colon = what.find(':');
  const std::vector<Rational> x = numbers(named, what.substr(0, colon), 3);
  KeepNormal wanted{{x[0], x[1], x[2]}, std::nullopt};
  if (colon != what.npos) wanted.degrees = parse_decimal(named, what.substr(colon + 1));
  return wanted;
}

KeepFaces faces_of_group(const std::string& named, const std::string& name,
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
  if (!is_found) refuse(named, "the file " + object.name + " has no group of that name");
  return wanted;
}

KeepSelector selector_of(const std::string& named, const KeepText& parsed,
                         const SceneObject& object) {
  KeepSelector selector{KeepIds{}, named};
  if (parsed.kind == "id:") {
    selector.facets = KeepIds{parse_ids(named, parsed.what)};
  } else if (parsed.kind == "plane:") {
    selector.facets = parse_plane(named, parsed.what);
  } else if (parsed.kind == "normal:") {
    selector.facets = parse_normal(named, parsed.what);
  } else {
    selector.facets = faces_of_group(named, parsed.what, object);
  }
  return selector;
}

}  // namespace

std::vector<HalfspaceId> parse_ids(const std::string& option, const std::string& text) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
  std::vector<HalfspaceId> ids;
  for (const std::string& word : words_of(text)) {
    ids.emplace_back(parse_count(option, word, {0, kMost}));
  }
  return ids;
}

std::vector<std::vector<KeepSelector>> keep_selectors(const std::string& option,
                                                      const std::vector<std::string>& texts,
                                                      std::span<const SceneObject> scene) {
  std::vector<std::vector<KeepSelector>> selectors(scene.size());
  for (const std::string& text : texts) {
    const std::string named = option + " " + text;
    const std::optional<KeepText> whole = parse(text);
    bool is_used = scene.size() == 1 && whole;
    if (is_used) selectors[0].push_back(selector_of(named, *whole, scene[0]));
    for (std::size_t k = 0; k < scene.size() && !(is_used && scene.size() == 1); ++k) {
      const std::optional<KeepText> parsed = parse_for(scene[k], text);
      if (!parsed) continue;
      selectors[k].push_back(selector_of(named, *parsed, scene[k]));
      is_used = true;
    }
    if (is_used) continue;
    const std::string selector = "id:N,..., plane:NX,NY,NZ,D, normal:X,Y,Z[:DEGREES] or group:NAME";
    if (scene.size() == 1) refuse(named, "expected " + selector);
    refuse(named, "expected PART/SELECTOR, the part one of " + names_of(scene) +
                      ", the selector one of " + selector);
  }
  return selectors;
}

}  // namespace convexact
