// SPDX-License-Identifier: MIT
#include "cli/verify_union.hpp"

#include <filesystem>

#include "cli/outputs.hpp"
#include "convexact/io.hpp"
#include "convexact/scene.hpp"
#include "io/json.hpp"
#include "pages/parts_picture.hpp"
#include "scene/objects.hpp"
#include "wire/decompose_report.hpp"
#include "wire/part_models.hpp"
#include "wire/parts_verdict.hpp"

namespace convexact::cli {

std::string UnionOptions::foreign_to_one_solid() const {
  return !given.all().empty()     ? option_of(*given.all().front().first)
         : max_part_vertices      ? "--max-part-vertices"
         : measures.wanted        ? "--measures"
         : measures.exact_volumes ? "--exact-volumes"
                                  : "";
}

void add_union_options(Command& command, UnionOptions& options) {
  command.add_flag(
      "--union", options.is_asked,
      "judge the parts of CANDIDATE together: does their union hold INPUT? Also "
      "without this option if CANDIDATE is a folder, or JSON with \"parts\", or with --distance, "
      "or if --claims names a claim of parts");
  for (BoundField field : options.given.bound(parts_fields())) {
    if (field.info->name == "exact_volumes") continue;
    FieldInfo info = *field.info;
    info.meaning = "with --union: " + info.meaning;
    field.info = &info;
    add_field(command, field);
  }
  add_count(
      command, "--max-part-vertices", options.max_part_vertices, {},
      "with --union: the largest number of corners of a part; --max-vertices means the same there");
  add_measures_options(command, options.measures, "with --union: ");
  command.add_option("--picture", options.picture,
                     "a page (.html) that shows INPUT and CANDIDATE, or its parts, and in red the "
                     "witness of what is violated: a point, or the pieces of INPUT in no part");
}

bool is_decomposition(const std::string& path) {
  std::error_code ignored;
  if (path == "-") return false;
  if (std::filesystem::is_directory(path, ignored) || is_part_model(path)) return true;
  if (halfspace_format_of_path(path) != HalfspaceFormat::Json) return false;
  return read_bytes(path).find("\"parts\"") != std::string::npos;
}

int run_verify_union(const GlobalOptions& global, const std::string& input,
                     const std::string& candidate, const SceneOptions& reading,
                     PartsRequest request, const UnionOptions& options) {
  if (!options.picture.empty()) require_outputs({options.picture}, {input, candidate});
  options.given.apply_to(request, parts_fields());
  if (options.max_part_vertices && request.max_vertices) {
    throw Error(ErrorCode::InvalidArgument,
                "--max-vertices is --max-part-vertices of a union: name one of them");
  }
  if (options.max_part_vertices) request.max_vertices = options.max_part_vertices;
  if (request.measures != PartMeasures::None) {
    request.measures = options.measures.to_print(global.json);
  } else if (options.measures.wanted || options.measures.exact_volumes) {
    throw Error(ErrorCode::InvalidArgument,
                "--no-tightness is --measures none of a union: name no others");
  }
  request.exact_volumes = options.measures.exact_volumes;
  CommandRun run(global);
  SceneObject object = run.read_one(input, reading, "read input");
  const std::string name = object.name;
  const auto made = mesh_of(std::move(object));
  if (const auto* reason = std::get_if<NotSolid>(&made)) return run.end_flat(name, *reason);
  const CandidateParts parts = run.log().run(
      "read parts", StageKind::Io, [&] { return read_parts(candidate, reading.decimal); });
  request.watch = run.watch();
  const PartsVerdict verdict = verify_parts(std::get<Mesh>(made), parts, request);
  run.log().add(verdict.stages);
  OutputFiles files;
  if (!options.picture.empty()) {
    files.emplace_back(options.picture, picture_html(parts_picture(
                                            std::get<Mesh>(made), verdict,
                                            std::filesystem::path(name).filename().string())));
  }
  return run.end(
      {.json =
           [&] {
             Json document = {{"input", name}, {"file", candidate}};
             document.update(parts_verdict_json(verdict));
             return document;
           },
       .text =
           [&] {
             return candidate + " as parts of " + name + "\n" + parts_verdict_text(verdict) +
                    (options.picture.empty() ? ""
                                             : "  written             " + options.picture + "\n") +
                    "\n";
           },
       .files = files,
       .exit = verdict.holds() ? 0 : 1});
}

}  // namespace convexact::cli
