// SPDX-License-Identifier: MIT
// decomposition.hpp - a decomposition in the form that the C interface keeps.
#pragma once
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "capi/arrays.hpp"
#include "convexact/decompose.hpp"

namespace convexact::capi {

struct PartArrays {
  MeshArrays mesh;
  std::vector<std::string> planes;
  double concavity = 0;
  std::string squared_concavity;
};

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

struct VolumeNumbers {
  std::array<double, 2> bounds = {kUnknown, kUnknown};
  std::string exact;
};

}  // namespace convexact::capi

struct convexact_decomposition {
  convexact::Decomposition made;
  convexact::Precision precision;
  std::vector<convexact::capi::PartArrays> parts;
  std::vector<std::uint32_t> owners;  // by the caller's triangles
  std::array<convexact::capi::VolumeNumbers, 5> volumes;
};
