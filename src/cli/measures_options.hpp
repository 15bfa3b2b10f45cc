// SPDX-License-Identifier: MIT
// measures_options.hpp - which numbers are measured beside what is proven of a decomposition.
#pragma once
#include <optional>
#include <string>

#include "cli/parser.hpp"
#include "convexact/overlay.hpp"

namespace convexact::cli {

struct MeasuresOptions {
  std::optional<PartMeasures> wanted;
  bool exact_volumes = false;

  /// Without a wish: what the parts leave out, and everything for JSON.
  /// @throws Error InvalidArgument for exact volumes of no measures.
  [[nodiscard]] PartMeasures to_print(bool as_json) const;
};

/// Adds --measures and --exact-volumes. @param where  Begins their meanings; may be empty.
void add_measures_options(Command& command, MeasuresOptions& options, const std::string& where);

}  // namespace convexact::cli
