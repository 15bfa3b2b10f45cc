// SPDX-License-Identifier: MIT
// convexact itself gives the expected answer of every conformance vector. Those answers come from
// make_vectors.py: closed forms, the definition in Python's fractions, and lrslib.
#include <doctest/doctest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "convexact/conform.hpp"
#include "convexact/io.hpp"
#include "convexact/simplify.hpp"
#include "convexact/verify.hpp"
#include "json_schema.hpp"
#include "process.hpp"
#include "sweep.hpp"
using namespace convexact;

namespace {

std::string folder() { return std::getenv("CONVEXACT_VECTORS"); }

const std::vector<TestVector>& vectors() {
  static const std::vector<TestVector> list = read_test_vectors(folder());
  return list;
}

Shape shape_of(const TestVector& vector) {
  if (const auto* points = std::get_if<PointSet>(&vector.input)) return *points;
  return std::get<HalfspaceList>(vector.input).halfspaces;
}

// Calls visit(vector, question) for every vector that asks this.
template <class Question, class Visit>
void for_each(Visit&& visit) {
  std::size_t count = 0;
  for (const TestVector& vector : vectors()) {
    const auto* question = std::get_if<Question>(&vector.question);
    if (question == nullptr) continue;
    CAPTURE(vector.id);
    visit(vector, *question);
    ++count;
  }
  CHECK(count > 50);
}

void check_run(const TestVector& vector, const SimplifyQuestion& question, Engine engine) {
  SimplifyRequest request;
  request.faces = question.faces;
  request.engine = engine;
  request.trace = request.exact_volumes = question.volume.has_value();
  const SimplifyOutcome outcome = simplify(shape_of(vector), request);
  REQUIRE(std::holds_alternative<SimplifyResult>(outcome));
  const auto& result = std::get<SimplifyResult>(outcome);
  CHECK(result.input_halfspaces - result.steps == question.facets);
  CHECK((result.stop == StopReason::Reached) == question.reached);
  if (!question.volume) return;
  CHECK(result.output_volume.exact == question.volume);
  REQUIRE(result.run.has_value());
  const Run& trace = *result.run;
  REQUIRE(trace.steps.size() == question.costs.size());
  for (std::size_t i = 0; i < trace.steps.size(); ++i) {
    CAPTURE(i);
    const Step& step = trace.steps[i];
    CHECK(step.cost == question.costs[i]);
    const std::vector<Halfspace>& tie = question.ties[i];
    REQUIRE(step.tie.size() == std::max<std::size_t>(tie.size(), 1));
    for (std::size_t k = 0; k < tie.size(); ++k) {
      CHECK(trace.halfspaces[step.tie[k].index()] == tie[k]);
    }
  }
}

std::optional<ErrorCode> refusal(const RawFile& file) {
  const std::string name = "a." + file.extension;
  try {
    if (const auto format = halfspace_format_of_path(name)) {
      (void)read_halfspaces_bytes(file.bytes, *format);
    } else {
      (void)read_mesh_bytes(file.bytes, {.format = mesh_format_of_path(name)});
    }
  } catch (const Error& error) {
    return error.code();
  }
  return std::nullopt;
}

}  // namespace

TEST_CASE("vectors: hulls have the counts and the volume that are known") {
  for_each<HullQuestion>([](const TestVector& vector, const HullQuestion& question) {
    HullRequest request;
    request.exact_volume = true;
    const HullReport report = measure_hull(shape_of(vector), request);
    REQUIRE(std::holds_alternative<HullResult>(report));
    const auto& result = std::get<HullResult>(report);
    CHECK(result.solid.exact.planes.size() == question.facets);
    CHECK(result.solid.exact.vertices.size() == question.vertices);
    REQUIRE(result.volume);
    CHECK(result.volume->exact == question.volume);
  });
}

TEST_CASE("vectors: both exact engines remove at the known costs, with the known ties" * sweep) {
  for_each<SimplifyQuestion>([](const TestVector& vector, const SimplifyQuestion& question) {
    check_run(vector, question, Engine::Filtered);
    if (question.volume) check_run(vector, question, Engine::Exact);
  });
}

TEST_CASE("vectors: candidates get the known verdict, with the exact distance") {
  for_each<VerifyQuestion>([](const TestVector& vector, const VerifyQuestion& question) {
    VerifyRequest request;
    request.asks = question.inner ? Asks::Inner : Asks::Enclosure;
    request.exact_facets = true;  // budgets are counted by definition
    request.max_facets = question.max_facets;
    request.max_vertices = question.max_vertices;
    request.max_facet_vertices = question.max_facet_vertices;
    request.tightness = false;
    const VerifyOutcome outcome = verify(shape_of(vector), question.candidate, request);
    REQUIRE(std::holds_alternative<Verdict>(outcome));
    const auto& verdict = std::get<Verdict>(outcome);
    for (const auto& claim : question.claims) {
      const ClaimCode code = claim.first;  // Clang 14 captures no structured binding
      CAPTURE(std::string(name_of(code)));
      CAPTURE(verdict[code].sentence);
      CHECK(std::string(name_of(verdict[code].status)) == name_of(claim.second));
    }
    if (!question.outside) return;
    if (question.inner) {
      const std::optional<Rational>& beyond =
          verdict[ClaimCode::InsideInput].witness.squared_distance;
      CHECK(beyond.value_or(0) == question.outside->squared_distance);
      return;
    }
    REQUIRE(verdict.outside.has_value());
    CHECK(verdict.outside->points == question.outside->points);
    const std::optional<Rational>& distance =
        verdict[ClaimCode::ContainsInput].witness.squared_distance;
    CHECK(distance.value_or(0) == question.outside->squared_distance);
  });
}

TEST_CASE("vectors: unusable inputs are refused for the known reason") {
  for_each<RefuseQuestion>([](const TestVector& vector, const RefuseQuestion& question) {
    if (const auto* file = std::get_if<RawFile>(&vector.input)) {
      CHECK(refusal(*file) == question.error);
      return;
    }
    CHECK(question.error == ErrorCode::NoInterior);
    const auto* list = std::get_if<HalfspaceList>(&vector.input);
    if (list != nullptr && list->impossible_row) return;
    const HullReport report = measure_hull(shape_of(vector), {});
    REQUIRE(std::holds_alternative<NotSolid>(report));
    if (!question.dimension) return;
    const auto* flat = std::get_if<FlatInput>(&std::get<NotSolid>(report));
    REQUIRE(flat != nullptr);
    CHECK(flat->dimension == *question.dimension);
  });
}

TEST_CASE("vectors: every file is as the schema says; ids are unique and flags have pages") {
  std::set<std::string> ids;
  for (const auto& entry : std::filesystem::directory_iterator(folder())) {
    if (entry.path().extension() != ".json") continue;
    CAPTURE(entry.path().string());
    CHECK(schema_complaint("vector", nlohmann::json::parse(support::bytes_of(entry.path()))) == "");
  }
  std::map<std::string, int> flags;
  for (const TestVector& vector : vectors()) {
    CAPTURE(vector.id);
    CHECK(ids.insert(vector.id).second);
    for (const std::string& flag : vector.flags) ++flags[flag];
  }
  CHECK(ids.size() >= 300);
  const std::string page = support::bytes_of(std::getenv("CONVEXACT_FLAG_PAGE"));
  for (const auto& entry : flags) {
    CAPTURE(entry.first);
    CHECK(entry.second >= 10);
    const std::size_t begin = page.find("\n## " + entry.first + "\n");
    REQUIRE(begin != page.npos);
    CHECK(std::min(page.find("\n## ", begin + 1), page.size()) - begin > 200);
  }
}
