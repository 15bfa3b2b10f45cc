// SPDX-License-Identifier: MIT
#include "stress/stress.hpp"

#include <poll.h>

#include <chrono>
#include <map>
#include <utility>

#include "convexact/error.hpp"
#include "stress/child.hpp"

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

// An input on its way: its engines answer one by one, then the judge speaks.
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
  Child start(std::size_t i) const;
  void finish(std::size_t i, ChildEnd end);
  void finish_engine(std::size_t i, ChildEnd end);
  void finish_judge(std::size_t i, const ChildEnd& end);

  std::span<const StressInput> inputs_;
  const StressRequest& request_;
  std::vector<Progress> progress_;
  std::size_t done_ = 0;
};

std::vector<StressRun> Sweep::run() {
  std::map<std::size_t, Child> children;
  for (std::size_t next = 0; done_ < inputs_.size();) {
    if (request_.stop != nullptr && *request_.stop) throw Error(ErrorCode::Stopped, "interrupted");
    while (children.size() < std::max<std::size_t>(request_.processes, 1) &&
           next < inputs_.size()) {
      children.emplace(next, start(next));
      ++next;
    }
    (void)::poll(nullptr, 0, 1);  // a millisecond
    for (auto child = children.begin(); child != children.end();) {
      const std::size_t i = child->first;
      std::optional<ChildEnd> end = child->second.poll();
      if (!end) {
        ++child;
        continue;
      }
      child = children.erase(child);
      finish(i, std::move(*end));
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
Child Sweep::start(std::size_t i) const {
  const StressInput& input = inputs_[i];
  const std::vector<EngineAnswer>& answers = progress_[i].answers;
  if (answers.size() == request_.engines.size()) {
    return Child(
        [&] { return to_bytes(judge_answers(input, input.make(), answers, request_.judge)); },
        request_.limits);
  }
  const Engine engine = request_.engines[answers.size()];
  Question question{engine, input.faces, input.seed, SIZE_MAX, SIZE_MAX, request_.most_stored};
  if (engine == Engine::Exact) {
    question.most_work = request_.exact_work;
    question.most_steps = request_.exact_steps;
  }
  return Child([&, question] { return to_bytes(request_.answer(input.make(), question)); },
               request_.limits);
}

void Sweep::finish(std::size_t i, ChildEnd end) {
  if (progress_[i].answers.size() < request_.engines.size()) {
    finish_engine(i, std::move(end));
  } else {
    finish_judge(i, end);
    progress_[i].done = true;
    ++done_;
    if (request_.progress) request_.progress(done_, inputs_.size());
  }
}

void Sweep::finish_engine(std::size_t i, ChildEnd end) {
  std::vector<EngineAnswer>& answers = progress_[i].answers;
  EngineAnswer answer;
  if (end.result) {
    answer = answer_from_bytes(*end.result);
  } else {
    answer.end = end.end;
    answer.why = end.why;
  }
  answer.engine = request_.engines[answers.size()];
  answer.memory = end.memory;
  answers.push_back(std::move(answer));
}

void Sweep::finish_judge(std::size_t i, const ChildEnd& end) {
  Progress& progress = progress_[i];
  if (end.result) {
    progress.runs = runs_from_bytes(*end.result);
  } else {
    progress.runs = unjudged(inputs_[i], progress.answers, "the judge: " + end.why);
  }
  progress.answers.clear();
}

}  // namespace

StressReport stress(std::span<const StressInput> inputs, const StressRequest& request) {
  require_sensible(request);
  const auto start = std::chrono::steady_clock::now();
  StressReport report;
  report.runs = Sweep(inputs, request).run();
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace convexact
