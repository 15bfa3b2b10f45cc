// SPDX-License-Identifier: MIT
#include "wire/simplify_options.hpp"

#include <algorithm>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "number/text.hpp"
#include "simplify/run_names.hpp"

namespace convexact {
namespace {

constexpr std::uint64_t kMost = std::uint64_t(1) << 32;

// A field of a member of the request, as a field of the request.
template <class Request, class Part>
Field<Request> within(Part Request::*part, Field<Part> field) {
  return {static_cast<const FieldInfo&>(field),
          [part, read = field.read](Request& request, const auto& option, const auto& text) {
            read(request.*part, option, text);
          },
          [part, write = field.write](const Request& request) { return write(request.*part); }};
}

std::string spell_share(const std::optional<Rational>& share) {
  return share ? to_string(*share) : "";
}

std::string spell_center(const std::optional<RationalPoint>& center) {
  if (!center) return "chebyshev";
  return to_string((*center)[0]) + "," + to_string((*center)[1]) + "," + to_string((*center)[2]);
}

template <class Request>
Field<Request> verify_field() {
  return choice_field<Request>("verify", &Request::verify, kVerifyLevelNames,
                               "how much of each step is proven again");
}

template <class Request>
Field<Request> engine_field() {
  return choice_field<Request>(
      "engine", &Request::engine, kEngineNames,
      "rationals everywhere; the same answer, faster; or doubles that choose, the result still "
      "proven");
}

template <class Request>
Field<Request> threads_field() {
  return jobs_field<Request>(
      "threads, by default as many as there are cores; no result depends on them");
}

Fields<SimplifyRequest> make_simplify_fields() {
  using R = SimplifyRequest;
  Fields<R> fields = {
      count_field<R>("faces", &R::faces, {4, kMost}, "how many halfspaces to keep, at least 4"),
      text_field<R>("max_growth", &R::max_growth, parse_share, spell_share,
                    "stop before the measure of --cost grows by more, e.g. 5% or 0.05"),
      choice_field<R>("growth_of", &R::growth_of, kCostMeasureNames,
                      "what --max-growth limits, if not the measure of --cost"),
      choice_field<R>("cost", &R::cost, kCostMeasureNames,
                      "the measure to which each removal adds the least: for fewer false hits of "
                      "points, of rays, or of planes"),
      within(&R::compare,
             count_field<CompareLimits>("tie_bits", &CompareLimits::bits, kTieBits,
                                        "mean widths that neither this many bits nor a proof can "
                                        "order count as equal; the result says so")),
      engine_field<R>(),
      within(&R::search,
             choice_field<SearchRequest>(
                 "search", &SearchRequest::kind, kSearchKindNames,
                 "after the removals, exchange kept halfspaces for facets next to them as long as "
                 "the solid shrinks; local tries random exchanges, too; optimal then tries all "
                 "other choices, and proves the volume the least (for hulls of up to about 40 "
                 "facets)")),
      within(&R::search, count_field<SearchRequest>("moves", &SearchRequest::kicks, {0, kMost},
                                                    "with --search local or optimal: how many "
                                                    "random exchanges are tried")),
      within(&R::search,
             count_field<SearchRequest>(
                 "nodes", &SearchRequest::nodes, {1, std::uint64_t(1) << 48},
                 "with --search optimal: how many states are looked at before it ends without a "
                 "proof, as an interrupt ends it")),
      verify_field<R>(),
      text_field<R>(
          "center", &R::center, parse_center, spell_center,
          "center of the polar dual: chebyshev, or X,Y,Z strictly inside; the answer does not "
          "depend on it"),
      threads_field<R>()};
  fields[0].letter = 'k';
  return fields;
}

// The most vertices of which a hull has no more triangles than this: v vertices have up to 2 v - 4.
std::size_t vertices_of_triangles(const std::string& option, const std::string& text) {
  return narrowed<std::size_t>(parse_count(option, text, {4, kMost}) / 2 + 2);
}

Fields<InnerRequest> make_inner_fields() {
  using R = InnerRequest;
  return {count_field<R>("vertices", &R::vertices, {4, kMost},
                         "with --inner: how many vertices to keep; or --faces, at most so many "
                         "triangles"),
          text_field<R>(
              "faces", &R::vertices, vertices_of_triangles,
              [](const std::optional<std::size_t>&) { return ""; }, "at most so many triangles"),
          text_field<R>("max_loss", &R::max_loss, parse_share, spell_share,
                        "with --inner: stop before more of the volume is lost, e.g. 5% or 0.05"),
          engine_field<R>(),
          verify_field<R>(),
          threads_field<R>()};
}

// Whether the option has the value that it has where it is not given.
bool is_usual(const FieldInfo& info, const std::string& text) {
  return std::any_of(simplify_fields().begin(), simplify_fields().end(), [&](const auto& field) {
    if (field.name != info.name) return false;
    SimplifyRequest given;
    field.read(given, field.name, text);
    return field.write(given) == field.write(SimplifyRequest{});
  });
}

}  // namespace

const Fields<SimplifyRequest>& simplify_fields() {
  static const Fields<SimplifyRequest> fields = make_simplify_fields();
  return fields;
}

const Fields<SimplifyRequest>& simplify_call_fields() {
  static const Fields<SimplifyRequest> fields = [] {
    Fields<SimplifyRequest> all = simplify_fields();
    all.push_back(
        count_field<SimplifyRequest>("seed", &SimplifyRequest::seed, {}, "of every random order"));
    return all;
  }();
  return fields;
}

const Fields<InnerRequest>& inner_fields() {
  static const Fields<InnerRequest> fields = make_inner_fields();
  return fields;
}

const std::vector<std::string_view>& fields_of_inner_runs() {
  static const std::vector<std::string_view> names = {"vertices", "max_loss"};
  return names;
}

SimplifyRequest simplify_request(const GivenFields& given) {
  SimplifyRequest request;
  given.apply_to(request, simplify_call_fields());
  const SearchKind search = request.search.kind;
  if (given.has("moves") && search != SearchKind::Local && search != SearchKind::Optimal) {
    reject_argument(
        "--moves counts the kicks of a local search: give --search local or optimal as well");
  }
  if (given.has("nodes") && search != SearchKind::Optimal) {
    reject_argument(
        "--nodes limits the search for the least volume: give --search optimal as well");
  }
  if (given.has("growth_of") && !request.max_growth) {
    reject_argument("--growth-of says what --max-growth limits: give --max-growth as well");
  }
  return request;
}

InnerRequest inner_request(const GivenFields& given) {
  for (const auto& [info, text] : given.all()) {
    const bool is_known =
        std::any_of(inner_fields().begin(), inner_fields().end(),
                    [&, known = info](const auto& field) { return field.name == known->name; });
    if (is_known || is_usual(*info, text)) continue;
    reject_argument(option_of(*info) + " does not apply to an inner run (--inner)");
  }
  if (given.has("vertices") && given.has("faces")) {
    reject_argument("--vertices and --faces: give one of them; n vertices have 2 n - 4 triangles");
  }
  InnerRequest request;
  given.apply_to(request, inner_fields());
  if (request.engine == Engine::Float) {
    reject_argument("--engine float: an inner run has the engines exact and filtered");
  }
  return request;
}

Rational parse_share(const std::string& option, const std::string& text) {
  const bool percent = text.ends_with('%');
  try {
    const Rational share = parse_rational(text.substr(0, text.size() - (percent ? 1 : 0)));
    if (share >= 0) return percent ? Rational(share / 100) : share;
  } catch (const Error&) {  // told below
  }
  reject_argument(option + ": expected a share such as 5% or 0.05, found " + in_quotes(text));
}

std::optional<RationalPoint> parse_center(const std::string& option, const std::string& text) {
  if (text == "chebyshev") return std::nullopt;
  const std::vector<std::string> words = words_of(text);
  if (words.size() == 3) {
    try {
      return RationalPoint(parse_rational(words[0]), parse_rational(words[1]),
                           parse_rational(words[2]));
    } catch (const Error&) {  // told below
    }
  }
  reject_argument(option + ": expected chebyshev or three numbers X,Y,Z, found '" + text + "'");
}

}  // namespace convexact
