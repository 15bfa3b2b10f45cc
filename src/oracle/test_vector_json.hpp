// SPDX-License-Identifier: MIT
// test_vector_json.hpp - reads conformance vectors (docs/schema/vector.schema.json).
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "convexact/conform.hpp"

namespace convexact {

/// The vectors in a text. @param data  The folder of the meshes that vectors name.
/// @throws Error Malformed for anything that the schema does not allow; NotFinite; Unreadable for a
///         mesh that is not there.
[[nodiscard]] std::vector<TestVector> read_test_vectors_bytes(std::string_view bytes,
                                                              const std::string& data);

/// The vectors of one file. @throws Error as read_test_vectors_bytes, with the path in front.
[[nodiscard]] std::vector<TestVector> read_test_vectors_file(const std::string& path,
                                                             const std::string& data);

/// The vectors of all files NAME.json in a folder, by name; meshes come from `folder`/../data.
/// @throws Error as read_test_vectors_file; Unreadable if there is no such folder or no vector.
[[nodiscard]] std::vector<TestVector> read_test_vectors(const std::string& folder);

}  // namespace convexact
