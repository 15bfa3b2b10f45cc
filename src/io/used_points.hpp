// SPDX-License-Identifier: MIT
// used_points.hpp - the names of MeshPoints in requests and on the command line.
#pragma once
#include "convexact/io.hpp"
#include "io/names.hpp"

namespace convexact {

inline constexpr auto kMeshPointsNames =
    name_table<MeshPoints>({{MeshPoints::All, "all"}, {MeshPoints::Used, "used"}});

}  // namespace convexact
