// SPDX-License-Identifier: MIT
#include "io/file_beside.hpp"

#include <algorithm>
#include <filesystem>

#include "convexact/error.hpp"
#include "number/text.hpp"

namespace convexact {
namespace {

namespace fs = std::filesystem;

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

bool is_inside(const fs::path& file, const fs::path& folder) {
  const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return end == folder.end() && rest != file.end();
}

}  // namespace

std::string folder_of_file(const std::string& path) {
  if (path == "-") return "";
  const std::string folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

std::string decoded_uri(std::string_view uri) {
  std::string decoded;
  for (std::size_t k = 0; k < uri.size(); ++k) {
    if (uri[k] != '%') {
      decoded += uri[k];
      continue;
    }
    const int high = k + 2 < uri.size() ? hex_digit(uri[k + 1]) : -1;
    const int low = k + 2 < uri.size() ? hex_digit(uri[k + 2]) : -1;
    if (high < 0 || low < 0 || (high == 0 && low == 0)) {
      throw Error(ErrorCode::Malformed, "expected two digits behind %, found " + in_quotes(uri));
    }
    decoded += static_cast<char>(16 * high + low);
    k += 2;
  }
  return decoded;
}

std::string file_inside(const std::string& folder, std::string_view name,
                        const std::vector<std::string>& others) {
  const auto refuse = [&](const char* why) {
    throw Error(ErrorCode::Unreadable, "it names the file " + in_quotes(name) + why);
  };
  if (name.empty() || name.find('\0') != name.npos) refuse(", which is no name");
  const fs::path path(name);
  constexpr const char* kOutside = ", but only files in its own folder are read";
  if (path.is_absolute() || name.find("://") != name.npos || name.find('\\') != name.npos) {
    refuse(kOutside);
  }
  const fs::path file = fs::path(folder) / path;
  std::error_code failed;
  const fs::path real = fs::weakly_canonical(fs::absolute(file), failed);
  const auto holds = [&](const std::string& home) {
    std::error_code missing;
    const fs::path canonical = fs::weakly_canonical(fs::absolute(home), missing);
    return !missing && is_inside(real, canonical);
  };
  if (failed || !(holds(folder) || std::any_of(others.begin(), others.end(), holds))) {
    refuse(kOutside);
  }
  return file.string();
}

std::string file_beside(const std::string& folder, std::string_view uri) {
  const std::string name = decoded_uri(uri);
  if (folder.empty()) {
    throw Error(ErrorCode::Unreadable, "it names the file " + in_quotes(name) +
                                           ", but was itself read without a folder: give its path");
  }
  return file_inside(folder, name, {});
}

}  // namespace convexact
