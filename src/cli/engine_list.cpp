// SPDX-License-Identifier: MIT
#include "cli/engine_list.hpp"

#include <CLI/CLI.hpp>

#include "convexact/error.hpp"
#include "scene/result_json.hpp"

namespace convexact::cli {

std::vector<Engine> parse_engines(const std::string& text, const char* option) {
  std::vector<Engine> engines;
  for (const std::string& word : CLI::detail::split(text, ',')) {
    const auto engine = value_in(kEngineNames, word);
    if (!engine) {
      throw Error(ErrorCode::InvalidArgument,
                  std::string(option) + ": expected names out of exact,filtered,float, found '" +
                      word + "'");
    }
    engines.push_back(*engine);
  }
  return engines;
}

}  // namespace convexact::cli
