// SPDX-License-Identifier: MIT
// convexact shrink: reduces a failing input to a minimal one.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "cli/command.hpp"
#include "cli/outputs.hpp"
#include "cli/program_case.hpp"
#include "cli/progress.hpp"
#include "cli/promise_options.hpp"
#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "convexact/linear_program.hpp"
#include "convexact/scene.hpp"
#include "convexact/shrink.hpp"
#include "hull/hull_steps.hpp"
#include "io/json.hpp"
#include "scene/objects.hpp"

namespace convexact::cli {
namespace {

constexpr const char* kShrinkFooter =
    "Examples:\n"
    "  convexact shrink bad.obj -o minimal.obj -- ./my_hull {input} {output}\n"
    "  convexact shrink bad.obj -o minimal.off --faces 12 --fails-if verdict \\\n"
    "      --claims contains-input --tolerance 1e-9d -- ./my_hull {input} --faces {faces} -o "
    "{output}\n"
    "  convexact shrink bad.obj -o minimal.obj --asks hull -- ./my_hull {input} {output}\n"
    "  convexact shrink planes.ine -o minimal.ine -- ./my_clipper {input} {output}\n"
    "  convexact shrink bad.obj -o minimal.obj --interesting './my_hull {input} | grep -q NaN'\n"
    "\n"
    "PROGRAM is run directly, not by a shell. It fails if it does not exit with 0 in time, or\n"
    "if it exits with 0 and its {output} violates a claim (docs/verdicts.md). On the result it\n"
    "fails in the same way: with the same exit code, signal or first violated claim. An input\n"
    "with a volume keeps one unless --allow-flat is given. With --interesting anything can be\n"
    "kept: a warning, a slow run, a difference between two programs. Ctrl-C ends with exit code 6, "
    "and\n"
    "leaves the smallest failing input so far in the output file.";

struct ShrinkArguments {
  GlobalOptions global;
  std::string input, output, interesting;
  std::vector<ClaimCode> claims;
  PromiseOptions promise;
  MeshPoints points = MeshPoints::All;
  std::string output_format = "obj";
  bool allow_flat = false;
  ProgramCase program;
};

struct Size {
  std::size_t rows, bits;  // points or halfspaces, and all their numbers
};
Size size_of(const PointSet& points) { return {points.size(), coordinate_bits(points)}; }
Size size_of(std::span<const Halfspace> rows) { return {rows.size(), coordinate_bits(rows)}; }

bool is_solid(const PointSet& points) {
  if (points.is_binary()) return find_simplex(DoublePoints(points.doubles())).size() == 4;
  return std::holds_alternative<Hull>(convex_hull(points));
}
bool is_solid(std::span<const Halfspace> halfspaces) {
  return std::holds_alternative<InteriorPoint>(find_interior(halfspaces)) &&
         std::holds_alternative<BoundedProof>(find_recession(halfspaces));
}

// What other commands say of an input without points, or with rows that all bound nothing: there is
// nothing to remove from it.
std::optional<NotSolid> nothing_in(const Shape& shape) {
  if (const auto* points = std::get_if<PointSet>(&shape)) {
    if (points->size() > 0) return std::nullopt;
    return std::get<FlatInput>(convex_hull(*points));
  }
  const auto& halfspaces = std::get<std::vector<Halfspace>>(shape);
  if (!halfspaces.empty()) return std::nullopt;
  return std::get<RecessionRay>(find_recession(halfspaces));
}

bool is_binary32(const PointSet& points) {
  return points.is_binary() &&
         std::all_of(points.doubles().begin(), points.doubles().end(),
                     [](const Point& p) { return p.cast<float>().cast<double>() == p; });
}

// A mesh with some of its points, moved: the polygons that keep all their corners.
Mesh part_of(const SceneObject& mesh, const PointSet& points, std::span<const PointId> origin) {
  constexpr std::uint32_t kGone = 0xffffffff;
  std::vector<std::uint32_t> place(std::get<PointSet>(mesh.shape).size(), kGone);
  for (std::size_t k = 0; k < origin.size(); ++k) {
    place[origin[k].index()] = static_cast<std::uint32_t>(k);
  }
  Mesh part{points, {}, {}};
  for (std::vector<std::uint32_t> polygon : mesh.polygons) {
    bool is_whole = true;
    for (std::uint32_t& corner : polygon) {
      corner = place[corner];
      is_whole = is_whole && corner != kGone;
    }
    if (is_whole) part.polygons.push_back(std::move(polygon));
  }
  return part;
}

// An input that is being reduced: how it fails, and the smallest one so far that fails in this way.
class Shrinking {
 public:
  Shrinking(const ShrinkArguments& options, const SceneObject& input)
      : options_(options), input_(input), program_(options.program) {
    if (!options.interesting.empty()) program_.become_predicate(options.interesting);
    program_.require_sensible();
    program_.input_extension = std::filesystem::path(options.output).extension().string();
    program_.output_extension = "." + options.output_format;
    const Promise promised = promise();
    program_.numbers = promised.numbers;
    program_.verify = request_of(promised);
    program_.verify.claims = options.claims;
    program_.verify.points = options.points;
    program_.verify.tightness = false;
    program_.verify.seed = options.global.seed;
  }

