// SPDX-License-Identifier: MIT
// process.hpp - runs the program as a user would and keeps its output.
#pragma once
#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace support {

/// A separate folder for one test, removed afterwards.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "convexact-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no scratch folder");
    path_ = name;
  }
  ~ScratchFolder() { std::filesystem::remove_all(path_); }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::string file(const std::string& name) const { return (path_ / name).string(); }
  std::string write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path_ / name, std::ios::binary) << bytes;
    return file(name);
  }
  std::size_t count() const {
    std::size_t entries = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(path_)) ++entries;
    return entries;
  }

 private:
  std::filesystem::path path_;
};

/// The path of a shipped mesh.
inline std::string data(const std::string& name) {
  return std::string(std::getenv("CONVEXACT_TEST_DATA")) + "/" + name;
}

inline std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

struct Ran {
  int exit = -1;  ///< 128 + signal if one ended it.
  std::string out, err;
};

/// Runs a command of the shell; `after` is what the shell goes on with.
inline Ran run_shell(const std::string& words, const std::string& after = "") {
  const ScratchFolder scratch;
  const std::string command =
      words + " >" + scratch.file("out") + " 2>" + scratch.file("err") + after;
  const int status = std::system(command.c_str());
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return {code, bytes_of(scratch.file("out")), bytes_of(scratch.file("err"))};
}

/// Runs the program under test (CONVEXACT_PROGRAM) with shell-quoted arguments.
inline Ran run_program(const std::string& arguments, const std::string& after = "") {
  const char* program = std::getenv("CONVEXACT_PROGRAM");
  if (program == nullptr) throw std::runtime_error("CONVEXACT_PROGRAM is not set");
  return run_shell(std::string("'") + program + "' " + arguments, after);
}

/// Runs the program and sends it `signal` (INT or TERM) when it has worked for `seconds`: the time
/// counts from when it handles SIGINT, the second bit of SigCgt, however long a busy machine takes
/// to start it. `then` is what the shell does before it waits for the program, $pid.
inline Ran run_interrupted(const std::string& arguments, const std::string& signal,
                           const std::string& seconds, const std::string& then = "") {
  return run_program(
      arguments,
      " & pid=$!; for i in $(seq 3000); do"
      " grep -q '^SigCgt:.*[2367abef]$' /proc/$pid/status && break; sleep 0.02; done;"
      " sleep " +
          seconds + "; kill -" + signal + " $pid; " + then + "wait $pid");
}

}  // namespace support
