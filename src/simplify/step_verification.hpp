// SPDX-License-Identifier: MIT
// step_verification.hpp - proves each step of a run again, from plain lists and original planes.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>

#include "convexact/dual.hpp"
#include "convexact/run.hpp"

namespace convexact {

/// One condition that a step is tested for. A condition about a vertex where three planes meet has
/// the integer whose sign decides it.
struct TestedCondition {
  const char* name;
  std::optional<DualTriangle> triangle = {};  ///< The triangle whose vertex is tested ...
  std::optional<HalfspaceId> plane = {};      ///< ... and the plane that it is tested against;
                                              ///< none: its D.
  const Integer* value = nullptr;             ///< Valid during the call only.
  const char* wants = nullptr;                ///< ">0", ">=0" or "<=0" if there is a value.
};

/// Sees each tested condition, for lessons. One that does not hold is the last one.
class CheckObserver {
 public:
  virtual ~CheckObserver() = default;
  virtual void checked(const TestedCondition& check, bool holds) = 0;
};

/// Replays steps on a separate copy of the dual's directed edges. It shares no code with any
/// engine: it uses no center, computes with the planes (n, d) themselves, and assumes nothing about
/// a step. docs/verification.md says what each check proves.
class StepVerification {
 public:
  /// @param dual   The dual hull from which the run starts; must outlive this object.
  /// @param seed   For the two primes of the volume check.
  /// @param measure  Of the costs of steps.
  /// @param observer  Receives each condition tested; null for none.
  StepVerification(const DualHull& dual, VerifyLevel level, std::uint64_t seed = 1,
                   CostMeasure measure = CostMeasure::Volume, CheckObserver* observer = nullptr);
  ~StepVerification();

  /// Checks the next step. @throws Error Internal, naming the step (counted from 1) and the check.
  /// @par Cost  Local: O(k^2) signs for a ring of k. Full: linear in what is left, too.
  void check(const Step& step);
  /// The last checks of a run: the witness of every survivor and, at level full, every hull vertex
  /// and the volume as a rational. The writer must prove, from what it writes, that the written
  /// planes hold every input point.
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace convexact
