// SPDX-License-Identifier: MIT
// file_beside.hpp - files that a mesh or a model names: they must lie in its folder.
#pragma once
#include <string>
#include <string_view>

namespace convexact {

/// The folder that holds a file; empty for standard input, which lies nowhere.
[[nodiscard]] std::string folder_of_file(const std::string& path);

/// The bytes of a URI in which %41 stands for A. @throws Error Malformed for other %, and for %00.
[[nodiscard]] std::string decoded_uri(std::string_view uri);

/// The path of the file that a relative reference names.
/// @throws Error Unreadable for an absolute path, a scheme such as http:, and for a path, links
///               followed, that leads out of the folder; and without a folder.
[[nodiscard]] std::string file_beside(const std::string& folder, std::string_view uri);

}  // namespace convexact
