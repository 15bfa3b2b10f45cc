// SPDX-License-Identifier: MIT
#include "report/machine.hpp"

#include <fstream>
#include <sstream>
#include <thread>

namespace convexact {
namespace {

// The text after "NAME :" in a file of such lines; empty if there is none.
std::string entry_of(const char* file, const std::string& name) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind(name, 0) != 0) continue;
    const std::size_t start = line.find_first_not_of(" \t", line.find(':') + 1);
    if (start != std::string::npos) return line.substr(start);
  }
  return {};
}

}  // namespace

Machine this_machine() {
  Machine machine;
  machine.processor = entry_of("/proc/cpuinfo", "model name");
  if (machine.processor.empty()) machine.processor = "unknown";
  machine.cores = std::thread::hardware_concurrency();
  std::uint64_t kibibytes = 0;
  std::istringstream(entry_of("/proc/meminfo", "MemTotal")) >> kibibytes;
  machine.memory = 1024 * kibibytes;
  return machine;
}

}  // namespace convexact
