// SPDX-License-Identifier: MIT
// The sweep and its judge. Correct engines pass on inputs of every kind. A run with one error,
// injected here, is reported as a fault of that run, for every kind of error.
#include "lab/stress/stress.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "convexact/error.hpp"
#include "json_schema.hpp"
#include "lab/stress/judge.hpp"
#include "lab/stress/stress_report.hpp"
#include "process.hpp"
#include "solid/solid.hpp"
#include "sweep.hpp"

using namespace convexact;

namespace {

std::vector<StressInput> inputs_at(const std::string& family, std::vector<double> values,
                                   std::uint32_t points = 10) {
  SweepOptions options;
  options.points = points;
  options.values = std::move(values);
  return inputs_of(stress_family(family), options);
}

// A handful of halfspaces, all judged by the definition too: with different costs, or four tied.
std::vector<StressInput> one_input() { return inputs_at("random-ball", {7}); }
std::vector<StressInput> tied_input() { return inputs_at("cut-cube", {4}); }

using Corruption = std::function<void(EngineAnswer&)>;

// The sweep of one input by one engine, which lies.
StressReport with_corrupted(Engine engine, const Corruption& corrupt,
                            const std::vector<StressInput>& input = one_input()) {
  StressRequest request;
  request.engines = {engine};
  request.answer = [&](const Shape& shape, const Question& question) {
    EngineAnswer answer = answer_of(shape, question);
    corrupt(answer);
    return answer;
  };
  return stress(input, request);
}

void check_caught(Engine engine, const Corruption& corrupt,
                  const std::vector<StressInput>& input = one_input()) {
  const StressReport report = with_corrupted(engine, corrupt, input);
  REQUIRE(report.runs.size() == 1);
  CHECK_FALSE(report.passes());
  CHECK_FALSE(report.runs[0].passes());
  CHECK(schema_complaint("stress", nlohmann::json::parse(write_json(stress_json(report)))) == "");
  CHECK(stress_table(report).find(" NO\n") != std::string::npos);
  CHECK(stress_table(report).find(report.runs[0].faults[0]) != std::string::npos);
}

// As if the run without a record, where there is one, had made the same removals.
void make_lean_removals_equal(EngineAnswer& a) {
  for (std::size_t s = 0; s < a.lean.size(); ++s) a.lean[s].removed = a.run.steps[s].removed;
}

void check_caught_of_both(const Corruption& corrupt,
                          const std::vector<StressInput>& input = one_input()) {
  check_caught(Engine::Exact, corrupt, input);
  check_caught(Engine::Filtered, corrupt, input);
}

}  // namespace

TEST_CASE("stress: honest engines pass on inputs of every kind" * sweep) {
  std::vector<StressInput> inputs = one_input();
  for (const auto& more :
       {tied_input(), inputs_at("needle", {1, 1e300}), inputs_at("slab", {1e17}),
        inputs_at("subnormal", {3}), inputs_at("tilted-lid", {0x1p-52}),
        inputs_at("scaled-ball", {1000, -1000}), inputs_at("prism", {12}),
        inputs_at("collinear", {5}), inputs_at("mixture", {2}),
        inputs_at("mixed-halfspaces", {1, 2}), inputs_at("mixed-scales", {300}, 6)}) {
    inputs.insert(inputs.end(), more.begin(), more.end());
  }
  const StressReport report = stress(inputs, {});
  REQUIRE(report.runs.size() == 3 * inputs.size());
  for (std::size_t i = 0; i < report.runs.size(); ++i) {
    const StressRun& run = report.runs[i];
    CAPTURE(run.family);
    CAPTURE(run.value);
    CHECK(run.family == inputs[i / 3].family);
    CHECK_MESSAGE(run.passes(), (run.passes() ? "" : run.faults[0]));
    const bool flat = run.family == "collinear";
    CHECK((run.end == StressEnd::NoVolume) == flat);
    CHECK(run.stored.size() == (flat ? 0 : run.engine == Engine::Filtered ? 8 : 4));
    if (run.engine == Engine::Exact && !flat) CHECK(run.cost_error == 0);
  }
  CHECK(schema_complaint("stress", nlohmann::json::parse(write_json(stress_json(report)))) == "");
  for (const std::string& table : {stress_table(report), stress_case_table(report)}) {
    CHECK(table.find(" NO\n") == std::string::npos);
    std::istringstream lines(table);
    for (std::string line; std::getline(lines, line);) CHECK(line.size() <= 100);
  }
}

