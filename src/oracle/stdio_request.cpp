// SPDX-License-Identifier: MIT
#include "oracle/stdio_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "convexact/verify.hpp"
#include "convexact/verify_parts.hpp"
#include "io/json.hpp"
#include "io/json_text.hpp"
#include "number/text.hpp"
#include "oracle/parts_verdict.hpp"
#include "oracle/verdict_report.hpp"
#include "scene/json_mesh.hpp"
#include "scene/result_json.hpp"

namespace convexact {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

[[noreturn]] void reject(const std::string& expected) {
  throw Error(ErrorCode::Malformed, "expected " + expected);
}

void require_known_keys(const json& object, std::initializer_list<const char*> known,
                        const char* what) {
  if (!object.is_object()) reject(std::string(what) + " as an object");
  for (const auto& [key, value] : object.items()) {
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      reject(std::string("only known keys in ") + what + ", found '" + key + "'");
    }
  }
}

// A number of a JSON text or a string: both mean what their text means, independently of the other
// entries.
std::string_view text_of(const json& value) {
  const std::string_view text = spelling_of(value);
  if (text.empty()) reject("a number, or a string that holds one");
  return text;
}

// As in a list of halfspaces: integers and fractions are exact.
Rational coefficient(const json& value, Decimal decimal) {
  const std::string_view text = text_of(value);
  return is_hex_float(text) ? parse_hex_float(text) : parse_number(text, decimal);
}

// The oracle reports errors in the numbers of a candidate.
Candidate candidate(const json& object, Decimal decimal) {
  require_known_keys(object, {"planes", "vertices", "faces"}, "the candidate");
  if (object.contains("planes") == object.contains("vertices")) {
    reject("a candidate with 'planes', with 'vertices', or with 'parts'");
  }
  if (object.contains("planes") && object.contains("faces")) reject("faces with 'vertices' only");
  try {
    if (object.contains("planes")) {
      return halfspaces_of_json(object["planes"],
                                [&](const json& x) { return coefficient(x, decimal); });
    }
    return mesh_of_json(object, decimal);
  } catch (const Error& error) {
    return error;
  }
}

CandidateParts candidate_parts(const json& object, Decimal decimal) {
  require_known_keys(object, {"parts"}, "a candidate with parts");
  if (!object["parts"].is_array()) reject("the parts as an array");
  try {
    std::vector<NamedPart> parts;
    for (const json& part : object["parts"]) {
      require_known_keys(part, {"name", "vertices", "faces"}, "a part");
      parts.push_back(part_of_json(part, parts.size(), decimal));
    }
    return parts;
  } catch (const Error& error) {
    return error;
  }
}

std::optional<std::size_t> budget(const json& request, const char* key) {
  if (!request.contains(key)) return std::nullopt;
  if (!request[key].is_number_unsigned()) reject(std::string(key) + " as a count");
  return request[key].get<std::size_t>();
}

std::optional<bool> flag(const json& request, const char* key) {
  if (!request.contains(key)) return std::nullopt;
  if (!request[key].is_boolean()) reject(std::string(key) + " as true or false");
  return request[key].get<bool>();
}

std::vector<ClaimCode> claims(const json& names) {
  if (!names.is_array()) reject("claims as an array of names");
  std::vector<ClaimCode> codes;
  for (const json& name : names) {
    const auto code = name.is_string() ? claim_of_name(name.get<std::string>()) : std::nullopt;
    if (!code) reject("the name of a claim, found " + in_quotes(name.dump()));
    codes.push_back(*code);
  }
  return codes;
}

VerifyRequest questions(const json& request) {
  VerifyRequest asked;
  if (request.contains("claims")) asked.claims = claims(request["claims"]);
  asked.inner = flag(request, "inner").value_or(false);
  asked.tightness = flag(request, "tightness").value_or(false);
  if (request.contains("tolerance")) {
    const json& tolerance = request["tolerance"];
    if (!tolerance.is_string()) reject("the tolerance as a string, such as \"1e-9d\"");
    asked.tolerance = parse_tolerance(tolerance.get_ref<const std::string&>());
  }
  if (const auto exact = flag(request, "exact_facets")) {
    asked.exact_facets = *exact;
    if (!request.contains("max_facets")) reject("exact_facets with max_facets only");
  }
  asked.max_facets = budget(request, "max_facets");
  asked.max_vertices = budget(request, "max_vertices");
  asked.max_facet_vertices = budget(request, "max_facet_vertices");
  return asked;
}

// The same questions to parts, and how many there may be.
PartsRequest questions_to_parts(const json& request) {
  const VerifyRequest each = questions(request);
  if (each.inner) reject("inner with a single solid only");
  PartsRequest asked;
  asked.claims = each.claims;
  asked.tolerance = each.tolerance;
  asked.max_parts = budget(request, "max_parts");
  asked.max_facets = each.max_facets;
  asked.max_vertices = each.max_vertices;
  asked.max_facet_vertices = each.max_facet_vertices;
  asked.exact_facets = each.exact_facets;
  asked.measures = each.tightness;
  return asked;
}

Decimal decimal_of(const json& request) {
  const json name = request.value("decimal", json("nearest"));
  if (name != "nearest" && name != "exact") reject("decimal as nearest or exact");
  const json numbers = request.value("numbers", json("binary64"));
  if (numbers != "binary64" && numbers != "binary32") reject("numbers as binary64 or binary32");
  if (numbers == "binary64") return name == "exact" ? Decimal::Exact : Decimal::Nearest;
  if (name == "exact") reject("decimals as nearest with numbers in binary32");
  return Decimal::Nearest32;
}

