// SPDX-License-Identifier: MIT
// conformance.hpp - what a run of somebody's program over one vector amounts to.
#pragma once
#include <array>
#include <atomic>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "convexact/oracle/program.hpp"
#include "convexact/oracle/promise.hpp"
#include "convexact/oracle/test_vector.hpp"
#include "convexact/oracle/verify.hpp"

namespace convexact {

/// How a program did on a vector, from the gravest on. A run that ends well can fail in several of
/// the ways from UnreadableOutput on.
enum class Outcome {
  NotStarted,            ///< There is no such program.
  TimedOut,              ///< It did not end in time.
  OutOfMemory,           ///< It failed for want of memory.
  Crashed,               ///< A signal ended it.
  AcceptedUnusable,      ///< Exit code 0 for an input that encloses no volume or cannot be read.
  WrongExit,             ///< Another exit code for a usable input.
  MissingOutput,         ///< Exit code 0 and no output.
  UnreadableOutput,      ///< The output is malformed or not finite.
  NoSolid,               ///< The output is empty, flat or unbounded.
  NotEnclosing,          ///< The output misses a point of the input.
  NotInside,             ///< The output, an inner solid by promise, sticks out of the input's hull.
  TooLoose,              ///< The output is larger than any enclosure of so many facets need be.
  BrokenMesh,            ///< The output's surface has holes, or looks inward.
  NotConvex,             ///< The output's faces are not the surface of the hull of its points.
  NotTheHull,            ///< The output, a hull by promise, has a corner that is no input point.
  TooManyFacets,         ///< More facets than asked for or promised.
  TooManyVertices,       ///< More corners than promised.
  TooManyFacetVertices,  ///< A facet of more corners than promised.
  Passed,
};
inline constexpr std::array kAllOutcomes = {
    Outcome::NotStarted,    Outcome::TimedOut,         Outcome::OutOfMemory,
    Outcome::Crashed,       Outcome::AcceptedUnusable, Outcome::WrongExit,
    Outcome::MissingOutput, Outcome::UnreadableOutput, Outcome::NoSolid,
    Outcome::NotEnclosing,  Outcome::NotInside,        Outcome::TooLoose,
    Outcome::BrokenMesh,    Outcome::NotConvex,        Outcome::NotTheHull,
    Outcome::TooManyFacets, Outcome::TooManyVertices,  Outcome::TooManyFacetVertices,
    Outcome::Passed};

/// "timed-out" and the like: stable, in messages and in JSON.
[[nodiscard]] const char* name_of(Outcome outcome);

/// One way in which a run failed.
struct Failure {
  Outcome outcome;
  std::string sentence;      ///< What was found, for people.
  bool is_rounding = false;  ///< Explained by the rounding of the output's numbers.
  /// How bad it is among failures of its kind: a squared distance over the squared diameter, or
  /// how many times the allowed volume or number.
  Rational size = 0;
};
/// Gross failures come before those by rounding, graver outcomes before others, larger before
/// smaller.
[[nodiscard]] bool is_graver(const Failure& a, const Failure& b);

struct Conformance {
  std::vector<Failure> failures;   ///< The gravest first; none if the vector is passed.
  std::string sentence;            ///< That of the first failure, or how it passed.
  std::vector<std::string> notes;  ///< What rounding explains, or the promise allows.
  std::optional<Outside> outside;  ///< Of the input's points, if there is a solid.
  /// How many corners of the input's hull are outside by more than 10^(k-1) and up to 10^k times
  /// the diameter, by k.
  std::map<int, std::size_t> outside_by_decade;
  /// Volume of the output over that of the exact greedy result if a simplification is asked for and
  /// the vector knows it, else over that of the input's hull. 1 is as tight as that, less tighter.
  std::optional<Rational> tightness;
  /// The square of the Hausdorff distance to the input's hull over the square of the diameter.
  std::optional<Rational> relative_squared_hausdorff;

  Outcome outcome() const { return failures.empty() ? Outcome::Passed : failures.front().outcome; }
};

/// Why a vector is not put to a program.
enum class NotRun {
  AsksOtherwise,     ///< It asks what the program does not answer, or the same input comes twice.
  OtherFormat,       ///< The input format cannot hold it.
  OtherNumbers,      ///< In binary32 it would overflow, become flat or cease to be flat.
  BeyondTheProgram,  ///< Its hull has more facets or corners than the program handles by promise.
};
inline constexpr std::array kAllNotRun = {NotRun::AsksOtherwise, NotRun::OtherFormat,
                                          NotRun::OtherNumbers, NotRun::BeyondTheProgram};
[[nodiscard]] const char* name_of(NotRun reason);

/// Whether another of the vectors asks for the hull of the same points. One of the two is enough
/// for a program of which no simplification is asked.
[[nodiscard]] bool repeats_hull_vector(const TestVector& vector,
                                       std::span<const TestVector> vectors);

/// The vector as it is put to a program that promises this: the input in the program's numbers.
/// Where that changes the input, the known counts of a hull are computed anew and other known
/// answers left out.
[[nodiscard]] std::variant<TestVector, NotRun> as_put(const TestVector& vector,
                                                      const Promise& promise);

/// Judges a run.
///
/// A vector that asks `refuse` is passed by ending in time with an exit code other than 0. If only
/// the faces of its file are malformed, also by an output that is right for its points: a program
/// that reads points only does not see them.
///
/// Other vectors are passed by an output of which every claim of verify() holds that applies, and
/// what the promise asks; docs/conform.md has the whole list. Two things are forgiven. A face may
/// be bent, or off the surface of the hull, by what 16 units in the last place of the largest
/// coordinate explain (is_explained()); and an output of which no facet can go without leaving it
/// unbounded does not have too many: which of tied removals comes first decides where a greedy run
/// ends.
/// @param vector  As as_put() gives it.
/// @param output  What the program wrote, if there is a file.
/// @param stop    When it becomes true: Error Stopped.
[[nodiscard]] Conformance judge_run(const TestVector& vector, const Promise& promise,
                                    const ProgramRun& run, const ProgramLimits& limits,
                                    const std::optional<Candidate>& output,
                                    const std::atomic<bool>* stop = nullptr);

}  // namespace convexact
