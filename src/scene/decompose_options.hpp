// SPDX-License-Identifier: MIT
// decompose_options.hpp - numbers of a decomposition as users spell them: on the command line, in
// requests and in the C interface.
#pragma once
#include <string>

#include "convexact/cluster.hpp"
#include "convexact/number.hpp"

namespace convexact {

/// "3%" and "0.03d" are shares of the diameter, "0.05" is a length; all exact.
/// @param option  Its name, for the message.
/// @throws Error InvalidArgument for anything else, for a share that is not from 0 to 1, and for a
///               negative length.
[[nodiscard]] ConcavityLimit parse_concavity(const std::string& option, const std::string& text);

/// The cosine of an angle, above 0 and at most 1: "0.99", exact.
/// @throws Error InvalidArgument for anything else.
[[nodiscard]] Rational parse_cosine(const std::string& option, const std::string& text);

}  // namespace convexact
