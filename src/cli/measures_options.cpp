// SPDX-License-Identifier: MIT
#include "cli/measures_options.hpp"

#include "cli/options.hpp"

namespace convexact::cli {

PartMeasures MeasuresOptions::to_print(bool as_json) const {
  if (exact_volumes && wanted == PartMeasures::None) {
    throw Error(ErrorCode::InvalidArgument,
                "--exact-volumes asks for volumes and --measures none for none: name one");
  }
  return wanted.value_or(as_json ? PartMeasures::All : PartMeasures::Uncovered);
}

void add_measures_options(Command& command, MeasuresOptions& options, const std::string& where) {
  add_choice<PartMeasures>(
      command, "--measures", options.wanted,
      {{"none", PartMeasures::None},
       {"uncovered", PartMeasures::Uncovered},
       {"all", PartMeasures::All}},
      where +
          "what the parts leave out (the default); all, the default with --json: also union, "
          "excess, overlap and distances, which may take most of the time; or nothing");
  command.add_flag("--exact-volumes", options.exact_volumes,
                   where + "volumes in --json as fractions, too, which may be very long");
}

}  // namespace convexact::cli
