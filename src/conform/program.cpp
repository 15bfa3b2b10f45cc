// SPDX-License-Identifier: MIT
#include "conform/program.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/mman.h>
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <new>
#include <vector>

#include "convexact/conform.hpp"
#include "convexact/error.hpp"

namespace convexact {
namespace {

// Of a file without a name, which ends with its last descriptor. A program that the process becomes
// does not inherit it.
int open_unnamed_file() {
#ifdef __linux__
  const int id = memfd_create("result", MFD_CLOEXEC);
#else
  std::string path = (std::filesystem::temp_directory_path() / "convexact-XXXXXX").string();
  const int id = mkstemp(path.data());
  if (id >= 0) {
    (void)unlink(path.c_str());
    (void)fcntl(id, F_SETFD, FD_CLOEXEC);
  }
#endif
  if (id < 0) throw Error(ErrorCode::Stopped, "the system cannot make a file for a result");
  return id;
}

// The calling process is killed when its parent ends, however that comes, where the system can.
void end_with_parent() {
#ifdef __linux__
  (void)prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
}

void set_limit(decltype(RLIMIT_AS) resource, std::uint64_t value) {
  const auto held = static_cast<rlim_t>(std::min<std::uint64_t>(value, RLIM_INFINITY));
  const rlimit limit{held, held};
  (void)setrlimit(resource, &limit);
}

bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const auto count = write(file, bytes.data(), bytes.size());
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

// The work of the child, up to its exit code.
int do_work(const std::function<std::string()>& work, int result) {
  try {
    return write_all(result, work()) ? 0 : exit_code(ErrorCode::Stopped);
  } catch (const std::bad_alloc&) {
    return exit_code(ErrorCode::Stopped);
  } catch (const std::exception& error) {
    (void)write_all(STDERR_FILENO, error.what());
    return exit_code(ErrorCode::Internal);
  }
}

std::mutex& paths_mutex() {
  static std::mutex mutex;
  return mutex;
}

std::vector<std::string>& all_paths() {
  static std::vector<std::string> paths;
  return paths;
}

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
                       const Watch& watch) {
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
    watch.ask();
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

void Descriptor::reset(int id) {
  if (id_ >= 0) close(id_);
  id_ = id;
}

// Neither the pipe nor the file of the result stays open in a program that the child becomes.
ChildProcess::ChildProcess(const std::function<std::string()>& work, const ProgramLimits& limits)
    : limits_(limits), result_(open_unnamed_file()) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
    throw Error(ErrorCode::Stopped, "the system cannot make a pipe");
  output_.reset(ends[0]);
  const Descriptor write_end(ends[1]);
  id_ = fork();
  if (id_ < 0) throw Error(ErrorCode::Stopped, "the system cannot make a process");
  if (id_ == 0) become_child(work, write_end.id());
  setpgid(id_, id_);  // here and in the child, as either may come first
}

// Before the work, only calls that are safe in a signal handler are made: the parent may have other
// threads.
void ChildProcess::become_child(const std::function<std::string()>& work, int output) const {
  setpgid(0, 0);  // an interrupt from the terminal goes to the parent, which then kills this group
  end_with_parent();
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE}) std::signal(signal, SIG_DFL);
  set_limit(RLIMIT_CORE, 0);
  if (limits_.memory != 0) set_limit(RLIMIT_AS, limits_.memory);
  dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  _exit(do_work(work, result_.id()));  // nothing of the parent's is flushed or destroyed twice
}

ChildProcess::~ChildProcess() {
  kill_group();
  if (!has_ended_) (void)waitpid(id_, nullptr, 0);
}

void ChildProcess::kill_group() const { (void)kill(-id_, SIGKILL); }

std::optional<ProgramRun> ChildProcess::poll(int milliseconds) {
  const std::chrono::duration<double> spent = Clock::now() - start_;
  int status = 0;
  rusage usage{};
  if (wait4(id_, &status, WNOHANG, &usage) != id_) {
    if (spent.count() <= limits_.seconds) {
      (void)listen(milliseconds);
      return std::nullopt;
    }
    run_.end = ProgramEnd::TimedOut;
    run_.seconds = limits_.seconds;
    return std::move(run_);
  }
  has_ended_ = true;
  kill_group();  // processes left in the background could go on printing
  while (listen(0)) {
  }
  run_.seconds = spent.count();
  run_.peak_memory = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
  run_.end = WIFEXITED(status) ? ProgramEnd::Exited : ProgramEnd::Crashed;
  if (WIFEXITED(status)) run_.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) run_.signal = WTERMSIG(status);
  return std::move(run_);
}

// Waits for output, its end, or some milliseconds; keeps the last of the output. Returns whether
// there was any.
bool ChildProcess::listen(int milliseconds) {
  if (output_.id() < 0) {  // it has closed its output and goes on
    (void)::poll(nullptr, 0, std::min(milliseconds, 1));
    return false;
  }
  pollfd ready{output_.id(), POLLIN, 0};
  if (::poll(&ready, 1, milliseconds) <= 0) return false;
  std::array<char, 4096> bytes;
  const auto count = read(output_.id(), bytes.data(), bytes.size());
  if (count > 0) {
    std::string& printed = run_.printed;
    printed.append(bytes.data(), static_cast<std::size_t>(count));
    if (printed.size() > bytes.size()) printed.erase(0, printed.size() - bytes.size());
  } else if (count == 0) {
    output_.reset();
  }
  return count > 0;
}

std::string ChildProcess::result() const {
  std::string bytes(static_cast<std::size_t>(lseek(result_.id(), 0, SEEK_END)), '\0');
  for (std::size_t at = 0; at < bytes.size();) {
    const auto count =
        pread(result_.id(), bytes.data() + at, bytes.size() - at, static_cast<off_t>(at));
    if (count <= 0) throw Error(ErrorCode::Stopped, "the result of a process cannot be read");
    at += static_cast<std::size_t>(count);
  }
  return bytes;
}

ScratchFolder::ScratchFolder() {
  path_ = (std::filesystem::temp_directory_path() / "convexact-XXXXXX").string();
  if (mkdtemp(path_.data()) == nullptr) {
    throw Error(ErrorCode::Unwritable, "no folder for temporary files can be made");
  }
  const std::lock_guard lock(paths_mutex());
  all_paths().push_back(path_);
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
  const std::lock_guard lock(paths_mutex());
  std::erase(all_paths(), path_);
}

void remove_scratch_folders() noexcept {
  std::error_code ignored;
  for (const std::string& path : all_paths()) std::filesystem::remove_all(path, ignored);
}

std::string ScratchFolder::write(const std::string& name, const std::string& bytes) const {
  std::ofstream stream(file(name), std::ios::binary);
  stream << bytes << std::flush;
  if (!stream) throw Error(ErrorCode::Unwritable, "cannot write " + file(name));
  return file(name);
}

}  // namespace convexact
