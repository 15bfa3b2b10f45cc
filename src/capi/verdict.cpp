// SPDX-License-Identifier: MIT
#include <variant>

#include "capi/arrays.hpp"
#include "capi/guarded.hpp"
#include "convexact/scene.hpp"
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
    reject_argument("the vertices of parts are missing");
  }
  std::vector<NamedPart> parts;
  for (std::size_t k = 0; k < count; ++k) {
    Mesh mesh{to_points(vertices, vertex_counts[k], "vertices"), {}, {}};
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
  if (parents == nullptr) reject_argument("the parents are missing");
  HullTree tree;
  tree.nodes.resize(hulls.size());
  for (std::size_t i = 0; i < hulls.size(); ++i) {
    if (parents[i] == CONVEXACT_NONE) continue;
    if (parents[i] >= hulls.size()) reject_argument("a parent is not the index of a node");
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

// What is asked of a solid, or of each part: no numbers beside the claims, unless they are wanted.
VerifyRequest asked_of_solid(const GivenFields& given) {
  VerifyRequest request;
  request.tightness = false;
  given.apply_to(request, verify_call_fields());
  if (request.exact_facets && !request.max_facets) {
    reject_argument("exact_facets with max_facets only");
  }
  return request;
}

// A question about parts is no other one than whether they enclose, so `asks` is no option.
PartsRequest asked_of_parts(const char* options) {
  GivenFields given;
  BoundFields fields = given.bound(verify_call_fields());
  std::erase_if(fields, [](const BoundField& field) { return field.info->name == "asks"; });
  for (BoundField& field : given.bound(parts_fields())) fields.push_back(std::move(field));
  read_options(options, fields);
  PartsRequest request = parts_request(asked_of_solid(given));
  given.apply_to(request, parts_fields());
  if (request.exact_volumes && request.measures == PartMeasures::None) {
    reject_argument("exact_volumes with tightness only");
  }
  return request;
}

convexact_verdict judge(const Mesh& input, const Candidate& candidate, const char* options) {
  GivenFields given;
  read_options(options, given.bound(verify_call_fields()));
  VerifyRequest request = asked_of_solid(given);
  if (!input.polygons.empty()) request.used = used_points(input.points.size(), input.polygons);
  VerifyOutcome outcome = verify(input.points, candidate, request);
  if (auto* verdict = std::get_if<Verdict>(&outcome)) {
    return {verdict->holds(), std::move(verdict->claims)};
  }
  throw Error(ErrorCode::NoInterior, describe(std::get<NotSolid>(outcome)));
}

convexact_verdict judge_parts(const Mesh& mesh, const CandidateParts& parts, const char* options) {
  PartsVerdict verdict = verify_parts(mesh, parts, asked_of_parts(options));
  return {verdict.holds(), std::move(verdict.claims)};
}

}  // namespace
}  // namespace convexact::capi

using namespace convexact::capi;

convexact_status convexact_judge_planes(const double* points, size_t point_count,
                                        const uint32_t* triangles, size_t triangle_count,
                                        const double* planes, size_t plane_count,
                                        const char* options, convexact_verdict** result) {
  return guarded(result, [&] {
    return judge(to_mesh(points, point_count, triangles, triangle_count),
                 to_list(planes, plane_count), options);
  });
}

convexact_status convexact_judge_mesh(const double* points, size_t point_count,
                                      const uint32_t* triangles, size_t triangle_count,
                                      const double* vertices, size_t vertex_count,
                                      const uint32_t* corners, const size_t* face_sizes,
                                      size_t face_count, const char* options,
                                      convexact_verdict** result) {
  return guarded(result, [&] {
    convexact::Mesh mesh;
    mesh.points = to_points(vertices, vertex_count, "vertices");
    mesh.polygons = to_faces(corners, face_sizes, face_count, vertex_count);
    return judge(to_mesh(points, point_count, triangles, triangle_count), mesh, options);
  });
}

convexact_status convexact_verify_parts(const double* points, size_t point_count,
                                        const uint32_t* triangles, size_t triangle_count,
                                        const double* vertices, const size_t* vertex_counts,
                                        size_t part_count, const uint32_t* corners,
                                        const size_t* face_sizes, const size_t* face_counts,
                                        const char* options, convexact_verdict** result) {
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
                                       const char* options, convexact_verdict** result) {
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
