// SPDX-License-Identifier: MIT
// Feeds files, and all files of folders, to a fuzz target: its corpus as an ordinary test, or one
// input that a fuzzer found, under a debugger, without a fuzzing engine.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "convexact/io/read_bytes.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int main(int count, char** arguments) {
  std::vector<std::filesystem::path> files;
  for (int k = 1; k < count; ++k) {
    if (!std::filesystem::is_directory(arguments[k])) files.emplace_back(arguments[k]);
    if (!std::filesystem::is_directory(arguments[k])) continue;
    for (const auto& entry : std::filesystem::directory_iterator(arguments[k])) {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    std::printf("%s\n", file.filename().c_str());
    std::fflush(stdout);  // the last line names the input, should it end the process
    const std::string bytes = convexact::read_bytes(file.string());
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  }
  std::printf("%zu inputs replayed\n", files.size());
  return files.empty() ? 1 : 0;
}
