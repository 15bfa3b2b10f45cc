// SPDX-License-Identifier: MIT
// Feeds files, and all files of folders, to a fuzz target without a fuzzing engine: its corpus as
// an ordinary test, or one input that a fuzzer found, under a debugger.
//     replay TARGET FILE-OR-FOLDER...
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>

#include "convexact/io.hpp"
#include "fuzz_target.hpp"

#ifdef CONVEXACT_LIMB_POOL
#include "limb_pool.hpp"
#endif

namespace {

std::vector<std::filesystem::path> files_of(int count, char** arguments) {
  std::vector<std::filesystem::path> files;
  for (int k = 2; k < count; ++k) {
    if (!std::filesystem::is_directory(arguments[k])) files.emplace_back(arguments[k]);
    if (!std::filesystem::is_directory(arguments[k])) continue;
    for (const auto& entry : std::filesystem::directory_iterator(arguments[k])) {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

int main(int count, char** arguments) {
#ifdef CONVEXACT_LIMB_POOL
  pool_limbs();
#endif
  const FuzzTarget* const target = count > 1 ? FuzzTarget::find(arguments[1]) : nullptr;
  if (target == nullptr) {
    std::fprintf(stderr, "replay TARGET FILE-OR-FOLDER...; the targets are:\n");
    for (const FuzzTarget* known : FuzzTarget::all()) std::fprintf(stderr, "%s\n", known->name);
    return 2;
  }
  const std::vector<std::filesystem::path> files = files_of(count, arguments);
  for (const auto& file : files) {
    std::printf("%s\n", file.filename().c_str());
    std::fflush(stdout);  // the last line names the input if it ends the process
    const std::string bytes = convexact::read_bytes(file.string());
    FuzzInput in(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    target->hold(in);
  }
  std::printf("%zu inputs replayed\n", files.size());
  return files.empty() ? 1 : 0;
}
