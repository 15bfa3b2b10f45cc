// SPDX-License-Identifier: MIT
#include "cli/command_run.hpp"

#include <iostream>

#include "convexact/io.hpp"
#include "wire/stage_report.hpp"

namespace convexact::cli {

void write_together(const OutputFiles& files, const std::string& summary) {
  AtomicOutput output;
  for (const auto& [path, bytes] : files) output.add(path, bytes);
  output.commit([&summary] { print(summary); });
}

std::vector<SceneObject> CommandRun::read(const std::vector<std::string>& paths,
                                          const SceneOptions& options, const std::string& stage) {
  SceneOptions noting = options;
  noting.on_note = [this](const std::string& file, const std::string& text) { note(file, text); };
  return log_.run(stage, StageKind::Io, [&] { return read_scene(paths, noting); });
}

SceneObject CommandRun::read_one(const std::string& path, const SceneOptions& options,
                                 const std::string& stage) {
  return std::move(read({path}, options, stage).front());
}

void CommandRun::tell_notes() {
  progress_.clear();
  std::cerr << notes_;
  notes_.clear();
}

int CommandRun::end_flat(const std::string& name, const NotSolid& reason) {
  tell_notes();
  return report_not_solid(global_, name, reason);
}

int CommandRun::end_flat(const SceneObject& object, const NotSolid& reason) {
  return end_flat(object.name, of_typed_rows(reason, object.rows));
}

int CommandRun::end(const CommandAnswer& answer) {
  tell_notes();
  std::string said;
  if (global_.json) {
    Json document = answer.json();
    document["stages"] = stages_json(log_.stages());
    said = write_json(document, 2) + "\n";
  } else {
    said = answer.text() + stage_text(log_.stages(), global_.stages || global_.verbose);
  }
  answer.write(answer.files, said);
  return answer.exit;
}

}  // namespace convexact::cli
