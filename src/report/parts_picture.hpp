// SPDX-License-Identifier: MIT
// parts_picture.hpp - a decomposition to look at.
#pragma once
#include <string>

#include "convexact/verify_parts.hpp"
#include "report/picture.hpp"

namespace convexact {

/// The parts in colours, in red what of the input's surface none of them covers, and the input
/// itself, which is hidden at first.
[[nodiscard]] Picture parts_picture(const Mesh& input, const PartsVerdict& verdict,
                                    const std::string& title);

}  // namespace convexact