TEST_CASE("stress: answers and findings are the same on the other side of a process") {
  for (const Engine engine : {Engine::Exact, Engine::Filtered, Engine::Float}) {
    const StressInput input = inputs_at("needle", {1e17})[0];
    EngineAnswer answer = answer_of(input.make(), {.engine = engine});
    answer.why = "a \"reason\"\n";
    if (answer.claim) answer.claim->regret = std::numeric_limits<double>::infinity();
    if (!answer.lean.empty()) answer.lean[0].cost.high.reset();
    answer.seconds = 0.1 + 0.2;
    const EngineAnswer read = answer_in(write_json(answer_json(answer)));
    CHECK(answer_json(read) == answer_json(answer));
    CHECK(read.why == answer.why);
    CHECK(read.seconds == answer.seconds);
    CHECK(read.left == answer.left);
    REQUIRE(read.run.steps.size() == answer.run.steps.size());
    for (std::size_t s = 0; s < read.run.steps.size(); ++s) {
      CHECK(read.run.steps[s].removed == answer.run.steps[s].removed);
      CHECK(read.run.steps[s].cost == answer.run.steps[s].cost);
      CHECK(read.run.steps[s].tie == answer.run.steps[s].tie);
    }
    if (!read.lean.empty()) CHECK_FALSE(read.lean[0].cost.high.has_value());
    if (read.claim) CHECK(read.claim->regret == std::numeric_limits<double>::infinity());
    const StressReport report{judge_answers(input, input.make(), std::span(&answer, 1)), 0};
    const auto json = stress_json(report);
    CHECK(stress_json({stress_runs_in(write_json(json)), 0}) == json);
  }
}

TEST_CASE("stress: a family does not take every value") {
  CHECK_THROWS_AS((void)inputs_at("needle", {0.5}), Error);
  CHECK_THROWS_AS((void)inputs_at("mixed-halfspaces", {-1}), Error);
  CHECK_THROWS_AS((void)stress_family("sphere-of-cheese"), Error);
}

TEST_CASE("stress: a removal too dear is a fault, recorded honestly or not") {
  check_caught_of_both(
      [](EngineAnswer& a) { std::swap(a.run.steps[0].removed, a.run.steps.back().removed); });
  check_caught_of_both([](EngineAnswer& a) {
    std::swap(a.run.steps[0], a.run.steps.back());
    make_lean_removals_equal(a);
  });
}

TEST_CASE("stress: a tie broken the wrong way, or listed wrongly, is a fault") {
  check_caught_of_both(
      [](EngineAnswer& a) {
        REQUIRE(a.run.steps[0].tie.size() > 1);  // the first two of four equal cuts change places
        std::swap(a.run.steps[0].removed, a.run.steps[1].removed);
        make_lean_removals_equal(a);
      },
      tied_input());
  check_caught_of_both([](EngineAnswer& a) { a.run.steps[0].tie.pop_back(); }, tied_input());
}

// What one judge sees another one often sees, too: each of them alone must.
TEST_CASE("stress: each judge of ties sees by itself that one is listed wrongly" * sweep) {
  const StressInput input = tied_input().front();
  const Shape shape = input.make();
  StageLog log;
  const Solid solid = std::get<Solid>(make_solid(shape, {}, log));
  const CenteredDual centered{solid.dual, interior_point_of(solid)};
  const EngineAnswer honest = answer_of(shape, {.engine = Engine::Exact});
  REQUIRE(honest.run.steps[0].tie.size() == 4);
  const auto judges = [&](const EngineAnswer& answer) {
    return std::array{!faults_of_order(answer, follow(centered, answer)).empty(),
                      !faults_by_definition(centered, answer).empty()};
  };
  CHECK(judges(honest) == std::array{false, false});
  const auto check_seen = [&](const auto& change) {
    EngineAnswer answer = honest;
    change(answer.run.steps[0]);
    const auto [by_order, by_definition] = judges(answer);
    CHECK(by_order);
    CHECK(by_definition);
  };
  check_seen([](Step& step) { step.tie.pop_back(); });
  check_seen([](Step& step) { step.tie.erase(step.tie.begin() + 1); });
  check_seen([](Step& step) { step.tie.clear(); });
  check_seen([&](Step& step) {
    // A halfspace that costs more: a side of the cube.
    for (std::size_t i = 0; i < solid.dual.halfspaces.size(); ++i) {
      const HalfspaceId id(i);
      if (std::find(step.tie.begin(), step.tie.end(), id) == step.tie.end()) {
        step.tie.push_back(id);
        return;
      }
    }
  });
}

