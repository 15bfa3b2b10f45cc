// SPDX-License-Identifier: MIT
// Documents and their text, compared with nlohmann/json, whose constructors and layout they follow.
#include "io/json_document.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "convexact/geometry.hpp"

using namespace convexact;
using Theirs = nlohmann::ordered_json;

namespace {

std::string dump(const Theirs& document, int indent = -1) {
  return document.dump(indent, ' ', false, Theirs::error_handler_t::replace);
}

// The same statement builds one document of each type.
template <class Document>
Document sample() {
  Document json = {{"name", "a"}, {"none", nullptr}, {"pair", {1, "b"}}, {"sorted", false}};
  json["list"] = Document::array();
  json["list"].push_back({{"x", 1.5}, {"y", {{"z", -7}}}});
  json["list"].push_back({"1", "2"});
  json["list"].push_back({{"1", "2", "3"}, {"4", "5", "6"}});
  json["list"].push_back(Document::object());
  json["list"].push_back(Document::array());
  json["list"].emplace_back() = {{"only", 1u}};
  json["list"][1].push_back("3");
  json["nested"] = std::vector<std::vector<unsigned>>{{1, 2, 3}, {}, {4}};
  json["alike"] = {{"k", 1}, {"k", 2}};  // the first counts
  json["pairs"] = std::vector<std::pair<int, bool>>{{1, true}, {2, false}};
  json["name"] = json["pair"][1];
  json.update({{"sorted", true}, {"new", {{"one", 1}}}});
  json["gone"] = 1;
  json.erase("gone");
  return json;
}

template <class Document>
std::vector<Document> small_documents() {
  return {Document(),
          nullptr,
          true,
          {},
          Document::array(),
          Document::object(),
          {1},
          {{"a", 1}},
          {{"a", 1}, {"b"}},
          {"a", "b"},
          {{"a", "b"}, {"c", "d"}},
          {{1, "a"}},
          {{{"a", 1}}},
          {nullptr, nullptr},
          std::vector<std::string>{},
          std::array<int, 3>{1, 2, 3},
          Document::array({{"a", 1}}),
          Document::array({Document::array(), Document::object()}),
          {{"", {{"", {{"", Document::array({Document::array()})}}}}}}};
}

std::string with_any_digits(std::string text) {
  for (char& c : text) c = c >= '0' && c <= '9' ? '0' : c;
  return text;
}

// Their digits are not always the fewest and nearest: the value counts, and the layout.
void check_double(double value) {
  CAPTURE(value);
  const std::string ours = write_json(value), theirs = dump(value);
  const double read = Theirs::parse(ours).get<double>();
  CHECK(std::bit_cast<std::uint64_t>(read) == std::bit_cast<std::uint64_t>(value));
  CHECK(ours.size() <= theirs.size());
  if (ours.size() == theirs.size()) CHECK(with_any_digits(ours) == with_any_digits(theirs));
}

std::string random_bytes(std::mt19937_64& random) {
  // Beginnings and ends of characters of every length, so that many are nearly complete.
  constexpr unsigned char kBytes[] = {0x00, 0x08, 0x1F, 0x22, 0x41, 0x5C, 0x7F, 0x80, 0x8F,
                                      0x90, 0x9F, 0xA0, 0xBF, 0xC0, 0xC2, 0xDF, 0xE0, 0xE1,
                                      0xED, 0xEF, 0xF0, 0xF1, 0xF4, 0xF5, 0xFF};
  std::string bytes(random() % 9, ' ');
  for (char& c : bytes) c = static_cast<char>(kBytes[random() % std::size(kBytes)]);
  return bytes;
}

}  // namespace

TEST_CASE("json_document: braces, keys and lists mean what they mean to nlohmann") {
  for (const int indent : {-1, 0, 1, 2}) {
    CAPTURE(indent);
    CHECK(write_json(sample<Json>(), indent) == dump(sample<Theirs>(), indent));
    const auto ours = small_documents<Json>();
    const auto theirs = small_documents<Theirs>();
    for (std::size_t k = 0; k < ours.size(); ++k) {
      CAPTURE(k);
      CHECK(write_json(ours[k], indent) == dump(theirs[k], indent));
    }
  }
}

TEST_CASE("json_document: exact numbers are strings, ids numbers, a plane its four integers") {
  const Rational third = Rational(1) / 3;
  CHECK(write_json({{"x", third}}) == R"({"x":"1/3"})");
  CHECK(write_json({PointId(7), HalfspaceId(0)}) == "[7,0]");
  const Halfspace plane(RationalVector3(third, Rational(0), Rational(-1)), Rational(2));
  CHECK(write_json(std::vector<Halfspace>{plane}) == R"([["1","0","-3","6"]])");
}

