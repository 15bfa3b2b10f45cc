// SPDX-License-Identifier: MIT
// convexact shrink: a failing input made minimal.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "claim_list.hpp"
#include "command.hpp"
#include "convexact/error.hpp"
#include "convexact/format/write_json.hpp"
#include "convexact/io/read_mesh.hpp"
#include "convexact/io/write_mesh.hpp"
#include "convexact/oracle/shrink.hpp"
#include "outputs.hpp"
#include "program_case.hpp"
#include "progress.hpp"
#include "quantity_option.hpp"

namespace convexact::cli {
namespace {

constexpr const char* kShrinkFooter =
    "Examples:\n"
    "  convexact shrink bad.obj -o minimal.obj -- ./my_hull {input} {output}\n"
    "  convexact shrink bad.obj -o minimal.off --faces 12 --fails-if verdict \\\n"
    "      --claims contains-input -- ./my_hull {input} --faces {faces} -o {output}\n"
    "\n"
    "PROGRAM is run directly, not by a shell. It fails if it does not exit with 0 in time, or if "
    "it "
    "does\n"
    "and what it writes to {output} violates a claim (docs/verdicts). The result fails in the same "
    "way:\n"
    "with the same exit code, signal or first violated claim.";

struct ShrinkArguments {
  GlobalOptions global;
  std::string input, output, claims;
  std::string output_extension = ".obj";
  ProgramCase program;
};

struct Size {
  std::size_t points, bits;
};

Size size_of(const PointSet& points) { return {points.size(), coordinate_bits(points)}; }

MeshFormat format_of(const std::string& path) {
  const auto format = mesh_format_of_path(path);
  if (!format || *format == MeshFormat::Stl) {
    throw Error(ErrorCode::InvalidArgument, "-o " + path + ": expected .obj, .off, .ply or .xyz");
  }
  return *format;
}

// Of a mesh what is left with some of its points, moved: the polygons that keep all their corners.
Mesh part_of(const Mesh& mesh, const PointSet& points, std::span<const PointId> origin) {
  constexpr std::uint32_t kGone = 0xffffffff;
  std::vector<std::uint32_t> place(mesh.points.size(), kGone);
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

std::string summary_of(const ShrinkArguments& options, const std::string& failure,
                       const Size& before, const Size& after, std::size_t runs) {
  if (options.global.json) {
    const nlohmann::ordered_json document = {
        {"failure", failure},
        {"points", {{"before", before.points}, {"after", after.points}}},
        {"bits", {{"before", before.bits}, {"after", after.bits}}},
        {"runs", runs},
        {"output", options.output}};
    return write_json(document, 2) + "\n";
  }
  return fmt::format(
      "{}\n  failure     {}\n  points      {} of {}\n  bits        {} of {}\n"
      "  runs        {}\n  written     {}\n",
      options.input, failure, after.points, before.points, after.bits, before.bits, runs,
      options.output);
}

// An interrupt costs only what would have come: what fails already is written.
void keep(const ShrinkArguments& options, MeshFormat format, const Mesh& smallest,
          const Size& before) {
  const Size size = size_of(smallest.points);
  if (size.points == before.points && size.bits == before.bits) return;
  write_together({{options.output, write_mesh(smallest, format)}}, "");
  throw Error(ErrorCode::Stopped,
              fmt::format("interrupted; {} holds the smallest input so far that fails, {} of {} "
                          "points, not yet minimal",
                          options.output, size.points, before.points));
}

int run_shrink(const ShrinkArguments& options) {
  ProgramCase program = options.program;
  program.require_sensible();
  program.format = format_of(options.output);
  program.input_extension = std::filesystem::path(options.output).extension().string();
  program.output_extension = options.output_extension;
  program.verify.claims = parse_claims(options.claims);
  program.verify.tightness = false;
  program.verify.seed = options.global.seed;
  require_other_files({options.output}, {options.input});
  const Mesh mesh = read_mesh(options.input);
  const ScratchFolder folder;
  const std::optional<std::string> failure = failure_of(program, mesh, folder);
  if (!failure) {
    throw Error(ErrorCode::InvalidArgument, "the program does not fail on " + options.input);
  }
  const Size before = size_of(mesh.points);
  Progress progress;
  std::size_t runs = 1;
  Mesh smallest = mesh;  // that fails, so far
  const auto still_fails = [&](const PointSet& points, std::span<const PointId> origin) {
    ++runs;
    Mesh part = part_of(mesh, points, origin);
    const bool fails = failure_of(program, part, folder) == failure;
    if (fails) smallest = std::move(part);
    return fails;
  };
  try {
    (void)shrink(mesh.points, still_fails, [&](const PointSet& points) {
      progress("shrinking; points gone", before.points - points.size(), before.points);
    });
  } catch (const Error& error) {
    progress.clear();
    if (error.code() == ErrorCode::Stopped) keep(options, program.format, smallest, before);
    throw;
  }
  progress.clear();
  write_together({{options.output, write_mesh(smallest, program.format)}},
                 summary_of(options, *failure, before, size_of(smallest.points), runs));
  return 0;
}

}  // namespace

void add_shrink_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<ShrinkArguments>();
  CLI::App& command =
      *program.add_subcommand("shrink", "make an input minimal on which a program fails");
  command.footer(kShrinkFooter);
  command.add_option("INPUT", options->input, "a mesh or point cloud on which PROGRAM fails")
      ->required();
  command
      .add_option("PROGRAM", options->program.words,
                  "after --: the program and its arguments, with {input}, {output}, {faces}")
      ->required();
  command
      .add_option("-o,--output", options->output,
                  "the minimal input: .obj, .off, .ply or .xyz; {input} has this format")
      ->required();
  add_faces(command, options->program.faces, "what {faces} stands for");
  add_choice<FailsIf>(
      command, "--fails-if", options->program.fails_if,
      {{"either", FailsIf::Either}, {"exit", FailsIf::Exit}, {"verdict", FailsIf::Verdict}},
      "what counts as failing: how it ends, the verdict on {output}, or whichever comes first");
  command.add_option("--claims", options->claims,
                     "of the verdict decide these claims only, separated by commas");
  command
      .add_option("--output-as", options->output_extension,
                  "extension of {output}, as the program writes it")
      ->check(CLI::IsMember({".obj", ".off", ".ply", ".stl", ".json", ".ine", ".txt"}))
      ->capture_default_str();
  add_seconds(command, "--time-limit", options->program.limits.seconds, "for each run");
  add_bytes(command, "--memory-limit", options->program.limits.memory,
            "address space for each run, e.g. 2GB; no limit by default");
  add_global_options(command, options->global);
  command.callback([options, &exit_code] {
    exit_code = run_guarded(options->global, [&] { return run_shrink(*options); });
  });
}

}  // namespace convexact::cli
