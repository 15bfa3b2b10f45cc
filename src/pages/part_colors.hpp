// SPDX-License-Identifier: MIT
// part_colors.hpp - colours for convex parts: two that touch never share one.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "convexact/geometry.hpp"

namespace convexact {

/// Any two of these, and of them and kOutsideColor, are 20 apart in CIELAB for readers of full
/// colour vision and, simulated [Machado2009], without long, middle or short cones.
inline constexpr std::array kPartColors = {"#287cf4", "#dca01c", "#70f4a0", "#944034",
                                           "#c4b8e8", "#7c4c70", "#b8e870", "#dc7070",
                                           "#584cac", "#f4c4d0", "#947cc4", "#b888a0"};
/// Of what lies where nothing should.
inline constexpr const char* kOutsideColor = "#d51a00";

/// By part, its number of a colour: parts with a common point differ, and the numbers below
/// kPartColors.size() are used about equally often. Flat parts count as their boxes do.
/// @param parts  The points whose hulls the parts are; at least one of each.
/// @par Cost     A comparison of boxes for each pair; where they meet, a linear program.
[[nodiscard]] std::vector<std::size_t> colors_by_contact(std::span<const PointSet* const> parts);

/// "#rrggbb"; beyond the palette, darker shades of it.
[[nodiscard]] std::string part_color(std::size_t number);

}  // namespace convexact
