// SPDX-License-Identifier: MIT
// Shapes as JSON: one key for each node.
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "convexact/error.hpp"
#include "convexact/implicit.hpp"
#include "io/json_text.hpp"
#include "number/text.hpp"

namespace convexact {
namespace {

using nlohmann::json;

// A value of the document and its JSON pointer.
struct JsonPlace {
  const json& value;
  std::string pointer;

  [[noreturn]] void refuse(const std::string& expected) const {
    throw Error(ErrorCode::Malformed,
                (pointer.empty() ? "the document" : pointer) + ": expected " + expected);
  }
  std::string found() const { return ", found " + in_quotes(dump_json(value)); }

  double number() const {
    if (!value.is_number()) refuse("a number" + found());
    return value.get<double>();
  }
  // A number, or a string with an integer or fraction.
  Rational rational() const {
    if (!value.is_string()) return to_rational(number());
    try {
      return parse_rational(value.get_ref<const std::string&>());
    } catch (const Error& error) {
      refuse("a number, or a string with a fraction: " + std::string(error.what()));
    }
  }
  std::vector<JsonPlace> entries() const {
    if (!value.is_array()) refuse("a list" + found());
    std::vector<JsonPlace> list;
    for (const json& entry : value) {
      list.push_back({entry, pointer + "/" + std::to_string(list.size())});
    }
    return list;
  }
  std::vector<JsonPlace> entries(std::size_t count) const {
    std::vector<JsonPlace> list = entries();
    if (list.size() != count) {
      refuse("a list of " + std::to_string(count) + ", found " + std::to_string(list.size()));
    }
    return list;
  }
  Point point() const {
    const auto list = entries(3);
    return {list[0].number(), list[1].number(), list[2].number()};
  }
  // The values of an object that has these keys and no others, in this order.
  std::vector<JsonPlace> values(std::initializer_list<const char*> keys) const {
    std::string names;
    for (const char* key : keys) names += (names.empty() ? "'" : ", '") + std::string(key) + "'";
    if (!value.is_object()) refuse("an object with the keys " + names + found());
    std::vector<JsonPlace> list;
    for (const char* key : keys) {
      if (!value.contains(key)) refuse("the keys " + names + ", found no '" + key + "'");
      list.push_back({value[key], pointer + "/" + key});
    }
    for (const auto& [key, unused] : value.items()) {
      if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
        refuse("the keys " + names + ", found " + in_quotes(key));
      }
    }
    return list;
  }
};

ImplicitShape shape_of(const JsonPlace& place);

std::vector<ImplicitShape> parts_of(const JsonPlace& list) {
  std::vector<ImplicitShape> parts;
  for (const JsonPlace& entry : list.entries()) parts.push_back(shape_of(entry));
  return parts;
}

implicit::Node sphere_of(const JsonPlace& body) {
  const auto v = body.values({"center", "radius"});
  return implicit::Sphere{v[0].point(), v[1].number()};
}

implicit::Node capsule_of(const JsonPlace& body) {
  const auto v = body.values({"from", "to", "radius"});
  return implicit::Capsule{v[0].point(), v[1].point(), v[2].number()};
}

implicit::Node cylinder_of(const JsonPlace& body) {
  const auto v = body.values({"from", "to", "radius"});
  return implicit::Cylinder{v[0].point(), v[1].point(), v[2].number()};
}

implicit::Node box_of(const JsonPlace& body) {
  const auto v = body.values({"low", "high"});
  return implicit::Box{v[0].point(), v[1].point()};
}

implicit::Node rounded_box_of(const JsonPlace& body) {
  const auto v = body.values({"low", "high", "radius"});
  return implicit::Box{v[0].point(), v[1].point(), v[2].number()};
}

implicit::Node torus_of(const JsonPlace& body) {
  const auto v = body.values({"center", "axis", "major", "minor"});
  return implicit::Torus{v[0].point(), v[1].point(), v[2].number(), v[3].number()};
}

implicit::Node half_space_of(const JsonPlace& body) {
  const auto v = body.values({"normal", "offset"});
  return implicit::Plane{v[0].point(), v[1].number()};
}

implicit::Node union_of(const JsonPlace& body) { return implicit::Union{parts_of(body)}; }

implicit::Node intersection_of(const JsonPlace& body) {
  return implicit::Intersection{parts_of(body)};
}

implicit::Node difference_of(const JsonPlace& body) { return implicit::Difference{parts_of(body)}; }

implicit::Node smooth_union_of(const JsonPlace& body) {
  const auto v = body.values({"of", "radius"});
  return implicit::SmoothUnion{parts_of(v[0]), v[1].number()};
}

implicit::Node translate_of(const JsonPlace& body) {
  const auto v = body.values({"by", "of"});
  return implicit::Translate{{shape_of(v[1])}, v[0].point()};
}

implicit::Node rotate_of(const JsonPlace& body) {
  const auto v = body.values({"quaternion", "of"});
  const auto q = v[0].entries(4);
  return implicit::Rotate{{shape_of(v[1])},
                          {q[0].rational(), q[1].rational(), q[2].rational(), q[3].rational()}};
}

implicit::Node scale_of(const JsonPlace& body) {
  const auto v = body.values({"factor", "of"});
  const Point factors =
      v[0].value.is_array() ? v[0].point() : Point(Point::Constant(v[0].number()));
  return implicit::Scale{{shape_of(v[1])}, factors};
}

implicit::Node offset_of(const JsonPlace& body) {
  const auto v = body.values({"by", "of"});
  return implicit::Offset{{shape_of(v[1])}, v[0].number()};
}

const std::map<std::string, implicit::Node (*)(const JsonPlace&)> kNodeReaders = {
    {"sphere", sphere_of},
    {"capsule", capsule_of},
    {"box", box_of},
    {"rounded-box", rounded_box_of},
    {"torus", torus_of},
    {"cylinder", cylinder_of},
    {"half-space", half_space_of},
    {"union", union_of},
    {"intersection", intersection_of},
    {"difference", difference_of},
    {"smooth-union", smooth_union_of},
    {"translate", translate_of},
    {"rotate", rotate_of},
    {"scale", scale_of},
    {"offset", offset_of}};

ImplicitShape shape_of(const JsonPlace& place) {
  const json& value = place.value;
  if (!value.is_object() || value.size() != 1) {
    place.refuse("an object with one key, the name of a node" + place.found());
  }
  const std::string& name = value.begin().key();
  const auto reader = kNodeReaders.find(name);
  if (reader == kNodeReaders.end()) {
    std::string names;
    for (const auto& [known, unused] : kNodeReaders) names += (names.empty() ? "" : ", ") + known;
    place.refuse("a node out of " + names + ", found " + in_quotes(name));
  }
  const JsonPlace body{value.begin().value(), place.pointer + "/" + name};
  const implicit::Node node = reader->second(body);
  try {
    return ImplicitShape(node);
  } catch (const Error& error) {
    throw Error(ErrorCode::Malformed, body.pointer + ": " + error.what());
  }
}

}  // namespace

ImplicitShape read_implicit_bytes(std::string_view bytes) {
  const json document = parse_json(bytes);
  return shape_of({document, ""});
}

}  // namespace convexact
