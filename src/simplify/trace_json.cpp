// SPDX-License-Identifier: MIT
#include "simplify/trace_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "io/json.hpp"
#include "io/json_text.hpp"

namespace convexact {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

ordered_json to_json(const Halfspace& halfspace) {
  const IntegerVector3& n = halfspace.normal();
  return {to_string(n[0]), to_string(n[1]), to_string(n[2]), to_string(halfspace.offset())};
}

ordered_json to_json(const std::vector<HalfspaceId>& ids) {
  ordered_json list = ordered_json::array();
  for (const HalfspaceId id : ids) list.push_back(id.value);
  return list;
}

ordered_json to_json(const Step& step) {
  ordered_json triangles = ordered_json::array();
  for (const auto& [a, b, c] : step.triangles) triangles.push_back({a.value, b.value, c.value});
  const Rational& cost = step.cost.value().rational();
  const double value = to_double(cost, Rounding::Nearest);
  return {{"removed", step.removed.value},
          {"cost",
           {{"value", std::isfinite(value) ? ordered_json(value) : ordered_json()},
            {"exact", to_string(cost)}}},
          {"tie", to_json(step.tie)},
          {"ring", to_json(step.ring)},
          {"triangles", std::move(triangles)},
          {"left", step.left}};
}

// Reads one document; `place_` is where in it the reader is, for messages.
class TraceReader {
 public:
  Run read(const json& document);
  const std::string& place() const { return place_; }

 private:
  [[noreturn]] void reject(const std::string& expected) const {
    throw Error(ErrorCode::Malformed, place_ + ": expected " + expected);
  }
  Integer integer(const json& text) const;
  Halfspace halfspace(const json& row) const;
  HalfspaceId id(const json& number) const;
  std::vector<HalfspaceId> ids(const json& list) const;
  Step step(const json& object) const;
  StopReason stop_reason(const std::string& name) const;
  void require_array(const json& value) const {
    if (!value.is_array()) reject("an array");
  }

  std::string place_ = "trace";
  std::size_t count_ = 0;  // of halfspaces
};

Integer TraceReader::integer(const json& text) const {
  const Rational value = parse_rational(text.get_ref<const std::string&>());
  if (denominator(value) != 1) reject("an integer as a string");
  return numerator(value);
}

Halfspace TraceReader::halfspace(const json& row) const {
  if (!row.is_array() || row.size() != 4) reject("four integers as strings");
  const IntegerVector3 normal(integer(row[0]), integer(row[1]), integer(row[2]));
  if (normal == IntegerVector3::Zero()) reject("a normal that is not zero");
  return {normal, integer(row[3])};
}

HalfspaceId TraceReader::id(const json& number) const {
  if (!number.is_number_unsigned() || number.get<std::uint64_t>() >= count_) {
    reject("the index of a halfspace, below " + std::to_string(count_));
  }
  return HalfspaceId(number.get<std::size_t>());
}

std::vector<HalfspaceId> TraceReader::ids(const json& list) const {
  require_array(list);
  std::vector<HalfspaceId> result;
  for (const json& number : list) result.push_back(id(number));
  return result;
}

Step TraceReader::step(const json& object) const {
  Step step;
  step.removed = id(object.at("removed"));
  step.cost = parse_rational(object.at("cost").at("exact").get_ref<const std::string&>());
  step.tie = ids(object.at("tie"));
  step.ring = ids(object.at("ring"));
  require_array(object.at("triangles"));
  for (const json& corners : object.at("triangles")) {
    const std::vector<HalfspaceId> abc = ids(corners);
    if (abc.size() != 3) reject("triangles of three indices");
    step.triangles.push_back({abc[0], abc[1], abc[2]});
  }
  if (!object.at("left").is_number_unsigned()) reject("how many are left");
  step.left = object.at("left").get<std::size_t>();
  return step;
}

StopReason TraceReader::stop_reason(const std::string& name) const {
  if (const auto reason = value_in(kStopReasonNames, name)) return *reason;
  reject("reached, growth-limit or all-unbounded");
}

Run TraceReader::read(const json& document) {
  Run run;
  const json& halfspaces = document.at("halfspaces");
  require_array(halfspaces);
  for (const json& row : halfspaces) {
    place_ = "halfspace " + std::to_string(run.halfspaces.size());
    run.halfspaces.push_back(halfspace(row));
  }
  count_ = run.halfspaces.size();
  place_ = "trace";
  const json& steps = document.at("steps");
  require_array(steps);
  for (const json& object : steps) {
    place_ = "step " + std::to_string(run.steps.size() + 1);
    run.steps.push_back(step(object));
  }
  place_ = "stop";
  run.stop = stop_reason(document.value<std::string>("stop", name_of(StopReason::Reached)));
  return run;
}

}  // namespace

std::string write_trace_json(const Run& run) {
  ordered_json halfspaces = ordered_json::array(), steps = ordered_json::array();
  for (const Halfspace& halfspace : run.halfspaces) halfspaces.push_back(to_json(halfspace));
  for (const Step& step : run.steps) steps.push_back(to_json(step));
  const ordered_json document = {{"halfspaces", std::move(halfspaces)},
                                 {"steps", std::move(steps)},
                                 {"stop", name_of(run.stop)}};
  return write_json(document) + "\n";
}

Run read_trace_json(std::string_view text) {
  TraceReader reader;
  try {
    return reader.read(parse_json(text));
  } catch (const json::exception& error) {
    // A key that is missing or a value of another kind; the text of the library names it.
    throw Error(ErrorCode::Malformed, reader.place() + ": " + error.what());
  }
}

}  // namespace convexact
