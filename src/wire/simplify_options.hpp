// SPDX-License-Identifier: MIT
// simplify_options.hpp - the options of runs that leave few halfspaces, or few vertices, as users
// spell them: on the command line, in Python and in C.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "convexact/simplify.hpp"
#include "io/names.hpp"
#include "wire/field.hpp"

namespace convexact {

inline constexpr auto kSearchKindNames = name_table<SearchKind>({{SearchKind::None, "none"},
                                                                 {SearchKind::Walk, "walk"},
                                                                 {SearchKind::Local, "local"},
                                                                 {SearchKind::Optimal, "optimal"}});

/// What `hull` measures.
inline constexpr auto kHullMeasureNames =
    name_table<bool HullRequest::*>({{&HullRequest::volume, "volume"},
                                     {&HullRequest::area, "area"},
                                     {&HullRequest::mean_width, "mean-width"},
                                     {&HullRequest::inertia, "inertia"}});

/// The precision up to which mean widths are compared, in bits.
inline constexpr CountRange kTieBits{128, 1 << 20};

[[nodiscard]] const Fields<SimplifyRequest>& simplify_fields();

/// The same, and the seed, which is an option of all commands: for Python and the C interface.
[[nodiscard]] const Fields<SimplifyRequest>& simplify_call_fields();

/// `faces` are triangles here: as many vertices as have no more.
[[nodiscard]] const Fields<InnerRequest>& inner_fields();

/// The names of those that simplify_fields() has not.
[[nodiscard]] const std::vector<std::string_view>& fields_of_inner_runs();

/// The request with these options. @throws Error InvalidArgument for one that refines another
/// option that was not given.
[[nodiscard]] SimplifyRequest simplify_request(const GivenFields& given);

/// The same of a run that removes vertices. @throws Error InvalidArgument for an option of
/// simplify_fields() alone, unless it has its default.
[[nodiscard]] InnerRequest inner_request(const GivenFields& given);

/// A share, 0 or more: "5%", "0.05" or "1/20". @throws Error InvalidArgument.
[[nodiscard]] Rational parse_share(const std::string& option, const std::string& text);

/// The center of the polar dual, as "X,Y,Z"; nothing for "chebyshev".
/// @throws Error InvalidArgument.
[[nodiscard]] std::optional<RationalPoint> parse_center(const std::string& option,
                                                        const std::string& text);

}  // namespace convexact
