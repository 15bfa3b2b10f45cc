// SPDX-License-Identifier: MIT
// Reads the JSON files of conform: profiles, and vectors with their known answers.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "convexact/conform.hpp"
#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "convexact/number.hpp"
#include "convexact/verify.hpp"
#include "io/base64.hpp"
#include "io/json_text.hpp"
#include "number/text.hpp"
#include "simplify/run_names.hpp"
#include "wire/judge_fields.hpp"
#include "wire/request_line.hpp"
#include "wire/verdict_report.hpp"

namespace convexact {
namespace {

using nlohmann::json;

[[noreturn]] void fail(const std::string& message) { throw Error(ErrorCode::Malformed, message); }

// An integer of JSON within bounds. The JSON library converts any number to one: -1 becomes
// a huge count, and 1e99 is undefined behaviour.
std::int64_t to_integer(const json& number, std::int64_t least, std::int64_t most) {
  const bool is_beyond =
      number.is_number_unsigned() &&
      (most < 0 || number.get<std::uint64_t>() > static_cast<std::uint64_t>(most));
  if (!number.is_number_integer() || is_beyond || number.get<std::int64_t>() < least) {
    fail("expected an integer from " + std::to_string(least) + " to " + std::to_string(most) +
         ", found " + in_quotes(dump_json(number)));
  }
  return number.get<std::int64_t>();
}

std::size_t to_count(const json& number) {
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
  return static_cast<std::size_t>(to_integer(number, 0, kMost));
}

constexpr auto kKnownStatus =
    name_table<Status>({{Status::Holds, "holds"}, {Status::Violated, "violated"}});
constexpr auto kRefusals = name_table<ErrorCode>({{ErrorCode::Malformed, "malformed"},
                                                  {ErrorCode::NotFinite, "not-finite"},
                                                  {ErrorCode::NoInterior, "no-interior"}});

template <class E, std::size_t N>
E to_word(const NameTable<E, N>& words, const json& word, const char* expected) {
  const auto value = value_in(words, word.get<std::string>());
  if (!value) fail(expected + (", found " + in_quotes(word.get<std::string>())));
  return *value;
}

Profile to_profile(const std::string& name, const json& entry) {
  Profile profile{name, entry.at("title").get<std::string>(), {}};
  const BoundFields fields = bound_fields(promise_fields(), profile.promise);
  require_known_keys(entry, {"title"}, "a profile", fields);
  if (!entry.contains("asks")) fail("expected what the program was asked for, under asks");
  read_fields(entry, fields);
  return profile;
}

// "p", "p/q", or either followed by "*2^e".
Rational to_exact(const std::string& text) {
  const std::size_t star = text.find("*2^");
  if (star == std::string::npos) return parse_rational(text);
  int exponent = 0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data() + star + 3, end, exponent);
  if (result.ec != std::errc() || result.ptr != end || exponent < -100000 || exponent > 100000) {
    fail("expected a power of two, found " + in_quotes(text));
  }
  return scale_by_power_of_two(parse_rational(text.substr(0, star)), exponent);
}

// A double, or one in hexadecimal as Python and C print it: "-0x1.8p-3".
Rational to_coordinate(const json& x) {
  return x.is_string() ? parse_hex_float(x.get_ref<const std::string&>())
                       : to_rational(x.get<double>());
}

PointSet to_points(const json& list) { return points_of_json(list, "point", to_coordinate); }

HalfspaceList to_halfspaces(const json& list) {
  return halfspaces_of_json(
      list, [](const json& x) { return to_exact(x.get_ref<const std::string&>()); });
}

RawFile to_file(const json& file) {
  const std::string extension = file.at("format").get<std::string>();
  if (file.contains("text")) return {file["text"].get<std::string>(), extension};
  return {from_base64(file.at("base64").get<std::string>()), extension};
}

PointSet scaled_mesh(const json& input, const std::string& data) {
  const auto mesh = read_mesh((std::filesystem::path(data) / input.at("file").get<std::string>()));
  const auto scale = input.at("scale").get<double>();
  std::vector<Point> points(mesh.points.doubles().begin(), mesh.points.doubles().end());
  for (Point& p : points) p *= scale;  // each coordinate to the nearest double
  return PointSet(std::move(points));
}

decltype(TestVector::input) to_input(const json& input, const std::string& data) {
  if (input.contains("points")) return to_points(input["points"]);
  if (input.contains("halfspaces")) return to_halfspaces(input["halfspaces"]);
  if (input.contains("file")) return scaled_mesh(input, data);
  return to_file(input);
}

Candidate to_candidate(const json& candidate) {
  if (candidate.contains("halfspaces")) return to_halfspaces(candidate["halfspaces"]);
  if (candidate.contains("points")) {
    Mesh mesh;
    mesh.points = to_points(candidate["points"]);
    mesh.polygons = polygons_of_json(candidate.at("faces"), mesh.points.size());
    return mesh;
  }
  const RawFile file = to_file(candidate);
  return read_candidate_bytes(file.bytes, "candidate." + file.extension);
}

VerifyQuestion to_verify_question(const json& question, const json& expected) {
  VerifyQuestion result{{}, to_candidate(question.at("candidate")), {}, {}};
  read_fields(question, bound_fields<Budgets>(budget_fields(), result));
  result.inner = question.contains("inner") && question["inner"].get<bool>();
  for (const auto& [name, status] : expected.at("claims").items()) {
    const std::optional<ClaimCode> code = claim_of_name(name);
    if (!code || is_of_parts(*code)) {
      fail("expected the code of a claim about a solid, found " + in_quotes(name));
    }
    result.claims.emplace_back(*code, to_word(kKnownStatus, status, "expected holds or violated"));
  }
  if (expected.contains("outside")) {
    const json& outside = expected["outside"];
    result.outside = {to_count(outside.at("points")),
                      to_exact(outside.at("squared_distance").get<std::string>())};
  }
  return result;
}

SimplifyQuestion to_simplify_question(const json& question, const json& expected) {
  SimplifyQuestion result;
  result.faces = to_count(question.at("faces"));
  result.facets = to_count(expected.at("facets"));
  result.reached = expected.at("reached").get<bool>();
  if (!expected.contains("volume")) return result;
  result.volume = to_exact(expected["volume"].get<std::string>());
  for (const json& cost : expected.at("costs")) {
    result.costs.push_back(to_exact(cost.get<std::string>()));
  }
  for (const json& tie : expected.at("ties")) {
    result.ties.push_back(to_halfspaces(tie).halfspaces);
  }
  return result;
}

RefuseQuestion to_refuse_question(const json& expected) {
  RefuseQuestion result{
      to_word(kRefusals, expected.at("error"), "expected malformed, not-finite or no-interior"),
      {},
      {}};
  if (expected.contains("dimension")) {
    result.dimension = static_cast<int>(to_integer(expected["dimension"], -1, 2));
  }
  if (expected.contains("points")) result.points = to_points(expected["points"]);
  return result;
}

decltype(TestVector::question) to_question(const json& question, const json& expected) {
  const std::string ask = question.at("ask").get<std::string>();
  if (ask == "simplify") return to_simplify_question(question, expected);
  if (ask == "verify") return to_verify_question(question, expected);
  if (ask == "refuse") return to_refuse_question(expected);
  if (ask != "hull") fail("expected hull, simplify, verify or refuse, found " + in_quotes(ask));
  return HullQuestion{to_count(expected.at("facets")), to_count(expected.at("vertices")),
                      to_exact(expected.at("volume").get<std::string>())};
}

TestVector to_vector(const json& entry, const std::string& data) {
  TestVector vector;
  vector.id = entry.at("id").get<std::string>();
  vector.title = entry.at("title").get<std::string>();
  vector.level = static_cast<int>(to_integer(entry.at("level"), 1, 3));
  vector.required = entry.at("required").get<bool>();
  vector.flags = entry.at("flags").get<std::vector<std::string>>();
  try {
    vector.input = to_input(entry.at("input"), data);
    vector.question = to_question(entry.at("question"), entry.at("expected"));
  } catch (const json::exception& error) {
    fail(vector.id + ": " + error.what());
  }
  return vector;
}

}  // namespace

