// SPDX-License-Identifier: MIT
// Removal orders as files: three kinds, and errors in each with their place.
#include "wire/removal_order_file.hpp"

#include <doctest/doctest.h>

#include "convexact/error.hpp"
#include "convexact/verify_order.hpp"
#include "expect_error.hpp"
#include "number/random.hpp"
#include "shapes/makers.hpp"
#include "simplify_points.hpp"
#include "sweep.hpp"
#include "wire/trace_json.hpp"

using namespace convexact;

namespace {

// Two parallel sides of a cube, in canonical order.
const std::vector<Halfspace> kCanonical = {Halfspace(IntegerVector3(-1, 0, 0), 0),
                                           Halfspace(IntegerVector3(1, 0, 0), -4)};

RemovalOrder read(const std::string& text, const std::optional<ListedFacets>& facets = {}) {
  return read_removal_order(text, facets, kCanonical);
}

Error refusal_of(const std::string& text) {
  return error_of([&] { return read(text); });
}

// Of many corruptions enough are read, and enough of these are wrong.
void corrupt_and_judge(const std::string& good, int repeats, const DualHull& solid,
                       const RationalPoint& center, Random& random) {
  int read_again = 0, violated = 0;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    std::string bytes = good;
    for (std::uint64_t k = uniform_below(random, 3) + 1; k > 0; --k) {
      const std::size_t at = uniform_below(random, bytes.size());
      // Mostly a digit for a digit: most other changes leave no JSON.
      const bool digit = bytes[at] >= '0' && bytes[at] <= '9' && random() % 8 != 0;
      bytes[at] = static_cast<char>(digit ? '0' + uniform_below(random, 10) : random() % 256);
    }
    CAPTURE(bytes);
    try {
      const RemovalOrder order = read_removal_order(bytes, {}, solid.halfspaces);
      const TraceVerdict verdict = judge_trace(solid, center, order);
      ++read_again;
      if (!verdict.holds()) ++violated;
    } catch (const Error& error) {
      const ErrorCode code = error.code();
      REQUIRE((code == ErrorCode::Malformed || code == ErrorCode::NotFinite ||
               code == ErrorCode::InvalidArgument));
    }
  }
  CHECK(read_again > repeats * 3 / 40);
  CHECK(violated > repeats / 40);
}

}  // namespace

TEST_CASE("removal order: ids refer to canonical order, or to the list that is given") {
  RemovalOrder order = read("# cheapest first\n\n1\n +0 # and the other\n");
  REQUIRE(order.steps.size() == 2);
  CHECK(order.steps[0].step.removed.index() == 1);
  CHECK(order.steps[0].row == 1);
  CHECK(order.steps[1].step.removed.index() == 0);
  CHECK(order.steps[1].row == 2);
  REQUIRE(order.facets.size() == 2);
  CHECK(order.facets[1] == kCanonical[1]);
  CHECK_FALSE(order.stop.has_value());

  order = read("1\r\n0", ListedFacets{kCanonical[1], std::nullopt, kCanonical[0]});
  CHECK(order.facets.size() == 3);
  CHECK(order.facets[0] == kCanonical[1]);
}

TEST_CASE("removal order: an id that is negative or too long names no facet") {
  const RemovalOrder order = read("-1\n99999999999999999999\n-0\n18446744073709551615\n");
  CHECK(order.steps[0].step.removed == kNoFacet);
  CHECK(order.steps[1].step.removed == kNoFacet);
  CHECK(order.steps[1].text == "the id '99999999999999999999'");
  CHECK(order.steps[2].step.removed.index() == 0);
  CHECK(order.steps[3].step.removed == kNoFacet);
}

TEST_CASE("removal order: rows of four numbers are planes, exact as spelled") {
  const RemovalOrder order = read("2 0 0 -8\n0 0 0 1\n-1/3 0 0 0\n0.1 0 0 -0.3\n");
  REQUIRE(order.facets.size() == 4);
  CHECK(order.facets[0] == kCanonical[1]);
  CHECK_FALSE(order.facets[1].has_value());
  CHECK(order.facets[2] == kCanonical[0]);
  const Halfspace third(IntegerVector3(1, 0, 0), -3);
  CHECK(order.facets[3] != third);  // thrice the double next to 0.1 is not the one next to 0.3
  CHECK(order.steps[3].step.removed.index() == 3);
  CHECK(order.steps[3].row == 4);
  CHECK(read_removal_order("0.1 0 0 -0.3", {}, kCanonical, Decimal::Exact).facets[0] == third);
}