TEST_CASE("stress: engines that promise the same and differ are at fault") {
  StressRequest request;
  request.engines = {Engine::Exact, Engine::Filtered};
  request.answer = [](const Shape& shape, const Question& question) {
    EngineAnswer answer = answer_of(shape, question);
    if (question.engine == Engine::Exact)
      answer.run.steps[1].cost = answer.run.steps[1].cost->rational() * 2;
    return answer;
  };
  const StressReport report = stress(one_input(), request);
  REQUIRE(report.runs.size() == 2);
  for (const StressRun& run : report.runs) {
    CHECK(std::count(run.faults.begin(), run.faults.end(), "exact and filtered differ at step 1") ==
          1);
  }
}

TEST_CASE("stress: a wrong cost, volume or enclosure is a fault") {
  check_caught_of_both([](EngineAnswer& a) {
    a.run.steps[1].cost = a.run.steps[1].cost->rational() + Rational(1, 1000000007);
  });
  for (const Engine engine : {Engine::Exact, Engine::Filtered, Engine::Float}) {
    check_caught(engine, [](EngineAnswer& a) { a.output_volume.low = *a.output_volume.high * 2; });
    check_caught(engine, [](EngineAnswer& a) { a.input_volume.high = 0; });
  }
  check_caught(Engine::Filtered, [](EngineAnswer& a) { a.lean[0].cost.high = 0; });
  check_caught(Engine::Filtered, [](EngineAnswer& a) { ++a.lean[0].tied; });
}

TEST_CASE("stress: a run that stops too early, or removes something twice, is a fault") {
  check_caught_of_both([](EngineAnswer& a) {
    a.run.steps.pop_back();
    if (!a.lean.empty()) a.lean.pop_back();
    a.end = StressEnd::AllUnbounded;
  });
  for (const Engine engine : {Engine::Exact, Engine::Filtered, Engine::Float}) {
    check_caught(engine, [](EngineAnswer& a) { a.run.steps[1].removed = a.run.steps[0].removed; });
    check_caught(engine, [](EngineAnswer& a) { a.left.pop_back(); });
    check_caught(engine, [](EngineAnswer& a) { a.run.halfspaces.pop_back(); });
    check_caught(engine, [](EngineAnswer& a) { a.end = StressEnd::NoVolume; });
  }
}

TEST_CASE("stress: what is stored and misses a point, is open or unreadable is a fault" * sweep) {
  for (const Engine engine : {Engine::Exact, Engine::Filtered, Engine::Float}) {
    for (std::size_t form = 0; form < 4; ++form) {
      CAPTURE(form);
      // A tetrahedron with legs of 1/4, for points all over the unit ball.
      check_caught(engine, [form](EngineAnswer& a) {
        a.stored[form].bytes = form < 2
                                   ? R"([[1,0,0,-0.25],[0,1,0,-0.25],[0,0,1,-0.25],[-1,-1,-1,0]])"
                                   : "v 0 0 0\nv .25 0 0\nv 0 .25 0\nv 0 0 .25\n"
                                     "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
      });
      check_caught(engine, [form](EngineAnswer& a) {
        a.stored[form].bytes = form < 2 ? "[[1,0,0,-1],[0,1,0,-1],[0,0,1,-1],[-1,0,0,0]]"
                                        : a.stored[form].bytes.substr(0, 100);
      });
      check_caught(engine, [form](EngineAnswer& a) { a.stored[form].bytes = "nonsense"; });
    }
  }
}

TEST_CASE("stress: the float engine may be wrong, but not more than it says") {
  const auto claim = [](double cost, double regret, std::size_t doubtful) {
    return StressClaim{cost, regret, doubtful, true, doubtful == 0};
  };
  const auto dear = [](EngineAnswer& a) {  // the dearest first
    std::swap(a.run.steps[0], a.run.steps.back());
    std::swap(a.lean[0], a.lean.back());
  };
  check_caught(Engine::Float, [&](EngineAnswer& a) {
    dear(a);
    a.claim = claim(0.001, 0.001, 0);
  });
  check_caught(Engine::Float, [&](EngineAnswer& a) {  // an estimate that is off by half
    *a.lean[0].cost.low /= 2;
    a.lean[0].cost.high = a.lean[0].cost.low;
    a.claim = claim(0.001, 0.001, 0);
  });
  const StressReport doubted = with_corrupted(Engine::Float, [&](EngineAnswer& a) {
    dear(a);
    a.claim = claim(0.001, 0.001, a.run.steps.size());
  });
  CHECK(doubted.passes());
  const StressRun& run = doubted.runs[0];
  CHECK(run.first_difference == 0);
  CHECK(*run.regret > 0.5);
}

