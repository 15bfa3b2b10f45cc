// SPDX-License-Identifier: MIT
#include <algorithm>

#include "convexact/dual.hpp"
#include "convexact/error.hpp"

namespace convexact {
namespace {

// Where column j stands, or would stand, in a row sorted by column.
template <class Row>
auto find_column(Row& row, HalfspaceId j) {
  return std::lower_bound(row.begin(), row.end(), j, [](const auto& entry, HalfspaceId column) {
    return entry.first < column;
  });
}

}  // namespace

void AdjacencyMatrix::add(const DualTriangle& triangle) {
  for (int e = 0; e < 3; ++e) {
    const HalfspaceId i = triangle[e], j = triangle[(e + 1) % 3], k = triangle[(e + 2) % 3];
    auto& row = rows_[i.index()];
    const auto place = find_column(row, j);
    CONVEXACT_ASSERT(place == row.end() || place->first != j);
    row.insert(place, {j, k});
  }
}

void AdjacencyMatrix::remove(const DualTriangle& triangle) {
  for (int e = 0; e < 3; ++e) {
    const HalfspaceId i = triangle[e], j = triangle[(e + 1) % 3];
    auto& row = rows_[i.index()];
    const auto place = find_column(row, j);
    CONVEXACT_ASSERT(place != row.end() && *place == Entry(j, triangle[(e + 2) % 3]));
    row.erase(place);
  }
}

std::optional<HalfspaceId> AdjacencyMatrix::at(HalfspaceId i, HalfspaceId j) const {
  const auto& row = rows_[i.index()];
  const auto place = find_column(row, j);
  if (place == row.end() || place->first != j) return std::nullopt;
  return place->second;
}

std::vector<HalfspaceId> AdjacencyMatrix::one_ring(HalfspaceId i) const {
  // Entry (i, j) = k: the triangle (i, j, k) turns from j to k, so k is the neighbour after j.
  std::vector<HalfspaceId> ring;
  const auto& row = rows_[i.index()];
  if (row.empty()) return ring;
  const HalfspaceId first = row.front().first;
  HalfspaceId j = first;
  do {
    ring.push_back(j);
    const std::optional<HalfspaceId> k = at(i, j);
    if (!k) break;  // an open fan
    j = *k;
  } while (j != first && ring.size() < row.size());
  return ring;
}

std::vector<DualTriangle> AdjacencyMatrix::triangles() const {
  std::vector<DualTriangle> all;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    for (const auto& [j, k] : rows_[i]) {
      if (HalfspaceId(i) < j && HalfspaceId(i) < k) all.push_back({HalfspaceId(i), j, k});
    }
  }
  return all;
}

bool AdjacencyMatrix::is_closed_manifold() const {
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    const HalfspaceId i(row);
    for (const auto& [j, k] : rows_[row]) {
      if (!at(j, i) || at(j, k) != i || at(k, i) != j) return false;
    }
    if (rows_[row].empty()) continue;
    const std::vector<HalfspaceId> ring = one_ring(i);
    if (ring.size() != rows_[row].size() || at(i, ring.back()) != ring.front()) return false;
  }
  return true;
}

}  // namespace convexact