TEST_CASE("json_document: a number is read as a double, however it was written") {
  CHECK(Json(-3).number() == -3);
  CHECK(Json(3u).number() == 3);
  CHECK(Json(2.5).number() == 2.5);
}

TEST_CASE("json_document: integers at their limits") {
  using std::numeric_limits;
  CHECK(write_json({numeric_limits<std::int64_t>::min(), numeric_limits<std::int64_t>::max(),
                    numeric_limits<std::uint64_t>::max(), numeric_limits<int>::min(),
                    numeric_limits<unsigned>::max()}) ==
        "[-9223372036854775808,9223372036854775807,18446744073709551615,-2147483648,4294967295]");
}

TEST_CASE("json_document: the layout of doubles is nlohmann's, and their digits give them back") {
  // By hand: the point stands within 15 digits before it and three zeros behind it.
  CHECK(write_json({0.0, -0.0, 1.0, 100.0, 0.001, 1e-4, 1e-5, 1e15, 123456789012345.0, 1.5e300}) ==
        "[0.0,-0.0,1.0,100.0,0.001,0.0001,1e-05,1e+15,123456789012345.0,1.5e+300]");
  CHECK(write_json({NAN, INFINITY, -INFINITY}) == "[null,null,null]");
  for (const double x :
       {5e-324, 2.2250738585072014e-308, 1.7976931348623157e308, 0.1, 1.0 / 3, 1e14,
        999999999999999.0, 9999999999999998.0, 9007199254740993.0, 1e22, 1e23}) {
    check_double(x);
    check_double(-x);
  }
  for (int e = -330; e < 309; ++e)
    check_double(std::strtod(("1e" + std::to_string(e)).c_str(), nullptr));
  std::mt19937_64 random(7);
  for (int k = 0; k < 20000; ++k) {
    const auto any = std::bit_cast<double>(random());
    if (std::isfinite(any)) check_double(any);
    check_double(static_cast<double>(random() % 1000000) / 1000);
    check_double(
        std::ldexp(static_cast<double>(random() >> 11), static_cast<int>(random() % 80) - 90));
  }
}

TEST_CASE("json_document: control characters are escaped, and what is not UTF-8 is U+FFFD") {
  CHECK(write_json("\x01\b\t\n\f\r\"\\/\x7F\xC3\xA9") ==
        "\"\\u0001\\b\\t\\n\\f\\r\\\"\\\\/\x7F\xC3\xA9\"");
  CHECK(write_json("a\xFF\xE2\x82") == "\"a\xEF\xBF\xBD\xEF\xBF\xBD\"");
  std::mt19937_64 random(7);
  for (int k = 0; k < 20000; ++k) {
    const std::string bytes = random_bytes(random);
    CAPTURE(k);
    CHECK(write_json(bytes) == dump(bytes));
    CHECK(write_json({{bytes, 1}}) == dump({{bytes, 1}}));
    CHECK(as_utf8(bytes) == Theirs::parse(dump(bytes)).get<std::string>());
  }
}

TEST_CASE("json_document: lines") {
  CHECK(write_lines(
            {{"a", 1}, {"b", {{{"c", 1}}, {{"c", 2}}}}, {"d", {1, 2}}, {"e", Json::array()}}) ==
        "{\n\"a\": 1,\n\"b\": [\n  {\"c\":1},\n  {\"c\":2}\n],\n\"d\": [1,2],\n\"e\": []\n}\n");
}

TEST_CASE("json_document: values are told apart by meaning") {
  CHECK(Json(1) == Json(1u));
  CHECK(Json(1) == Json(1.0));
  CHECK(Json(-1) != Json(std::numeric_limits<std::uint64_t>::max()));
  CHECK(Json(1) != Json(true));
  CHECK(Json(0) != Json());
  CHECK(Json("a") == "a");
  CHECK(Json{{"a", 1}, {"b", 2}} != Json{{"b", 2}, {"a", 1}});
  CHECK(sample<Json>() == Json(sample<Json>()));
  CHECK(Json::array() != Json::object());
}

TEST_CASE("json_document: a part can be assigned to its whole") {
  Json json = {{"a", {{"b", {1, 2}}}}};
  json = json["a"]["b"];
  CHECK(write_json(json) == "[1,2]");
  json = std::move(json[1]);
  CHECK(json == 2);
}

TEST_CASE("json_document: depth needs no stack") {
  constexpr std::size_t kDepth = 1000000;
  Json json;
  for (std::size_t k = 0; k < kDepth; ++k) {
    Json outer = Json::array();
    outer.push_back(std::move(json));
    json = std::move(outer);
  }
  CHECK(write_json(json).size() == 2 * kDepth + 4);
}
