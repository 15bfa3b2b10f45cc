// SPDX-License-Identifier: MIT
#include "wire/result_files.hpp"

#include <algorithm>

#include "convexact/io.hpp"

namespace convexact {
namespace {

Precision precision_of(int bits) { return bits == 32 ? Precision::Binary32 : Precision::Binary64; }

}  // namespace

bool is_binary32_only(const std::string& name) {
  const auto format = mesh_format_of_path(name);
  return format && holds_binary32_only(*format);
}

std::string file_of_less_precision(const std::vector<std::string>& names, int precision) {
  const auto found = std::find_if(names.rbegin(), names.rend(), is_binary32_only);
  if (found == names.rend() || precision == 32) return {};
  const bool is_alone = std::none_of(names.begin(), names.end(), [](const std::string& name) {
    return mesh_format_of_path(name) && !is_binary32_only(name);
  });
  return precision == 0 && is_alone ? std::string() : *found;
}

bool is_result_file(const std::string& name) {
  return is_proof(name) || mesh_format_of_path(name) || halfspace_format_of_path(name);
}

bool needs_record(const std::vector<std::string>& names) {
  return std::any_of(names.begin(), names.end(), is_proof);
}

StoreRequest store_request_for(const std::vector<std::string>& names, int precision) {
  StoreRequest request;
  const bool needs_32 = std::any_of(names.begin(), names.end(), is_binary32_only);
  for (const std::string& name : names) {
    if (mesh_format_of_path(name)) {
      request.mesh = precision_of(precision != 0 ? precision : needs_32 ? 32 : 64);
    } else if (precision != 0) {  // a proof has planes in a format, too
      request.planes = precision_of(precision);
    }
  }
  return request;
}

}  // namespace convexact
