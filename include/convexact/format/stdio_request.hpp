// SPDX-License-Identifier: MIT
// stdio_request.hpp - one question to the oracle and its answer, each a line of JSON.
#pragma once
#include <string>
#include <string_view>

namespace convexact {

/// Answers a request (docs/schema/stdio_request.schema.json) with one line of JSON, without a line
/// end: the request's `id` and either what verdict_json() writes, without the
/// claims that were not asked, or `error`. Whatever is wrong with
/// the request is such an error, and whatever is wrong with the candidate is a verdict; nothing is
/// thrown but std::bad_alloc.
///
/// Numbers are JSON numbers (the nearest double; integers below 2^63 exactly) or strings: decimals
/// by the request's `decimal`, fractions, hexadecimal floats.
/// @par Cost  Reading, about 20 ns a byte, and verify() for the claims asked.
[[nodiscard]] std::string answer_request(std::string_view line);

}  // namespace convexact
