// SPDX-License-Identifier: MIT
// peak_memory.hpp - how much memory a piece of work took at its highest, on Linux.
#pragma once
#include <malloc.h>

#include <algorithm>
#include <fstream>
#include <string>

/// From construction on. The kernel's mark is per process and is reset here, after what earlier
/// work left behind is given back.
class PeakMemory {
 public:
  PeakMemory() {
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << "5";
    before_ = kilobytes("VmRSS:");
  }
  /// Bytes; 0 where the system does not tell.
  double bytes() const { return 1024 * std::max(0.0, kilobytes("VmHWM:") - before_); }

 private:
  static double kilobytes(const std::string& name) {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
      double value = 0;
      if (word == name && status >> value) return value;
    }
    return 0;
  }

  double before_ = 0;
};
