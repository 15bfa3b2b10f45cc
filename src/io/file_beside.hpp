// SPDX-License-Identifier: MIT
// file_beside.hpp - files that a mesh or a model names: they must lie in its folder.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace convexact {

/// The folder that holds a file; empty for standard input, which lies nowhere.
[[nodiscard]] std::string folder_of_file(const std::string& path);

/// The bytes of a URI in which %41 stands for A. @throws Error Malformed for other %, and for %00.
[[nodiscard]] std::string decoded_uri(std::string_view uri);

/// The path of a file relative to a folder.
/// @param others  Folders in which it may lie, too.
/// @throws Error Unreadable for an absolute path, a scheme such as http:, and for a path, links
///               followed, that leads out of the folder and of the others.
[[nodiscard]] std::string file_inside(const std::string& folder, std::string_view path,
                                      const std::vector<std::string>& others);

/// The path of the file that a relative reference names, in which %41 stands for A.
/// @throws Error as file_inside(); Unreadable, too, without a folder.
[[nodiscard]] std::string file_beside(const std::string& folder, std::string_view uri);

}  // namespace convexact
