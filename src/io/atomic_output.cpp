// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>

#include "convexact/error.hpp"
#include "convexact/io.hpp"

namespace convexact {
namespace {

[[noreturn]] void cannot_write(const std::string& path, const std::string& reason) {
  throw Error(ErrorCode::Unwritable, "cannot be written: " + reason).in_file(path);
}
[[noreturn]] void cannot_write(const std::string& path, int reason) {
  cannot_write(path, std::strerror(reason));
}

std::string folder_of(const std::string& target) {
  const std::string folder = std::filesystem::path(target).parent_path().string();
  return folder.empty() ? "." : folder;
}

// Follows symbolic links to the file itself, which need not exist yet.
std::string resolve(const std::string& path) {
  std::error_code failed;
  // The relative name of a file that does not exist would stay as it is spelt.
  auto absolute = std::filesystem::absolute(path, failed);
  // weakly_canonical() would stop at a link to a file that does not exist.
  constexpr int kLongestChain = 40;  // as Linux allows
  for (int k = 0; k < kLongestChain && std::filesystem::is_symlink(absolute, failed); ++k) {
    absolute = absolute.parent_path() / std::filesystem::read_symlink(absolute, failed);
  }
  if (std::filesystem::is_symlink(absolute, failed)) cannot_write(path, ELOOP);
  const auto resolved = std::filesystem::weakly_canonical(absolute, failed);
  return failed ? path : resolved.string();
}

// An unused name beside the target; `attempt` makes the next one different. It begins like the
// target, whose name may be as long as names may be.
std::string name_beside(const std::string& target, const char* suffix, int attempt) {
  constexpr std::size_t kKept = 200;
  const std::filesystem::path path(target);
  const std::string name = "." + path.filename().string().substr(0, kKept) + "." +
                           std::to_string(::getpid()) + "-" + std::to_string(attempt) + suffix;
  return (path.parent_path() / name).string();
}

// The mode of the file that will be replaced, if there is one.
std::optional<mode_t> require_replaceable(const std::string& path, const std::string& target) {
  struct stat status;
  if (::stat(target.c_str(), &status) != 0) return std::nullopt;
  if (S_ISDIR(status.st_mode)) cannot_write(path, EISDIR);
  if (!S_ISREG(status.st_mode)) cannot_write(path, "Is not a regular file");
  if (::access(target.c_str(), W_OK) != 0) cannot_write(path, errno);
  return status.st_mode;
}

constexpr int kAttempts = 1000;  // files left by killed runs may have taken some names

int create_beside(const std::string& target, std::string& name) {
  int file = -1;
  for (int attempt = 0; attempt < kAttempts && file < 0; ++attempt) {
    name = name_beside(target, ".new", attempt);
    file = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file < 0 && errno != EEXIST) break;
  }
  if (file < 0) name.clear();
  return file;
}

// 0, or the errno of the failure.
int write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(file, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) return errno;
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return ::fsync(file) == 0 ? 0 : errno;
}

// Flushes the renames in a folder to the disk. Some file systems cannot; then only durability is
// lost.
void sync_folder(const std::string& target) {
  const int folder = ::open(folder_of(target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;
  (void)::fsync(folder);
  ::close(folder);
}

}  // namespace

AtomicOutput::~AtomicOutput() { undo(); }

void AtomicOutput::add(const std::string& path, std::string_view bytes) {
  try {
    File file{.path = path, .target = resolve(path), .temporary = {}, .backup = {}};
    for (const File& other : files_) {
      if (other.target != file.target) continue;
      throw Error(ErrorCode::InvalidArgument, "two outputs go to this file").in_file(path);
    }
    files_.push_back(std::move(file));
    write_temporary(files_.back(), bytes);
  } catch (...) {
    undo();
    throw;
  }
}

void AtomicOutput::require_writable(const std::string& path) {
  const std::string target = resolve(path);
  require_replaceable(path, target);
  if (::access(folder_of(target).c_str(), W_OK | X_OK) != 0) cannot_write(path, errno);
}

void AtomicOutput::write_temporary(File& file, std::string_view bytes) {
  const std::optional<mode_t> mode = require_replaceable(file.path, file.target);
  const int descriptor = create_beside(file.target, file.temporary);
  if (descriptor < 0) cannot_write(file.path, errno);
  int reason = write_all(descriptor, bytes);
  if (mode && reason == 0 && ::fchmod(descriptor, *mode & 07777) != 0) reason = errno;
  if (::close(descriptor) != 0 && reason == 0) reason = errno;
  if (reason != 0) cannot_write(file.path, reason);
}

void AtomicOutput::commit(const std::function<void()>& last) {
  try {
    for (File& file : files_) {
      // The last step is never undone, so the file that it replaces needs no second name.
      if (last || &file != &files_.back()) keep_replaced(file);
      if (std::rename(file.temporary.c_str(), file.target.c_str()) != 0)
        cannot_write(file.path, errno);
      file.moved = true;
    }
    if (last) last();
  } catch (...) {
    undo();
    throw;
  }
  for (const File& file : files_) {
    if (!file.backup.empty()) (void)::unlink(file.backup.c_str());
    sync_folder(file.target);
  }
  files_.clear();
}

void AtomicOutput::keep_replaced(File& file) {
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    file.backup = name_beside(file.target, ".old", attempt);
    if (::link(file.target.c_str(), file.backup.c_str()) == 0) return;
    const int reason = errno;
    if (reason == EEXIST) continue;
    // Where hard links are refused, the file is moved away instead. Some refuse them before they
    // look whether there is a file.
    const bool is_there = reason != ENOENT && ::access(file.target.c_str(), F_OK) == 0;
    if (is_there && ::access(file.backup.c_str(), F_OK) != 0 &&
        std::rename(file.target.c_str(), file.backup.c_str()) == 0) {
      return;
    }
    file.backup.clear();  // no file has this name
    if (!is_there) return;
    cannot_write(file.path, reason);
  }
  file.backup.clear();
  cannot_write(file.path, EEXIST);
}

void AtomicOutput::undo() noexcept {
  for (const File& file : files_) {
    if (!file.moved && !file.temporary.empty()) (void)::unlink(file.temporary.c_str());
    if (!file.backup.empty()) {
      // Renaming one name of a file to another name of the same file does nothing and leaves both.
      (void)std::rename(file.backup.c_str(), file.target.c_str());
      (void)::unlink(file.backup.c_str());
    } else if (file.moved) {
      (void)::unlink(file.target.c_str());
    }
  }
  files_.clear();
}

}  // namespace convexact
