// SPDX-License-Identifier: MIT
// shipped_meshes.hpp - the meshes of tests/data.
#pragma once
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

/// Paths of all its OBJ files, sorted. The test's environment names the directory.
inline std::vector<std::string> shipped_meshes() {
  const char* directory = std::getenv("CONVEXACT_TEST_DATA");
  if (directory == nullptr) throw std::runtime_error("CONVEXACT_TEST_DATA is not set");
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    if (entry.path().extension() == ".obj") paths.push_back(entry.path().string());
  }
  if (paths.empty()) throw std::runtime_error("there are no meshes in tests/data");
  std::sort(paths.begin(), paths.end());
  return paths;
}