TEST_CASE("stress: an end that the float engine vouches for is the end") {
  const auto shorten = [](EngineAnswer& a) {
    const std::size_t all = a.run.halfspaces.size();
    a.run.steps.clear();
    a.lean.clear();
    a.left = a.run.halfspaces;
    a.output_volume = a.input_volume;
    a.end = StressEnd::AllUnbounded;
    REQUIRE(all > 4);
  };
  check_caught(Engine::Float, [&](EngineAnswer& a) {
    shorten(a);
    a.claim = StressClaim{0, 0, 0, true, true};
  });
  CHECK(with_corrupted(Engine::Float, [&](EngineAnswer& a) {
          shorten(a);
          a.claim = StressClaim{0, 0, 0, false, false};
        }).passes());
}

TEST_CASE("stress: a crash, an exception, a hang and a lack of memory are lines of the table") {
  for (const Engine engine : {Engine::Exact, Engine::Filtered, Engine::Float}) {
    const StressReport crashed =
        with_corrupted(engine, [](EngineAnswer&) { (void)std::raise(SIGKILL); });
    CHECK_FALSE(crashed.passes());
    CHECK(crashed.runs[0].end == StressEnd::Crashed);
    const StressReport thrown =
        with_corrupted(engine, [](EngineAnswer&) { throw std::logic_error("out of cheese"); });
    CHECK_FALSE(thrown.passes());
    CHECK(thrown.runs[0].end == StressEnd::Failed);
    CHECK(thrown.runs[0].faults[0].find("out of cheese") != std::string::npos);
    const StressReport empty =
        with_corrupted(engine, [](EngineAnswer&) { throw std::bad_alloc(); });
    CHECK_FALSE(empty.passes());
    CHECK(empty.runs[0].end == StressEnd::OutOfMemory);
  }
  StressRequest request;
  request.limits.seconds = 0.05;
  request.engines = {Engine::Float};
  request.answer = [](const Shape&, const Question&) -> EngineAnswer {
    for (;;) std::this_thread::sleep_for(std::chrono::seconds(1));
  };
  const StressReport waiting = stress(one_input(), request);
  CHECK_FALSE(waiting.passes());
  CHECK(waiting.runs[0].end == StressEnd::TimedOut);
  request.answer = [](const Shape&, const Question&) -> EngineAnswer {
    const volatile bool forever = true;
    while (forever) {
    }
    return {};
  };
  request.limits.seconds = 1;
  const StressReport hung = stress(one_input(), request);
  CHECK_FALSE(hung.passes());
  CHECK(hung.runs[0].end == StressEnd::TimedOut);
}

TEST_CASE("stress: an interrupt ends it and its processes") {
  const std::atomic<bool> stop = true;
  StressRequest request;
  request.watch = &stop;
  CHECK_THROWS_AS((void)stress(one_input(), request), Error);
}

TEST_CASE("stress: what was judged before a stop is told") {
  std::vector<StressInput> inputs = one_input();
  inputs.push_back(inputs.front());
  std::atomic<bool> stop = false;
  std::vector<StressRun> judged;
  StressRequest request;
  request.engines = {Engine::Filtered};
  request.limits.memory = 0;  // sanitizers reserve more than any
  request.watch = &stop;
  request.judged = [&](std::span<const StressRun> runs) {
    judged.insert(judged.end(), runs.begin(), runs.end());
    stop = true;
  };
  CHECK_THROWS_AS((void)stress(inputs, request), Error);
  REQUIRE(judged.size() == 1);
  CHECK(judged[0].passes());
}

TEST_CASE("stress --log: a line for each run, as in the report") {
  const support::ScratchFolder folder;
  const std::string log = folder.file("runs.jsonl");
  const auto run = support::run_program(
      "stress needle --values 7,9 --size 8 --engines filtered --json --memory-limit 0 --log " +
      log);
  REQUIRE(run.exit == 0);
  nlohmann::json lines = nlohmann::json::array();
  std::istringstream text(support::bytes_of(log));
  for (std::string line; std::getline(text, line);) lines.push_back(nlohmann::json::parse(line));
  CHECK(lines.size() == 2);
  const auto runs = nlohmann::json::parse(run.out)["runs"];
  for (const auto& line : lines) CHECK(std::find(runs.begin(), runs.end(), line) != runs.end());
  CHECK(support::run_program("stress needle --values 7 --log " + log + "/no").exit == 5);
}

