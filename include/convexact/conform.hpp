// SPDX-License-Identifier: MIT
// conform.hpp - judges the outputs of another program for inputs with known answers.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "convexact/number.hpp"
#include "convexact/verify.hpp"

namespace convexact {

struct ProgramLimits {
  double seconds = 10;       ///< Wall time, more than 0; a program that takes longer is killed.
  std::uint64_t memory = 0;  ///< Bytes of address space of each of its processes; 0 for no limit.
  std::uint64_t output = std::uint64_t(1) << 30;  ///< Bytes; a longer output is not read.
};

enum class ProgramEnd {
  Exited,      ///< By itself, with `exit_code`.
  Crashed,     ///< By `signal`.
  TimedOut,    ///< Killed.
  NotStarted,  ///< There is no such program, or it cannot be executed.
};

struct ProgramRun {
  ProgramEnd end = ProgramEnd::NotStarted;
  int exit_code = 0;
  int signal = 0;
  double seconds = 0;             ///< Wall time.
  std::uint64_t peak_memory = 0;  ///< Largest resident set of one of its processes, in bytes.
  std::string printed;  ///< The end of what it wrote to standard output and error, up to 4 KiB.

  bool succeeded() const { return end == ProgramEnd::Exited && exit_code == 0; }
};

/// "exit code 3", "killed by signal 11", "no end within 10 s", "cannot be started".
[[nodiscard]] std::string describe(const ProgramRun& run);

/// Runs a program and waits for its end; processes that it started in the background end with it.
/// No shell is involved: the words are its arguments as they are. Its standard input is empty, and
/// it leaves no core dump.
/// @param words  The program, looked up in PATH unless it has a slash, and its arguments.
/// @param watch  When it ends the run, the program is killed: Error Stopped.
/// @throws Error InvalidArgument if there are no words or the time is not positive; Stopped also if
///               the system cannot make a process.
[[nodiscard]] ProgramRun run_program(const std::vector<std::string>& words,
                                     const ProgramLimits& limits, const Watch& watch = {});

/// The words with every "{name}" replaced by its value, also inside a word. Other braces stay.
[[nodiscard]] std::vector<std::string> fill_in(const std::vector<std::string>& words,
                                               const std::map<std::string, std::string>& values);

struct Promise : Budgets {
  Asks asks = Asks::Simplify;
  /// The number format of inputs and outputs. Inputs are rounded to it before they are written; a
  /// decimal in an output means the nearest number of the format.
  Precision numbers = Precision::Binary64;
  Tolerance tolerance = {};  ///< Violations up to this distance pass.
  bool allow_flat = false;   ///< Inputs without volume may be accepted.
};

/// What a promise asks of an output. A simplification to no known number of facets is an enclosure.
[[nodiscard]] VerifyRequest request_of(const Promise& promise);

/// A promise that is known by a name, such as that of an engine.
struct Profile {
  std::string name, title;
  Promise promise;
};

/// The bytes of a file, which may be malformed, and the extension that says how to read them.
struct RawFile {
  std::string bytes;
  std::string extension;  ///< Without a dot.
};

/// The question: what is the hull?
struct HullQuestion {
  std::size_t facets, vertices;
  Rational volume;
};

/// The question: what is the result of the greedy removal of halfspaces?
struct SimplifyQuestion {
  std::size_t faces;               ///< How many to keep.
  std::size_t facets;              ///< How many are left; more than `faces` if not `reached`.
  bool reached;                    ///< False if every further removal would be unbounded.
  std::optional<Rational> volume;  ///< The rest is known only together with the volume.
  std::vector<Rational> costs;     ///< Of each step.
  std::vector<std::vector<Halfspace>> ties;  ///< For each step the tied halfspaces; empty if only
                                             ///< one.
};

/// The question: which claims hold of a candidate?
struct VerifyQuestion : Budgets {
  Candidate candidate;
  std::vector<std::pair<ClaimCode, Status>> claims;  ///< Those whose status is known.
  struct Outside {
    std::size_t points;
    Rational squared_distance;  ///< Of the worst one; 0 if none is outside.
  };
  /// Input points outside of the candidate; of an inner solid its vertices outside of the input.
  std::optional<Outside> outside;
  bool inner = false;  ///< Whether the candidate is judged as an inner solid.
};

/// The question: is the input refused, and why?
struct RefuseQuestion {
  ErrorCode error;               ///< Malformed, NotFinite or NoInterior.
  std::optional<int> dimension;  ///< Of points that span no volume.
  /// The points of a malformed file if they are sound: a program that reads points only does not
  /// see its faces.
  std::optional<PointSet> points = {};
};
/// The value of {faces} in a run on an input that is to be refused.
inline constexpr std::size_t kFacesOfRefusals = 8;

struct TestVector {
  std::string id, title;
  int level = 1;  ///< 1 everyday, 2 hard, 3 cruel.
  bool required = true;
  std::vector<std::string> flags;  ///< Headings of docs/flags.md.
  std::variant<PointSet, HalfspaceList, RawFile> input;
  std::variant<HullQuestion, SimplifyQuestion, VerifyQuestion, RefuseQuestion> question;
};

/// How a program did on a vector, the gravest outcome first. A run that ends well can fail in
/// several of the ways from UnreadableOutput on.
enum class Outcome {
  NotStarted,            ///< There is no such program.
  TimedOut,              ///< It did not end in time.
  OutOfMemory,           ///< It ran out of memory.
  Crashed,               ///< A signal ended it.
  AcceptedUnusable,      ///< Exit code 0 for an input that encloses no volume or cannot be read.
  WrongExit,             ///< Another exit code for a usable input.
  MissingOutput,         ///< Exit code 0 and no output.
  UnreadableOutput,      ///< The output is malformed or not finite.
  NoSolid,               ///< The output is empty, flat or unbounded.
  NotEnclosing,          ///< The output misses a point of the input.
  NotInside,             ///< The output, an inner solid by promise, sticks out of the input's hull.
  TooLoose,              ///< The output is larger than an enclosure of so many facets has to be.
  BrokenMesh,            ///< The output's surface has holes, or looks inward.
  NotConvex,             ///< The output's faces are not the surface of the hull of its points.
  NotTheHull,            ///< The output, a hull by promise, reaches out of the input's hull.
  TooManyFacets,         ///< More facets than asked for or promised.
  TooManyVertices,       ///< More corners than promised.
  TooManyFacetVertices,  ///< A facet of more corners than promised.
  Undecided,             ///< The judge found nothing wrong, but did not come to an end.
  Passed,
};
inline constexpr std::array kAllOutcomes = {
    Outcome::NotStarted,       Outcome::TimedOut,
    Outcome::OutOfMemory,      Outcome::Crashed,
    Outcome::AcceptedUnusable, Outcome::WrongExit,
    Outcome::MissingOutput,    Outcome::UnreadableOutput,
    Outcome::NoSolid,          Outcome::NotEnclosing,
    Outcome::NotInside,        Outcome::TooLoose,
    Outcome::BrokenMesh,       Outcome::NotConvex,
    Outcome::NotTheHull,       Outcome::TooManyFacets,
    Outcome::TooManyVertices,  Outcome::TooManyFacetVertices,
    Outcome::Undecided,        Outcome::Passed};

/// "timed-out" and the like: stable, in messages and in JSON.
[[nodiscard]] const char* name_of(Outcome outcome);

/// One way in which a run failed.
struct Failure {
  Outcome outcome;
  std::string sentence;      ///< The finding, for people.
  bool is_rounding = false;  ///< Explained by the rounding of the output's numbers.
  /// Its rank among failures of its kind: a squared distance over the squared diameter, or the
  /// ratio to the allowed volume or number.
  Rational size = 0;
};
/// Gross failures come before those by rounding, graver outcomes before others, larger before
/// smaller.
[[nodiscard]] bool is_graver(const Failure& a, const Failure& b);

struct Conformance {
  std::vector<Failure> failures;   ///< The gravest first; none if the vector is passed.
  std::string sentence;            ///< That of the first failure, or how it passed.
  std::vector<std::string> notes;  ///< Facts that rounding explains, or the promise allows.
  std::optional<Outside> outside;  ///< Of the input's points, if there is a solid.
  /// How many corners of the input's hull are outside by more than 10^(k-1) and up to 10^k times
  /// the diameter, by k.
  std::map<int, std::size_t> outside_by_decade;
  /// Volume of the output over that of the exact greedy result if a simplification is asked for and
  /// the vector knows it, otherwise over that of the input's hull. 1 is as tight as that, and less
  /// is tighter.
  std::optional<Rational> tightness;
  /// The square of the Hausdorff distance to the input's hull over the square of the diameter.
  std::optional<Rational> relative_squared_hausdorff;

