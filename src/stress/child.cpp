// SPDX-License-Identifier: MIT
#include "stress/child.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <csignal>
#include <new>
#include <utility>

#include "convexact/error.hpp"

namespace convexact {
namespace {

constexpr int kDone = 0;
const int kOutOfMemory = exit_code(ErrorCode::Stopped);
const int kFailed = exit_code(ErrorCode::Internal);

int memory_file(const char* name) {
  const int file = memfd_create(name, MFD_CLOEXEC);
  if (file < 0) throw Error(ErrorCode::Stopped, "the system cannot make a file in memory");
  return file;
}

bool write_all(int file, const std::string& bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const auto count = write(file, bytes.data() + at, bytes.size() - at);
    if (count <= 0) return false;
    at += static_cast<std::size_t>(count);
  }
  return true;
}

// From `start` to the end.
std::string read_from(int file, off_t start) {
  std::string bytes;
  std::array<char, 1 << 16> part;
  for (off_t at = start;;) {
    const auto count = pread(file, part.data(), part.size(), at);
    if (count <= 0) return bytes;
    bytes.append(part.data(), static_cast<std::size_t>(count));
    at += count;
  }
}

void limit(decltype(RLIMIT_AS) resource, rlim_t soft, rlim_t hard) {
  const rlimit both{soft, hard};
  (void)setrlimit(resource, &both);
}

// A busy machine may give a process a small share of its time; beyond this, it waits for something.
constexpr double kWallPerProcessorTime = 20;

void set_limits(const StressLimits& limits) {
  const auto seconds = static_cast<rlim_t>(std::ceil(limits.seconds));
  limit(RLIMIT_CPU, seconds, seconds + 1);
  limit(RLIMIT_CORE, 0, 0);
  if (limits.memory != 0) limit(RLIMIT_AS, limits.memory, limits.memory);
}

std::string too_long(const StressLimits& limits) {
  return fmt::format("no end within {:g} s", limits.seconds);
}

// What the child does, to its exit code.
int do_work(const std::function<std::string()>& work, int result) {
  try {
    return write_all(result, work()) ? kDone : kOutOfMemory;
  } catch (const std::bad_alloc&) {
    return kOutOfMemory;
  } catch (const std::exception& error) {
    (void)write_all(STDERR_FILENO, error.what());
    return kFailed;
  }
}

}  // namespace

Child::Child(const std::function<std::string()>& work, const StressLimits& limits)
    : result_(memory_file("result")), errors_(memory_file("errors")), limits_(limits) {
  id_ = fork();
  if (id_ < 0) throw Error(ErrorCode::Stopped, "the system cannot make a process");
  if (id_ != 0) return;
  setpgid(0, 0);  // an interrupt of the terminal is for the parent, which then ends this process
  (void)prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);
  set_limits(limits);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) (void)dup2(errors_, stream);
  _exit(do_work(work, result_));  // nothing of the parent's is flushed or destroyed twice
}

Child::Child(Child&& other) noexcept
    : id_(std::exchange(other.id_, -1)),
      result_(std::exchange(other.result_, -1)),
      errors_(std::exchange(other.errors_, -1)),
      limits_(other.limits_),
      start_(other.start_) {}

Child::~Child() {
  if (id_ > 0) {
    (void)kill(id_, SIGKILL);
    (void)waitpid(id_, nullptr, 0);
  }
  for (const int file : {result_, errors_}) {
    if (file >= 0) close(file);
  }
}

std::optional<ChildEnd> Child::poll() {
  int status = 0;
  rusage usage{};
  if (wait4(id_, &status, WNOHANG, &usage) == id_) {
    id_ = -1;
    return describe(status, static_cast<std::uint64_t>(usage.ru_maxrss) * 1024);
  }
  const std::chrono::duration<double> spent = Clock::now() - start_;
  if (spent.count() <= kWallPerProcessorTime * limits_.seconds) return std::nullopt;
  return ChildEnd{{}, StressEnd::TimedOut, too_long(limits_), 0};
}

ChildEnd Child::describe(int status, std::uint64_t memory) const {
  if (WIFEXITED(status) && WEXITSTATUS(status) == kDone) {
    return {read_from(result_, 0), StressEnd::Reached, {}, memory};
  }
  const off_t size = lseek(errors_, 0, SEEK_END);
  const std::string said = read_from(errors_, size > 500 ? size - 500 : 0);
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) {
    return {{}, StressEnd::TimedOut, too_long(limits_), memory};
  }
  if (WIFSIGNALED(status)) {
    const bool no_memory = said.find("annot allocate memory") != std::string::npos;
    return {{},
            no_memory ? StressEnd::OutOfMemory : StressEnd::Crashed,
            fmt::format("killed by signal {}: {}", WTERMSIG(status), said),
            memory};
  }
  if (WEXITSTATUS(status) == kOutOfMemory) {
    return {{}, StressEnd::OutOfMemory, "out of memory", memory};
  }
  return {{}, StressEnd::Failed, said, memory};
}

}  // namespace convexact
