// SPDX-License-Identifier: MIT
// The tables of options against the schemas, which say by hand which keys, words, ranges and
// defaults there are; and reading by name.
#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "expect_error.hpp"
#include "wire/decompose_options.hpp"
#include "wire/field.hpp"
#include "wire/judge_fields.hpp"
#include "wire/request_line.hpp"
#include "wire/simplify_options.hpp"

using namespace convexact;
using nlohmann::json;

namespace {

json schema(const std::string& name) {
  const char* folder = std::getenv("CONVEXACT_SCHEMAS");
  REQUIRE(folder != nullptr);
  std::ifstream file(std::string(folder) + "/" + name + ".schema.json");
  return json::parse(file);
}

std::set<std::string> words_of(const json& property) {
  std::set<std::string> words;
  for (const json& word : property.at("enum")) {
    words.insert(word.is_string() ? word.get<std::string>() : word.dump());
  }
  return words;
}

// What a schema says of the values of a field.
void check_property(const FieldInfo& field, const std::string& present, const json& property) {
  CAPTURE(field.name);
  switch (field.kind) {
    case FieldKind::Flag:
      CHECK(property.at("type") == "boolean");
      break;
    case FieldKind::Count:
      CHECK(property.at("type") == "integer");
      CHECK(property.at("minimum") == field.range.least);
      break;
    case FieldKind::Choice:
      CHECK(words_of(property) == std::set(field.words.begin(), field.words.end()));
      break;
    case FieldKind::Text:
      CHECK((property.contains("$ref") || property.at("type") == "string"));
      break;
  }
  if (!property.contains("default") || present.empty()) return;
  const json& usual = property["default"];
  CHECK((usual.is_string() ? usual.get<std::string>() : usual.dump()) == present);
}

template <class Request>
void check_properties(const Fields<Request>& fields, const json& properties, Request request = {}) {
  for (const BoundField& field : bound_fields(fields, request)) {
    REQUIRE_MESSAGE(properties.contains(field.info->name), field.info->name);
    check_property(*field.info, field.present, properties[field.info->name]);
  }
}

json properties_of_request(const std::string& name) {
  return schema(name)["definitions"]["request"]["properties"];
}

}  // namespace

TEST_CASE("fields: decompose_request.schema.json says the same") {
  check_properties(decompose_call_fields(), properties_of_request("decompose_request"),
                   default_decompose_request());
}

TEST_CASE("fields: stdio_request.schema.json says the same") {
  json properties = properties_of_request("stdio_request");
  CHECK(properties["tightness"]["default"] == false);  // the one default that lines have alone
  properties["tightness"].erase("default");
  check_properties(verify_fields(), properties);
  check_properties(parts_fields(), properties);
}

TEST_CASE("fields: solid_request.schema.json says the same") {
  check_properties(simplify_fields(), properties_of_request("solid_request"));
}

TEST_CASE("fields: profiles.schema.json has the promises, and nothing else but a title") {
  const json properties =
      schema("profiles")["properties"]["profiles"]["additionalProperties"]["properties"];
  check_properties(promise_fields(), properties);
  CHECK(properties.size() == promise_fields().size() + 1);
}

TEST_CASE("fields: a value of another type is refused with what was expected") {
  DecomposeRequest request;
  const BoundFields fields = bound_fields(decompose_fields(), request);
  const auto message = [&](const char* object) -> std::string {
    return error_of([&] { read_fields(json::parse(object), fields); }).what();
  };
  CHECK(message(R"({"method": 5})") == "expected method as acd or auto or cut or hacd");
  CHECK(message(R"({"method": "HACD"})") == "expected method as acd or auto or cut or hacd");
  CHECK(message(R"({"precision": "64"})") == "expected precision as 32 or 64");
  CHECK(message(R"({"precision": 16})") == "expected precision as 32 or 64");
  CHECK(message(R"({"keep_inner": 1})") == "expected keep_inner as true or false");
  CHECK(message(R"({"faces": -1})") == "expected faces as a count");
  CHECK(message(R"({"faces": 4.5})") == "expected faces as a count");
  CHECK(message(R"({"faces": 3})") ==
        "faces: expected a whole number from 4 to 4294967296, found '3'");
}

