// SPDX-License-Identifier: MIT
// Shapes as JSON: every node, and what is refused, with its place.
#include <doctest/doctest.h>

#include <string>

#include "convexact/implicit.hpp"
#include "expect_error.hpp"

using namespace convexact;

namespace {

std::string refusal(const std::string& text) {
  const Error error = error_of([&] { return read_implicit_bytes(text); });
  CHECK(exit_code(error.code()) == 3);
  return error.what();
}

bool begins(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }

}  // namespace

TEST_CASE("read_implicit_bytes: every node") {
  const std::string ball = R"({"sphere": {"center": [0, 0, 0], "radius": 1}})";
  const auto read = [](const std::string& text) { return read_implicit_bytes(text); };
  const auto capsule =
      read(R"({"capsule": {"from": [-0.1, 0, 0], "to": [1, 2, 3], "radius": 0.5}})");
  // The nearest double.
  CHECK(std::get<implicit::Capsule>(capsule.node()).from[0] == -0.1);
  CHECK(std::get<implicit::Capsule>(capsule.node()).to == Point(1, 2, 3));
  const auto box = read(R"({"box": {"low": [0, 0, 0], "high": [1, 1, 1]}})");
  CHECK(std::get<implicit::Box>(box.node()).radius == 0);
  const auto rounded =
      read(R"({"rounded-box": {"low": [0, 0, 0], "high": [1, 1, 1], "radius": 0.25}})");
  CHECK(std::get<implicit::Box>(rounded.node()).radius == 0.25);
  const auto torus =
      read(R"({"torus": {"center": [0, 0, 0], "axis": [0, 0, 1], "major": 2, "minor": 0.5}})");
  CHECK(std::get<implicit::Torus>(torus.node()).minor == 0.5);
  const auto cylinder = read(R"({"cylinder": {"from": [0, 0, 0], "to": [0, 0, 1], "radius": 2}})");
  CHECK(std::get<implicit::Cylinder>(cylinder.node()).radius == 2);
  const auto plane = read(R"({"half-space": {"normal": [1, 0, 0], "offset": -1}})");
  CHECK(std::get<implicit::Plane>(plane.node()).offset == -1);
  const std::string pair = "[" + ball + ", " + ball + "]";
  CHECK(std::get<implicit::Union>(read("{\"union\": " + pair + "}").node()).of.size() == 2);
  CHECK(
      std::get<implicit::Intersection>(read("{\"intersection\": " + pair + "}").node()).of.size() ==
      2);
  CHECK(std::get<implicit::Difference>(read("{\"difference\": " + pair + "}").node()).of.size() ==
        2);
  const auto smooth = read("{\"smooth-union\": {\"of\": " + pair + ", \"radius\": 0.5}}");
  CHECK(std::get<implicit::SmoothUnion>(smooth.node()).radius == 0.5);
  const auto moved = read("{\"translate\": {\"by\": [1, 2, 3], \"of\": " + ball + "}}");
  CHECK(std::get<implicit::Translate>(moved.node()).by == Point(1, 2, 3));
  const auto turned =
      read("{\"rotate\": {\"quaternion\": [\"3/5\", 0, \"4/5\", 0], \"of\": " + ball + "}}");
  CHECK(std::get<implicit::Rotate>(turned.node()).quaternion[2] == Rational(4) / 5);
  CHECK(turned.levels() == 2);
  const auto scaled = read("{\"scale\": {\"factor\": 2, \"of\": " + ball + "}}");
  CHECK(std::get<implicit::Scale>(scaled.node()).factors == Point(2, 2, 2));
  const auto stretched = read("{\"scale\": {\"factor\": [1, 2, 3], \"of\": " + ball + "}}");
  CHECK(std::get<implicit::Scale>(stretched.node()).factors == Point(1, 2, 3));
  const auto grown = read("{\"offset\": {\"by\": -0.5, \"of\": " + ball + "}}");
  CHECK(std::get<implicit::Offset>(grown.node()).by == -0.5);
}

TEST_CASE("read_implicit_bytes: what is refused, by its JSON pointer") {
  const auto in_union = [](const std::string& node) {
    return R"({"union": [{"sphere": {"center": [0, 0, 0], "radius": 1}}, )" + node + "]}";
  };
  CHECK(begins(refusal("[]"), "the document: expected an object with one key"));
  CHECK(begins(refusal("{}"), "the document: expected an object with one key"));
  CHECK(begins(refusal(in_union(R"({"blob": {}})")), "/union/1: expected a node out of box, "));
  CHECK(begins(refusal(in_union(R"({"sphere": {"radius": 1}})")),
               "/union/1/sphere: expected the keys 'center', 'radius', found no 'center'"));
  CHECK(begins(refusal(in_union(R"({"sphere": {"center": [0, 0, 0], "radius": 1, "color": 1}})")),
               "/union/1/sphere: expected the keys 'center', 'radius', found"));
  CHECK(begins(refusal(in_union(R"({"sphere": {"center": [0, 0], "radius": 1}})")),
               "/union/1/sphere/center: expected a list of 3, found 2"));
  CHECK(begins(refusal(in_union(R"({"sphere": {"center": [0, "0", 0], "radius": 1}})")),
               "/union/1/sphere/center/1: expected a number"));
  CHECK(begins(refusal(in_union(R"({"sphere": {"center": [0, 0, 0], "radius": -1}})")),
               "/union/1/sphere: expected a radius above 0, found -1"));
  CHECK(begins(refusal(in_union(R"({"rotate": {"quaternion": [1, 1, 0, 0], "of": 1}})")),
               "/union/1/rotate/of: expected an object with one key"));
  CHECK(begins(refusal(R"({"rotate": {"quaternion": [1, 1, 0, 0], "of":
                          {"sphere": {"center": [0, 0, 0], "radius": 1}}}})"),
               "/rotate: expected a unit quaternion, whose squares add up to 1, found the sum 2"));
  CHECK(begins(refusal(R"({"rotate": {"quaternion": ["x", 1, 0, 0], "of":
                          {"sphere": {"center": [0, 0, 0], "radius": 1}}}})"),
               "/rotate/quaternion/0: expected a number, or a string with a fraction"));
  CHECK(begins(refusal(R"({"union": []})"), "/union: expected at least 1 parts, found 0"));
  CHECK(begins(refusal(R"({"union": {}})"), "/union: expected a list"));
}

TEST_CASE("read_implicit_bytes: what the parser refuses, by its line") {
  CHECK(begins(refusal(""), "line 1: expected JSON"));
  CHECK(begins(refusal("\n{\"sphere\": {\"center\": [0, 0, 0], \"radius\": NaN}}"), "line 2: "));
  CHECK(begins(refusal("{\"sphere\": {\"center\": [0, 0, 0], \"radius\": 1e999}}"), "line 1: "));
  CHECK(begins(refusal("{\"sphere\": {}, \"sphere\": {}}"), "line 1: expected the key"));
  std::string deep = R"({"sphere": {"center": [0, 0, 0], "radius": 1}})";
  for (int k = 0; k < 40; ++k) deep = "{\"union\": [" + deep + "]}";
  CHECK(refusal(deep).find("expected at most 64 lists and objects") != std::string::npos);
}
