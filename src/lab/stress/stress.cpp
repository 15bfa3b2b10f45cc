// SPDX-License-Identifier: MIT
#include "lab/stress/stress.hpp"

#include <fmt/format.h>
#include <poll.h>

#include <chrono>
#include <map>
#include <memory>
#include <utility>

#include "conform/program.hpp"
#include "convexact/error.hpp"
#include "io/json.hpp"
#include "lab/stress/child.hpp"

namespace convexact {
namespace {

void require_sensible(const StressRequest& request) {
  std::vector<Engine> engines = request.engines;
  std::sort(engines.begin(), engines.end());
  if (engines.empty() || std::unique(engines.begin(), engines.end()) != engines.end()) {
    throw Error(ErrorCode::InvalidArgument, "name one to three different engines");
  }
  if (!(request.limits.seconds > 0)) {
    throw Error(ErrorCode::InvalidArgument, "no time to run an engine");
  }
}

using Children = std::map<std::size_t, std::unique_ptr<ChildProcess>>;

// An input in progress: its engines answer one by one, then the judge decides.
struct Progress {
  std::vector<EngineAnswer> answers;  // of the engines so far
  std::vector<StressRun> runs;        // of the judge, at the end
  bool done = false;
};

class Sweep {
 public:
  Sweep(std::span<const StressInput> inputs, const StressRequest& request)
      : inputs_(inputs), request_(request), progress_(inputs.size()) {}

  std::vector<StressRun> run();

 private:
  std::unique_ptr<ChildProcess> start(std::size_t i) const;
  void finish(std::size_t i, const ChildEnd& end);

  std::span<const StressInput> inputs_;
  const StressRequest& request_;
  std::vector<Progress> progress_;
  std::size_t done_ = 0;
};

std::vector<StressRun> Sweep::run() {
  Children children;
  for (std::size_t next = 0; done_ < inputs_.size();) {
    request_.watch.ask();
    while (children.size() < std::max<std::size_t>(request_.processes, 1) &&
           next < inputs_.size()) {
      children.emplace(next, start(next));
      ++next;
    }
    (void)::poll(nullptr, 0, 1);  // a millisecond
    for (auto child = children.begin(); child != children.end();) {
      const std::size_t i = child->first;
      const std::optional<ProgramRun> run = child->second->poll(0);
      if (!run) {
        ++child;
        continue;
      }
      const ChildEnd end = end_of(*run, *child->second, request_.limits);
      child = children.erase(child);
      finish(i, end);
      if (!progress_[i].done) children.emplace(i, start(i));
    }
  }
  std::vector<StressRun> runs;
  for (Progress& p : progress_) {
    std::move(p.runs.begin(), p.runs.end(), std::back_inserter(runs));
  }
  return runs;
}

// The next engine, or the judge when all have answered.
std::unique_ptr<ChildProcess> Sweep::start(std::size_t i) const {
  const StressInput& input = inputs_[i];
  const std::vector<EngineAnswer>& answers = progress_[i].answers;
  if (answers.size() == request_.engines.size()) {
    return start_child(
        [&] {
          return stress_json({judge_answers(input, input.make(), answers), 0, request_.cost});
        },
        request_.limits);
  }
  const Engine engine = request_.engines[answers.size()];
  const Question question{.engine = engine,
                          .faces = input.faces,
                          .seed = input.seed,
                          .cost = request_.cost,
                          .search = request_.search};
  return start_child([&] { return answer_json(request_.answer(input.make(), question)); },
                     request_.limits);
}

void Sweep::finish(std::size_t i, const ChildEnd& end) {
  Progress& progress = progress_[i];
  if (progress.answers.size() < request_.engines.size()) {
    EngineAnswer answer;
    if (end.answer) {
      answer = answer_in(*end.answer);
    } else {
      answer.end = end.end;
      answer.why = end.why;
    }
    answer.engine = request_.engines[progress.answers.size()];
    answer.run.measure = request_.cost;
    answer.memory = end.memory;
    progress.answers.push_back(std::move(answer));
    return;
  }
  progress.runs = end.answer ? stress_runs_in(*end.answer)
                             : unjudged(inputs_[i], progress.answers, "the judge: " + end.why);
  progress.answers.clear();
  progress.done = true;
  request_.judged(progress.runs);
  ++done_;
  request_.watch.report(done_, inputs_.size());
}

}  // namespace

StressReport stress(std::span<const StressInput> inputs, const StressRequest& request) {
  require_sensible(request);
  const auto start = std::chrono::steady_clock::now();
  StressReport report;
  report.cost = request.cost;
  report.runs = Sweep(inputs, request).run();
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace convexact
