// SPDX-License-Identifier: MIT
// COLLADA: files written by hand, and what their nodes do to points, worked out by hand.
#include <doctest/doctest.h>

#include "convexact/io.hpp"
#include "expect_error.hpp"

using namespace convexact;

namespace {

using Polygons = std::vector<std::vector<std::uint32_t>>;

const std::string kHead =
    "<?xml version=\"1.0\"?>\n<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" "
    "version=\"1.4.1\">\n";
const std::string kSource = R"(<source id="p"><float_array id="a" count="12">0 0 0 1 0 0
 0 1 0 0 0 1</float_array><technique_common><accessor source="#a" count="4" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
</accessor></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>)";
const std::string kInput = R"(<input semantic="VERTEX" source="#v" offset="0"/>)";
const std::string kTriangles =
    "<triangles count=\"4\">" + kInput + "<p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles>";

std::string geometry(const std::string& primitives, const std::string& source = kSource) {
  return R"(<library_geometries><geometry id="g" name="shape"><mesh>)" + source + primitives +
         "</mesh></geometry></library_geometries>\n";
}

std::string file(const std::string& nodes, const std::string& libraries = geometry(kTriangles),
                 const std::string& asset = "") {
  return kHead + asset + libraries + R"(<library_visual_scenes><visual_scene id="s">)" + nodes +
         R"(</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

std::string node(const std::string& transforms) {
  return R"(<node name="n">)" + transforms + R"(<instance_geometry url="#g"/></node>)";
}

Mesh collada(const std::string& bytes, Decimal decimal = Decimal::Nearest) {
  return read_mesh_bytes(bytes, {.decimal = decimal, .format = MeshFormat::Collada});
}

// The corner that is 1 0 0 in the geometry, and so on: 0 to 3.
std::vector<RationalPoint> first_corners(const Mesh& mesh) {
  std::vector<RationalPoint> points;
  const auto& first = mesh.polygons[0];
  const auto& second = mesh.polygons[1];
  for (const std::uint32_t c : {first[0], first[2], first[1], second[2]}) {
    points.push_back(mesh.points[PointId(c)]);
  }
  return points;
}

void check_says(const std::string& bytes, const std::string& words) {
  const Error error = error_of([&] { return collada(bytes); });
  const std::string said = error.what();
  CAPTURE(said);
  CAPTURE(words);
  CHECK(exit_code(error.code()) == 3);
  CHECK(said.find(words) != said.npos);
}

}  // namespace

TEST_CASE(
    "collada: rotations by right angles are exact, transforms apply from the last to the first") {
  const Mesh mesh =
      collada(file(node("<translate>5 6 7</translate><rotate>0 0 1 90</rotate>"
                        "<scale>2 3 4</scale>")));
  CHECK(mesh.parts[0].name == "n");
  CHECK(mesh.notes.empty());
  CHECK(first_corners(mesh) ==
        std::vector<RationalPoint>{{5, 6, 7}, {5, 8, 7}, {2, 6, 7}, {5, 6, 11}});
  for (const auto& [degrees, x] : {std::pair{"180", RationalPoint(-1, 0, 0)},
                                   {"-180", RationalPoint(-1, 0, 0)},
                                   {"-90", RationalPoint(0, -1, 0)},
                                   {"270", RationalPoint(0, -1, 0)},
                                   {"450", RationalPoint(0, 1, 0)},
                                   {"3600", RationalPoint(1, 0, 0)}}) {
    const auto turned =
        first_corners(collada(file(node("<rotate>0 0 2 " + std::string(degrees) + "</rotate>"))));
    CHECK(turned[1] == x);
  }
}

