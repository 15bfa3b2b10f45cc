// SPDX-License-Identifier: MIT
// shipped_vectors.hpp - the conformance vectors that come with the program, or those of a folder.
#pragma once
#include <string>
#include <vector>

#include "convexact/conform.hpp"

namespace convexact::cli {

/// @param folder  Empty for the shipped ones.
/// @throws Error Unreadable if they are not found; as read_test_vectors().
[[nodiscard]] std::vector<TestVector> read_vectors(const std::string& folder);

/// The vector of that id. @throws Error InvalidArgument, naming one that is spelt nearly so.
[[nodiscard]] const TestVector& vector_of_id(const std::vector<TestVector>& vectors,
                                             const std::string& id);

}  // namespace convexact::cli
