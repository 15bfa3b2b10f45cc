// SPDX-License-Identifier: MIT
// stage_times.hpp - where the time of a run goes, and the time that skipping stages saves.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "convexact/simplify.hpp"
#include "report/effort.hpp"

namespace convexact {

struct StageTime {
  std::string name;
  std::optional<Spread> seconds;  ///< None if the stage was left out:
  std::string skipped;            ///< why.
};

/// One kind of run of the pipeline, repeated.
struct RunTimes {
  std::string run;  ///< "exact", "filtered", "float": down to so many halfspaces, nothing else.
                    ///< "everything": by the filtered engine, and no stage left out.
  std::optional<Spread> seconds;  ///< From the input in memory to the result; none if it took
                                  ///< longer than the effort allows.
  std::vector<StageTime> stages;
};

/// Runs of simplify() by each engine, with the verification that is its default, and one of
/// everything: exact planes, certificate and Chebyshev center; record and ties of each step; the
/// result as planes and as a mesh in binary64; area, mean width and exact volumes; and the detour
/// through the halfspaces, which points do not need. So "filtered" against "everything" shows the
/// time that planning saves.
[[nodiscard]] std::vector<RunTimes> measure_stage_times(const Shape& shape, std::size_t faces,
                                                        const Effort& effort);

}  // namespace convexact
