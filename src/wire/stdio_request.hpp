// SPDX-License-Identifier: MIT
// stdio_request.hpp - one question to the oracle and its answer, each a line of JSON.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "convexact/scene.hpp"
#include "convexact/verify.hpp"

namespace convexact {

/// From the input, the candidate and the verdict to a page.
using VerdictPicture = std::function<std::string(
    const SceneObject& input, const Candidate& candidate, const Verdict& verdict)>;

/// Answers a request (docs/schema/stdio_request.schema.json) with one line of JSON, without a line
/// end: the request's `id` and either the verdict as verdict_json() writes it, without the claims
/// that were not asked, or `error`. Any fault of the request is such an error, and any fault
/// of the candidate is a verdict; only std::bad_alloc is thrown.
///
/// A number means what the same text means in a file, as a JSON number or as a string,
/// independently of the other entries: a coordinate of a point or vertex is read by the request's
/// `decimal`; in a plane, integers and fractions are exact and other decimals are read by
/// `decimal`. Strings may also hold fractions (for coordinates as well) and hexadecimal floats,
/// which are exact. The id is a number, a string, true, false or null, and a number comes back
/// digit by digit.
/// @param time_limit  Seconds that the verdict may take; a request may ask for fewer. Beyond them
///                    the answer is the error `stopped`, some milliseconds later.
/// @param picture     Makes the page that a request with `picture` about one solid gets under
///                    that name; null: such a request is an error.
/// @par Cost  Reading, about 20 ns a byte, and verify() for the claims asked.
[[nodiscard]] std::string answer_request(std::string_view line,
                                         std::optional<double> time_limit = {},
                                         const VerdictPicture& picture = {});

}  // namespace convexact
