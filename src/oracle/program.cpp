// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <optional>

#include "convexact/conform.hpp"
#include "convexact/error.hpp"

namespace convexact {
namespace {

using Clock = std::chrono::steady_clock;

// A pipe whose ends do not live on in the program, but for the one that becomes its output.
struct Pipe {
  std::array<int, 2> ends{-1, -1};

  Pipe() {
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
      throw Error(ErrorCode::Stopped, "the system cannot make a pipe");
  }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  void close_end(std::size_t end) {
    if (ends[end] >= 0) close(ends[end]);
    ends[end] = -1;
  }
};

void set_limit(decltype(RLIMIT_AS) resource, rlim_t value) {
  const rlimit limit{value, value};
  (void)setrlimit(resource, &limit);
}

// Becomes the program. Between fork and exec, so only calls that are safe in a signal handler.
[[noreturn]] void become(char* const* arguments, const ProgramLimits& limits, const Pipe& output,
                         const Pipe& failure) {
  setpgid(0, 0);
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE}) std::signal(signal, SIG_DFL);
  set_limit(RLIMIT_CORE, 0);
  if (limits.memory != 0) set_limit(RLIMIT_AS, limits.memory);
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(output.ends[1], STDOUT_FILENO);
  dup2(output.ends[1], STDERR_FILENO);
  execvp(arguments[0], arguments);
  const char failed = 1;
  [[maybe_unused]] const auto written = write(failure.ends[1], &failed, 1);
  _exit(127);
}

// A running program, killed with all that it started when this goes away.
class Process {
 public:
  Process(std::vector<std::string> words, const ProgramLimits& limits) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    id_ = fork();
    if (id_ < 0) throw Error(ErrorCode::Stopped, "the system cannot make a process");
    if (id_ == 0) become(arguments.data(), limits, output_, failure_);
    setpgid(id_, id_);  // here and there, as either may come first
    output_.close_end(1);
    failure_.close_end(1);
  }
  ~Process() {
    kill_all();
    if (!status_) (void)wait(0);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  void kill_all() const { (void)kill(-id_, SIGKILL); }

  // Whether the program was executed at all; waits until that is known.
  bool started() const {
    char failed = 0;
    while (true) {
      const auto count = read(failure_.ends[0], &failed, 1);
      if (count >= 0 || errno != EINTR) return count == 0;
    }
  }
  // Waits for output, its end, or some milliseconds; keeps the last of the output. Returns whether
  // there was any.
  bool listen(std::string& printed, int milliseconds) {
    if (output_.ends[0] < 0) {
      (void)poll(nullptr, 0, std::min(milliseconds, 1));  // it has closed its output and goes on
      return false;
    }
    pollfd ready{output_.ends[0], POLLIN, 0};
    if (poll(&ready, 1, milliseconds) <= 0) return false;
    std::array<char, 4096> bytes;
    const auto count = read(output_.ends[0], bytes.data(), bytes.size());
    if (count > 0) {
      printed.append(bytes.data(), static_cast<std::size_t>(count));
      if (printed.size() > bytes.size()) printed.erase(0, printed.size() - bytes.size());
    } else if (count == 0) {
      output_.close_end(0);
    }
    return count > 0;
  }
  // Its status, once it has ended. @param options  WNOHANG to ask without waiting.
  std::optional<int> wait(int options) {
    int status = 0;
    rusage usage{};
    if (!status_ && wait4(id_, &status, options, &usage) == id_) {
      status_ = status;
      peak_memory_ = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
    }
    return status_;
  }
  // Known once it has ended.
  std::uint64_t peak_memory() const { return peak_memory_; }

 private:
  Pipe output_, failure_;
  pid_t id_ = -1;
  std::optional<int> status_;
  std::uint64_t peak_memory_ = 0;
};

}  // namespace

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
  const auto start = Clock::now();
  const auto seconds = [start] {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  ProgramRun run;
  Process process(words, limits);
  if (!process.started()) return run;
  std::optional<int> status;
  while (!(status = process.wait(WNOHANG))) {
    if (stop != nullptr && *stop) throw Error(ErrorCode::Stopped, "interrupted");
    if (seconds() > limits.seconds) {
      run.end = ProgramEnd::TimedOut;
      run.seconds = limits.seconds;
      return run;
    }
    (void)process.listen(run.printed, 20);
  }
  process.kill_all();  // remaining processes could go on printing
  while (process.listen(run.printed, 0)) {
  }
  run.seconds = seconds();
  run.peak_memory = process.peak_memory();
  run.end = WIFEXITED(*status) ? ProgramEnd::Exited : ProgramEnd::Crashed;
  if (WIFEXITED(*status)) run.exit_code = WEXITSTATUS(*status);
  if (WIFSIGNALED(*status)) run.signal = WTERMSIG(*status);
  return run;
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