// The shorter one of the limits of the caller and of the request.
std::optional<double> time_limit_of(const json& request, std::optional<double> limit) {
  constexpr double kLongest = 1e6;
  if (!request.contains("time_limit")) return limit;
  const json& seconds = request["time_limit"];
  if (!seconds.is_number() || !(seconds > 0) || seconds > kLongest) {
    reject("time_limit as a number of seconds, more than 0 and at most a million");
  }
  return std::min(seconds.get<double>(), limit.value_or(kLongest));
}

// Sets a flag when some seconds are over, unless it is destroyed before.
class TimeLimit {
 public:
  explicit TimeLimit(std::optional<double> seconds) {
    if (!seconds) return;
    waiter_ = std::thread([this, time = std::chrono::duration<double>(*seconds)] {
      std::unique_lock lock(mutex_);
      is_over_ = !ended_.wait_for(lock, time, [this] { return has_ended_; });
    });
  }
  ~TimeLimit() {
    if (!waiter_.joinable()) return;
    {
      const std::lock_guard lock(mutex_);
      has_ended_ = true;
    }
    ended_.notify_one();
    waiter_.join();
  }
  TimeLimit(const TimeLimit&) = delete;

  const std::atomic<bool>& is_over() const { return is_over_; }

 private:
  std::mutex mutex_;  // of has_ended_
  std::condition_variable ended_;
  bool has_ended_ = false;
  std::atomic<bool> is_over_ = false;
  std::thread waiter_;
};

// What `decide` answers, given the flag that stops it.
template <class Decide>
auto in_time(std::optional<double> seconds, const Decide& decide) {
  const TimeLimit limit(seconds);
  try {
    return decide(&limit.is_over());
  } catch (const Error& error) {
    if (error.code() != ErrorCode::Stopped) throw;
    throw Error(ErrorCode::Stopped,
                fmt::format("no verdict within the time limit of {} s", seconds.value()));
  }
}

ordered_json answer_about_parts(const json& request, PointSet points, Decimal decimal,
                                std::optional<double> seconds) {
  PartsRequest asked = questions_to_parts(request);
  Mesh input{std::move(points), {}, {}};
  if (request.contains("triangles")) {
    input.polygons = polygons_of_json(request["triangles"], input.points.size());
  }
  const CandidateParts parts = candidate_parts(request["candidate"], decimal);
  PartsVerdict verdict = in_time(seconds, [&](const std::atomic<bool>* stop) {
    asked.watch.stop = stop;
    return verify_parts(input, parts, asked);
  });
  ordered_json json = parts_verdict_json(verdict);
  std::erase_if(json["claims"].get_ref<ordered_json::array_t&>(),
                [](const ordered_json& claim) { return claim["status"] == "not-asked"; });
  return json;
}

ordered_json answer(const json& request, std::optional<double> time_limit) {
  require_known_keys(request,
                     {"id", "points", "candidate", "claims", "tolerance", "tightness", "decimal",
                      "numbers", "max_facets", "max_vertices", "max_facet_vertices", "exact_facets",
                      "inner", "time_limit", "triangles", "max_parts"},
                     "the request");
  if (request.contains("id") && request["id"].is_structured()) {
    reject("an id that is a number, a string, true, false or null");
  }
  if (!request.contains("points") || !request.contains("candidate")) {
    reject("a request with 'points' and 'candidate'");
  }
  const Decimal decimal = decimal_of(request);
  VerifyRequest asked = questions(request);
  PointSet input = points_of_json(request["points"], "point",
                                  [&](const json& x) { return coordinate_of_json(x, decimal); });
  const std::optional<double> seconds = time_limit_of(request, time_limit);
  if (request["candidate"].is_object() && request["candidate"].contains("parts")) {
    return answer_about_parts(request, std::move(input), decimal, seconds);
  }
  for (const char* key : {"triangles", "max_parts"}) {
    if (request.contains(key)) reject(std::string(key) + " with a candidate that has 'parts' only");
  }
  const Candidate judged = candidate(request["candidate"], decimal);
  VerifyOutcome outcome = in_time(seconds, [&](const std::atomic<bool>* stop) {
    asked.watch.stop = stop;
    return verify(input, judged, asked);
  });
  if (auto* verdict = std::get_if<Verdict>(&outcome)) {
    std::erase_if(verdict->claims, [](const Claim& c) { return c.status == Status::NotAsked; });
    return verdict_json(*verdict);
  }
  const auto& reason = std::get<NotSolid>(outcome);
  ordered_json error = error_json(Error(ErrorCode::NoInterior, describe(reason)));
  error["proof"] = proof_json(reason);
  return {{"error", error}};
}

// The id of a request as it goes into the answer: a number as spelled, and empty if there is none.
std::string id_text(const json& request) {
  if (!request.is_object() || !request.contains("id")) return {};
  const json& id = request["id"];
  if (id.is_structured()) return {};
  return id.is_binary() ? std::string(spelling_of(id)) : id.dump();
}

// Invalid UTF-8 in a message is replaced, so that a line is always JSON.
std::string one_line(const json& request, const ordered_json& body) {
  const std::string line = write_json(body);
  const std::string id = id_text(request);
  return id.empty() ? line : "{\"id\":" + id + "," + line.substr(1);
}

}  // namespace

std::string answer_request(std::string_view line, std::optional<double> time_limit) {
  JsonDocument reader({"id", "points", "planes", "vertices"});
  const auto failure = [&](const Error& error) {
    return one_line(reader.document, {{"error", error_json(error)}});
  };
  try {
    parse_json_events(line, reader);
  } catch (const Error& error) {
    return failure(Error(error.code(), std::string("not a request: ") + error.what()));
  }
  try {
    return one_line(reader.document, answer(reader.document, time_limit));
  } catch (const Error& error) {
    return failure(error);
  }
}

}  // namespace convexact
