// SPDX-License-Identifier: MIT
// convexact teach: the construction of one shape, step by step, as the exact engine recorded it.
#include <fmt/format.h>

#include <memory>

#include "cli/outputs.hpp"
#include "io/json.hpp"
#include "simplify/run_names.hpp"
#include "teach/lesson.hpp"
#include "teach/lesson_page.hpp"
#include "teach/plane_lesson.hpp"
#include "wire/simplify_options.hpp"
#include "wire/stage_report.hpp"

namespace convexact::cli {
namespace {

constexpr const char* kTeachFooter =
    "Examples:\n"
    "  convexact teach cube.obj -o lesson.html\n"
    "  convexact teach planes.ine --faces 6 --cost area --measures volume,mean-width -o a.html\n"
    "  convexact teach cube.obj --center 1/2,1/2,1/2 --precision 64 -o lesson.html -o lesson.json\n"
    "  convexact teach cube.obj --json | jq .removals\n"
    "  convexact teach polygon.obj --plane -o polygon.html\n"
    "\n"
    "The lesson is a record of what the engine did: each point of the hull, each row of the "
    "linear\n"
    "program, each cost, each removal with the signs that verify it, and the rounding of the "
    "result.\n"
    "For large inputs, parts of the lesson are left out; the summary and the lesson say which, and "
    "why.\n"
    "A step that fails its verification is shown as the last one; the exit code is then 70.";

struct TeachArguments {
  GlobalOptions global;
  std::string input;
  SceneOptions scene;
  std::vector<std::string> outputs;
  std::string center = "chebyshev";
  LessonRequest request;
  bool in_plane = false;
};

void require_sensible(const TeachArguments& options) {
  if (options.in_plane && (options.outputs.empty() || options.global.json)) {
    throw Error(ErrorCode::InvalidArgument,
                "with --plane a lesson is a page that computes itself: add -o lesson.html, and "
                "leave out --json");
  }
  if (options.outputs.empty() && !options.global.json) {
    throw Error(ErrorCode::InvalidArgument,
                "teach needs a place for the lesson: add -o lesson.html (a page) or -o lesson.json "
                "(its data), or --json to print the data");
  }
  for (const std::string& path : options.outputs) {
    if (options.in_plane && !path.ends_with(".html")) {
      throw Error(ErrorCode::InvalidArgument,
                  "-o: with --plane a lesson is a page that computes itself: expected a name that "
                  "ends in .html, found " +
                      in_quotes(path));
    }
    if (!path.ends_with(".html") && !path.ends_with(".json")) {
      throw Error(ErrorCode::InvalidArgument,
                  "-o: expected a name that ends in .html or .json, found " + in_quotes(path));
    }
  }
  require_outputs(options.outputs, {options.input});
}

OutputFiles lesson_files(const std::vector<std::string>& paths, const Lesson& lesson) {
  OutputFiles files;
  const std::string name = lesson.document["name"].text();
  for (const std::string& path : paths) {
    files.emplace_back(path, path.ends_with(".html") ? lesson_page(name, lesson.document)
                                                     : write_json(lesson.document) + "\n");
  }
  return files;
}

// The chapters, the missing parts, and the place of the lesson.
std::string summary_of(const Lesson& lesson, const OutputFiles& files) {
  const Json& document = lesson.document;
  std::string text =
      fmt::format("  input       {} {}, {} halfspaces\n", document["input"]["count"].count(),
                  document["input"]["kind"].text(), document["halfspaces"].size());
  if (document.contains("hull")) {
    text += fmt::format("  hull        {} insertions\n", document["hull"]["insertions"].size());
  }
  if (document.contains("center")) {
    text += fmt::format("  center      a linear program of {} rows\n",
                        document["halfspaces"].size() + 1);
  }
  if (document.contains("removals")) {
    std::size_t checks = 0;
    for (const auto& removal : document["removals"]) checks += removal["checks"].size();
    text += fmt::format("  removals    {}, from {} evaluations, verified by {} checks\n",
                        document["removals"].size(), document["evaluations"].size(), checks);
  }
  text += fmt::format("  left        {} halfspaces ({})\n", document["end"]["present"].size(),
                      document["stop"].text());
  if (document.contains("storing")) {
    text += fmt::format("  storing     {} planes in {}\n", document["storing"]["planes"].size(),
                        document["storing"]["precision"].text());
  }
  for (const auto& missing : document["left_out"]) {
    text += fmt::format("  left out    {}: {}\n", missing["chapter"].text(), missing["why"].text());
  }
  for (const auto& [path, bytes] : files) text += "  written     " + path + "\n";
  return text;
}

int run_plane_lesson(const TeachArguments& options) {
  CommandRun run(options.global);
  const SceneObject object = run.read_one(options.input, options.scene);
  const std::string page = plane_lesson_page(object);
  OutputFiles files;
  std::string text =
      object.name + "\n  lesson      in the plane; what has a ring around it can be dragged\n";
  for (const std::string& path : options.outputs) {
    files.emplace_back(path, page);
    text += "  written     " + path + "\n";
  }
  run.progress().clear();
  write_together(files, text);
  return 0;
}

int run_teach(const TeachArguments& options) {
  require_sensible(options);
  if (options.in_plane) return run_plane_lesson(options);
  LessonRequest request = options.request;
  request.center = parse_center("--center", options.center);
  request.seed = options.global.seed;
  CommandRun run(options.global);
  const SceneObject object = run.read_one(options.input, options.scene);
  request.watch = run.watch();
  const auto outcome = make_lesson(object, request);
  if (const auto* reason = std::get_if<NotSolid>(&outcome)) {
    if (std::holds_alternative<FlatInput>(*reason)) {
      run.note(object.name, "points in the plane z = 0 have a lesson of their own: teach --plane");
    }
    return run.end_flat(object.name, *reason);
  }
  const auto& lesson = std::get<Lesson>(outcome);
  run.log().add(lesson.stages);
  const OutputFiles files =
      run.log().run("write", StageKind::Io, [&] { return lesson_files(options.outputs, lesson); });
  run.progress().clear();
  if (lesson.failure) {
    // The lesson shows the step; the report of the error has the usual form.
    write_together(files, "");
    throw Error(ErrorCode::Internal, *lesson.failure);
  }
  write_together(files, options.global.json
                            ? write_json(lesson.document) + "\n"
                            : object.name + "\n" + summary_of(lesson, files) +
                                  stage_text(run.log().stages(), options.global.stages));
  return 0;
}

}  // namespace

void add_teach_command(Command& program, int& exit_code) {
  auto options = std::make_shared<TeachArguments>();
  Command& command = *program.add_subcommand(
      "teach", "a lesson: how the halfspaces of one shape are found and removed, step by step");
  command.footer(kTeachFooter);
  command
      .add_option("INPUT", options->input,
                  "points or a mesh (OBJ, OFF, PLY, STL, glTF, COLLADA, XYZ), or halfspaces (JSON, "
                  ".ine, rows); - "
                  "is standard input")
      ->required();
  add_faces(command, options->request.faces, "how many halfspaces to keep, at least 4");
  add_choice(command, "--cost", options->request.cost, kCostMeasureNames,
             "the measure to which each removal adds the least");
  add_text(command, "--measures",
           "further costs of each evaluation to show, out of volume,area,mean-width",
           [&request = options->request](const auto& option, const auto& text) {
             request.measures = parse_words(option, text, kCostMeasureNames);
           });
  add_center_option(command, options->center);
  command
      .add_option("-o,--output", options->outputs,
                  "file for the lesson, by extension: .html, a page that needs no other file, or "
                  ".json; may be repeated")
      ->expected(1)
      ->allow_extra_args(false)
      ->take_all();
  add_choice<Precision>(command, "--precision", options->request.precision,
                        {{"64", Precision::Binary64}, {"32", Precision::Binary32}},
                        "the numbers in which the lesson stores the result");
  Option plane =
      command.add_flag("--plane", options->in_plane,
                       "in the plane, from points with one z, or on convex parts, from a "
                       "face: a page that computes itself, where things can be dragged");
  for (const char* other : {"--faces", "--cost", "--measures", "--center", "--precision"}) {
    plane->excludes(command.get_option(other));
  }
  options->scene.on_read = remember_input;
  add_decimal_option(command, options->scene.decimal);
  finish_command(command, options, exit_code, run_teach);
  add_stages_option(command, options->global);
}

}  // namespace convexact::cli
