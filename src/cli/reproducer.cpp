// SPDX-License-Identifier: MIT
#include "cli/reproducer.hpp"

#include <filesystem>

#include "convexact/io.hpp"

namespace convexact::cli {
namespace {

constexpr int kMostFiles = 1000;

std::string text_of(const Reproducer& reproducer) {
  std::string text = std::string(CONVEXACT_VERSION) + "\ncommand:";
  for (const std::string& word : reproducer.command_line) text += " " + word;
  text += "\nfailure: " + reproducer.failure + "\n";
  for (const auto& [name, bytes] : reproducer.inputs) {
    text += "input " + name + ", " + std::to_string(bytes->size()) + " bytes:\n" + *bytes + "\n";
  }
  return text;
}

}  // namespace

std::string write_reproducer(const Reproducer& reproducer, const std::string& folder) noexcept {
  try {
    for (int number = 1; number <= kMostFiles; ++number) {
      const std::string suffix = number == 1 ? "" : "-" + std::to_string(number);
      std::string path = folder + "/convexact-reproducer" + suffix + ".txt";
      if (std::filesystem::exists(path)) continue;
      AtomicOutput output;
      output.add(path, text_of(reproducer));
      output.commit();
      return path;
    }
  } catch (const std::exception&) {  // the failure itself is reported in any case
  }
  return {};
}

}  // namespace convexact::cli