  Outcome outcome() const { return failures.empty() ? Outcome::Passed : failures.front().outcome; }
};

/// Why a program is not run on a vector.
enum class NotRun {
  AsksOtherwise,     ///< It asks a question that the program does not answer, or its input occurs
                     ///< twice.
  OtherFormat,       ///< The input format cannot hold it.
  OtherNumbers,      ///< In binary32 it would overflow, become flat or cease to be flat.
  BeyondTheProgram,  ///< Its hull has more facets or corners than the program handles by promise.
};
inline constexpr std::array kAllNotRun = {NotRun::AsksOtherwise, NotRun::OtherFormat,
                                          NotRun::OtherNumbers, NotRun::BeyondTheProgram};
[[nodiscard]] const char* name_of(NotRun reason);

/// Whether another of the vectors asks for the hull of the same points. One of the two is enough
/// for a program that does not simplify.
[[nodiscard]] bool repeats_hull_vector(const TestVector& vector,
                                       std::span<const TestVector> vectors);

/// The vector as a program with this promise receives it: the input in the program's numbers. If
/// that changes the input, the known counts of a hull are computed anew and other known answers are
/// left out.
[[nodiscard]] std::variant<TestVector, NotRun> as_put(const TestVector& vector,
                                                      const Promise& promise);

/// The input as a program receives it: points with the facets of their hull, for programs that need
/// a closed surface as well as for those that read points only; halfspaces; or the bytes of a file.
/// Nothing if the format cannot hold it.
/// @param format  An extension without a dot.
[[nodiscard]] std::optional<std::string> input_bytes(const TestVector& vector,
                                                     const std::string& format,
                                                     Precision numbers = Precision::Binary64);

/// Judges a run.
///
/// A vector that asks `refuse` is passed by ending in time with an exit code other than 0. If only
/// the faces of its file are malformed, it is also passed by an output that is right for its
/// points, since a program that reads points only does not see the faces.
///
/// Other vectors are passed by an output for which every applicable claim of verify() and of the
/// promise holds; docs/conform.md has the whole list. There are two exceptions. A face may be bent,
/// or off the surface of the hull, as far as 16 units in the last place of the largest coordinate
/// explain it (is_explained()). An output does not have too many facets if its planes are facet
/// planes of the input's hull, up to rounding, and none can be removed without leaving it
/// unbounded: the order of tied removals decides where a greedy run ends.
/// @param vector  As as_put() gives it.
/// @param output  The program's output, if there is a file.
/// @param watch   Ends the judgement: Error Stopped.
[[nodiscard]] Conformance judge_run(const TestVector& vector, const Promise& promise,
                                    const ProgramRun& run, const ProgramLimits& limits,
                                    const std::optional<Candidate>& output,
                                    const StageWatch& watch = {});

/// The vectors in a text. @param data  The folder of the meshes that vectors name.
/// @throws Error Malformed for anything that the schema does not allow; NotFinite; Unreadable for a
///         mesh that is not there.
[[nodiscard]] std::vector<TestVector> read_test_vectors_bytes(std::string_view bytes,
                                                              const std::string& data);

/// The vectors of one file. @throws Error as read_test_vectors_bytes, with the path in front.
[[nodiscard]] std::vector<TestVector> read_test_vectors_file(const std::string& path,
                                                             const std::string& data);

/// The vectors of all files NAME.json in a folder, by name; meshes come from `folder`/../data.
/// @throws Error as read_test_vectors_file; Unreadable if there is no such folder or no vector.
[[nodiscard]] std::vector<TestVector> read_test_vectors(const std::string& folder);

/// The profiles of a file (docs/schema/profiles.schema.json), by name.
/// @throws Error Malformed, naming the profile.
[[nodiscard]] std::vector<Profile> read_profiles_bytes(std::string_view bytes);

/// The profile of that name. @throws Error InvalidArgument with the names that there are.
[[nodiscard]] const Profile& profile_of_name(const std::vector<Profile>& profiles,
                                             const std::string& name);

/// One vector and the result of a program on it. The vector outlives this.
struct ConformanceEntry {
  const TestVector* vector;
  Conformance result;
  double seconds;            ///< Of the program.
  std::string printed = {};  ///< As ProgramRun::printed.
};

struct ConformanceReport {
  std::string program;  ///< The command as it was given.
  std::string profile;  ///< Its name, or empty.
  Promise promise;
  std::vector<ConformanceEntry> entries;       ///< In the order of the vectors.
  std::map<NotRun, std::size_t> not_run = {};  ///< How many vectors were not run, and why.
  /// The ids of the vectors that are known to fail, if there is such a list.
  std::optional<std::set<std::string>> known_failures = {};

