// SPDX-License-Identifier: MIT
// command_run.hpp - how a command runs: it reads, works under a watch, and ends with an answer and
// its files, or with the proof that an input encloses no volume.
#pragma once
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "cli/command.hpp"
#include "cli/progress.hpp"
#include "convexact/scene.hpp"
#include "io/json_document.hpp"
#include "solid/stage_log.hpp"

namespace convexact::cli {

/// Path and bytes of each output.
using OutputFiles = std::vector<std::pair<std::string, std::string>>;

/// Writes the files and prints the summary: all of it succeeds, or every file stays as it was.
/// @throws Error as AtomicOutput and print().
void write_together(const OutputFiles& files, const std::string& summary);

/// What a command says at its end. One of the two is called.
struct CommandAnswer {
  std::function<Json()> json;  ///< The stages are added.
  std::function<std::string()> text;
  OutputFiles files = {};
  int exit = 0;
  /// Puts the files into place together with what is said.
  std::function<void(const OutputFiles& files, const std::string& said)> write = write_together;
};

/// An interrupt ends the stages with Stopped.
class CommandRun {
 public:
  explicit CommandRun(const GlobalOptions& global)
      : global_(global), watch_(progress_.watch()), log_(watch_) {}
  /// Tells the notes, if an error ends the run.
  ~CommandRun() { tell_notes(); }
  CommandRun(const CommandRun&) = delete;
  CommandRun& operator=(const CommandRun&) = delete;

  StageLog& log() { return log_; }
  /// For work that reports its stages by itself.
  const StageWatch& watch() const { return watch_; }
  Progress& progress() { return progress_; }

  /// The objects of the files, as a stage.
  std::vector<SceneObject> read(const std::vector<std::string>& paths, const SceneOptions& options,
                                const std::string& stage = "read");
  /// The one object of a file whose parts are not asked for.
  SceneObject read_one(const std::string& path, const SceneOptions& options,
                       const std::string& stage = "read");

  /// Something that the reader of a file left out or guessed: told on standard error at the end.
  void note(const std::string& file, const std::string& note) {
    notes_ += "convexact: " + file + ": note: " + note + "\n";
  }

  /// Each ends the run and returns the exit code: an input encloses no volume; or there is an
  /// answer, which is printed when the files are written.
  int end_flat(const std::string& name, const NotSolid& reason);
  int end_flat(const SceneObject& object, const NotSolid& reason);
  int end(const CommandAnswer& answer);
  /// Another run takes over, which reads the files again.
  void abandon() {
    progress_.clear();
    notes_.clear();
  }

 private:
  void tell_notes();

  const GlobalOptions& global_;
  Progress progress_;
  StageWatch watch_;
  StageLog log_;
  std::string notes_;
};

}  // namespace convexact::cli
