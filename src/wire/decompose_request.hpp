// SPDX-License-Identifier: MIT
// decompose_request.hpp - a mesh to be decomposed and its parts, each a line of JSON.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "convexact/decompose.hpp"

namespace convexact {

/// From the name of the input and its parts to a page.
using DecompositionPicture =
    std::function<std::string(const std::string& name, const Decomposition& parts)>;

/// Answers a request (docs/schema/decompose_request.schema.json) with one line of JSON, without a
/// line end: the request's `id`, and either the document of decomposition_json() with all details
/// and, if asked for, under `tree_file` that of proven_tree_file(), both proven on their bytes; or
/// `error`. Only std::bad_alloc is thrown.
///
/// Coordinates are read as in requests to the oracle (stdio_request.hpp). `concavity` and
/// `coplanar` mean exactly what their texts spell, as strings or as numbers.
/// @param time_limit  Seconds that the decomposition may take; a request may ask for fewer. Beyond
///                    them the answer is the error `stopped`, some milliseconds later.
/// @param picture     Makes the page that a request with `picture` gets under that name; null: such
///                    a request is an error.
/// @par Cost  Reading, about 20 ns a byte, and decompose().
[[nodiscard]] std::string answer_decompose_request(std::string_view line,
                                                   std::optional<double> time_limit = {},
                                                   const DecompositionPicture& picture = {});

}  // namespace convexact
