// SPDX-License-Identifier: MIT
// answer.hpp - everything that an engine says about one input, for the judge.
#pragma once
#include <string>
#include <vector>

#include "convexact/halfspace.hpp"
#include "stress/stress_result.hpp"

namespace convexact {

/// A result as bytes, as a file would hold it.
struct StoredBytes {
  StressStored::Form form = StressStored::Form::Planes;
  Precision precision = Precision::Binary64;
  bool whole = false;  ///< Of the input's hull itself, nothing removed.
  bool refused = false;
  std::string why;    ///< If refused.
  std::string bytes;  ///< JSON for planes, OBJ for a mesh.
  double push = 0, volume_ratio = 1;
};

/// A closed interval of rationals.
struct Range {
  Rational low, high;
};

struct EngineAnswer {
  Engine engine = Engine::Exact;
  StressEnd end = StressEnd::Failed;
  std::string why;  ///< Of an end with an error, and of NoVolume.

  std::vector<Halfspace> halfspaces;  ///< Of the solid, in canonical order; ids are positions.
  std::vector<HalfspaceId> removed;
  /// Of each step; empty for the float engine, which keeps no such record.
  std::vector<Rational> costs;
  std::vector<std::vector<HalfspaceId>> ties;
  /// What the run without a record says of each step; empty for the exact engine.
  std::vector<HalfspaceId> lean_removed;
  std::vector<Range> lean_costs;  ///< An estimate, so a point, of the float engine.
  std::vector<std::uint64_t> lean_tied;

  std::vector<Halfspace> left;        ///< What the pipeline returns.
  Range input_volume, output_volume;  ///< What it says about volumes.
  std::optional<StressClaim> claim;   ///< Of the float engine.
  std::vector<StoredBytes> stored;
  double seconds = 0;        ///< Of processor time: the pipeline with the exact result, not stored.
  std::uint64_t memory = 0;  ///< Filled in by the process that started this one.
};

struct Question {
  Engine engine = Engine::Exact;
  std::size_t faces = 4;
  std::uint64_t seed = 1;
  /// Of a solid of n halfspaces and largest valence v, of a facet or a vertex, for which n (v +
  /// 140) is above `most_work` only the first `most_steps` removals are made.
  std::size_t most_work = SIZE_MAX, most_steps = SIZE_MAX;
  std::size_t most_stored = SIZE_MAX;  ///< Solids of more halfspaces are not stored.
};

/// Runs an engine through the pipeline, as users do; again where needed for the record of its
/// steps; and stores the result in every format. The errors of convexact become part of the answer.
[[nodiscard]] EngineAnswer answer_of(const Shape& shape, const Question& question);

/// For the way from one process to another.
[[nodiscard]] std::string to_bytes(const EngineAnswer& answer);
[[nodiscard]] EngineAnswer answer_from_bytes(const std::string& bytes);
[[nodiscard]] std::string to_bytes(const std::vector<StressRun>& runs);
[[nodiscard]] std::vector<StressRun> runs_from_bytes(const std::string& bytes);

}  // namespace convexact
