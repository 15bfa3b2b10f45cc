// SPDX-License-Identifier: MIT
// as_put() and run_vectors(): run a program over the vectors, each in the numbers that it promises.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <optional>

#include "conform/conformance_judge.hpp"
#include "conform/program.hpp"
#include "conform/program_output.hpp"
#include "convexact/conform.hpp"
#include "convexact/error.hpp"
#include "convexact/hull.hpp"
#include "convexact/io.hpp"
#include "convexact/verify.hpp"
#include "scene/time_limit.hpp"
#include "task/parallel.hpp"

namespace convexact {

// ---- Which vectors are put to a program, and in which numbers

namespace {

using oracle::Given;
using oracle::given_by;

// The points in binary32; nothing if one is beyond its range.
std::optional<PointSet> rounded(const PointSet& points) {
  std::vector<Point> result(points.doubles().begin(), points.doubles().end());
  for (Point& p : result) {
    for (double& x : p) {
      x = static_cast<float>(x);
      if (!std::isfinite(x)) return std::nullopt;
    }
  }
  return PointSet(std::move(result));
}

bool is_binary32(const Integer& x) {
  const Rational value(x);
  const float rounded = to_float(value, Rounding::Nearest);
  return std::isfinite(rounded) && to_rational(rounded) == value;
}

bool is_binary32(const HalfspaceList& list) {
  return std::all_of(list.halfspaces.begin(), list.halfspaces.end(), [](const Halfspace& h) {
    return is_binary32(h.normal()[0]) && is_binary32(h.normal()[1]) && is_binary32(h.normal()[2]) &&
           is_binary32(h.offset());
  });
}

// The known answers for other points than those that they were known for.
void forget_answers(TestVector& vector, const std::optional<Given>& given) {
  if (auto* question = std::get_if<SimplifyQuestion>(&vector.question)) {
    question->volume.reset();
    question->costs.clear();
    question->ties.clear();
  } else if (auto* hull = std::get_if<HullQuestion>(&vector.question)) {
    hull->facets = given->hull.planes.size();
    hull->vertices = given->hull.vertices.size();
  }
}

std::variant<TestVector, NotRun> in_binary32(TestVector vector) {
  if (const auto* list = std::get_if<HalfspaceList>(&vector.input)) {
    if (!is_binary32(*list)) return NotRun::OtherNumbers;
    return vector;
  }
  auto* points = std::get_if<PointSet>(&vector.input);
  if (points == nullptr) return vector;
  std::optional<PointSet> nearest = rounded(*points);
  if (!nearest) return NotRun::OtherNumbers;
  if (std::equal(nearest->doubles().begin(), nearest->doubles().end(), points->doubles().begin())) {
    return vector;
  }
  *points = std::move(*nearest);
  const std::optional<Given> given = given_by(vector);
  const bool is_refusal = std::holds_alternative<RefuseQuestion>(vector.question);
  if (given.has_value() == is_refusal) return NotRun::OtherNumbers;
  forget_answers(vector, given);
  return vector;
}

// Whether the hull of the input has more facets or corners than the program handles.
bool is_beyond(const TestVector& vector, const Promise& promise) {
  const bool has_caps = promise.max_facets || promise.max_vertices || promise.max_facet_vertices;
  if (promise.asks != Asks::Hull || !has_caps ||
      std::holds_alternative<RefuseQuestion>(vector.question)) {
    return false;
  }
  constexpr std::size_t kAny = std::numeric_limits<std::size_t>::max();
  const Polytope hull = given_by(vector)->hull;
  return hull.planes.size() > promise.max_facets.value_or(kAny) ||
         hull.vertices.size() > promise.max_vertices.value_or(kAny) ||
         std::any_of(hull.facets.begin(), hull.facets.end(), [&](const auto& facet) {
           return facet.size() > promise.max_facet_vertices.value_or(kAny);
         });
}

// Whether a program with this promise can answer the question.
bool is_asked(const TestVector& vector, const Promise& promise) {
  if (std::holds_alternative<VerifyQuestion>(vector.question)) return false;
  return promise.asks != Asks::Simplify || !std::holds_alternative<HullQuestion>(vector.question);
}

}  // namespace

bool repeats_hull_vector(const TestVector& vector, std::span<const TestVector> vectors) {
  const auto* points = std::get_if<PointSet>(&vector.input);
  if (points == nullptr || !std::holds_alternative<SimplifyQuestion>(vector.question)) return false;
  return std::any_of(vectors.begin(), vectors.end(), [&](const TestVector& other) {
    const auto* same = std::get_if<PointSet>(&other.input);
    return same != nullptr && std::holds_alternative<HullQuestion>(other.question) &&
           std::equal(same->doubles().begin(), same->doubles().end(), points->doubles().begin(),
                      points->doubles().end());
  });
}

std::variant<TestVector, NotRun> as_put(const TestVector& vector, const Promise& promise) {
  if (!is_asked(vector, promise)) return NotRun::AsksOtherwise;
  std::variant<TestVector, NotRun> put = vector;
  if (promise.numbers == Precision::Binary32) put = in_binary32(vector);
  const auto* given = std::get_if<TestVector>(&put);
  if (given != nullptr && is_beyond(*given, promise)) return NotRun::BeyondTheProgram;
  return put;
}

// ---- Running it

namespace {

std::optional<std::string> mesh_bytes(const PointSet& points, MeshFormat format,
                                      Precision precision) {
  Mesh mesh;
  mesh.points = points;
  const HullOutcome outcome = convex_hull(points);
  if (const auto* hull = std::get_if<Hull>(&outcome)) {
    mesh.polygons = polygons_of(hull->facets);
  } else if (holds_binary32_only(format)) {
    return std::nullopt;  // there are no triangles to write
  }
  return write_mesh(mesh, format, {.precision = precision});
}

}  // namespace

std::optional<std::string> input_bytes(const TestVector& vector, const std::string& format,
                                       Precision numbers) {
  const std::string name = "input." + format;
  const auto mesh_format = mesh_format_of_path(name);
  if (const auto* file = std::get_if<RawFile>(&vector.input)) {
    if (file->extension != format) return std::nullopt;
    return file->bytes;
  }
  if (const auto* list = std::get_if<HalfspaceList>(&vector.input)) {
    if (mesh_format || list->impossible_row) return std::nullopt;
    return write_halfspaces(list->halfspaces, *halfspace_format_of_path(name));
  }
  if (!mesh_format) return std::nullopt;
  return mesh_bytes(std::get<PointSet>(vector.input), *mesh_format, numbers);
}

namespace {

using RunResult = std::variant<ConformanceEntry, NotRun>;

std::size_t faces_of(const TestVector& vector) {
  if (const auto* question = std::get_if<SimplifyQuestion>(&vector.question)) {
    return question->faces;
  }
  const auto* hull = std::get_if<HullQuestion>(&vector.question);
  return hull == nullptr ? kFacesOfRefusals : hull->facets;
}

// No verdict in time is no pass.
Conformance judge_in_time(const TestVector& vector, const ProgramRun& run,
                          const std::optional<Candidate>& candidate, const ConformRun& options) {
  const std::atomic<bool>* interrupt = options.watch.stop;
  try {
    return in_time(
        options.judge_seconds, "verdict",
        [&](const StageWatch& watch) {
          return judge_run(vector, options.promise, run, options.limits, candidate, watch);
        },
        interrupt);
  } catch (const Error& error) {
    const bool is_interrupted = interrupt != nullptr && interrupt->load();
    if (error.code() != ErrorCode::Stopped || is_interrupted) throw;
    Conformance undecided;
    undecided.failures = {{Outcome::Undecided, error.what()}};
    undecided.sentence = error.what();
    return undecided;
  }
}

// The output is gone when the report is read: it is called what the command line calls it.
void name_output(std::string& sentence, const std::string& path) {
  for (std::size_t at = sentence.find(path); at != sentence.npos; at = sentence.find(path, at)) {
    sentence.replace(at, path.size(), "{output}");
  }
}

RunResult run_vector(const TestVector& vector, const ConformRun& options) {
  const auto put = as_put(vector, options.promise);
  if (const auto* reason = std::get_if<NotRun>(&put)) return *reason;
  const auto& given = std::get<TestVector>(put);
  const std::optional<std::string> bytes =
      input_bytes(given, options.input_format, options.promise.numbers);
  if (!bytes) return NotRun::OtherFormat;
  const ScratchFolder scratch;
  const std::string input = scratch.write("input." + options.input_format, *bytes);
  const std::string output = scratch.file("output." + options.output_format);
  const std::size_t faces = faces_of(given);
  const std::vector<std::string> words = fill_in(
      options.program, {{"input", input}, {"faces", std::to_string(faces)}, {"output", output}});
  const ProgramRun run = run_program(words, options.limits, options.watch.stop);
  if (run.end == ProgramEnd::NotStarted) {
    throw Error(ErrorCode::InvalidArgument,
                "the program '" + options.program.front() + "' cannot be started");
  }
  std::optional<Candidate> candidate;
  if (run.succeeded()) {
    const bool is_binary32 = options.promise.numbers == Precision::Binary32;
    candidate = read_program_output(output, is_binary32 ? Decimal::Nearest32 : Decimal::Nearest,
                                    options.limits.output);
  }
  ConformanceEntry entry{&vector, judge_in_time(given, run, candidate, options), run.seconds,
                         run.printed};
  name_output(entry.result.sentence, output);
  if (!entry.result.failures.empty() && options.on_failure) {
    options.on_failure({given, *bytes, faces, output, run, entry});
  }
  return entry;
}

}  // namespace

ConformanceReport run_vectors(std::span<const TestVector> vectors,
                              const std::function<bool(const TestVector&)>& is_chosen,
                              const ConformRun& options) {
  ConformanceReport report;
  report.program = fmt::format("{}", fmt::join(options.program, " "));
  report.promise = options.promise;
  std::vector<const TestVector*> chosen;
  for (const TestVector& vector : vectors) {
    if (!is_chosen(vector)) continue;
    const bool is_simplify = options.promise.asks == Asks::Simplify;
    if (!is_simplify && repeats_hull_vector(vector, vectors)) {
      ++report.not_run[NotRun::AsksOtherwise];
    } else {
      chosen.push_back(&vector);
    }
  }
  std::vector<std::optional<RunResult>> results(chosen.size());
  for_each_in_parallel(
      chosen.size(), options.jobs,
      [&](std::size_t i) {
        Watch(options.watch.stop).ask();
        results[i] = run_vector(*chosen[i], options);
      },
      [&](std::size_t done) {
        if (options.watch.progress) options.watch.progress("running vectors", done, chosen.size());
      });
  for (std::optional<RunResult>& result : results) {
    if (const auto* reason = std::get_if<NotRun>(&*result)) {
      ++report.not_run[*reason];
    } else {
      report.entries.push_back(std::get<ConformanceEntry>(std::move(*result)));
    }
  }
  return report;
}

}  // namespace convexact
