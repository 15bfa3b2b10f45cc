// SPDX-License-Identifier: MIT
#include "cli/part_files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "io/json_text.hpp"
#include "number/text.hpp"

namespace convexact::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestName = 200;  // of the 255 bytes that file systems allow

[[noreturn]] void reject_names(const std::string& pattern, const std::string& why) {
  throw Error(ErrorCode::InvalidArgument, "--names: " + why + ", found " + in_quotes(pattern));
}

bool has_extension(const std::string& path, std::string_view extension) {
  return path.size() >= extension.size() &&
         std::equal(extension.rbegin(), extension.rend(), path.rbegin(), [](char lower, char c) {
           return lower == (c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
         });
}

bool is_blank(char c) { return c == ' ' || c == '\t'; }

// Folders that did not exist before; they are removed again, if they are empty, unless keep() is
// called.
class NewFolders {
 public:
  NewFolders() = default;
  NewFolders(const NewFolders&) = delete;
  NewFolders& operator=(const NewFolders&) = delete;
  ~NewFolders() {
    std::error_code ignored;
    for (const std::string& folder : made_) fs::remove(folder, ignored);
  }

  void make(const std::string& folder) {
    std::error_code failed;
    if (fs::create_directory(folder, failed)) made_.push_back(folder);
    if (failed) {
      throw Error(ErrorCode::Unwritable, "the folder cannot be made: " + failed.message())
          .in_file(folder);
    }
  }
  void keep() { made_.clear(); }

 private:
  std::vector<std::string> made_;
};

// Files under names that no reader of a folder looks at. They get their names back unless remove()
// is called.
class HiddenFiles {
 public:
  explicit HiddenFiles(const std::vector<std::string>& files) {
    for (const std::string& file : files) {
      const fs::path path(file);
      const fs::path hidden = path.parent_path() / ("." + path.filename().string() + "." +
                                                    std::to_string(::getpid()) + ".old");
      std::error_code failed;
      fs::rename(path, hidden, failed);
      if (failed) {
        show();
        throw Error(ErrorCode::Unwritable, "cannot be removed: " + failed.message()).in_file(file);
      }
      moved_.emplace_back(path, hidden);
    }
  }
  HiddenFiles(const HiddenFiles&) = delete;
  HiddenFiles& operator=(const HiddenFiles&) = delete;
  ~HiddenFiles() { show(); }

  void remove() {
    std::error_code ignored;
    for (const auto& [path, hidden] : moved_) fs::remove(hidden, ignored);
    moved_.clear();
  }

 private:
  void show() {
    std::error_code ignored;
    for (const auto& [path, hidden] : moved_) fs::rename(hidden, path, ignored);
    moved_.clear();
  }

  std::vector<std::pair<fs::path, fs::path>> moved_;
};

// The names of files that the document of an earlier run gives; none if there is no such document.
std::set<std::string> files_of_document(const fs::path& path) {
  std::set<std::string> names;
  std::error_code failed;
  if (!fs::is_regular_file(path, failed)) return names;
  const std::string bytes = read_bytes(path.string());
  nlohmann::json document;
  try {
    document = parse_json(bytes);
  } catch (const Error&) {
    return names;
  }
  if (!document.is_object() || !document.contains("decomposition")) return names;
  const auto parts = document.find("parts");
  if (parts == document.end() || !parts->is_array()) return names;
  for (const auto& part : *parts) {
    if (!part.is_object() || !part.contains("file") || !part["file"].is_string()) continue;
    names.insert(part["file"].get<std::string>());
  }
  return names;
}

}  // namespace

bool is_plain_name(const std::string& text) {
  const bool has_plain_ends =
      text.empty() || (text[0] != '.' && !is_blank(text[0]) && !is_blank(text.back()));
  return has_plain_ends && text.size() <= kLongestName &&
         std::none_of(text.begin(), text.end(), [](char c) {
           const auto byte = static_cast<unsigned char>(c);
           return byte < ' ' || byte == 0x7f || c == '/' || c == '\\' || c == '#';
         });
}

