// SPDX-License-Identifier: MIT
// plain_surface.hpp - the dual surface that only the verifier uses: a table of directed edges.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "convexact/geometry.hpp"

namespace convexact {

/// third(a, b) = c for each triangle (a, b, c) and its rotations. Nothing is assumed about the
/// triangles; a directed edge that occurs twice is reported by add().
class PlainSurface {
 public:
  PlainSurface(std::size_t size, std::span<const DualTriangle> triangles);

  /// False, and nothing changes, if one of the directed edges is taken.
  [[nodiscard]] bool add(const DualTriangle& triangle);
  void remove(const DualTriangle& triangle);
  std::optional<HalfspaceId> third(HalfspaceId from, HalfspaceId to) const;
  /// The neighbours of i in order as far as they can be followed; empty if i has none.
  std::vector<HalfspaceId> ring(HalfspaceId i) const;
  /// Each triangle once.
  std::vector<DualTriangle> triangles() const;
  std::size_t size() const { return neighbour_.size(); }
  std::size_t directed_edges() const { return third_.size(); }

 private:
  std::unordered_map<std::uint64_t, HalfspaceId> third_;
  std::vector<HalfspaceId> neighbour_;  // where to start looking for a ring
};

}  // namespace convexact
