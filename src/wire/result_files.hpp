// SPDX-License-Identifier: MIT
// result_files.hpp - the files of one solid, and the forms in which a run must store it for them.
#pragma once
#include <string>
#include <vector>

#include "convexact/scene.hpp"

namespace convexact {

/// Whether a file of that name is the proof of a run.
[[nodiscard]] inline bool is_proof(const std::string& name) { return name.ends_with(".proof"); }

/// Whether it is a mesh of numbers in binary32, by the extension: STL and GLB.
[[nodiscard]] bool is_binary32_only(const std::string& name);

/// The last file of binary32 only that one run cannot write beside the others: the precision is
/// 64, or it is open and another mesh asks for binary64. Empty if there is none.
[[nodiscard]] std::string file_of_less_precision(const std::vector<std::string>& names,
                                                 int precision);

/// A mesh or halfspaces by the extension, or a proof.
[[nodiscard]] bool is_result_file(const std::string& name);

/// Whether one of the files needs the record of a run.
[[nodiscard]] bool needs_record(const std::vector<std::string>& names);

/// The formats that the files need; unset where none does.
/// @param precision  64 or 32; 0 if it is open: then planes stay exact, and meshes are binary64
///                   unless a file holds binary32 only.
[[nodiscard]] StoreRequest store_request_for(const std::vector<std::string>& names, int precision);

}  // namespace convexact
