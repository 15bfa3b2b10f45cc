// SPDX-License-Identifier: MIT
// atomic_output.hpp - several files that appear together, complete, or not at all.
#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace convexact {

/// Each file is written beside its target under another name; commit() moves all into place.
/// Unless that succeeds, every target stays as it was and nothing new is left behind.
class AtomicOutput {
 public:
  AtomicOutput() = default;
  ~AtomicOutput();
  AtomicOutput(const AtomicOutput&) = delete;
  AtomicOutput& operator=(const AtomicOutput&) = delete;

  /// Writes `bytes` to the disk, for `path` to hold after commit(). A symbolic link stays one: the
  /// file that it points to is replaced. A file that exists keeps its permissions.
  /// After an error every file added so far is forgotten, and removed.
  /// @throws Error Unwritable if the folder does not exist or cannot be written to, or if the
  ///               target is a folder or another thing that is no regular file;
  ///               InvalidArgument if `path` was added before.
  void add(const std::string& path, std::string_view bytes);

  /// Moves all files into place and then calls `last`, if there is one: the step of the run that
  /// must succeed with them, such as telling of them.
  /// @throws Error Unwritable, or what `last` throws, after undoing the moves made so far.
  void commit(const std::function<void()>& last = {});

 private:
  struct File {
    std::string path;       // as the caller gave it, for messages
    std::string target;     // without symbolic links
    std::string temporary;  // empty once it has been moved
    std::string backup;     // another name of the file that was replaced; empty: there was none
    bool moved = false;
  };

  static void write_temporary(File& file, std::string_view bytes);
  static void keep_replaced(File& file);
  void undo() noexcept;
  std::vector<File> files_;
};

}  // namespace convexact
