// SPDX-License-Identifier: MIT
// solid_request.hpp - a shape whose hull is asked for, or that is to be enclosed in few halfspaces,
// and the answer, each a line of JSON.
#pragma once
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "convexact/scene.hpp"
#include "convexact/simplify.hpp"

namespace convexact {

/// The shape of a request, under its name.
/// @throws Error Malformed unless there are points or planes, as answer_hull_request() says.
[[nodiscard]] SceneObject shape_in_request(const nlohmann::json& request);

/// Makes the page that a request with `picture` gets beside the answer.
template <class Result>
using PictureOf = std::function<std::string(const SceneObject& input, const Result& result)>;

/// Answers a request (docs/schema/solid_request.schema.json) with one line of JSON, without a line
/// end: the request's `id`, and what `convexact hull --json` prints but for the stages, or `error`;
/// under `files` the bytes of each file that is asked for, proven as those of the command line, STL
/// and GLB in base64; and under `picture` a page. Only std::bad_alloc is thrown.
///
/// The shape is `points`, read as in requests to the oracle (stdio_request.hpp), or `planes`, read
/// as its candidates are. `triangles` are drawn, and count for nothing else.
/// @param time_limit  As in requests to the oracle.
/// @param picture     Null: a request for a picture is an error.
/// @par Cost          Reading, about 20 ns a byte, and measure_hull().
[[nodiscard]] std::string answer_hull_request(std::string_view line,
                                              std::optional<double> time_limit = {},
                                              const PictureOf<HullResult>& picture = {});

/// The pages of simplify.
struct SimplifyPictures {
  PictureOf<SimplifyResult> outer = {};
  PictureOf<InnerResult> inner = {};  ///< Of a request with `inner`.
};

/// The same for `convexact simplify --json`: each option of simplify_fields() by its name there, or
/// with `inner` those of inner_fields(); `keep`, a list of selectors as --keep takes them; and with
/// `trace` what --trace writes, under that name.
/// @par Cost  Reading, about 20 ns a byte, and simplify().
[[nodiscard]] std::string answer_simplify_request(std::string_view line,
                                                  std::optional<double> time_limit = {},
                                                  const SimplifyPictures& pictures = {});

}  // namespace convexact