  // All that the program promises. Asked for so many facets, it promises no more.
  Promise promise() const {
    Promise promise = options_.promise.promise(Asks::Enclosure);
    if (promise.asks == Asks::Simplify) {
      if (program_.faces == 0) {
        throw Error(ErrorCode::InvalidArgument, "--asks simplify needs --faces");
      }
      promise.max_facets = std::min(promise.max_facets.value_or(program_.faces), program_.faces);
    }
    return promise;
  }

  // Leaves the smallest one in smallest_. @throws Error Stopped among others.
  void run() {
    Progress progress;
    progress_ = &progress;
    if (std::holds_alternative<PointSet>(input_.shape)) {
      shrink_points(std::get<PointSet>(input_.shape));
    } else {
      shrink_halfspaces(std::get<std::vector<Halfspace>>(input_.shape));
    }
  }

  bool is_smaller() const { return size_.rows < before_.rows || size_.bits < before_.bits; }
  const std::string& smallest() const { return smallest_; }
  std::string found() const {
    return fmt::format("{} of {} {}", size_.rows, before_.rows, rows_name());
  }
  std::string summary() const;

 private:
  const char* rows_name() const {
    return std::holds_alternative<PointSet>(input_.shape) ? "points" : "halfspaces";
  }
  void shrink_points(const PointSet& points);
  void shrink_halfspaces(const std::vector<Halfspace>& halfspaces);
  void begin(const std::string& bytes, const Size& size);
  bool still_fails(const std::string& bytes, const Shape& shape, const Size& size);

