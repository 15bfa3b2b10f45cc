// SPDX-License-Identifier: MIT
// model_body.hpp - what a model for a simulator says of a body beside its shapes: how it stands,
// its size, its mass, and the mesh to be seen.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>

#include "convexact/measure.hpp"

namespace convexact {

enum class UpAxis { Y, Z };

/// In kilograms and meters, about the axes of the file.
struct BodyMass {
  double mass;
  Point center;
  std::array<double, 6> inertia;  ///< About the center: xx, yy, zz, xy, xz, yz.
};

/// Attributes of the model: no number of a shape changes.
struct ModelBody {
  std::string name;
  UpAxis up = UpAxis::Z;  ///< Which axis of the file points upward.
  double scale = 1;       ///< Meters for each unit of the file.
  std::optional<BodyMass> mass = {};
  std::string visual = {};  ///< The path of the mesh, relative to the model; empty: none to show.
};

/// The nearest doubles; but diagonal entries of the tensor grow by up to a few units in the last
/// place, if that is needed for the doubles to be a positive tensor whose principal moments fulfil
/// a
/// + b >= c, which simulators ask for.
/// @param density  In kilograms for each cubic meter. @param scale  Meters for each unit of length.
/// @return Nothing if a number is beyond the doubles or rounds to a mass of 0.
[[nodiscard]] std::optional<BodyMass> body_mass(const MassProperties& mass, const Rational& density,
                                                const Rational& scale);

/// Whether a tensor is one that a body may have: the matrix of its second moments, half the trace
/// less the tensor, has no negative eigenvalue, and the tensor is positive. Exactly.
[[nodiscard]] bool is_tensor_of_body(const std::array<double, 6>& inertia);

}  // namespace convexact