PartNames::PartNames(const std::string& pattern) {
  const auto begin = pattern.find('%');
  const auto end = begin == pattern.npos ? begin : pattern.find('d', begin);
  const std::string width = end == pattern.npos ? "?" : pattern.substr(begin + 1, end - begin - 1);
  const bool is_number =
      width.empty() || (width.size() == 2 && width[0] == '0' && width[1] >= '1' && width[1] <= '9');
  if (!is_number || pattern.find('%', begin + 1) != pattern.npos) {
    reject_names(pattern, "expected a name with exactly one %d or %0Nd, N from 1 to 9");
  }
  before_ = pattern.substr(0, begin);
  after_ = pattern.substr(end + 1);
  if (!width.empty()) width_ = static_cast<std::size_t>(width[1] - '0');
  if (pattern.find_first_of("/\\") != pattern.npos) {
    reject_names(pattern, "expected a name without a folder, since -o names that");
  }
  if (!is_plain_name(pattern)) {
    reject_names(pattern,
                 "expected at most 200 printable characters, no # among them, no blank at either "
                 "end and no dot at the beginning");
  }
}

std::string PartNames::operator()(std::size_t k) const {
  return fmt::format("{}{:0{}}{}", before_, k, width_, after_);
}

bool PartNames::may_end(std::string_view name) const {
  if (!name.ends_with(after_)) return false;
  name.remove_suffix(after_.size());
  const std::size_t last = name.find_last_not_of("0123456789");
  const std::size_t digits = name.size() - (last == name.npos ? 0 : last + 1);
  return digits >= width_ && name.substr(0, name.size() - digits).ends_with(before_);
}

PartsOutput parts_output_of(const std::string& path) {
  std::error_code ignored;
  if (path.ends_with('/') || fs::is_directory(path, ignored)) return PartsOutput::Folder;
  if (mesh_format_of_path(path) == MeshFormat::Obj) return PartsOutput::Obj;
  if (mesh_format_of_path(path) == MeshFormat::Gltf) return PartsOutput::Glb;
  if (halfspace_format_of_path(path) == HalfspaceFormat::Json) return PartsOutput::Json;
  if (has_extension(path, kMjcfExtension)) return PartsOutput::Mjcf;
  if (has_extension(path, ".urdf")) return PartsOutput::Urdf;
  if (has_extension(path, ".usda")) return PartsOutput::Usd;
  throw Error(
      ErrorCode::InvalidArgument,
      "-o " + path +
          ": expected an extension .obj or .glb (an object for each part), .json, .mjcf.xml, .urdf "
          "or .usda, or a folder (a name that ends in /)");
}

bool is_folder(const std::string& path) { return parts_output_of(path) == PartsOutput::Folder; }

std::string part_file_name(const std::string& part) { return part + ".obj"; }

LeftInFolder left_in_folder(const std::string& folder, const std::set<std::string>& written,
                            const std::vector<std::string>& inputs) {
  LeftInFolder left;
  std::error_code failed;
  const std::set<std::string> earlier = files_of_document(fs::path(folder) / kPartsDocument);
  for (fs::directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed)) {
    const std::string name = it->path().filename().string();
    if (name.front() == '.' || !mesh_format_of_path(name) || written.contains(name)) continue;
    std::error_code ignored;
    const bool is_input = std::any_of(inputs.begin(), inputs.end(), [&](const std::string& input) {
      std::error_code missing;
      return fs::equivalent(it->path(), input, missing);
    });
    const bool is_stale = earlier.contains(name) && it->is_regular_file(ignored) && !is_input;
    (is_stale ? left.stale : left.foreign).push_back(it->path().string());
  }
  std::sort(left.stale.begin(), left.stale.end());
  std::sort(left.foreign.begin(), left.foreign.end());
  return left;
}

void write_parts_together(const OutputFiles& files, const std::vector<std::string>& folders,
                          const std::vector<std::string>& stale, const std::string& summary) {
  NewFolders made;  // removed after the files in them
  for (const std::string& folder : folders) made.make(folder);
  AtomicOutput output;
  for (const auto& [path, bytes] : files) output.add(path, bytes);
  output.commit([&] {
    HiddenFiles hidden(stale);
    print(summary);
    hidden.remove();
  });
  made.keep();
}

}  // namespace convexact::cli
