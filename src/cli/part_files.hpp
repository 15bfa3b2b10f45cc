// SPDX-License-Identifier: MIT
// part_files.hpp - the names of parts, and the files and folders that hold them.
#pragma once
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "cli/outputs.hpp"
#include "io/json_document.hpp"

namespace convexact::cli {

/// Names from a pattern with one number in it: "UCX_%02d".
class PartNames {
 public:
  /// @throws Error InvalidArgument unless there is exactly one %d or %0Nd and the rest can be part
  ///               of the name of a file and of an object.
  explicit PartNames(const std::string& pattern);

  /// Of part k, from 0.
  [[nodiscard]] std::string operator()(std::size_t k) const;
  /// Whether a name may end with that of a part.
  [[nodiscard]] bool may_end(std::string_view name) const;

 private:
  std::string before_, after_;
  std::size_t width_ = 1;
};

/// Whether a text can be the beginning of a part's name.
[[nodiscard]] bool is_plain_name(const std::string& text);

/// Where parts go, by the name of an output.
enum class PartsOutput {
  Obj,     ///< One file, an object for each part.
  Glb,     ///< The same as glTF, in binary32.
  Json,    ///< One document.
  Folder,  ///< A file for each part, and the document.
  Mjcf,    ///< A model for MuJoCo that names the files of a folder.
  Urdf,    ///< The same for readers of URDF.
  Usd,     ///< A layer of USD that holds the meshes.
};

inline constexpr std::string_view kMjcfExtension = ".mjcf.xml";

/// By the extension .obj, .glb, .json, .mjcf.xml, .urdf or .usda; a name that ends in /, or that of
/// a folder, means a folder.
/// @throws Error InvalidArgument for any other name.
[[nodiscard]] PartsOutput parts_output_of(const std::string& path);

/// Whether the name of an output means a folder. @throws Error as parts_output_of().
[[nodiscard]] bool is_folder(const std::string& path);

/// Of the file that holds a part, in a folder.
[[nodiscard]] std::string part_file_name(const std::string& part);

/// The document in a folder of parts.
inline constexpr const char* kPartsDocument = "parts.json";

/// Meshes in a folder that a run does not write.
struct LeftInFolder {
  std::vector<std::string> stale;    ///< Of an earlier run, according to its document: they must be
                                     ///< removed.
  std::vector<std::string> foreign;  ///< All others, which a reader of the folder would take for
                                     ///< parts.
};

/// @param written  Names of files, without the folder.
/// @param inputs   They are no parts of an earlier run.
[[nodiscard]] LeftInFolder left_in_folder(const std::string& folder,
                                          const std::set<std::string>& written,
                                          const std::vector<std::string>& inputs);

/// Makes the folders that are missing, writes the files, removes those that are stale, and prints
/// the summary: all of it succeeds, or everything stays as it was, and no new folder remains.
/// @throws Error as write_together(); Unwritable if a folder cannot be made or a file not removed.
void write_parts_together(const OutputFiles& files, const std::vector<std::string>& folders,
                          const std::vector<std::string>& stale, const std::string& summary);

}  // namespace convexact::cli
