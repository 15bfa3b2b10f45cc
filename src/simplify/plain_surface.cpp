// SPDX-License-Identifier: MIT
#include "simplify/plain_surface.hpp"

#include "convexact/error.hpp"

namespace convexact {
namespace {

std::uint64_t key(HalfspaceId from, HalfspaceId to) {
  return std::uint64_t{from.value} << 32 | to.value;
}

}  // namespace

PlainSurface::PlainSurface(std::size_t size, std::span<const DualTriangle> triangles)
    : neighbour_(size) {
  for (const DualTriangle& triangle : triangles) {
    if (!add(triangle)) {
      throw Error(ErrorCode::Internal, "two triangles of the dual hull share a directed edge");
    }
  }
}

bool PlainSurface::add(const DualTriangle& triangle) {
  const auto& [a, b, c] = triangle;
  if (third(a, b) || third(b, c) || third(c, a)) return false;
  third_[key(a, b)] = c;
  third_[key(b, c)] = a;
  third_[key(c, a)] = b;
  neighbour_[a.index()] = b;
  neighbour_[b.index()] = c;
  neighbour_[c.index()] = a;
  return true;
}

void PlainSurface::remove(const DualTriangle& triangle) {
  const auto& [a, b, c] = triangle;
  third_.erase(key(a, b));
  third_.erase(key(b, c));
  third_.erase(key(c, a));
}

std::optional<HalfspaceId> PlainSurface::third(HalfspaceId from, HalfspaceId to) const {
  const auto place = third_.find(key(from, to));
  if (place == third_.end()) return std::nullopt;
  return place->second;
}

std::vector<HalfspaceId> PlainSurface::ring(HalfspaceId i) const {
  std::vector<HalfspaceId> ring;
  const HalfspaceId first = neighbour_[i.index()];
  std::optional<HalfspaceId> next = third(i, first);
  if (!next) return ring;
  ring.push_back(first);
  for (; next && *next != first && ring.size() < size(); next = third(i, *next)) {
    ring.push_back(*next);
  }
  return ring;
}

std::vector<DualTriangle> PlainSurface::triangles() const {
  std::vector<DualTriangle> triangles;
  for (const auto& [edge, c] : third_) {
    const HalfspaceId a(static_cast<std::uint32_t>(edge >> 32)),
        b(static_cast<std::uint32_t>(edge));
    if (a < b && a < c) triangles.push_back({a, b, c});
  }
  return triangles;
}

}  // namespace convexact