TEST_CASE("removal order: a trace brings its planes and its claims") {
  const Run trace = simplify_points(shapes::cut_cube(3, 0.25));
  const RemovalOrder order = read(write_trace_json(trace));
  REQUIRE(order.steps.size() == trace.steps.size());
  CHECK(order.stop == trace.stop);
  for (std::size_t i = 0; i < trace.halfspaces.size(); ++i) {
    CHECK(order.facets[i] == trace.halfspaces[i]);
  }
  for (std::size_t s = 0; s < trace.steps.size(); ++s) {
    CHECK(order.steps[s].step.removed == trace.steps[s].removed);
    CHECK(order.steps[s].step.cost == trace.steps[s].cost);
    CHECK(order.steps[s].step.tie == trace.steps[s].tie);
    CHECK(order.steps[s].step.left == trace.steps[s].left);
    CHECK((order.steps[s].claims_tie && order.steps[s].claims_left));
  }
}

TEST_CASE("removal order: of a trace only what is removed is needed") {
  const RemovalOrder order =
      read(R"({"steps": [{"removed": 1, "cost": 0.5}, {"removed": -7}, {"removed": 9}]})");
  REQUIRE(order.steps.size() == 3);
  CHECK(order.facets.size() == 2);
  CHECK(order.steps[0].step.removed.index() == 1);
  CHECK_FALSE(order.steps[0].step.cost.has_value());  // a number is no exact claim
  CHECK_FALSE(order.steps[0].claims_tie);
  CHECK(order.steps[1].step.removed == kNoFacet);
  CHECK(order.steps[2].step.removed.index() == 9);
  CHECK(read(R"({"steps": [], "stop": "all-unbounded"})").stop == StopReason::AllUnbounded);
}

TEST_CASE("removal order: what makes no sense is malformed, with its place") {
  for (const char* text : {"",
                           "\n# nothing\n",
                           "1 2\n",
                           "1\n2 3\n",
                           "1.5\n",
                           "x\n",
                           "+\n",
                           "1 0 0 0\n1\n",
                           "1 0 0 x\n",
                           "[1, 2]",
                           "{",
                           R"({"steps": 3})",
                           R"({"steps": [3]})",
                           R"({"steps": [{}]})",
                           R"({"steps": [{"removed": "1"}]})",
                           R"({"steps": [{"removed": 1.5}]})",
                           R"({"steps": [{"removed": 1, "tie": 3}]})",
                           R"({"steps": [{"removed": 1, "left": -3}]})",
                           R"({"steps": [{"removed": 1, "cost": {"exact": 3}}]})",
                           R"({"steps": [{"removed": 1, "cost": {"exact": "1/0"}}]})",
                           R"({"steps": [], "stop": "bored"})",
                           R"({"steps": [], "halfspaces": [[1, 2]]})",
                           "{\"steps\": [{\"removed\": \"\xff\"}]}"}) {
    CAPTURE(text);
    CHECK(refusal_of(text).code() == ErrorCode::Malformed);
  }
  CHECK(refusal_of("1\n\n2 3\n").line() == 3);
  CHECK(refusal_of("1 0 0 0\n1e999 0 0 1\n").code() == ErrorCode::NotFinite);
  CHECK(refusal_of(R"({"steps": [{"removed": 1e999}]})").code() == ErrorCode::NotFinite);
  CHECK(std::string(refusal_of(R"({"steps": [{"removed": 1}, {}]})").what()).find("step 2") !=
        std::string::npos);
}

TEST_CASE("removal order: a facet list for planes that are spelled out is wrong usage") {
  const ListedFacets facets(kCanonical.begin(), kCanonical.end());
  for (const char* text : {"1 0 0 -4\n", R"({"steps": [], "halfspaces": [["1","0","0","-4"]]})"}) {
    try {
      (void)read(text, facets);
      FAIL("read without error");
    } catch (const Error& error) {
      CHECK(error.code() == ErrorCode::InvalidArgument);
    }
  }
}

TEST_CASE("facet list: every row counts, in each of the formats") {
  const ListedFacets rows = read_facet_list("0 0 0 0\n1 0 0 -4\n", "list");
  REQUIRE(rows.size() == 2);
  CHECK_FALSE(rows[0].has_value());
  CHECK(rows[1] == kCanonical[1]);
  CHECK(read_facet_list("[[0,0,0,0],[1,0,0,-4]]", "list.json") == rows);
  CHECK(read_facet_list("begin\n2 4 integer\n0 0 0 0\n4 -1 0 0\nend\n", "list.ine") == rows);
  CHECK_THROWS_AS((void)read_facet_list("what is this", "list"), Error);
}

