// SPDX-License-Identifier: MIT
// decompose_arguments.hpp - what decompose is asked, and how it takes one object apart: of a mesh,
// or of a robot.
#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cli/command_run.hpp"
#include "cli/decomposed_files.hpp"
#include "cli/measures_options.hpp"
#include "cli/stdio_loop.hpp"
#include "convexact/decompose.hpp"
#include "convexact/verify.hpp"
#include "wire/decompose_options.hpp"
#include "wire/robot_model.hpp"

namespace convexact::cli {

struct DecomposeArguments {
  GlobalOptions global;
  std::string input;
  SceneOptions scene;
  DecomposeFiles files;
  DecomposeRequest request = default_decompose_request();
  MeasuresOptions measures;
  std::optional<Tolerance> weld;
  std::string profile;
  StdioOptions stdio;
  std::vector<std::string> packages;  ///< NAME=DIR
  bool keep_going = false;            ///< A robot: collisions that fail stay as they are.
  std::optional<Option> precision = {};
};

/// An object without a volume, with its name.
struct FlatMesh {
  std::string name;
  NotSolid reason;
};

/// Welds as the arguments ask, chooses the method, and decomposes. Notes go to the run.
/// @throws Error as decompose(), with the name of the object.
[[nodiscard]] std::variant<DecomposedObject, FlatMesh> decompose_object(
    SceneObject object, const DecomposeRequest& request, const DecomposeArguments& options,
    CommandRun& run);

/// Whether the input is the model of a robot, by its name.
[[nodiscard]] bool is_robot(const std::string& input);

/// convexact decompose robot.urdf -o out/.
/// @param request  As for parts of a model.
int run_robot(const DecomposeArguments& options, const DecomposeRequest& request);

}  // namespace convexact::cli
