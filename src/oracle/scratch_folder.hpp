// SPDX-License-Identifier: MIT
// scratch_folder.hpp - a folder for the files that a program reads and writes.
#pragma once
#include <string>

namespace convexact {

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