  std::size_t passed() const;
  /// How many vectors have a usable input: who ends with an error on every input is asked nothing
  /// by refusals alone.
  std::size_t asked() const;
  bool is_known_failure(const TestVector& vector) const;
  /// Whether something was asked, and every required vector passed; with a list of known failures,
  /// whether every vector passed that is not in the list.
  bool conforms() const;
};

/// What is at hand when a program has failed on a vector.
struct FailedRun {
  const TestVector& vector;        ///< As the program received it.
  const std::string& input;        ///< Its bytes, in the program's format.
  std::size_t faces;               ///< The value of {faces}.
  const std::string& output_path;  ///< Where the program's output is, if it wrote one.
  const ProgramRun& run;
  const ConformanceEntry& entry;
};

struct ConformRun {
  std::vector<std::string> program;  ///< Its words, with {input}, {output} and perhaps {faces}.
  ProgramLimits limits{30, 0};
  std::optional<double> judge_seconds = {};                 ///< For the verdict on each output.
  std::string input_format = "obj", output_format = "obj";  ///< Extensions.
  std::size_t jobs = 1;                                     ///< Vectors at the same time.
  Promise promise;
  /// Called for each failure, possibly by several threads at the same time.
  std::function<void(const FailedRun&)> on_failure = {};
  StageWatch watch = {};  ///< Reports vectors as the progress of "running vectors".
};

/// Runs the program over the chosen vectors, and judges its outputs. Only the seconds of the result
/// depend on the number of jobs.
/// @throws Error InvalidArgument if the program cannot be started; Stopped.
[[nodiscard]] ConformanceReport run_vectors(std::span<const TestVector> vectors,
                                            const std::function<bool(const TestVector&)>& is_chosen,
                                            const ConformRun& options);

}  // namespace convexact
