// SPDX-License-Identifier: MIT
// program.hpp - runs somebody's program within limits and tells how it ended.
#pragma once
#include <atomic>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace convexact {

struct ProgramLimits {
  double seconds = 10;       ///< Of wall time, more than 0; then it is killed.
  std::uint64_t memory = 0;  ///< Bytes of address space of each of its processes; 0 for no limit.
};

enum class ProgramEnd {
  Exited,      ///< By itself, with `exit_code`.
  Crashed,     ///< By `signal`.
  TimedOut,    ///< Killed.
  NotStarted,  ///< There is no such program, or it cannot be executed.
};

struct ProgramRun {
  ProgramEnd end = ProgramEnd::NotStarted;
  int exit_code = 0;
  int signal = 0;
  double seconds = 0;             ///< Wall time.
  std::uint64_t peak_memory = 0;  ///< Largest resident set of one of its processes, in bytes.
  std::string printed;  ///< The end of what it wrote to standard output and error, up to 4 KiB.

  bool succeeded() const { return end == ProgramEnd::Exited && exit_code == 0; }
};

/// "exit code 3", "killed by signal 11", "no end within 10 s", "cannot be started".
[[nodiscard]] std::string describe(const ProgramRun& run);

/// Runs a program and waits for its end; what it started in the background is ended with it. No
/// shell: the words are its arguments as they are. Its standard input is empty, and it may leave no
/// core dump.
/// @param words  The program, looked up in PATH unless it has a slash, and its arguments.
/// @param stop   When it becomes true, the program is killed: Error Stopped.
/// @throws Error InvalidArgument if there are no words or the time is not positive; Stopped also if
///               the system cannot make a process.
[[nodiscard]] ProgramRun run_program(const std::vector<std::string>& words,
                                     const ProgramLimits& limits,
                                     const std::atomic<bool>* stop = nullptr);

/// The words with every "{name}" replaced by its value, also inside a word. Other braces stay.
[[nodiscard]] std::vector<std::string> fill_in(const std::vector<std::string>& words,
                                               const std::map<std::string, std::string>& values);

}  // namespace convexact
