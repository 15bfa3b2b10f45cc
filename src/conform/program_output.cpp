// SPDX-License-Identifier: MIT
#include "conform/program_output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <variant>

#include "conform/program.hpp"
#include "convexact/error.hpp"
#include "number/text.hpp"

namespace convexact {
namespace {

Error unreadable(const std::string& what) {
  return Error(ErrorCode::Malformed, "the output " + what);
}

// Opening a FIFO would wait for a writer, and reading a device may never end.
std::variant<std::string, Error> regular_bytes(int file, std::uint64_t most) {
  struct stat status;
  if (::fstat(file, &status) != 0 || !S_ISREG(status.st_mode)) {
    return unreadable("is no regular file");
  }
  const auto size = static_cast<std::uint64_t>(status.st_size);
  if (size > std::min<std::uint64_t>(most, std::string().max_size())) {
    return unreadable(fmt::format("has {} bytes, more than the {} that are read",
                                  with_separators(size), with_separators(most)));
  }
  std::string bytes(static_cast<std::size_t>(size), '\0');
  std::size_t filled = 0;
  while (filled < bytes.size()) {
    const ssize_t count = ::read(file, bytes.data() + filled, bytes.size() - filled);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return unreadable(std::string("cannot be read: ") + std::strerror(errno));
    if (count == 0) break;  // somebody shortens it
    filled += static_cast<std::size_t>(count);
  }
  bytes.resize(filled);
  return bytes;
}

}  // namespace

std::optional<Candidate> read_program_output(const std::string& path, Decimal decimal,
                                             std::uint64_t most) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  if (file.id() < 0) {
    if (errno == ENOENT) return std::nullopt;
    return unreadable(std::string("cannot be opened: ") + std::strerror(errno));
  }
  std::variant<std::string, Error> read = regular_bytes(file.id(), most);
  if (auto* error = std::get_if<Error>(&read)) return std::move(*error);
  const auto& bytes = std::get<std::string>(read);
  if (bytes.find_first_not_of(" \t\r\n") == std::string::npos) return Mesh{};
  return read_candidate_bytes(bytes, path, decimal);
}

}  // namespace convexact
