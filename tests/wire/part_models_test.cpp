// SPDX-License-Identifier: MIT
// Models of parts for simulators: names, numbers, and what the proof of USD notices.
#include "wire/part_models.hpp"

#include <doctest/doctest.h>

#include <array>
#include <variant>

#include "cells.hpp"
#include "convexact/error.hpp"
#include "expect_error.hpp"

using namespace convexact;

namespace {

// Two parts of a mesh whose corners are no numbers of binary32.
struct TenthParts {
  Decomposition made;

  explicit TenthParts(Precision precision) {
    Mesh mesh = support::mesh_of_cells(support::l_cells());
    std::vector<Point> points(mesh.points.doubles().begin(), mesh.points.doubles().end());
    for (Point& p : points) p /= 10;
    mesh.points = PointSet(std::move(points));
    DecomposeRequest request;
    request.precision = precision;
    made = std::get<Decomposition>(decompose(mesh, request));
  }
  std::vector<WrittenPart> written() const {
    return {{"a", &made.parts[0], &made.surface}, {"b", &made.parts[1], &made.surface}};
  }
  std::string usd() const { return proven_parts_usd({.name = "tenths"}, written(), "x.usda"); }
};

template <class Action>
bool is_noticed_in_usd(Action&& action) {
  return error_of(action).code() == ErrorCode::Internal;
}

}  // namespace

TEST_CASE("part models: the proof of USD takes numbers as floats, so doubles do not pass") {
  const TenthParts rounded(Precision::Binary32), doubles(Precision::Binary64);
  REQUIRE(rounded.made.parts.size() == 2);
  CHECK(rounded.usd().find("#usda 1.0\n") == 0);
  CHECK(is_noticed_in_usd([&] { return doubles.usd(); }));
}

TEST_CASE("part models: the proof of USD notices moved corners and swapped owners") {
  TenthParts moved(Precision::Binary32);
  std::vector<Point> points(moved.made.parts[1].mesh.points.doubles().begin(),
                            moved.made.parts[1].mesh.points.doubles().end());
  points[0] = points[1];
  moved.made.parts[1].mesh.points = PointSet(points);
  CHECK(is_noticed_in_usd([&] { return moved.usd(); }));
  TenthParts swapped(Precision::Binary32);
  std::swap(swapped.made.parts[0].owns, swapped.made.parts[1].owns);
  CHECK(is_noticed_in_usd([&] { return swapped.usd(); }));
  TenthParts huge(Precision::Binary32);
  points[0].x() = 1e39;  // beyond the largest float
  huge.made.parts[1].mesh.points = PointSet(points);
  CHECK(is_noticed_in_usd([&] { return huge.usd(); }));
}

TEST_CASE("part models: names of prims are identifiers, all different") {
  const TenthParts parts(Precision::Binary32);
  const auto named = [&](const std::string& name) {
    return WrittenPart{name, &parts.made.parts[0], &parts.made.surface};
  };
  const std::array<WrittenPart, 8> written = {named("part_000"),
                                              named("7"),
                                              named("a b"),
                                              named("a-b"),
                                              named("a_b_2"),
                                              named(""),
                                              named("\xC3\xA9t\xC3\xA9"),
                                              named("a+b")};
  CHECK(prim_names(written) ==
        std::vector<std::string>{"part_000", "_7", "a_b", "a_b_2", "a_b_2_2", "_", "_t_", "a_b_3"});
}

TEST_CASE("part models: a name is displayed where it is no identifier") {
  const TenthParts parts(Precision::Binary32);
  std::vector<WrittenPart> written = parts.written();
  // As a reader of lines might take it for points.
  written[1].name = "\"]\" point3f[] points = [(0, 0, 0)]";
  const std::string text = proven_parts_usd({.name = "m"}, written, "x.usda");
  CHECK(text.find("displayName = \"\\\"]\\\" point3f[] points = [(0, 0, 0)]\"\n") != text.npos);
  CHECK(text.find("def Mesh \"a\"") != text.npos);
  CHECK(text.find("displayName = \"a\"") == text.npos);
}

TEST_CASE("part models: XML escapes what it must, and bytes that no reader takes are refused") {
  const std::vector<PartFile> files = {{"<&>\"'", "p&/<&>\"'.obj"}};
  const std::string name = "\"&lt;&amp;&gt;&quot;'\"", path = "\"p&amp;/&lt;&amp;&gt;&quot;'.obj\"";
  const std::string mjcf = write_mjcf({.name = "m"}, files),
                    urdf = write_urdf({.name = "m"}, files);
  CHECK(mjcf.find("<mesh name=" + name + " file=" + path + "/>") != mjcf.npos);
  CHECK(mjcf.find("<geom name=" + name + " type=\"mesh\" mesh=" + name + "/>") != mjcf.npos);
  CHECK(urdf.find("<collision name=" + name + ">") != urdf.npos);
  CHECK(urdf.find("<mesh filename=" + path + "/>") != urdf.npos);
  for (const char* text : {"a\nb", "a\tb", "\x01", "\x7F", "\xFF", "\xC3", "\xEF\xBF\xBE"}) {
    const std::vector<PartFile> bad = {{text, "x.obj"}}, bad_path = {{"x", text}};
    CHECK(error_of([&] { return write_mjcf({.name = "m"}, bad); }).code() ==
          ErrorCode::Unrepresentable);
    CHECK(error_of([&] { return write_mjcf({.name = "m"}, bad_path); }).code() ==
          ErrorCode::Unrepresentable);
    CHECK(error_of([&] { return write_urdf({.name = text}, files); }).code() ==
          ErrorCode::Unrepresentable);
  }
}
