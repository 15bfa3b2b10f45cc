// SPDX-License-Identifier: MIT
#include "command.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <new>

#include "convexact/format/error_json.hpp"
#include "convexact/format/result_json.hpp"
#include "reproducer.hpp"

namespace convexact::cli {
namespace {

std::atomic<bool> interrupt_flag = false;
static_assert(std::atomic<bool>::is_always_lock_free, "set by a signal handler");

// The first interrupt asks the work to end by itself, so that nothing half-written stays; the
// second one, with the default action restored, ends the process.
extern "C" void on_interrupt(int signal) {
  interrupt_flag = true;
  std::signal(signal, SIG_DFL);
}

Reproducer& reproducer() {
  static Reproducer kept;
  return kept;
}

// An internal error, with the file that a report of it needs.
Error with_reproducer(const Error& error) {
  reproducer().failure = error.what();
  const std::string path = write_reproducer(reproducer(), ".");
  const std::string hint =
      path.empty() ? "please report it with the input" : "please report it with " + path;
  return {ErrorCode::Internal, std::string(error.what()) + "; this is a bug in convexact: " + hint};
}

// Tells an error, with further facts for --json, and returns its exit code.
int report(const GlobalOptions& options, const Error& error,
           const nlohmann::ordered_json& proof = {}) {
  const int code = exit_code(error.code());
  if (options.json) {
    nlohmann::ordered_json body = error_json(error);
    if (!proof.is_null()) body["proof"] = proof;
    std::cout << nlohmann::ordered_json{{"error", body}}.dump(2) << std::endl;
  } else {
    std::cerr << "convexact: " << error.what() << std::endl;
  }
  return code;
}

void limit_memory(std::uint64_t bytes) {
  if (bytes == 0) return;
  const rlimit limit{bytes, bytes};
  if (setrlimit(RLIMIT_AS, &limit) != 0) {
    throw Error(ErrorCode::InvalidArgument, "--max-memory: the system refuses this limit");
  }
}

}  // namespace

void add_global_options(CLI::App& command, GlobalOptions& options) {
  command.add_flag("--json", options.json, "print one JSON object, also on failure");
  command
      .add_option("--seed", options.seed, "of the random orders; the answer does not depend on it")
      ->capture_default_str();
  command
      .add_option("--max-memory", options.max_memory, "stop with exit code 6 beyond this, e.g. 2GB")
      ->transform(CLI::AsSizeValue(false));
}

void remember_command_line(int argc, char** argv) {
  reproducer().command_line.assign(argv, argv + argc);
}

void remember_input(const std::string& name, const std::string& bytes) {
  reproducer().inputs.emplace_back(name, bytes);
}

int run_guarded(const GlobalOptions& options, const std::function<int()>& work) {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
  std::signal(SIGPIPE,
              SIG_IGN);  // a closed pipe is an error of print(), not the end of the process
  try {
    limit_memory(options.max_memory);
    return work();
  } catch (const Error& error) {
    const bool is_bug = error.code() == ErrorCode::Internal;
    return report(options, is_bug ? with_reproducer(error) : error);
  } catch (const std::bad_alloc&) {
    return report(options, Error(ErrorCode::Stopped, "out of memory"));
  } catch (const std::exception& error) {
    return report(options, with_reproducer(Error(ErrorCode::Internal, error.what())));
  }
}

int report_not_solid(const GlobalOptions& options, const std::string& name,
                     const NotSolid& reason) {
  const Error error = Error(ErrorCode::NoInterior, describe(reason)).in_file(name);
  return report(options, error, proof_json(reason));
}

void print(const std::string& text) {
  std::cout << text << std::flush;
  if (!std::cout) throw Error(ErrorCode::Stopped, "standard output is closed");
}

void print(const nlohmann::ordered_json& document) { print(document.dump(2) + "\n"); }

const std::atomic<bool>& interrupted() noexcept { return interrupt_flag; }

double Progress::now() {
  const auto time = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(time).count();
}

void Progress::clear() {
  if (printed_ > 0) std::fputs("\r\033[K", stderr);
  printed_ = 0;
}

void Progress::operator()(const char* what, std::size_t done, std::size_t total) {
  const double time = now();
  if (time - started_ < 1 || time - printed_ < 0.1 || isatty(STDERR_FILENO) == 0) return;
  printed_ = time;
  fmt::print(
      stderr, "\r\033[K{}: {} of {} ({:.0f}%)", what, done, total,
      100.0 * static_cast<double>(done) / static_cast<double>(std::max<std::size_t>(total, 1)));
  std::fflush(stderr);
}

}  // namespace convexact::cli
