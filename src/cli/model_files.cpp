// SPDX-License-Identifier: MIT
#include "cli/model_files.hpp"

#include <algorithm>
#include <filesystem>

#include "convexact/error.hpp"
#include "oracle/part_models.hpp"

namespace convexact::cli {
namespace {

namespace fs = std::filesystem;

bool is_model(PartsOutput kind) {
  return kind == PartsOutput::Mjcf || kind == PartsOutput::Urdf || kind == PartsOutput::Usd;
}

bool is_folder(const std::string& path) { return parts_output_of(path) == PartsOutput::Folder; }

// The name of the file up to its extension.
std::string model_name(const std::string& path, PartsOutput kind) {
  const std::string name = fs::path(path).filename().string();
  const std::size_t extension = kind == PartsOutput::Mjcf ? kMjcfExtension.size() : 5;
  return name.substr(0, name.size() - extension);
}

// Paths relative to the place of the model, as readers expect. Neither has to exist.
std::vector<PartFile> files_in(const std::string& folder, const std::string& model,
                               std::span<const WrittenPart> parts) {
  const fs::path place = fs::weakly_canonical(fs::absolute(model).parent_path());
  const fs::path target = fs::weakly_canonical(fs::absolute(folder));
  std::vector<PartFile> files;
  for (const WrittenPart& part : parts) {
    const fs::path file = target / part_file_name(part.name);
    files.push_back({part.name, file.lexically_relative(place).generic_string()});
  }
  return files;
}

}  // namespace

void require_model_options(const std::vector<std::string>& outputs, Precision precision,
                           FlatParts flat) {
  const auto folders = std::count_if(outputs.begin(), outputs.end(), is_folder);
  for (const std::string& path : outputs) {
    const PartsOutput kind = parts_output_of(path);
    if (!is_model(kind)) continue;
    if (precision != Precision::Binary32) {
      throw Error(ErrorCode::InvalidArgument,
                  "-o " + path +
                      ": simulators round to the nearest binary32 number, which cuts off points "
                      "of the input; --precision 32 rounds outward before they do");
    }
    if (flat == FlatParts::Keep) {
      throw Error(ErrorCode::InvalidArgument,
                  "-o " + path +
                      ": a part that stays flat is no solid to a simulator; --flat thicken, the "
                      "default, makes it one");
    }
    if (kind != PartsOutput::Usd && folders != 1) {
      throw Error(ErrorCode::InvalidArgument,
                  "-o " + path +
                      ": it names the files of the parts, so one folder for them is "
                      "needed, such as -o parts/, and there are " +
                      (folders == 0 ? "none" : "several"));
    }
  }
}

std::string model_bytes(const std::string& path, const std::vector<std::string>& outputs,
                        std::span<const WrittenPart> parts) {
  const PartsOutput kind = parts_output_of(path);
  const std::string name = model_name(path, kind);
  if (kind == PartsOutput::Usd) return proven_parts_usd(name, parts, path);
  const std::string& folder = *std::find_if(outputs.begin(), outputs.end(), is_folder);
  const std::vector<PartFile> files = files_in(folder, path, parts);
  return kind == PartsOutput::Mjcf ? write_mjcf(name, files) : write_urdf(name, files);
}

}  // namespace convexact::cli
