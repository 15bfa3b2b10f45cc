// SPDX-License-Identifier: MIT
// lesson_request.hpp - a shape that a lesson is asked for, and the page, each a line of JSON.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace convexact {

/// Answers a request for a lesson with one line of JSON, without a line end: the request's `id`,
/// `page`, which is that of `convexact teach -o lesson.html`, and `left_out`, the chapters that the
/// page has not, with reasons; or `error`. Only std::bad_alloc is thrown.
///
/// The shape, `name`, `decimal`, `numbers`, `time_limit` and `seed` are those of requests to
/// simplify (solid_request.hpp); `faces`, `cost`, `measures`, `center` and `precision` are the
/// options of teach. The title of the page is `name`. With `plane` as true the page is
/// plane_lesson_page(), and of the options only `name`, `decimal` and `numbers` are taken.
/// @param time_limit  As in requests to the oracle.
/// @par Cost          make_lesson().
[[nodiscard]] std::string answer_lesson_request(std::string_view line,
                                                std::optional<double> time_limit = {});

}  // namespace convexact
