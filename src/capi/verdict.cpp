// SPDX-License-Identifier: MIT
#include <sstream>
#include <variant>

#include "capi/arrays.hpp"
#include "capi/guarded.hpp"
#include "convexact/verify.hpp"
#include "convexact/verify_parts.hpp"
#include "io/used_points.hpp"
#include "wire/judge_fields.hpp"

struct convexact_verdict {
  bool holds;
  std::vector<convexact::Claim> claims;
};

namespace convexact::capi {
namespace {

// The parts in arrays that hold all of them, one after another.
std::vector<NamedPart> to_parts(const double* vertices, const std::size_t* vertex_counts,
                                std::size_t count, const std::uint32_t* corners,
                                const std::size_t* face_sizes, const std::size_t* face_counts) {
  if (vertices == nullptr || vertex_counts == nullptr || count == 0) {
    throw Error(ErrorCode::InvalidArgument, "the vertices of parts are missing");
  }
  std::vector<NamedPart> parts;
  for (std::size_t k = 0; k < count; ++k) {
    Mesh mesh{to_points(vertices, vertex_counts[k]), {}, {}};
    vertices += 3 * vertex_counts[k];
    if (face_counts != nullptr && face_counts[k] > 0) {
      mesh.polygons = to_faces(corners, face_sizes, face_counts[k], vertex_counts[k]);
      for (const auto& polygon : mesh.polygons) corners += polygon.size();
      face_sizes += face_counts[k];
    }
    parts.push_back({"part_" + std::to_string(k), std::move(mesh)});
  }
  return parts;
}

// Nodes without children are the leaves; their parts are in the order of the leaves.
HullTree to_tree(std::vector<NamedPart> hulls, const std::size_t* parents) {
  if (parents == nullptr) throw Error(ErrorCode::InvalidArgument, "the parents are missing");
  HullTree tree;
  tree.nodes.resize(hulls.size());
  for (std::size_t i = 0; i < hulls.size(); ++i) {
    if (parents[i] == CONVEXACT_NONE) continue;
    if (parents[i] >= hulls.size()) {
      throw Error(ErrorCode::InvalidArgument, "a parent is not the index of a node");
    }
    tree.nodes[i].parent = parents[i];
    tree.nodes[parents[i]].children.push_back(i);
  }
  for (std::size_t i = 0; i < hulls.size(); ++i) {
    HullTreeNode& node = tree.nodes[i];
    if (!node.children.empty()) {
      node.mesh = std::move(hulls[i].mesh);
      continue;
    }
    node.part = tree.parts.size();
    tree.parts.push_back({"part_" + std::to_string(*node.part), std::move(hulls[i].mesh)});
  }
  return tree;
}

std::vector<ClaimCode> to_claims(const char* names) {
  std::vector<ClaimCode> claims;
  if (names == nullptr) return claims;
  std::istringstream list(names);
  for (std::string name; std::getline(list, name, ',');) {
    const std::optional<ClaimCode> code = claim_of_name(name);
    if (!code) throw Error(ErrorCode::InvalidArgument, "no such claim");
    claims.push_back(*code);
  }
  if (claims.empty()) throw Error(ErrorCode::InvalidArgument, "an empty list of claims");
  return claims;
}

MeshPoints to_mesh_points(const char* name) {
  if (name == nullptr) return MeshPoints::All;
  if (const auto points = value_in(kMeshPointsNames, name)) return *points;
  throw Error(ErrorCode::InvalidArgument, "no such points: all or used");
}

PartsRequest to_request(const convexact_parts_options& options) {
  PartsRequest request;
  request.points = to_mesh_points(options.points);
  request.claims = to_claims(options.claims);
  if (options.tolerance != nullptr) request.tolerance = parse_tolerance(options.tolerance);
  if (options.distance != nullptr) request.distance = read_distance("distance", options.distance);
  request.max_parts = to_limit(options.max_parts);
  request.max_facets = to_limit(options.max_facets);
  request.max_vertices = to_limit(options.max_vertices);
  request.max_facet_vertices = to_limit(options.max_facet_vertices);
  request.measures = PartMeasures::None;
  return request;
}

// Budgets are not asked, so there is no simplification to judge.
Asks to_asks(std::string_view name) {
  for (const Asks asks : {Asks::Enclosure, Asks::Hull, Asks::Inner}) {
    if (name == name_of(asks)) return asks;
  }
  throw Error(ErrorCode::InvalidArgument, "no such question");
}

VerifyRequest to_request(const convexact_judge_options& options, std::size_t point_count) {
  VerifyRequest request;
  if (options.asks != nullptr) request.asks = to_asks(options.asks);
  request.tightness = false;
  if (options.tolerance != nullptr) request.tolerance = parse_tolerance(options.tolerance);
  request.points = to_mesh_points(options.points);
  if (options.triangle_count > 0) {
    request.used = used_points(
        point_count, to_triangles(options.triangles, options.triangle_count, point_count));
  }
  return request;
}

convexact_verdict judge(const PointSet& points, const Candidate& candidate,
                        const convexact_judge_options* options) {
  VerifyOutcome outcome = verify(points, candidate, to_request(to_options(options), points.size()));
  if (auto* verdict = std::get_if<Verdict>(&outcome)) {
    return {verdict->holds(), std::move(verdict->claims)};
  }
  throw Error(ErrorCode::NoInterior, "the points lie in one plane");
}

convexact_verdict judge_parts(const Mesh& mesh, const CandidateParts& parts,
                              const convexact_parts_options* options) {
  PartsVerdict verdict = verify_parts(mesh, parts, to_request(to_options(options)));
  return {verdict.holds(), std::move(verdict.claims)};
}

}  // namespace
}  // namespace convexact::capi