TEST_CASE("removal order: the measure is the one that is asked for, or the trace's, or volume") {
  using Asked = std::optional<CostMeasure>;
  const auto read_by = [](const std::string& text, Asked asked) {
    return read_removal_order(text, {}, kCanonical, Decimal::Nearest, asked);
  };
  const auto trace = [](const std::string& measure) {
    return R"({"version": 2, "measure": )" + measure + R"(, "steps": []})";
  };
  for (const char* text : {"0\n", "1 0 0 -4\n", R"({"steps": [{"removed": 1}]})"}) {
    CHECK(read_by(text, {}).measure == CostMeasure::Volume);
    CHECK(read_by(text, CostMeasure::Area).measure == CostMeasure::Area);
    CHECK(read_by(text, CostMeasure::MeanWidth).measure == CostMeasure::MeanWidth);
  }
  CHECK(read_by(trace(R"("area")"), {}).measure == CostMeasure::Area);
  CHECK(read_by(trace(R"("area")"), CostMeasure::Area).measure == CostMeasure::Area);
  CHECK(read_by(trace(R"("mean-width")"), {}).measure == CostMeasure::MeanWidth);
  const auto code = [&](const std::string& text, Asked asked) {
    return error_of([&] { return read_by(text, asked); }).code();
  };
  CHECK(code(trace(R"("area")"), CostMeasure::Volume) == ErrorCode::InvalidArgument);
  CHECK(code(trace(R"("volume")"), CostMeasure::MeanWidth) == ErrorCode::InvalidArgument);
  CHECK(code(trace(R"("weight")"), {}) == ErrorCode::Malformed);
  CHECK(code(trace("7"), {}) == ErrorCode::Malformed);
}

TEST_CASE("removal order: costs are spelled as the measure has them") {
  const auto step = [](const std::string& measure, const std::string& cost) {
    const std::string named = measure.empty() ? "" : R"("measure": ")" + measure + R"(", )";
    return "{" + named + R"("steps": [{"removed": 1, "cost": {)" + cost + "}}]}";
  };
  const auto cost = [&](const std::string& measure, const std::string& text) {
    return read(step(measure, text)).steps.at(0).step.cost.value();
  };
  RootSum area(Rational(3, 8));
  area.add(Rational(-1, 8), 3);
  CHECK(cost("area", R"("value": 0.1, "roots": [["3/8", "1"], ["-1/8", "3"]])") == Cost(area));
  CHECK(compare(cost("mean-width", R"("edges": [["1", "4", "1", "0"]])"), Cost(AngleSum::pi(1)))
            .order == Order::Equal);
  CHECK_FALSE(read(step("area", R"("value": 0.1)")).steps[0].step.cost.has_value());
  const auto code = [&](const std::string& measure, const std::string& text) {
    return refusal_of(step(measure, text)).code();
  };
  for (const char* roots :
       {"3", "[3]", R"(["3"])", R"([["1"]])", R"([["1", "2", "3"]])", R"([["1", "0"]])",
        R"([["1", "-2"]])", R"([["1", "1/2"]])", R"([[1, "2"]])", R"([["x", "2"]])"}) {
    CAPTURE(roots);
    CHECK(code("area", R"("roots": )" + std::string(roots)) == ErrorCode::Malformed);
  }
  for (const char* edges : {"{}", R"([["1", "4", "1"]])", R"([["1", "-4", "1", "0"]])",
                            R"([["1", "4", "-1", "0"]])", R"([["1", "4", "0", "0"]])",
                            R"([["1", "4", "1/2", "0"]])", R"([["1", "4", "1", "1/2"]])"}) {
    CAPTURE(edges);
    CHECK(code("mean-width", R"("edges": )" + std::string(edges)) == ErrorCode::Malformed);
  }
  // A number of another kind: the trace contradicts itself, or was taken for another one.
  CHECK(code("area", R"("exact": "1/2")") == ErrorCode::Malformed);
  CHECK(code("mean-width", R"("roots": [])") == ErrorCode::Malformed);
  CHECK(code("", R"("roots": [["1", "2"]])") == ErrorCode::InvalidArgument);
}

TEST_CASE("removal order: a corrupted trace is read or refused, and judged without a failure" *
          sweep) {
  const DualHull solid = dual_of_doubles(shapes::cut_cube(5, 0.25));
  const RationalPoint center = center_of(solid);
  Random random(2604);
  for (const auto& [measure, repeats] :
       {std::pair(CostMeasure::Volume, 4000), std::pair(CostMeasure::Area, 600),
        std::pair(CostMeasure::MeanWidth, 600)}) {
    const std::string good =
        write_trace_json(simplify_points(shapes::cut_cube(5, 0.25), {.cost = measure}));
    corrupt_and_judge(good, repeats, solid, center, random);
  }
}
