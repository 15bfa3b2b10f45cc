// SPDX-License-Identifier: MIT
// Pictures: what the page carries for viewer.js, on shapes whose data are known by construction.
#include "pages/picture.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "sweep.hpp"

using namespace convexact;

namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
  return found;
}

// What stands between two texts.
std::string between(const std::string& page, const std::string& first, const std::string& last) {
  const std::size_t at = page.find(first) + first.size();
  return page.substr(at, page.find(last, at) - at);
}

nlohmann::json layers_of(const std::string& page) {
  return nlohmann::json::parse(
      between(page, R"(<script type="application/json" id="picture">)", "</script>"));
}

// [RFC 4648, sec. 4]; then pairs of bytes, the low one first.
std::vector<int> numbers_of(const std::string& base64) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bits;
  for (const char c : base64.substr(0, base64.find('='))) {
    for (int bit = 5; bit >= 0; --bit) bits += digits.find(c) >> bit & 1 ? '1' : '0';
  }
  std::vector<int> bytes, numbers;
  for (std::size_t k = 0; k + 8 <= bits.size(); k += 8) {
    bytes.push_back(std::stoi(bits.substr(k, 8), nullptr, 2));
  }
  for (std::size_t k = 0; k + 2 <= bytes.size(); k += 2) {
    numbers.push_back(static_cast<std::int16_t>(bytes[k] + 256 * bytes[k + 1]));
  }
  return numbers;
}

