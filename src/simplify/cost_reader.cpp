// SPDX-License-Identifier: MIT
#include "simplify/cost_reader.hpp"

#include <nlohmann/json.hpp>

#include "convexact/error.hpp"
#include "convexact/number.hpp"

namespace convexact {

using nlohmann::json;

namespace {

[[noreturn]] void reject(const char* expected) {
  throw Error(ErrorCode::Malformed, std::string("expected ") + expected);
}

// An entry of a term; `expected` describes the whole term.
Rational number_in(const json& entry, const char* expected) {
  if (!entry.is_string()) reject(expected);
  try {
    return parse_rational(entry.get_ref<const std::string&>());
  } catch (const Error&) {
    reject(expected);
  }
}

Integer integer_in(const json& entry, const char* expected) {
  const Rational x = number_in(entry, expected);
  if (denominator(x) != 1) reject(expected);
  return numerator(x);
}

RootSum roots_in(const json& list) {
  constexpr const char* kExpected = "the roots as [q, N] in strings, N > 0 an integer";
  if (!list.is_array()) reject(kExpected);
  std::vector<RootTerm> terms;
  for (const json& term : list) {
    if (!term.is_array() || term.size() != 2) reject(kExpected);
    terms.push_back({number_in(term[0], kExpected), integer_in(term[1], kExpected)});
    if (terms.back().radicand <= 0) reject(kExpected);
  }
  return RootSum(std::move(terms));
}

AngleSum edges_in(const json& list) {
  constexpr const char* kExpected =
      "the edges as [f, L, C, D] in strings, L, C >= 0, C and D integers that are not both 0";
  if (!list.is_array()) reject(kExpected);
  std::vector<AngleTerm> terms;
  for (const json& term : list) {
    if (!term.is_array() || term.size() != 4) reject(kExpected);
    const AngleTerm& edge = terms.emplace_back(
        AngleTerm{number_in(term[0], kExpected), number_in(term[1], kExpected),
                  integer_in(term[2], kExpected), integer_in(term[3], kExpected)});
    if (edge.squared_length < 0 || edge.squared_cross < 0 ||
        (edge.squared_cross == 0 && edge.dot == 0)) {
      reject(kExpected);
    }
  }
  return AngleSum(std::move(terms));
}

}  // namespace

std::optional<Cost> cost_in_json(const json& object, CostMeasure measure) {
  switch (measure) {
    case CostMeasure::Volume:
      if (!object.contains("exact")) return std::nullopt;
      if (!object["exact"].is_string()) reject("the exact cost as a string");
      return Cost(number_in(object["exact"], "the exact cost as p or p/q"));
    case CostMeasure::Area:
      if (!object.contains("roots")) return std::nullopt;
      return Cost(roots_in(object["roots"]));
    case CostMeasure::MeanWidth:
      break;
  }
  if (!object.contains("edges")) return std::nullopt;
  return Cost(edges_in(object["edges"]));
}

}  // namespace convexact
