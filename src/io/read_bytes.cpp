// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "convexact/error.hpp"
#include "convexact/io.hpp"

namespace convexact {
namespace {

class Descriptor {
 public:
  explicit Descriptor(const std::string& path)
      : owned_(path != "-"),
        value_(owned_ ? ::open(path.c_str(), O_RDONLY | O_CLOEXEC) : STDIN_FILENO) {}
  ~Descriptor() {
    if (owned_ && value_ >= 0) ::close(value_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int value() const { return value_; }

 private:
  bool owned_;
  int value_;
};

[[noreturn]] void cannot_read(const std::string& path, int reason) {
  throw Error(ErrorCode::Unreadable, std::string("cannot be read: ") + std::strerror(reason))
      .in_file(display_name(path));
}

}  // namespace

std::string display_name(const std::string& path) { return path == "-" ? "standard input" : path; }

std::string read_bytes(const std::string& path) {
  const Descriptor file(path);
  struct stat status;
  if (file.value() < 0 || ::fstat(file.value(), &status) != 0) cannot_read(path, errno);
  if (S_ISDIR(status.st_mode)) cannot_read(path, EISDIR);
  // The size is a hint: pipes have none, and a file may grow while it is read.
  constexpr std::size_t kChunk = 1 << 16;
  std::string bytes;
  std::size_t filled = 0;
  const std::size_t hint = S_ISREG(status.st_mode) ? static_cast<std::size_t>(status.st_size) : 0;
  bytes.resize(std::max(hint + 1, kChunk));  // one more, to find the end
  while (true) {
    if (filled == bytes.size()) bytes.resize(2 * bytes.size());
    const ssize_t count = ::read(file.value(), bytes.data() + filled, bytes.size() - filled);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) cannot_read(path, errno);
    if (count == 0) break;
    filled += static_cast<std::size_t>(count);
  }
  bytes.resize(filled);
  return bytes;
}

}  // namespace convexact
