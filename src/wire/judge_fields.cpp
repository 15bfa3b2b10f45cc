// SPDX-License-Identifier: MIT
#include "wire/judge_fields.hpp"

#include <fmt/format.h>

#include <sstream>

#include "convexact/error.hpp"
#include "io/used_points.hpp"
#include "number/text.hpp"
#include "simplify/run_names.hpp"
#include "wire/decompose_options.hpp"
#include "wire/verdict_report.hpp"

namespace convexact {
namespace {

template <class Request>
Fields<Request> make_budget_fields() {
  return {
      count_field<Request>("max_facets", &Request::max_facets, {},
                           "most facets; coplanar faces count as one, in a mesh also faces "
                           "that only rounding bent"),
      count_field<Request>("max_vertices", &Request::max_vertices, {}, "most corners of the solid"),
      count_field<Request>("max_facet_vertices", &Request::max_facet_vertices, {},
                           "most corners of a facet")};
}

Tolerance read_tolerance(const std::string&, const std::string& text) {
  return parse_tolerance(text);
}

// The options in front, then the budgets.
template <class Request>
Fields<Request> with_budgets(Fields<Request> fields) {
  for (Field<Request>& field : make_budget_fields<Request>()) fields.push_back(std::move(field));
  return fields;
}

template <class Request>
Field<Request> asks_field() {
  return choice_field<Request>("asks", &Request::asks, kAsksNames,
                               "what was to be written: an enclosure, the hull, a solid inside it, "
                               "or an enclosure of so many facets");
}

template <class Request>
Field<Request> tolerance_field() {
  return text_field<Request>(
      "tolerance", &Request::tolerance, read_tolerance, [](const Tolerance&) { return ""; },
      "let violations up to this distance pass: 1e-6, or 1e-9d of the diameter");
}

}  // namespace

Tolerance read_distance(const std::string& option, const std::string& text) {
  ConcavityLimit limit = parse_concavity(option, text);
  return {std::move(limit.value), limit.is_share};
}

const Fields<Budgets>& budget_fields() {
  static const Fields<Budgets> fields = make_budget_fields<Budgets>();
  return fields;
}

const Fields<Promise>& promise_fields() {
  static const Fields<Promise> fields = with_budgets<Promise>(
      {asks_field<Promise>(),
       flag_field<Promise>("allow_flat", &Promise::allow_flat,
                           "accepting points without volume is not a failure"),
       tolerance_field<Promise>(),
       choice_field<Promise>("numbers", &Promise::numbers, kPrecisionNames,
                             "the numbers of input and output are doubles, or each is rounded to "
                             "the nearest binary32 (default: binary64)")});
  return fields;
}

const Fields<VerifyRequest>& verify_fields() {
  using R = VerifyRequest;
  static const Fields<R> fields = with_budgets<R>(
      {asks_field<R>(), tolerance_field<R>(),
       flag_field<R>("exact_facets", &R::exact_facets,
                     "let --max-facets merge exactly coplanar faces only"),
       flag_field<R>("tightness", &R::tightness, "measure volume, area, mean width and distance"),
       choice_field<R>("judge_points", &R::points, kMeshPointsNames,
                       "of an input with faces, whether points that no face uses count")});
  return fields;
}

std::vector<ClaimCode> parse_claims(const std::string& option, const std::string& text) {
  std::vector<ClaimCode> claims;
  // A comma at the end, since a stream ends before an empty last word.
  std::istringstream words(text + ",");
  for (std::string word; std::getline(words, word, ',');) {
    if (const auto code = claim_of_name(word)) {
      claims.push_back(*code);
      continue;
    }
    std::vector<std::string> names;
    for (int known = 0; known <= static_cast<int>(ClaimCode::TreeNested); ++known) {
      names.emplace_back(name_of(static_cast<ClaimCode>(known)));
    }
    reject_argument(fmt::format("{}: expected names out of {}; found {}", option,
                                fmt::join(names, ", "), in_quotes(word)));
  }
  return claims;
}

const Fields<VerifyRequest>& verify_call_fields() {
  using R = VerifyRequest;
  static const Fields<R> fields = [] {
    Fields<R> all = verify_fields();
    all.push_back(text_field<R>(
        "claims", &R::claims, parse_claims, [](const std::vector<ClaimCode>&) { return ""; },
        "decide these claims only, separated by commas"));
    return all;
  }();
  return fields;
}

const Fields<PartsRequest>& parts_fields() {
  using R = PartsRequest;
  static const Fields<R> fields = {
      text_field<R>(
          "distance", &R::distance, read_distance,
          [](const std::optional<Tolerance>&) { return ""; },
          "decide whether no point of a part is farther than this from the solid of "
          "INPUT, and whether they hold it: 3% or 0.03d of the diameter, or a length"),
      count_field<R>("max_parts", &R::max_parts, {},
                     "the largest number of parts; the other budgets apply to each part"),
      choice_field<R>("close", &R::close, kCloseNames,
                      "judge INPUT with caps over borders of at most a quarter of the diameter, if "
                      "they close it, or as it is (default: never)"),
      choice_field<R>("orient", &R::orient, kOrientationNames,
                      "turn faces of INPUT so that they bound its solid correctly, or keep them as "
                      "they are (default: auto)"),
      flag_field<R>("exact_volumes", &R::exact_volumes,
                    "volumes in --json as fractions, too, which may be very long"),
      jobs_field<R>("threads, by default as many as there are cores; the verdict does not depend "
                    "on it")};
  return fields;
}

}  // namespace convexact