TEST_CASE("collada: other rotations are rotations, close to the angle") {
  // cos 30 = sqrt(3) / 2 and sin 30 = 1 / 2.
  const auto turned =
      first_corners(collada(file(node("<rotate>0 0 1 30</rotate>")), Decimal::Exact));
  CHECK(turned[1].dot(turned[1]) == 1);
  CHECK(turned[1].dot(turned[2]) == 0);
  CHECK(abs(turned[1][1] - Rational(1, 2)) < Rational(1, 1'000'000'000'000'000));
}

TEST_CASE("collada: matrices by rows; a mirror image is turned; nodes within nodes") {
  const Mesh mesh = collada(file(R"(<node><matrix>0 -1 0 5 1 0 0 6 0 0 -1 7 0 0 0 1</matrix>)" +
                                 node("<translate>1 0 0</translate>") + "</node>"));
  // (x + 1, y, z) becomes (5 - y, 7 + x, 7 - z).
  const auto expected = std::vector<RationalPoint>{{5, 7, 7}, {5, 8, 7}, {4, 7, 7}, {5, 7, 6}};
  for (const RationalPoint& p : expected) {
    const auto points = mesh.points.doubles();
    CHECK(std::find_if(points.begin(), points.end(),
                       [&](const Point& q) { return to_rational(q) == p; }) != points.end());
  }
  // The face 0 2 1 of the geometry, seen from outside, is 0 1 2 in its mirror image.
  CHECK(mesh.points[PointId(mesh.polygons[0][1])] == expected[1]);
}

TEST_CASE("collada: instances of nodes are objects of their own") {
  const std::string libraries = geometry(kTriangles) + R"(<library_nodes><node id="m" name="wheel">
<instance_geometry url="#g"/></node></library_nodes>)";
  const Mesh mesh =
      collada(file(R"(<node><translate>9 0 0</translate><instance_node url="#m"/></node>
<node><instance_node url="#m"/></node>)",
                   libraries));
  CHECK(mesh.parts.size() == 2);
  CHECK(mesh.points.size() == 8);
  check_says(
      file(R"(<node><instance_node url="#r"/></node>)",
           R"(<library_nodes><node id="r"><instance_node url="#r"/></node></library_nodes>)"),
      "none within itself");
  check_says(file(R"(<node><instance_node url="other.dae#r"/></node>)"), "a reference such as #id");
}

TEST_CASE("collada: lists of polygons, strips, fans, and other inputs beside the points") {
  const std::string two = R"(<input semantic="NORMAL" source="#n" offset="0"/>
<input semantic="VERTEX" source="#v" offset="1"/>)";
  const auto polygons = [](const std::string& primitives) {
    return collada(file(node(""), geometry(primitives))).polygons;
  };
  CHECK(polygons("<polylist count=\"2\">" + two +
                 "<vcount>3 4</vcount><p>9 0 9 1 9 2 9 0 9 3 9 2 "
                 "9 1</p></polylist>") == Polygons{{0, 1, 2}, {0, 3, 2, 1}});
  CHECK(polygons("<polygons>" + kInput + "<p>0 1 2</p><p>0 2 3</p></polygons>") ==
        Polygons{{0, 1, 2}, {0, 2, 3}});
  CHECK(polygons("<tristrips>" + kInput + "<p>0 1 2 3</p></tristrips>") ==
        Polygons{{0, 1, 2}, {1, 3, 2}});
  CHECK(polygons("<trifans>" + kInput + "<p>0 1 2 3</p></trifans>") ==
        Polygons{{0, 1, 2}, {0, 2, 3}});
  CHECK(polygons("<lines>" + kInput + "<p>0 1</p></lines>").empty());
}

TEST_CASE("collada: numbers are read as in any text, and what the file says of units is told") {
  const std::string source = R"(<source id="p"><float_array id="a" count="9">0.1 0 0 9 0 1 0 9
1e-3 0 0 9</float_array><technique_common><accessor source="#a" count="3" stride="4">
<param name="X"/><param name="Y"/><param name="Z"/><param/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>)";
  const std::string bytes =
      file(node(""), geometry("<triangles>" + kInput + "<p>0 1 2</p></triangles>", source),
           "<asset><unit name=\"inch\" meter=\"0.0254\"/><up_axis>Y_UP</up_axis></asset>");
  const Mesh exact = collada(bytes, Decimal::Exact);
  CHECK(exact.points[PointId(0)] == RationalPoint(Rational(1, 10), 0, 0));
  CHECK(collada(bytes).points.doubles()[0] == Point(0.1, 0, 0));
  CHECK(collada(bytes, Decimal::Nearest32).points.doubles()[0] == Point(0.1f, 0, 0));
  REQUIRE(exact.notes.size() == 2);
  CHECK(exact.notes[0].find("'Y_UP': coordinates are taken as written") != std::string::npos);
  CHECK(exact.notes[1].find("'0.0254' meters") != std::string::npos);
}

TEST_CASE("collada: what is not read, or malformed, is refused by name and line") {
  check_says(file(R"(<node><instance_controller url="#c"/></node>)"), "a skin or a morph");
  check_says(file(R"(<node><instance_geometry url="#x"/></node>)"),
             "an element geometry of the id 'x'");
  check_says(file(R"(<node><instance_geometry url="http://a/b.dae#g"/></node>)"), "in this file");
  check_says(
      file(node(""),
           R"(<library_geometries><geometry id="g"><spline/></geometry></library_geometries>)"),
      "splines");
  check_says(file(node("<skew>1 2 3 4 5 6 7</skew>")), "skew is not read");
  check_says(file(node("<scale>1 0 1</scale>")), "flattens");
  check_says(file(node("<rotate>0 0 0 5</rotate>")), "an axis");
  check_says(file(node("<rotate>0 0 1</rotate>")), "4 numbers");
  check_says(file(node("<translate>0 0 nan</translate>")), "nan");
  check_says(file(node("<matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 2</matrix>")), "0 0 0 1");
  check_says(file(node(""), geometry("<triangles>" + kInput + "<p>0 1 4</p></triangles>")),
             "indices of 4 points, found 4");
  check_says(file(node(""), geometry("<triangles>" + kInput + "<p>0 1</p></triangles>")),
             "three corners for each triangle");
  check_says(file(node(""), geometry("<triangles>" + kInput + "<p>0 -1 2</p></triangles>")),
             "an integer");
  check_says(
      file(node(""), geometry("<polylist>" + kInput + "<vcount>4</vcount><p>0 1 2</p></polylist>")),
      "as many corners as vcount says");
  check_says(file(node(""),
                  geometry("<polygons>" + kInput + "<ph><p>0 1 2</p><h>0 1 2</h></ph></polygons>")),
             "without holes");
  check_says("<!DOCTYPE COLLADA [<!ENTITY a \"b\">]>\n" + file(node("")), "entities");
  check_says(kHead + "<a>", "XML");
  check_says("<a/>", "an element COLLADA");
  const Error error = error_of([] { return collada(file("\n\n" + node("<scale>1 x 1</scale>"))); });
  CHECK(error.line() == 9);
}
