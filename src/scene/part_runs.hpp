// SPDX-License-Identifier: MIT
// part_runs.hpp - the engines' runs as the steps of a shared run.
#pragma once
#include <memory>

#include "scene/run_stages.hpp"
#include "scene/shared_run.hpp"

namespace convexact {

/// A run of one part that a shared run may advance.
class ScenePartRun : public PartRun {
 public:
  /// The end, for the reason why the shared run ends.
  virtual RunEnd finish(StopReason stop, StageLog& log) = 0;
};

/// The run of the engine that the request names. @param input, request  Must outlive it.
[[nodiscard]] std::unique_ptr<ScenePartRun> start_part(const RunInput& input,
                                                       const SimplifyRequest& request);

}  // namespace convexact
