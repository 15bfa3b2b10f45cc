// SPDX-License-Identifier: MIT
// decomposed_files.hpp - the files that decompose writes: the parts, alone or as models for
// simulators, and what shows, replays or proves them.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/model_files.hpp"
#include "cli/outputs.hpp"
#include "convexact/decompose.hpp"
#include "wire/decompose_report.hpp"

namespace convexact::cli {

/// Paths, each empty for none. A new kind joins all_paths(), decomposed_files() and the options.
struct DecomposeFiles {
  std::vector<std::string> results;       ///< -o
  std::string names = "part_%03d";        ///< Of the parts.
  std::string tree;                       ///< Of hulls over the parts.
  std::optional<std::size_t> tree_faces;  ///< Of each branch of the tree.
  std::string trace;                      ///< Every merge.
  std::string proof;                      ///< For convexact-check.
  std::string picture;                    ///< A page.
  ModelOptions model;                     ///< What models say of the body.

  std::vector<std::string> all_paths() const;
  /// Whether one of the results holds binary32 numbers: a model for simulators, or a GLB.
  bool need_binary32() const;
  /// Whether one of them is a model for simulators.
  bool have_model() const;
  /// A folder for the parts that a model names, if it has none: spot_parts/ beside spot.urdf. What
  /// to say of it; empty if none is missing.
  std::string add_missing_folder();
  /// Whether one of the results is JSON.
  bool have_document() const;
  /// Whether one of the files tells of single merges: a trace, a picture, or JSON.
  bool show_merges() const;
  /// @throws Error InvalidArgument for names and extensions that cannot be, for models of parts
  ///               that simulators would change or find in several folders, and if the input would
  ///               be lost.
  void require_sensible(const std::string& input, const DecomposeRequest& request) const;
  /// @throws Error InvalidArgument if a file shows one object only, and there are more.
  void require_room_for(std::size_t objects) const;
};

/// Adds -o, --names, --tree, --tree-faces, --trace, --proof, --picture, --name, --up, --scale and
/// --density.
void add_decompose_files(Command& command, DecomposeFiles& files);

/// Names the parts after the pattern. Parts of several objects begin with the name of theirs, or
/// with its number if one of these names cannot be part of the name of a file and of an object.
void name_parts(std::vector<DecomposedObject>& objects,
                const std::vector<std::string>& object_names, const std::string& pattern);

/// The files, the folders that some of them lie in, and what to say of both.
struct FilesOfParts {
  OutputFiles files;
  std::vector<std::string> folders;
  std::vector<std::string> removed;  ///< Files of an earlier run, which must go.
  std::vector<std::string> notes;
  std::string tree_summary;
  std::string mass_summary;
  Json mass;  ///< Of a run that writes models; else null.
};

/// Every file, its bytes proven. @param files  As require_sensible() and require_room_for() accept.
/// @throws Error Unrepresentable if a format cannot hold a name or a part; Stopped; Internal if a
///               proof fails.
[[nodiscard]] FilesOfParts decomposed_files(std::span<const DecomposedObject> objects,
                                            const DecomposeRequest& request,
                                            const DecomposeFiles& files, const std::string& input);

}  // namespace convexact::cli
