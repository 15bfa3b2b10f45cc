// SPDX-License-Identifier: MIT
#include "fuzz_target.hpp"

#include <algorithm>

namespace {

// Made at its first use: targets of other files may come before this file's own objects.
std::vector<const FuzzTarget*>& targets() {
  static std::vector<const FuzzTarget*> list;
  return list;
}

}  // namespace

FuzzTarget::FuzzTarget(const char* called, void (*held)(FuzzInput& in)) : name(called), hold(held) {
  targets().push_back(this);
}

const std::vector<const FuzzTarget*>& FuzzTarget::all() { return targets(); }

const FuzzTarget* FuzzTarget::find(std::string_view name) {
  const auto found = std::find_if(all().begin(), all().end(),
                                  [&](const FuzzTarget* target) { return target->name == name; });
  return found == all().end() ? nullptr : *found;
}