TEST_CASE("fields: what is read is written again") {
  DecomposeRequest request;
  read_fields(
      json::parse(R"({"method": "acd", "max_parts": 7, "precision": 32, "concavity": "1/8"})"),
      bound_fields(decompose_fields(), request));
  CHECK(request.method == DecomposeMethod::Acd);
  CHECK(request.max_parts == 7);
  CHECK(request.limit.value == Rational(1, 8));
  CHECK_FALSE(request.limit.is_share);
  CHECK(request.precision == Precision::Binary32);
  std::string written;
  for (const Field<DecomposeRequest>& field : decompose_fields()) {
    written += field.name + "=" + field.write(request) + " ";
  }
  CHECK(written ==
        "method=acd concavity=1/8 max_parts=7 guard=none merge=none distance=3% effort=normal "
        "max_excess=none disjoint= close=auto "
        "measure=surface "
        "bridge=farther coplanar=0.99 faces= "
        "max_part_vertices= total_faces= flat=auto keep_inner= connect=edge orient=auto loose=part "
        "engine=filtered jobs= "
        "precision=32 ");
}

TEST_CASE("fields: a text of options names values, and flags with or without one") {
  DecomposeRequest request;
  const BoundFields fields = bound_fields(decompose_call_fields(), request);
  read_options(nullptr, fields);
  read_options(" \t\r\n", fields);
  CHECK_FALSE(request.max_parts.has_value());
  read_options("\tmethod=cut  max_parts=8\ndisjoint keep_inner=true tree=false concavity=1/8 ",
               fields);
  CHECK(request.method == DecomposeMethod::Cut);
  CHECK(request.max_parts == 8);
  CHECK(request.disjoint);
  CHECK(request.keep_inner);
  CHECK_FALSE(request.for_tree);
  CHECK(request.limit.value == Rational(1, 8));
  read_options("disjoint=false no_measures seed=18446744073709551615", fields);
  CHECK_FALSE(request.disjoint);
  CHECK(request.measures == PartMeasures::None);
  CHECK(request.seed == 18446744073709551615u);
}

TEST_CASE("fields: a text of options that makes no sense is refused, and the option is named") {
  TreeRequest request;
  const auto message = [&](const char* text) -> std::string {
    const Error error = error_of([&] { read_options(text, bound_fields(tree_fields(), request)); });
    CHECK(error.code() == ErrorCode::InvalidArgument);
    return error.what();
  };
  const std::string known = ": expected options out of faces, leaf_faces, precision";
  CHECK(message("leaf-faces=4") == "there is no option 'leaf-faces'" + known);
  CHECK(message("faces=4 , leaf_faces=4") == "there is no option ','" + known);
  CHECK(message("faces = 4") == "faces: expected a whole number from 4 to 4294967296, found ''");
  CHECK(message("=") == "there is no option ''" + known);
  CHECK(message("faces=4 faces=4") == "faces: given twice");
  CHECK(message("faces=4=4") == "faces: expected a whole number from 4 to 4294967296, found '4=4'");
  CHECK(message("precision=64.0") == "precision: expected one of 32, 64, found '64.0'");
  VerifyRequest asked;
  const BoundFields fields = bound_fields(verify_call_fields(), asked);
  CHECK(std::string(error_of([&] { read_options("tolerance=-1", fields); }).what()) ==
        "tolerance: a tolerance cannot be negative");
  CHECK(std::string(error_of([&] { read_options("exact_facets=1", fields); }).what()) ==
        "exact_facets: expected one of false, true, found '1'");
}

TEST_CASE("narrowed: the largest number stands for all beyond it") {
  constexpr std::uint64_t kFar = std::uint64_t{1} << 32;
  CHECK(narrowed<std::uint32_t>(kFar - 1) == kFar - 1);
  CHECK(narrowed<std::uint32_t>(kFar) == kFar - 1);
  CHECK(narrowed<std::int32_t>(kFar) == std::numeric_limits<std::int32_t>::max());
  CHECK(narrowed<std::uint64_t>(kFar) == kFar);
  std::optional<std::uint32_t> count;
  assign_count(count, 2 * kFar + 7);
  CHECK(count == kFar - 1);
}

TEST_CASE("fields: given options override a profile, and only those") {
  GivenFields given;
  for (const BoundField& field : given.bound(promise_fields())) {
    if (field.info->name == "max_facets") field.read("--max-facets", "12");
    if (field.info->name == "asks") field.read("--asks", "hull");
  }
  CHECK(given.has("asks"));
  CHECK_FALSE(given.has("numbers"));
  Promise promise;
  promise.numbers = Precision::Binary32;
  promise.max_vertices = 8;
  given.apply_to(promise, promise_fields());
  CHECK(promise.asks == Asks::Hull);
  CHECK(promise.max_facets == 12);
  CHECK(promise.max_vertices == 8);
  CHECK(promise.numbers == Precision::Binary32);
}
