// SPDX-License-Identifier: MIT
#include "wire/removal_order_file.hpp"

#include <charconv>
#include <nlohmann/json.hpp>
#include <utility>

#include "convexact/error.hpp"
#include "io/halfspace_formats.hpp"
#include "io/json_text.hpp"
#include "io/text_cursor.hpp"
#include "number/text.hpp"
#include "oracle/order/facet_match.hpp"
#include "simplify/cost_reader.hpp"
#include "simplify/run_names.hpp"
#include "wire/field.hpp"
#include "wire/trace_json.hpp"

namespace convexact {
namespace {

using nlohmann::json;

constexpr TextRules kRowRules{.comment = '#'};

ListedFacets by_row(const HalfspaceList& list) {
  ListedFacets facets(list.row_count());
  for (std::size_t k = 0; k < list.rows.size(); ++k) {
    facets[list.rows[k]] = list.halfspaces[k];
  }
  return facets;
}

void set_facets(RemovalOrder& order, const std::optional<ListedFacets>& facets,
                std::span<const Halfspace> canonical) {
  order.facets = facets ? *facets : ListedFacets(canonical.begin(), canonical.end());
  order.has_list = facets.has_value();
}

void require_no_list(const std::optional<ListedFacets>& facets) {
  if (facets) {
    throw Error(ErrorCode::InvalidArgument,
                "a facet list is for ids, and this trace spells out its planes");
  }
}

HalfspaceId facet_of(std::uint64_t number) {
  return number < kNoFacet.value ? HalfspaceId(number) : kNoFacet;
}

// Reads the steps of a document; `place_` is the reader's place in it, for messages.
class StepReader {
 public:
  explicit StepReader(std::optional<CostMeasure> asked) : asked_(asked) {}
  void read(const json& document, RemovalOrder& order);
  const std::string& place() const { return place_; }

 private:
  [[noreturn]] void reject(const std::string& expected) const {
    throw Error(ErrorCode::Malformed, place_ + ": expected " + expected);
  }
  HalfspaceId facet(const json& number) const;
  void read_claims(const json& step, CostMeasure measure, OrderedStep& ordered) const;
  std::optional<Cost> claimed_cost(const json& cost, CostMeasure measure) const;
  std::vector<HalfspaceId> facets(const json& object, const char* key) const;
  void read_moves(const json& list, RemovalOrder& order);
  CostMeasure measure_of(const json& document) const;
  StopReason stop_reason(const json& name) const;