using namespace convexact::capi;

convexact_status convexact_judge_planes(const double* points, size_t point_count,
                                        const double* planes, size_t plane_count,
                                        const convexact_judge_options* options,
                                        convexact_verdict** result) {
  return guarded(result, [&] {
    return judge(to_points(points, point_count), to_list(planes, plane_count), options);
  });
}

convexact_status convexact_judge_mesh(const double* points, size_t point_count,
                                      const double* vertices, size_t vertex_count,
                                      const uint32_t* corners, const size_t* face_sizes,
                                      size_t face_count, const convexact_judge_options* options,
                                      convexact_verdict** result) {
  return guarded(result, [&] {
    convexact::Mesh mesh;
    mesh.points = to_points(vertices, vertex_count);
    mesh.polygons = to_faces(corners, face_sizes, face_count, vertex_count);
    return judge(to_points(points, point_count), mesh, options);
  });
}

convexact_status convexact_verify_parts(const double* points, size_t point_count,
                                        const uint32_t* triangles, size_t triangle_count,
                                        const double* vertices, const size_t* vertex_counts,
                                        size_t part_count, const uint32_t* corners,
                                        const size_t* face_sizes, const size_t* face_counts,
                                        const convexact_parts_options* options,
                                        convexact_verdict** result) {
  return guarded(result, [&] {
    return judge_parts(
        to_mesh(points, point_count, triangles, triangle_count),
        to_parts(vertices, vertex_counts, part_count, corners, face_sizes, face_counts), options);
  });
}

convexact_status convexact_verify_tree(const double* points, size_t point_count,
                                       const uint32_t* triangles, size_t triangle_count,
                                       const double* vertices, const size_t* vertex_counts,
                                       const size_t* parents, size_t node_count,
                                       const convexact_parts_options* options,
                                       convexact_verdict** result) {
  return guarded(result, [&] {
    return judge_parts(
        to_mesh(points, point_count, triangles, triangle_count),
        to_tree(to_parts(vertices, vertex_counts, node_count, nullptr, nullptr, nullptr), parents),
        options);
  });
}

int convexact_verdict_holds(const convexact_verdict* result) { return result->holds; }
size_t convexact_verdict_claim_count(const convexact_verdict* result) {
  return result->claims.size();
}
const char* convexact_verdict_claim_name(const convexact_verdict* result, size_t i) {
  return convexact::name_of(result->claims[i].code);
}
const char* convexact_verdict_claim_status(const convexact_verdict* result, size_t i) {
  return convexact::name_of(result->claims[i].status);
}
const char* convexact_verdict_claim_sentence(const convexact_verdict* result, size_t i) {
  return result->claims[i].sentence.c_str();
}
void convexact_verdict_free(convexact_verdict* result) { delete result; }