TEST_CASE(
    "stress: the program's exit code is 0 for promises kept, 1 for broken ones, 2 for nonsense" *
    sweep) {
  CHECK(support::run_program("stress cube --values 3").exit == 2);  // there is only one
  // Without a limit of memory: sanitizers reserve more than any.
  const auto kept = support::run_program(
      "stress needle --values 7,1e300 --size 8 --seeds 2 --json --memory-limit 0");
  CHECK(kept.exit == 0);
  const auto document = nlohmann::json::parse(kept.out);
  CHECK(schema_complaint("stress", document) == "");
  CHECK(document["passes"] == true);
  CHECK(document["runs"].size() == 12);
  const auto slow =
      support::run_program("stress needle --values 7 --memory-limit 0 --time-limit 0.000001");
  CHECK(slow.exit == 1);
  CHECK(slow.out.find("no end within") != std::string::npos);
  CHECK(support::run_program("stress sphere-of-cheese").exit == 2);
  CHECK(support::run_program("stress needle --values 0.5").exit == 2);
  const auto list = support::run_program("stress --list --json");
  CHECK(list.exit == 0);
  CHECK(schema_complaint("stress", nlohmann::json::parse(list.out)) == "");
}

TEST_CASE("stress --cost: honest engines pass by area and by mean width" * sweep) {
  std::vector<StressInput> inputs = one_input();
  for (const auto& more : {tied_input(), inputs_at("needle", {1, 1e9}), inputs_at("prism", {12}),
                           inputs_at("collinear", {5}), inputs_at("mixture", {2}),
                           inputs_at("mixed-halfspaces", {1, 2})}) {
    inputs.insert(inputs.end(), more.begin(), more.end());
  }
  for (const CostMeasure cost : {CostMeasure::Area, CostMeasure::MeanWidth}) {
    CAPTURE(static_cast<int>(cost));
    StressRequest request;
    request.engines = {Engine::Exact, Engine::Filtered};
    request.cost = cost;
    const StressReport report = stress(inputs, request);
    CHECK(report.cost == cost);
    for (const StressRun& run : report.runs) {
      CAPTURE(run.family);
      CAPTURE(run.value);
      CHECK_MESSAGE(run.passes(), (run.passes() ? "" : run.faults[0]));
      CHECK(run.undecided == 0);
    }
    const auto json = nlohmann::json::parse(write_json(stress_json(report)));
    CHECK(schema_complaint("stress", json) == "");
    CHECK(json["cost"] == (cost == CostMeasure::Area ? "area" : "mean-width"));
  }
}

TEST_CASE("stress --cost: what the float engine says is judged by the run that says it") {
  // Its costs and bounds depend on the center of the dual: those of another dual break some of
  // these bounds.
  for (const CostMeasure cost : {CostMeasure::Area, CostMeasure::MeanWidth}) {
    CAPTURE(static_cast<int>(cost));
    StressRequest request;
    request.engines = {Engine::Float};
    request.cost = cost;
    std::vector<StressInput> inputs = inputs_at("needle", {1e12}, 20);
    const auto more = inputs_at("mixed-halfspaces", {1});
    inputs.insert(inputs.end(), more.begin(), more.end());
    const StressReport report = stress(inputs, request);
    REQUIRE(report.runs.size() == 2);
    for (const StressRun& run : report.runs) {
      CAPTURE(run.family);
      CAPTURE(run.value);
      CHECK_MESSAGE(run.passes(), (run.passes() ? "" : run.faults[0]));
      CHECK(run.claim.has_value());
    }
  }
}