// [0, side]^3; corner k has the bits of k as coordinates.
PictureLayer cube(double side) {
  PictureLayer layer{.name = "cube", .color = "#123456", .opacity = 0.5, .edges = true};
  std::vector<Point> corners;
  for (int k = 0; k < 8; ++k) {
    corners.push_back(side * Point(k & 1, k >> 1 & 1, k >> 2));
  }
  layer.add(corners,
            {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
  return layer;
}

}  // namespace

TEST_CASE("picture: a cube has eight corners of a grid, twelve triangles and twelve edges") {
  const auto layer = layers_of(picture_html({"t", "c", {cube(2)}}))[0];
  CHECK(layer["color"] == "#123456");
  CHECK(layer["opacity"] == 0.5);
  const std::vector<int> points = numbers_of(layer["points"]);
  const std::vector<int> triangles = numbers_of(layer["triangles"]);
  const std::vector<int> edges = numbers_of(layer["edges"]);
  REQUIRE(points.size() == 24);
  REQUIRE(triangles.size() == 36);
  REQUIRE(edges.size() == 24);
  for (const int coordinate : points) CHECK(std::abs(coordinate) == 32767);
  const auto corner = [&](int k) {
    return Point(points[3 * k], points[3 * k + 1], points[3 * k + 2]);
  };
  for (std::size_t k = 0; k < triangles.size(); k += 3) {
    // Counter-clockwise from outside of a solid around the origin: the determinant is positive.
    const Point a = corner(triangles[k]), b = corner(triangles[k + 1]),
                c = corner(triangles[k + 2]);
    CHECK(a.dot(b.cross(c)) > 0);
  }
  for (std::size_t k = 0; k < edges.size(); k += 2) {
    CHECK((corner(edges[k]) - corner(edges[k + 1])).cwiseAbs().sum() == 2 * 32767);
  }
}

TEST_CASE("picture: scaling by a power of two changes no byte, up to the ends of the doubles") {
  const std::string page = picture_html({"t", "c", {cube(1)}});
  for (const int exponent : {-1074, -1022, -3, 10, 1023}) {
    CAPTURE(exponent);
    CHECK(picture_html({"t", "c", {cube(std::ldexp(1, exponent))}}) == page);
  }
}

TEST_CASE("picture: corners beyond the doubles are drawn at their end") {
  Rational huge = 1;
  for (int k = 0; k < 2000; ++k) huge *= 2;
  Polytope tetrahedron;
  tetrahedron.vertices = {RationalPoint(0, 0, 0), RationalPoint(huge, 0, 0),
                          RationalPoint(0, huge, 0), RationalPoint(0, 0, huge)};
  tetrahedron.facets = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  PictureLayer layer{.name = "n", .color = "#000000"};
  layer.add(tetrahedron);
  const auto points = numbers_of(layers_of(picture_html({"t", "c", {layer}}))[0]["points"]);
  REQUIRE(points.size() == 12);
  for (const int coordinate : points) CHECK(std::abs(coordinate) == 32767);
}

TEST_CASE("picture: no text ends an element, an attribute or a mark of the page") {
  PictureLayer layer = cube(1);
  layer.name = "</script><b> @DATA@ \"&";
  layer.color = "\"></script><i>";
  const std::string plain = picture_html({"t", "c", {cube(1)}});
  const std::string page = picture_html({"</script><b> @SCRIPT@ \"&", "</title><b>", {layer}});
  CHECK(count(page, "</script>") == count(plain, "</script>"));
  CHECK(count(page, "</title>") == 1);
  CHECK_FALSE(has(page, "<b>"));
  CHECK_FALSE(has(page, "</script><i>"));
  CHECK(has(page, "<title>&lt;/script&gt;&lt;b&gt; @SCRIPT@ &quot;&amp;</title>"));
  CHECK(has(page, "&lt;/script&gt;&lt;b&gt; @DATA@ &quot;&amp;"));
  CHECK(layers_of(page)[0]["color"] == layer.color);
}

TEST_CASE("picture: the static drawing of a cube shows three faces and hides three") {
  const std::string svg = between(picture_html({"t", "c", {cube(1)}}), "<svg", "</svg>");
  REQUIRE(count(svg, "<path") == 2);
  const std::size_t second = svg.rfind("<path");
  CHECK(count(svg.substr(0, second), "M") == 3);
  CHECK(has(svg.substr(0, second), "stroke-dasharray"));
  CHECK(count(svg.substr(second), "M") == 3);
  CHECK_FALSE(has(svg.substr(second), "stroke-dasharray"));
}

TEST_CASE("picture: a layer that is not shown is in the data, not in the drawing") {
  PictureLayer hidden = cube(1);
  hidden.shown = false;
  const std::string page = picture_html({"t", "c", {hidden}});
  CHECK_FALSE(has(page, "<path"));
  CHECK_FALSE(has(page, " checked hidden"));
  CHECK(layers_of(page).size() == 1);
  CHECK_NOTHROW((void)picture_html({"t", "c", {}}));
}

TEST_CASE("picture: more than a million points are drawn on a coarser grid of the same size" *
          sweep) {
  PictureLayer cloud{.name = "n", .color = "#000000"};
  for (int x = 0; x < 1010; ++x) {
    for (int y = 0; y < 1000; ++y) cloud.points.emplace_back(x, y, 0);
  }
  const auto layer = layers_of(picture_html({"t", "c", {cloud}}))[0];
  CHECK_FALSE(layer.contains("triangles"));
  // Four digits of base64 are three bytes, and a point has six.
  const std::size_t points = layer["points"].get<std::string>().size() / 8;
  CHECK(points <= 1000000);
  CHECK(points > 250000);  // a grid twice as coarse as needed has a quarter of the points
}

TEST_CASE("picture: facets that can be picked carry their planes as text, beyond the doubles") {
  // [0, 2^70]^3, facet by facet in canonical order; corner k has the bits of k.
  Integer side = 1;
  for (int k = 0; k < 70; ++k) side *= 2;
  Polytope box;
  for (int k = 0; k < 8; ++k) {
    box.vertices.emplace_back(Rational(side * (k & 1)), Rational(side * (k >> 1 & 1)),
                              Rational(side * (k >> 2)));
  }
  box.facets = {{0, 4, 6, 2}, {0, 1, 5, 4}, {0, 2, 3, 1}, {4, 5, 7, 6}, {2, 6, 7, 3}, {1, 3, 7, 5}};
  for (const auto& facet : box.facets) {
    box.planes.push_back(
        Halfspace::through(box.vertices[facet[0]], box.vertices[facet[1]], box.vertices[facet[2]]));
  }
  PictureLayer layer{.name = "n", .color = "#000000", .edges = true, .right = true};
  layer.add_to_pick(box, "</script><b>");
  layer.add_to_pick(box, "again");
  const std::string page = picture_html({"t", "c", {cube(1), layer}});
  CHECK_FALSE(has(page, "<b>"));
  const auto layers = layers_of(page);
  CHECK_FALSE(layers[0].contains("solids"));
  const auto& solids = layers[1]["solids"];
  REQUIRE(solids.size() == 2);
  CHECK(solids[0]["name"] == "</script><b>");
  const std::string end = "-1180591620717411303424)";  // -2^70
  const std::vector<std::string> planes = {"(-1, 0, 0, 0)",    "(0, -1, 0, 0)",
                                           "(0, 0, -1, 0)",    "(0, 0, 1, " + end,
                                           "(0, 1, 0, " + end, "(1, 0, 0, " + end};
  CHECK(solids[0]["planes"] == planes);
  CHECK(solids[1]["planes"] == planes);
  CHECK(solids[0]["polygons"] == box.facets);
  CHECK(solids[1]["polygons"][0] == std::vector<std::uint32_t>{8, 12, 14, 10});
  CHECK(numbers_of(layers[1]["corners"]).size() == 2 * 8 * 3);
  CHECK(has(page, R"(id="numbers")"));
  CHECK(has(page, R"(id="pair")"));

  SUBCASE("one pane is enough for layers of one side") {
    CHECK_FALSE(has(picture_html({"t", "c", {layer}}), R"(id="pair")"));
    CHECK_FALSE(has(picture_html({"t", "c", {cube(1), cube(2)}}), R"(id="pair")"));
  }
  SUBCASE("many facets have no numbers, and very many are not picked") {
    for (int k = 2; k < 34; ++k) layer.add_to_pick(box, "more");  // 204 facets
    const std::string many = picture_html({"t", "c", {layer}});
    CHECK_FALSE(has(many, R"(id="numbers")"));
    CHECK(layers_of(many)[0]["solids"].size() == 34);
    for (int k = 34; k < 834; ++k) layer.add_to_pick(box, "more");  // 5004 facets
    CHECK_FALSE(layers_of(picture_html({"t", "c", {layer}}))[0].contains("solids"));
  }
}

TEST_CASE("polygons with colours of their own keep their order, and move apart") {
  PictureLayer colored = cube(2);
  colored.edges = false;
  const std::size_t faces = colored.polygons.size();
  for (std::size_t k = 0; k < faces; ++k) colored.heat.push_back(double(k) / double(faces - 1));
  colored.merges = {{0, 1}, {2, 3}, {0, 2}};
  PictureLayer moved = cube(1);
  moved.away = {2, 0, -1};
  const Picture picture{.title = "t", .answer = "c", .layers = {colored, moved}};
  const std::string page = picture_html(picture);
  CHECK(page == picture_html(picture));
  const auto layers = layers_of(page);
  // A square is two triangles, and both name it. Numbers of 32 bits: low and high halves.
  std::vector<int> polygons;
  for (std::size_t k = 0; k < faces; ++k) polygons.insert(polygons.end(), {int(k), 0, int(k), 0});
  CHECK(numbers_of(layers[0]["polygonOf"]) == polygons);
  CHECK(numbers_of(layers[0]["merges"]) == std::vector<int>{0, 0, 1, 0, 2, 0, 3, 0, 0, 0, 2, 0});
  CHECK(layers[0].contains("heat"));
  CHECK_FALSE(layers[0].contains("away"));
  // The scene is [0, 2]^3, so a length of 1 is 32767 grid steps.
  CHECK(layers[1]["away"] == nlohmann::json({2 * 32767, 0, -32767}));
  CHECK_FALSE(layers[1].contains("polygonOf"));
  CHECK(has(page, R"(id="apart" min="0" max="100" value="0")"));
  CHECK(has(page, R"(id="merges" min="0" max="3" value="3")"));
  // Pages without such layers have no such controls.
  const std::string plain = picture_html({.title = "t", .answer = "c", .layers = {cube(1)}});
  CHECK_FALSE(has(plain, R"(id="apart")"));
  colored.splits = 2;
  const std::string with_splits = picture_html({.title = "t", .answer = "c", .layers = {colored}});
  CHECK(has(with_splits, R"(id="splits" min="0" max="2" value="2")"));
  CHECK_FALSE(has(with_splits, R"(id="merges")"));
  CHECK_FALSE(has(plain, R"(id="merges")"));
}
