// SPDX-License-Identifier: MIT
// whole_dual.hpp - the checks of level full: the entire dual, every hull vertex, the volume.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "simplify/modular_volume.hpp"
#include "simplify/plain_surface.hpp"
#include "simplify/plain_vertex.hpp"

namespace convexact {

class WholeDual {
 public:
  /// @param surface  The dual before the first step. The spans must outlive this object.
  WholeDual(std::span<const Halfspace> halfspaces, std::span<const PlainVertex> vertices,
            const PlainSurface& surface, std::uint64_t seed);

  /// The hull certificate: a closed surface of all survivors, the origin strictly below every
  /// triangle, every edge convex, and a ray from the origin that meets exactly one triangle.
  /// @par Source  [Mehlhorn1999]
  [[nodiscard]] bool is_certified(const PlainSurface& surface,
                                  const std::vector<bool>& present) const;
  [[nodiscard]] bool holds_vertices(const std::vector<bool>& present) const;
  /// Call once per step, in order.
  [[nodiscard]] bool volume_grew_by(const Rational& cost, const PlainSurface& surface);
  [[nodiscard]] bool volume_is_sum_of_costs(const PlainSurface& surface) const;

 private:
  bool has_all(const PlainSurface& surface, const std::vector<bool>& present) const;
  bool is_locally_convex(const PlainSurface& surface) const;
  bool is_met_once_by_a_ray(const PlainSurface& surface) const;
  Rational six_volume(const PlainSurface& surface) const;
  PlainVertex vertex_of(const DualTriangle& t) const;

  std::span<const Halfspace> halfspaces_;
  std::span<const PlainVertex> vertices_;
  std::array<ModularVolume, 2> modular_;
  std::array<std::uint64_t, 2> residues_;  // of six times the volume so far
  Rational first_six_volume_;
  std::vector<Rational> costs_;
};

}  // namespace convexact