  const ShrinkArguments& options_;
  const SceneObject& input_;
  ProgramCase program_;
  ScratchFolder folder_;
  Progress* progress_ = nullptr;
  std::string failure_;
  Size before_{}, size_{};
  std::string smallest_;
  std::size_t runs_ = 0;
};

void Shrinking::begin(const std::string& bytes, const Size& size) {
  const auto failure = failure_of(program_, bytes, input_.shape, folder_);
  runs_ = 1;
  if (!failure) {
    const bool is_predicate = program_.fails_if == FailsIf::Success;
    throw Error(ErrorCode::InvalidArgument, (is_predicate ? "the command does not end with 0 on "
                                                          : "the program does not fail on ") +
                                                options_.input);
  }
  failure_ = *failure;
  before_ = size_ = size;
  smallest_ = bytes;
}

bool Shrinking::still_fails(const std::string& bytes, const Shape& shape, const Size& size) {
  ++runs_;
  if (failure_of(program_, bytes, shape, folder_) != failure_) return false;
  smallest_ = bytes;
  size_ = size;
  (*progress_)(std::string("shrinking; ") + rows_name() + " gone", before_.rows - size.rows,
               before_.rows);
  return true;
}

void Shrinking::shrink_points(const PointSet& points) {
  const auto format = mesh_format_of_path(options_.output);
  if (!format || holds_binary32_only(*format)) {
    throw Error(ErrorCode::InvalidArgument,
                "-o " + options_.output + ": expected .obj, .off, .ply or .xyz");
  }
  program_.verify.used = used_flags(input_);
  const MeshWriteOptions numbers{.precision = program_.numbers};
  begin(write_mesh({points, input_.polygons, {}}, *format, numbers), size_of(points));
  const bool keeps_volume = !options_.allow_flat && is_solid(points);
  bool is_first = true;  // the original input, which has just been run
  (void)shrink(points, [&](const PointSet& fewer, std::span<const PointId> origin) {
    if (std::exchange(is_first, false)) return true;
    if (program_.numbers == Precision::Binary32 && !is_binary32(fewer)) return false;
    if (keeps_volume && !is_solid(fewer)) return false;
    const Mesh part = part_of(input_, fewer, origin);
    program_.verify.used = used_points(fewer.size(), part.polygons);
    if (part.polygons.empty()) program_.verify.used.clear();
    return still_fails(write_mesh(part, *format, numbers), fewer, size_of(fewer));
  });
}

void Shrinking::shrink_halfspaces(const std::vector<Halfspace>& halfspaces) {
  const auto format = halfspace_format_of_path(options_.output);
  if (!format) {
    throw Error(ErrorCode::InvalidArgument, "-o " + options_.output +
                                                ": expected .json, .ine or .txt, as the input is "
                                                "halfspaces");
  }
  begin(write_halfspaces(halfspaces, *format), size_of(halfspaces));
  const bool keeps_volume = !options_.allow_flat && is_solid(halfspaces);
  bool is_first = true;
  (void)shrink(halfspaces, [&](std::span<const Halfspace> fewer) {
    if (std::exchange(is_first, false)) return true;
    // The readers refuse a file without a row.
    if (fewer.empty() || (keeps_volume && !is_solid(fewer))) return false;
    return still_fails(write_halfspaces(fewer, *format),
                       std::vector<Halfspace>(fewer.begin(), fewer.end()), size_of(fewer));
  });
}

std::string Shrinking::summary() const {
  if (options_.global.json) {
    const Json document = {{"failure", failure_},
                           {rows_name(), {{"before", before_.rows}, {"after", size_.rows}}},
                           {"bits", {{"before", before_.bits}, {"after", size_.bits}}},
                           {"runs", runs_},
                           {"output", options_.output}};
    return write_json(document, 2) + "\n";
  }
  return fmt::format(
      "{}\n  failure     {}\n  {:<12}{} of {}\n  bits        {} of {}\n  runs        {}\n"
      "  written     {}\n",
      options_.input, failure_, rows_name(), size_.rows, before_.rows, size_.bits, before_.bits,
      runs_, options_.output);
}

int run_shrink(const ShrinkArguments& options) {
  require_outputs({options.output}, {options.input});
  // A decimal of binary32 may be no more than nine digits.
  const bool is_binary32 = options.promise.promise(Asks::Enclosure).numbers == Precision::Binary32;
  const std::vector<SceneObject> scene = read_scene(
      {options.input},
      {.decimal = is_binary32 ? Decimal::Nearest32 : Decimal::Nearest, .on_read = remember_input});
  Shrinking shrinking(options, scene.front());
  if (const auto reason = nothing_in(scene.front().shape)) {
    return report_not_solid(options.global, scene.front().name, *reason);
  }
  try {
    shrinking.run();
  } catch (const Error& error) {
    if (error.code() != ErrorCode::Stopped) throw;
    if (!shrinking.is_smaller()) {
      throw Error(ErrorCode::Stopped,
                  fmt::format("{}; nothing is written, as nothing smaller that fails was found",
                              error.what()));
    }
    // After an interrupt the smallest failing input so far is written.
    write_together({{options.output, shrinking.smallest()}}, "");
    throw Error(
        ErrorCode::Stopped,
        fmt::format("{}; {} holds the smallest input so far that fails, {}, not yet minimal",
                    error.what(), options.output, shrinking.found()));
  }
  write_together({{options.output, shrinking.smallest()}}, shrinking.summary());
  return 0;
}

}  // namespace

void add_shrink_command(Command& program, int& exit_code) {
  auto options = std::make_shared<ShrinkArguments>();
  Command& command = *program.add_subcommand(
      "shrink", "reduce an input on which a program fails to a minimal one");
  command.footer(kShrinkFooter);
  command
      .add_option("INPUT", options->input,
                  "a mesh, point cloud or list of halfspaces on which PROGRAM fails")
      ->required();
  command
      .add_option("PROGRAM", options->program.words,
                  "after --: the program and its arguments, with {input}, {output}, {faces}")
      ->expected(-1);
  command
      .add_option("-o,--output", options->output,
                  "the minimal input: .obj, .off, .ply or .xyz, of halfspaces .json, .ine or .txt; "
                  "{input} has this format")
      ->required();
  add_faces(command, options->program.faces, "the number that replaces {faces}");
  add_choice<FailsIf>(
      command, "--fails-if", options->program.fails_if,
      {{"either", FailsIf::Either}, {"exit", FailsIf::Exit}, {"verdict", FailsIf::Verdict}},
      "what counts as a failure: how the program ends, the verdict on {output}, or either of them");
  command.add_option(
      "--interesting", options->interesting,
      "in the place of PROGRAM: a command for the shell that ends with 0 for as long "
      "as an input is interesting; {input} in it, or its last word, is the input");
  add_points_option(command, options->points);
  add_claims_option(command, options->claims,
                    "in the verdict, decide these claims only, separated by commas");
  add_promise_options(command, options->promise, "enclosure");
  command.add_flag("--allow-flat", options->allow_flat,
                   "allow an input with a volume to be reduced to one without");
  command
      .add_option("--output-format", options->output_format,
                  "the format in which PROGRAM writes {output}")
      ->one_of({"obj", "off", "ply", "stl", "json", "ine", "txt"})
      ->capture_default_str();
  add_seconds(command, "--time-limit", options->program.limits.seconds, "time for each run");
  add_bytes(command, "--memory-limit", options->program.limits.memory,
            "address space for each run, e.g. 2GB; no limit by default");
  add_bytes(command, "--output-limit", options->program.limits.output,
            "size of an output that is read; a larger one violates candidate-readable (default: "
            "1GiB)");
  finish_command(command, options, exit_code, run_shrink);
  command.show_first({"--output", "--faces", "--fails-if", "--interesting", "--asks", "--claims",
                      "--tolerance", "--output-format", "--time-limit", "--json"});
}

}  // namespace convexact::cli