TEST_CASE("stress --cost: wrong costs, measures and choices by area and mean width are faults" *
          sweep) {
  for (const CostMeasure cost : {CostMeasure::Area, CostMeasure::MeanWidth}) {
    CAPTURE(static_cast<int>(cost));
    const auto faults_of = [&](const Question& asked, const Corruption& corrupt) {
      const StressInput input = one_input()[0];
      EngineAnswer answer = answer_of(input.make(), asked);
      corrupt(answer);
      const EngineAnswer read = answer_in(write_json(answer_json(answer)));
      return judge_answers(input, input.make(), std::span(&read, 1)).at(0).faults;
    };
    for (const Engine engine : {Engine::Exact, Engine::Filtered}) {
      const Question asked{.engine = engine, .cost = cost};
      CHECK(faults_of(asked, [](EngineAnswer&) {}).empty());
      const Rational more = 1 + scale_by_power_of_two(Rational(1), -100);
      CHECK_FALSE(faults_of(asked, [&](EngineAnswer& a) { *a.run.steps[1].cost *= more; }).empty());
      CHECK_FALSE(faults_of(asked, [&](EngineAnswer& a) { (*a.measure)[0].high = 0; }).empty());
      CHECK_FALSE(faults_of(asked, [&](EngineAnswer& a) { (*a.measure)[1].low = 1000; }).empty());
      CHECK_FALSE(faults_of(asked, [&](EngineAnswer& a) { a.measure.reset(); }).empty());
      CHECK_FALSE(faults_of(asked, [&](EngineAnswer& a) {
                    a.run.steps[0].tie.push_back(a.run.steps[1].removed);
                  }).empty());
      CHECK_FALSE(faults_of(asked, [&](EngineAnswer& a) {
                    std::swap(a.run.steps[0], a.run.steps[1]);
                    make_lean_removals_equal(a);
                  }).empty());
    }
    CHECK_FALSE(faults_of({.engine = Engine::Filtered, .cost = cost}, [](EngineAnswer& a) {
                  a.lean[0].cost.low = *a.lean[0].cost.high + 1;
                }).empty());
  }
}

namespace {

// Solids around which greedy removals miss the best planes, so that a search makes moves.
std::vector<StressInput> searched_input() { return inputs_at("random-ball", {14}); }

StressRequest with_search(CostMeasure cost = CostMeasure::Volume) {
  StressRequest request;
  request.engines = {Engine::Exact, Engine::Filtered};
  request.cost = cost;
  request.search = {SearchKind::Local, 5};
  return request;
}

void check_search_caught(const Corruption& corrupt) {
  for (const Engine engine : {Engine::Exact, Engine::Filtered}) {
    StressRequest request = with_search();
    request.engines = {engine};
    request.answer = [&](const Shape& shape, const Question& question) {
      EngineAnswer answer = answer_of(shape, question);
      corrupt(answer);
      return answer;
    };
    CHECK_FALSE(stress(searched_input(), request).passes());
  }
}

}  // namespace

TEST_CASE("stress: searches of both engines pass, by every measure" * sweep) {
  for (const CostMeasure cost : {CostMeasure::Volume, CostMeasure::Area, CostMeasure::MeanWidth}) {
    std::vector<StressInput> inputs = searched_input();
    for (const auto& more :
         {tied_input(), inputs_at("needle", {1e300}), inputs_at("prism", {12})}) {
      inputs.insert(inputs.end(), more.begin(), more.end());
    }
    const StressReport report = stress(inputs, with_search(cost));
    for (const StressRun& run : report.runs) {
      CAPTURE(run.family);
      CHECK_MESSAGE(run.passes(), (run.passes() ? "" : run.faults[0]));
      CHECK(run.moves.has_value());
    }
    CHECK(report.runs[0].moves.value() > 0);
    CHECK(schema_complaint("stress", nlohmann::json::parse(write_json(stress_json(report)))) == "");
  }
}

TEST_CASE("stress: a search that is not what it says is a fault" * sweep) {
  check_search_caught(
      [](EngineAnswer& a) { a.search->moves.back().measure = a.run.steps[0].cost; });
  check_search_caught([](EngineAnswer& a) { a.search->moves.pop_back(); });
  check_search_caught([](EngineAnswer& a) { a.search->left = a.left; });
  check_search_caught([](EngineAnswer& a) {  // back, which makes the solid larger
    const Move last = a.search->moves.back();
    a.search->moves.push_back({last.inserted, last.removed, a.run.steps[0].cost});
  });
  check_search_caught([](EngineAnswer& a) {  // what is not there
    a.search->moves.front().removed = a.search->moves.front().inserted;
  });
}

TEST_CASE("stress: searches that differ are a fault of both") {
  StressRequest request = with_search();
  request.answer = [](const Shape& shape, const Question& question) {
    Question other = question;
    if (question.engine == Engine::Filtered) other.search = {SearchKind::Local, 0};
    EngineAnswer answer = answer_of(shape, other);
    if (question.engine == Engine::Filtered) {
      answer.search->moves.clear();  // true of a search that finds nothing
      answer.search->left = answer.left;
    }
    return answer;
  };
  const StressReport report = stress(searched_input(), request);
  REQUIRE(report.runs.size() == 2);
  for (const StressRun& run : report.runs) CHECK_FALSE(run.passes());
}