std::vector<Profile> read_profiles_bytes(std::string_view bytes) {
  std::vector<Profile> profiles;
  std::string name;
  try {
    const json document = parse_json(bytes);
    for (const auto& [key, entry] : document.at("profiles").items()) {
      name = key;
      profiles.push_back(to_profile(key, entry));
    }
  } catch (const std::exception& error) {
    fail((name.empty() ? "" : "profile " + name + ": ") + error.what());
  }
  return profiles;
}

const Profile& profile_of_name(const std::vector<Profile>& profiles, const std::string& name) {
  std::string names;
  for (const Profile& profile : profiles) {
    if (profile.name == name) return profile;
    names += (names.empty() ? "" : ", ") + profile.name;
  }
  throw Error(ErrorCode::InvalidArgument,
              fmt::format("profile {}: expected one of {}", in_quotes(name), names));
}

std::vector<TestVector> read_test_vectors_bytes(std::string_view bytes, const std::string& data) {
  std::vector<TestVector> vectors;
  try {
    const json document = parse_json(bytes);
    for (const json& entry : document.at("vectors")) vectors.push_back(to_vector(entry, data));
  } catch (const json::exception& error) {
    throw Error(ErrorCode::Malformed, error.what());
  }
  return vectors;
}

std::vector<TestVector> read_test_vectors_file(const std::string& path, const std::string& data) {
  try {
    return read_test_vectors_bytes(read_bytes(path), data);
  } catch (const Error& error) {
    throw error.in_file(path);
  }
}

std::vector<TestVector> read_test_vectors(const std::string& folder) {
  namespace fs = std::filesystem;
  std::vector<fs::path> files;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder, failed)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  if (files.empty()) {
    throw Error(ErrorCode::Unreadable, folder + ": expected a folder with vectors in .json files");
  }
  std::sort(files.begin(), files.end());
  std::vector<TestVector> vectors;
  for (const fs::path& file : files) {
    for (TestVector& vector :
         read_test_vectors_file(file, (fs::path(folder).parent_path() / "data"))) {
      vectors.push_back(std::move(vector));
    }
  }
  return vectors;
}

}  // namespace convexact
