// SPDX-License-Identifier: MIT
// outputs.hpp - the files that simplify writes: all of them, complete, or none.
#pragma once
#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "convexact/run.hpp"
#include "convexact/scene.hpp"
#include "convexact/simplify.hpp"

namespace convexact::cli {

struct OutputOptions {
  std::vector<std::string>
      results;          ///< -o: .obj .off .ply .stl are meshes, .json .ine .txt planes.
  std::string picture;  ///< An HTML page; empty for none.
  std::string trace;    ///< Every step as JSON; empty for none.
  std::string proof;    ///< For convexact-check; empty for none.
  int precision = 0;    ///< 64 or 32; 0 if not given.

  std::vector<std::string> all_paths() const;
  /// The formats that the result must be stored in; nothing where no output needs them.
  StoreRequest store_request() const;
  /// @throws Error InvalidArgument for unknown extensions and for formats that contradict each
  /// other.
  void require_sensible() const;
  /// @throws Error InvalidArgument if an output cannot hold that many objects.
  void require_room_for(std::size_t objects) const;
};

/// @throws Error InvalidArgument if an output is one of the inputs, under any name: the input would
/// be lost.
void require_other_files(const std::vector<std::string>& outputs,
                         const std::vector<std::string>& inputs);

void add_input_argument(CLI::App& command, std::vector<std::string>& inputs);
void add_output_options(CLI::App& command, OutputOptions& options);
void add_scene_options(CLI::App& command, SceneOptions& options);

/// One object and what encloses it.
struct OutputObject {
  const SceneObject& source;
  const Stored& solid;
  const Run* run = nullptr;         ///< Set wherever a trace or a proof may be asked for.
  const RunStart* start = nullptr;  ///< Set wherever a proof may be asked for.
};

/// Path and bytes of each output.
using OutputFiles = std::vector<std::pair<std::string, std::string>>;

/// Every output, after reading each mesh and plane file back from its bytes and testing that the
/// result holds every input point.
/// @throws Error Unrepresentable; Internal if that test fails.
[[nodiscard]] OutputFiles output_files(const std::vector<OutputObject>& objects,
                                       const OutputOptions& options);

/// Writes the files and prints the summary: all of it succeeds, or every file stays as it was.
/// @throws Error as AtomicOutput and print().
void write_together(const OutputFiles& files, const std::string& summary);

}  // namespace convexact::cli
