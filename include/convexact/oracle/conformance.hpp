// SPDX-License-Identifier: MIT
// conformance.hpp - what a run of somebody's program over one vector amounts to.
#pragma once
#include <array>
#include <optional>
#include <string>

#include "convexact/oracle/program.hpp"
#include "convexact/oracle/test_vector.hpp"
#include "convexact/oracle/tolerance.hpp"

namespace convexact {

/// How a program did on a vector: the first of these that applies, from top to bottom.
enum class Outcome {
  NotStarted,        ///< There is no such program.
  TimedOut,          ///< It did not end in time.
  OutOfMemory,       ///< It failed for want of memory.
  Crashed,           ///< A signal ended it.
  AcceptedUnusable,  ///< Exit code 0 for an input that encloses no volume or cannot be read.
  WrongExit,         ///< Another exit code for a usable input.
  MissingOutput,     ///< Exit code 0 and no output.
  UnreadableOutput,  ///< The output is malformed or not finite.
  NoSolid,           ///< The output is empty, flat or unbounded.
  NotEnclosing,      ///< The output misses a point of the input.
  BrokenMesh,        ///< The output's surface has holes, or looks inward.
  TooManyFacets,     ///< More facets than asked for.
  Passed,
};
inline constexpr std::array kAllOutcomes = {
    Outcome::NotStarted,    Outcome::TimedOut,         Outcome::OutOfMemory,
    Outcome::Crashed,       Outcome::AcceptedUnusable, Outcome::WrongExit,
    Outcome::MissingOutput, Outcome::UnreadableOutput, Outcome::NoSolid,
    Outcome::NotEnclosing,  Outcome::BrokenMesh,       Outcome::TooManyFacets,
    Outcome::Passed};

/// "timed-out" and the like: stable, in messages and in JSON.
[[nodiscard]] const char* name_of(Outcome outcome);

struct Conformance {
  Outcome outcome;
  std::string sentence;  ///< What was found, for people.
  /// Volume of the output over that of the exact greedy result, if the output is a solid and the
  /// vector knows it. Reported, not judged: 1 is as tight as greedy, less is tighter.
  std::optional<double> tightness;
};

/// Judges a run. A vector that asks `refuse` is passed by ending in time with an exit code other
/// than 0; one that asks `simplify` by an output that is a bounded solid, closed and oriented
/// if it is a mesh, contains every point of the input, and has at most as many facets as asked for
/// (or as the exact run is left with, if no further removal is bounded).
///
/// Vertices rounded to doubles are hardly ever coplanar, so that an honest mesh of k halfspaces has
/// triangles where the solid meant has polygons. A mesh has too many facets only if more than k are
/// left when neighbours are merged that are coplanar up to 1e-6 of the input's diameter or 16 units
/// in the last place of the largest coordinate. This is the one place where something other than
/// an exact test decides, and it only ever forgives.
///
/// Which of tied removals comes first decides where a greedy run ends: an octahedron can become a
/// tetrahedron, or a parallelepiped of which no side can go. An output of which no facet can go
/// without leaving it unbounded therefore does not have too many.
/// @param vector  Asks simplify or refuse.
/// @param output  What the program wrote, if there is a file.
[[nodiscard]] Conformance judge_run(const TestVector& vector, const ProgramRun& run,
                                    const ProgramLimits& limits,
                                    const std::optional<Candidate>& output,
                                    const Tolerance& tolerance);

}  // namespace convexact
