// SPDX-License-Identifier: MIT
#include "cli/engine_list.hpp"

#include <CLI/CLI.hpp>

#include "convexact/error.hpp"

namespace convexact::cli {

std::vector<Engine> parse_engines(const std::string& text, const char* option) {
  std::vector<Engine> engines;
  for (const std::string& word : CLI::detail::split(text, ',')) {
    if (word == "exact") {
      engines.push_back(Engine::Exact);
    } else if (word == "filtered") {
      engines.push_back(Engine::Filtered);
    } else if (word == "float") {
      engines.push_back(Engine::Float);
    } else {
      throw Error(ErrorCode::InvalidArgument,
                  std::string(option) + ": expected names out of exact,filtered,float, found '" +
                      word + "'");
    }
  }
  return engines;
}

}  // namespace convexact::cli
