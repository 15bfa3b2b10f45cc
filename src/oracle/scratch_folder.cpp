// SPDX-License-Identifier: MIT
#include "oracle/scratch_folder.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <vector>

#include "convexact/error.hpp"

namespace convexact {
namespace {

std::mutex& paths_mutex() {
  static std::mutex mutex;
  return mutex;
}

std::vector<std::string>& all_paths() {
  static std::vector<std::string> paths;
  return paths;
}

}  // namespace

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
