// SPDX-License-Identifier: MIT
#include "cli/shipped_vectors.hpp"

#include <filesystem>

#include "cli/command.hpp"
#include "convexact/error.hpp"

namespace convexact::cli {
namespace {

namespace fs = std::filesystem;

// A build folder mirrors the source's folders, but not their data.
bool holds_json(const fs::path& folder) {
  std::error_code failed;
  for (const fs::path& file : fs::directory_iterator(folder, failed)) {
    if (file.extension() == ".json") return true;
  }
  return false;
}

}  // namespace

std::vector<TestVector> read_vectors(const std::string& folder) {
  if (!folder.empty()) return read_test_vectors(folder);
  const auto found = find_shipped("vectors", holds_json);
  if (!found) {
    throw Error(ErrorCode::Unreadable, "the conformance vectors were not found: use --vectors");
  }
  return read_test_vectors(*found);
}

const TestVector& vector_of_id(const std::vector<TestVector>& vectors, const std::string& id) {
  std::vector<std::string> ids;
  for (const TestVector& vector : vectors) {
    if (vector.id == id) return vector;
    ids.push_back(vector.id);
  }
  throw Error(ErrorCode::InvalidArgument,
              "there is no vector " + in_quotes(id) + did_you_mean(id, ids));
}

}  // namespace convexact::cli
