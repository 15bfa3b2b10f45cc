// SPDX-License-Identifier: MIT
// benches.hpp - the groups of benchmarks that convexact-bench runs.
#pragma once
#include <string>
#include <vector>

#include "bench_inputs.hpp"

/// INPUT/hull, /check (its certificate), and the peers' /cgal and /qhull where they are installed.
void register_hull_bench(const std::vector<BenchInput>& inputs);
/// INPUT/filtered, /float, /exact: from points to 18 proven planes, by the pipeline.
void register_pipeline_bench(const std::vector<BenchInput>& inputs);
/// INPUT/by-volume, /by-area, /by-mean-width, and these with -exact: the loops of the filtered and
/// of the exact engine alone, to 18 halfspaces. Counters: evaluations for each removal, exact
/// costs.
void register_loops_by_cost(const std::vector<BenchInput>& inputs);
/// INPUT/query-overlap/K, /query-ray/K, /query-line/K: one query against K halfspaces, 6 to 32, or
/// the hull: two solids, a ray with entry and exit as fractions, whether a line hits. The counter
/// "query" is the processor time of one.
void register_query_bench(const std::vector<BenchInput>& inputs);
/// INPUT/inner, /inner-costs, /outer: an inner run on a hull, without and with the exact costs of
/// its steps, and the run by volume on the same hull; down to the end, each step proven again.
void register_inner_bench(const std::vector<BenchInput>& inputs);
/// INPUT/obb, /cgal-obb (the peer): the oriented box of a hull by `compare`. The counter "volume"
/// is that of the box, in the same unit for both.
void register_box_bench(const std::vector<BenchInput>& inputs);
/// exact_growth/HALFSPACES: the exact engine alone.
void register_exact_growth();
/// scene/shared and scene/own: the meshes' points as parts, once with one budget of 18 halfspaces
/// for each on average, and once each on its own to the same ends. Without verification.
void register_scene_bench(const std::vector<BenchInput>& inputs);
/// overlay/MESH/union, /nef-union (the peer), /surface, /surface-half, /solid-half: some twenty
/// parts by a grid; the volume of their union, and what all of them or the first half leave of the
/// surface and of the solid. overlay/union-growth/PARTS: overlapping random solids.
void register_overlay_bench(const std::vector<std::string>& meshes);
/// clusters-of-MESH/filtered, /float, /hacd (the peer, of at most 20,000), /owners: the triangles
/// in clusters of 3%, and the test that the parts hold them; clusters-of-MESH-300/exact, /filtered:
/// the first 300 triangles. cluster-growth/TRIANGLES: one shape, more and more finely.
void register_cluster_bench(const std::vector<std::string>& meshes);
/// clusters-of-MESH/acd, /acd-paths: the triangles split at notches until 3%, and of that run the
/// searches for shortest paths alone.
void register_split_bench(const std::vector<std::string>& meshes);
/// growth/WHAT/SIZE, each with a size and with four times it: volumes of solids of many boxes,
/// clusters of a cylinder, a polygon of many corners, the distance of nested parts to their solid.
void register_growth_bench();