  const std::optional<CostMeasure> asked_;
  bool states_measure_ = false;
  std::string place_ = "trace";
};

HalfspaceId StepReader::facet(const json& number) const {
  if (number.is_number_unsigned()) return facet_of(number.get<std::uint64_t>());
  if (!number.is_number_integer()) reject("the index of a halfspace");
  return kNoFacet;
}

// A cost of another measure than the order's shows that the order is not the kind that it is taken
// for.
std::optional<Cost> StepReader::claimed_cost(const json& cost, CostMeasure measure) const {
  for (const auto& [spelled, key] :
       {std::pair(CostMeasure::Volume, "exact"), std::pair(CostMeasure::Area, "roots"),
        std::pair(CostMeasure::MeanWidth, "edges")}) {
    if (spelled == measure || !cost.contains(key)) continue;
    if (states_measure_) reject(std::string("a cost by ") + name_of(measure) + ", found " + key);
    throw Error(ErrorCode::InvalidArgument, place_ + " states a cost by " + name_of(spelled) +
                                                ", and the order is judged by " + name_of(measure));
  }
  try {
    return cost_in_json(cost, measure);
  } catch (const Error& error) {
    throw Error(ErrorCode::Malformed, place_ + ": " + error.what());
  }
}

void StepReader::read_claims(const json& step, CostMeasure measure, OrderedStep& ordered) const {
  if (step.contains("cost") && step["cost"].is_object()) {
    ordered.step.cost = claimed_cost(step["cost"], measure);
  }
  if (step.contains("tie")) {
    if (!step["tie"].is_array()) reject("the tie as an array");
    ordered.claims_tie = true;
    for (const json& number : step["tie"]) ordered.step.tie.push_back(facet(number));
  }
  if (step.contains("left")) {
    if (!step["left"].is_number_unsigned()) reject("how many are left");
    ordered.claims_left = true;
    ordered.step.left = narrowed<std::size_t>(step["left"].get<std::uint64_t>());
  }
}

StopReason StepReader::stop_reason(const json& name) const {
  if (name.is_string()) {
    if (const auto reason = value_in(kStopReasonNames, name.get<std::string>())) return *reason;
  }
  reject("reached, growth-limit, all-unbounded or all-kept-or-unbounded");
}

std::vector<HalfspaceId> StepReader::facets(const json& object, const char* key) const {
  if (!object.contains(key) || !object[key].is_array()) reject("an array of ids");
  std::vector<HalfspaceId> ids;
  for (const json& number : object[key]) ids.push_back(facet(number));
  return ids;
}

void StepReader::read_moves(const json& list, RemovalOrder& order) {
  if (!list.is_array()) reject("an array");
  for (const json& move : list) {
    place_ = "move " + std::to_string(order.moves.size() + 1);
    if (!move.is_object()) reject("an object with 'removed' and 'inserted'");
    Move& ordered = order.moves.emplace_back();
    ordered.removed = facets(move, "removed");
    ordered.inserted = facets(move, "inserted");
    if (move.contains("measure") && move["measure"].is_object()) {
      ordered.measure = claimed_cost(move["measure"], order.measure);
    }
  }
}

CostMeasure StepReader::measure_of(const json& document) const {
  if (!document.contains("measure")) return asked_.value_or(CostMeasure::Volume);
  const json& name = document["measure"];
  const auto measure = name.is_string()
                           ? value_in(kCostMeasureNames, name.get_ref<const std::string&>())
                           : std::nullopt;
  if (!measure) reject("volume, area or mean-width");
  if (!asked_ || *measure == *asked_) return *measure;
  throw Error(ErrorCode::InvalidArgument, std::string("the trace is by ") + name_of(*measure) +
                                              ", so it cannot be judged by " + name_of(*asked_));
}

void StepReader::read(const json& document, RemovalOrder& order) {
  if (!document.is_object() || !document.contains("steps") || !document["steps"].is_array()) {
    reject("an object with an array 'steps'");
  }
  place_ = "measure";
  order.measure = measure_of(document);
  states_measure_ = document.contains("measure");
  for (const json& step : document["steps"]) {
    const std::size_t row = order.steps.size() + 1;
    place_ = "step " + std::to_string(row);
    if (!step.is_object() || !step.contains("removed")) reject("an object with 'removed'");
    const json& removed = step["removed"];
    OrderedStep& ordered = order.steps.emplace_back();
    ordered.row = row;
    ordered.text = "the id " + in_quotes(dump_json(removed));
    ordered.step.removed = facet(removed);
    read_claims(step, order.measure, ordered);
  }
  place_ = "stop";
  if (document.contains("stop")) order.stop = stop_reason(document["stop"]);
  place_ = "kept";
  if (document.contains("kept")) order.kept = facets(document, "kept");
  place_ = "moves";
  if (document.contains("moves")) read_moves(document["moves"], order);
}

RemovalOrder read_json_order(std::string_view bytes, const std::optional<ListedFacets>& facets,
                             std::span<const Halfspace> canonical, Decimal decimal,
                             std::optional<CostMeasure> measure) {
  const json document = parse_json(bytes);
  RemovalOrder order;
  StepReader reader(measure);
  try {
    reader.read(document, order);
  } catch (const json::exception&) {  // invalid UTF-8 in a message, say
    throw Error(ErrorCode::Malformed, reader.place() + ": not as in trace.schema.json");
  }
  if (document.contains("halfspaces")) {
    require_no_list(facets);
    order.facets = by_row(read_halfspaces_json(bytes, decimal));
    order.has_list = true;
  } else {
    set_facets(order, facets, canonical);
  }
  return order;
}

RemovalOrder read_planes(std::string_view bytes, Decimal decimal) {
  RemovalOrder order;
  order.facets = by_row(read_halfspace_rows(bytes, decimal));
  for (std::size_t k = 0; k < order.facets.size(); ++k) {
    const auto& plane = order.facets[k];
    order.steps.push_back(
        {k + 1, plane ? plane_in_words(*plane) : "a plane with normal 0", {HalfspaceId(k)}});
  }
  return order;
}

// An integer of any length and sign.
HalfspaceId id_of(std::string_view token, const TextCursor& cursor) {
  std::string_view digits = token;
  const bool is_negative = digits.front() == '-';
  if (is_negative || digits.front() == '+') digits.remove_prefix(1);
  if (digits.empty() || digits.find_first_not_of("0123456789") != std::string_view::npos) {
    cursor.fail_expected("a facet id, or a plane n1 n2 n3 d", token);
  }
  std::uint64_t value = 0;
  const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool is_too_large = parsed.ec != std::errc();
  return is_too_large || (is_negative && value != 0) ? kNoFacet : facet_of(value);
}

RemovalOrder read_ids(std::string_view bytes) {
  TextCursor cursor(bytes, kRowRules);
  RemovalOrder order;
  while (cursor.next_line()) {
    const std::string_view token = cursor.token();
    order.steps.push_back(
        {order.steps.size() + 1, "the id " + in_quotes(token), {id_of(token, cursor)}});
    cursor.expect_line_end();
  }
  return order;
}

std::size_t numbers_in_first_row(std::string_view bytes) {
  TextCursor cursor(bytes, kRowRules);
  if (!cursor.next_line()) throw Error(ErrorCode::Malformed, "expected removals, found nothing");
  std::size_t count = 0;
  while (!cursor.token().empty()) ++count;
  return count;
}

RemovalOrder read_text_order(std::string_view bytes, const std::optional<ListedFacets>& facets,
                             std::span<const Halfspace> canonical, Decimal decimal) {
  if (numbers_in_first_row(bytes) == 4) {
    require_no_list(facets);
    return read_planes(bytes, decimal);
  }
  RemovalOrder order = read_ids(bytes);
  set_facets(order, facets, canonical);
  return order;
}

}  // namespace

ListedFacets read_facet_list(std::string_view bytes, const std::string& path, Decimal decimal) {
  std::optional<HalfspaceFormat> format = halfspace_format_of_path(path);
  if (!format) format = halfspace_format_of_content(bytes);
  if (!format) throw Error(ErrorCode::Malformed, "expected a list of halfspaces");
  return by_row(read_halfspaces_bytes(bytes, *format, decimal));
}

RemovalOrder read_removal_order(std::string_view bytes, const std::optional<ListedFacets>& facets,
                                std::span<const Halfspace> canonical, Decimal decimal,
                                std::optional<CostMeasure> measure) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  const bool is_json = first != std::string_view::npos && bytes[first] == '{';
  if (is_json) return read_json_order(bytes, facets, canonical, decimal, measure);
  RemovalOrder order = read_text_order(bytes, facets, canonical, decimal);
  order.measure = measure.value_or(CostMeasure::Volume);
  return order;
}

}  // namespace convexact
