// SPDX-License-Identifier: MIT
#include "cli/program_case.hpp"

#include <algorithm>
#include <filesystem>

#include "cli/command.hpp"
#include "conform/program_output.hpp"
#include "convexact/error.hpp"
#include "convexact/verify.hpp"

namespace convexact::cli {
namespace {

// The first claim that the output violates, if there is one.
std::optional<std::string> violation_of(const ProgramCase& program, const Shape& input,
                                        const std::string& output) {
  const bool is_binary32 = program.numbers == Precision::Binary32;
  const std::optional<Candidate> candidate = read_program_output(
      output, is_binary32 ? Decimal::Nearest32 : Decimal::Nearest, program.limits.output);
  if (!candidate) return "no output";
  VerifyRequest request = program.verify;
  request.watch.stop = &interrupted();
  const VerifyOutcome outcome = verify(input, *candidate, request);
  const auto* verdict = std::get_if<Verdict>(&outcome);
  if (verdict == nullptr) return std::nullopt;  // flat: there is nothing to enclose
  for (const Claim& claim : verdict->claims) {
    if (claim.status == Status::Violated) return std::string("violates ") + name_of(claim.code);
  }
  return std::nullopt;
}

}  // namespace

bool mentions(const std::vector<std::string>& words, const std::string& placeholder) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return word.find(placeholder) != std::string::npos;
  });
}

// The path of the input is an argument of the shell, so that blanks in it do no harm.
void ProgramCase::become_predicate(const std::string& command) {
  if (!words.empty()) {
    throw Error(ErrorCode::InvalidArgument,
                "--interesting takes the place of the program after --");
  }
  const std::string filled = fill_in({command}, {{"input", "\"$1\""}}).front();
  words = {"sh", "-c", filled == command ? command + " \"$1\"" : filled, "sh", "{input}"};
  fails_if = FailsIf::Success;
}

void ProgramCase::require_sensible() const {
  const auto reject = [](const std::string& what) {
    throw Error(ErrorCode::InvalidArgument, what);
  };
  if (words.empty()) {
    reject(
        "name the program after --, with {input} where its input goes; or --interesting COMMAND");
  }
  if (!mentions(words, "{input}")) reject("the program needs {input} among its arguments");
  if (mentions(words, "{faces}") && faces == 0) reject("{faces} needs --faces");
  if (fails_if == FailsIf::Verdict && !mentions(words, "{output}")) {
    reject("a verdict needs {output} among the program's arguments");
  }
}

std::optional<std::string> failure_of(const ProgramCase& program, const std::string& bytes,
                                      const Shape& input, const ScratchFolder& folder) {
  // After an interrupt no program is started: it might send another interrupt, which would end the
  // process.
  if (interrupted()) throw Error(ErrorCode::Stopped, "interrupted");
  const std::string output = folder.file("output" + program.output_extension);
  std::filesystem::remove_all(output);
  const std::string name = "input" + program.input_extension;
  std::filesystem::remove_all(folder.file(name));
  const std::string path = folder.write(name, bytes);
  const ProgramRun run = run_program(
      fill_in(program.words,
              {{"input", path}, {"output", output}, {"faces", std::to_string(program.faces)}}),
      program.limits, &interrupted());
  if (run.end == ProgramEnd::NotStarted) {
    throw Error(ErrorCode::InvalidArgument,
                "the program '" + program.words[0] + "' cannot be started");
  }
  if (program.fails_if == FailsIf::Success) {
    return run.succeeded() ? std::optional<std::string>("interesting") : std::nullopt;
  }
  if (!run.succeeded()) {
    if (program.fails_if == FailsIf::Verdict) return std::nullopt;
    return describe(run);
  }
  if (program.fails_if == FailsIf::Exit || !mentions(program.words, "{output}")) {
    return std::nullopt;
  }
  return violation_of(program, input, output);
}

}  // namespace convexact::cli
