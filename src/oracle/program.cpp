// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "convexact/conform.hpp"
#include "convexact/error.hpp"
#include "oracle/child_process.hpp"

namespace convexact {

std::string describe(const ProgramRun& run) {
  switch (run.end) {
    case ProgramEnd::Exited:
      return fmt::format("exit code {}", run.exit_code);
    case ProgramEnd::Crashed:
      return fmt::format("killed by signal {}", run.signal);
    case ProgramEnd::TimedOut:
      return fmt::format("no end within {:.3g} s", run.seconds);
    case ProgramEnd::NotStarted:
      break;
  }
  return "cannot be started";
}

ProgramRun run_program(const std::vector<std::string>& words, const ProgramLimits& limits,
                       const std::atomic<bool>* stop) {
  if (words.empty()) throw Error(ErrorCode::InvalidArgument, "no program to run");
  if (!(limits.seconds > 0))
    throw Error(ErrorCode::InvalidArgument, "the time limit of a program must be above 0");
  std::vector<std::string> copies = words;
  std::vector<char*> arguments;
  for (std::string& word : copies) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  ChildProcess process(
      [&arguments]() -> std::string {
        execvp(arguments[0], arguments.data());
        return "!";  // there is no such program
      },
      limits);
  std::optional<ProgramRun> run;
  while (!(run = process.poll(20))) {
    if (stop != nullptr && *stop) throw Error(ErrorCode::Stopped, "interrupted");
  }
  if (run->end == ProgramEnd::Exited && !process.result().empty()) return {};
  return *std::move(run);
}

std::vector<std::string> fill_in(const std::vector<std::string>& words,
                                 const std::map<std::string, std::string>& values) {
  std::vector<std::string> filled;
  for (const std::string& word : words) {
    std::string& result = filled.emplace_back();
    for (std::size_t at = 0; at < word.size();) {
      const auto place = std::find_if(values.begin(), values.end(), [&](const auto& entry) {
        return word.compare(at, entry.first.size() + 2, "{" + entry.first + "}") == 0;
      });
      if (place == values.end()) {
        result += word[at++];
      } else {
        result += place->second;
        at += place->first.size() + 2;
      }
    }
  }
  return filled;
}

}  // namespace convexact
