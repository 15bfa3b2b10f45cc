// SPDX-License-Identifier: MIT
// program.hpp - work in a separate process with limits, whose output and result are captured; and a
// folder for the files that a program reads and writes.
#pragma once
#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "convexact/conform.hpp"

namespace convexact {

/// A file descriptor, closed at the end.
class Descriptor {
 public:
  explicit Descriptor(int id = -1) : id_(id) {}
  ~Descriptor() { reset(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int id() const { return id_; }
  /// Closes it, and takes another.
  void reset(int id = -1);

 private:
  int id_;
};

/// A fork of this process that does one piece of work, in a separate process group. It is killed
/// with all processes that it started when this object is destroyed, and dies with its parent. Its
/// standard input is empty, and it leaves no core dump.
class ChildProcess {
 public:
  /// @param work  Its bytes are the result. If it throws, the child prints the message and ends
  ///              with the exit code of Internal, or of Stopped if memory ran out. It may
  ///              also become another program, by exec.
  /// @throws Error Stopped if the system cannot make a process.
  ChildProcess(const std::function<std::string()>& work, const ProgramLimits& limits);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// The run, once it has ended or taken too long; after that this must not be called again.
  /// Otherwise waits for output, at most this long.
  [[nodiscard]] std::optional<ProgramRun> poll(int milliseconds);
  /// For a child that has ended: what its work returned; empty if it did not return.
  [[nodiscard]] std::string result() const;

 private:
  using Clock = std::chrono::steady_clock;
  [[noreturn]] void become_child(const std::function<std::string()>& work, int output) const;
  bool listen(int milliseconds);
  void kill_group() const;

  ProgramLimits limits_;
  Clock::time_point start_ = Clock::now();
  Descriptor output_, result_;
  int id_ = -1;
  bool has_ended_ = false;
  ProgramRun run_;
};

/// A new folder, removed by the destructor.
class ScratchFolder {
 public:
  /// @throws Error Unwritable.
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::string file(const std::string& name) const { return path_ + "/" + name; }
  /// The path of a new file with these bytes. @throws Error Unwritable.
  std::string write(const std::string& name, const std::string& bytes) const;

 private:
  std::string path_;
};

/// Removes all of these folders, for an end of the process without destructors.
void remove_scratch_folders() noexcept;

}  // namespace convexact
