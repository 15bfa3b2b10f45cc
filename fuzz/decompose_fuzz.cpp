// SPDX-License-Identifier: MIT
// Property of decompose: for any few triangles on a grid the exact and the filtered engine make the
// same merges; clusters are a partition, connected and within the limit; no two neighbours can
// merge; and the judge of decompositions, which does not use the owners, finds every triangle
// covered.
#include <set>

#include "convexact/decompose.hpp"
#include "convexact/verify_parts.hpp"
#include "few_triangles.hpp"
#include "fuzz_check.hpp"
#include "fuzz_target.hpp"

using namespace convexact;

namespace {

DecomposeRequest request_of(FuzzInput& in) {
  constexpr std::array kLimits{0, 1, 3, 10, 30, 100};
  DecomposeRequest request;
  request.limit.value = Rational(kLimits[in.below(kLimits.size())], 100);
  request.measure = in.below(2) == 0 ? ConcavityMeasure::Surface : ConcavityMeasure::Vertices;
  request.connect = std::array{Connect::Edge, Connect::Overlap, Connect::Touching}[in.below(3)];
  request.flat = std::array{FlatParts::Thicken, FlatParts::Keep, FlatParts::Merge}[in.below(3)];
  request.keep_inner = in.below(2) == 0;
  if (in.below(3) == 0) request.faces = 4 + in.below(6);
  if (in.below(3) == 0) request.precision = Precision::Binary32;
  return request;
}

void check_clustering(const Surface& surface, const DecomposeRequest& request) {
  ClusterOptions options;
  options.limit = request.limit;
  options.measure = request.measure;
  options.connect = request.connect;
  const Clustering filtered = cluster(surface, options);
  options.engine = Engine::Exact;
  const Clustering exact = cluster(surface, options);
  FUZZ_CHECK(filtered.merges == exact.merges);
  FUZZ_CHECK(filtered.clusters == exact.clusters);
  FUZZ_CHECK(filtered.united == exact.united);
  std::vector<std::size_t> of(surface.triangles.size(), SIZE_MAX);
  for (std::size_t k = 0; k < exact.clusters.size(); ++k) {
    for (const TriangleId t : exact.clusters[k]) {
      FUZZ_CHECK(of[t.index()] == SIZE_MAX);
      of[t.index()] = k;
    }
  }
  const ExactConcavity concavity(surface, request.measure);
  std::vector<std::pair<TriangleId, TriangleId>> inside;
  std::set<std::pair<std::size_t, std::size_t>> beside;
  for (const auto& [a, b] : neighbours(surface, request.connect)) {
    FUZZ_CHECK(of[a.index()] != SIZE_MAX && of[b.index()] != SIZE_MAX);
    if (of[a.index()] == of[b.index()]) {
      inside.emplace_back(a, b);
    } else {
      beside.insert(std::minmax(of[a.index()], of[b.index()]));
    }
  }
  FUZZ_CHECK(count_groups(surface, inside) == exact.clusters.size());
  for (const auto& [x, y] : beside) {
    std::vector<TriangleId> both = exact.clusters[x];
    both.insert(both.end(), exact.clusters[y].begin(), exact.clusters[y].end());
    std::sort(both.begin(), both.end());
    const ConvexPart hull = convex_part(subset(surface.points, points_of(surface, both)));
    FUZZ_CHECK(concavity(both, hull).squared > exact.squared_limit);
  }
}

void decompose_few(FuzzInput& in) {
  const Mesh mesh = few_triangles(in);
  if (mesh.polygons.empty()) return;
  const DecomposeRequest request = request_of(in);
  const DecomposeOutcome outcome = decompose(mesh, request);
  const auto* made = std::get_if<Decomposition>(&outcome);
  if (made == nullptr) return;  // the whole mesh is flat
  check_clustering(made->surface, request);
  std::vector<NamedPart> parts;
  for (const Part& part : made->parts) parts.push_back({"part", part.mesh});
  PartsRequest asked;
  asked.claims = {ClaimCode::CoversPoints, ClaimCode::CoversSurface};
  asked.measures = PartMeasures::None;
  FUZZ_CHECK(verify_parts(mesh, parts, asked).holds());
}

const FuzzTarget kDecompose("decompose", decompose_few);

}  // namespace
