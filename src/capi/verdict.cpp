// SPDX-License-Identifier: MIT
#include <variant>

#include "capi/arrays.hpp"
#include "capi/guarded.hpp"
#include "convexact/verify.hpp"

struct convexact_verdict {
  convexact::Verdict verdict;
};

namespace convexact::capi {
namespace {

// Faces one after another: face f has sizes[f] corners.
std::vector<std::vector<std::uint32_t>> to_faces(const std::uint32_t* corners,
                                                 const std::size_t* sizes, std::size_t count,
                                                 std::size_t vertices) {
  if (count > 0 && (corners == nullptr || sizes == nullptr)) {
    throw Error(ErrorCode::InvalidArgument, "the corners or sizes of faces are missing");
  }
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::size_t f = 0; f < count; ++f) {
    if (sizes[f] < 3) throw Error(ErrorCode::InvalidArgument, "a face has fewer than 3 corners");
    for (const std::uint32_t corner : faces.emplace_back(corners, corners + sizes[f])) {
      if (corner >= vertices) {
        throw Error(ErrorCode::InvalidArgument, "a corner is not the index of a vertex");
      }
    }
    corners += sizes[f];
  }
  return faces;
}

convexact_verdict judge(const PointSet& points, const Candidate& candidate, const char* tolerance) {
  VerifyRequest request;
  request.tightness = false;
  if (tolerance != nullptr) request.tolerance = parse_tolerance(tolerance);
  VerifyOutcome outcome = verify(points, candidate, request);
  if (auto* verdict = std::get_if<Verdict>(&outcome)) return {std::move(*verdict)};
  throw Error(ErrorCode::NoInterior, "the points lie in one plane");
}

}  // namespace
}  // namespace convexact::capi

using namespace convexact::capi;

convexact_status convexact_judge_planes(const double* points, size_t point_count,
                                        const double* planes, size_t plane_count,
                                        const char* tolerance, convexact_verdict** result) {
  return guarded(result, [&] {
    return judge(to_points(points, point_count), to_list(planes, plane_count), tolerance);
  });
}

convexact_status convexact_judge_mesh(const double* points, size_t point_count,
                                      const double* vertices, size_t vertex_count,
                                      const uint32_t* corners, const size_t* face_sizes,
                                      size_t face_count, const char* tolerance,
                                      convexact_verdict** result) {
  return guarded(result, [&] {
    convexact::Mesh mesh;
    mesh.points = to_points(vertices, vertex_count);
    mesh.polygons = to_faces(corners, face_sizes, face_count, vertex_count);
    return judge(to_points(points, point_count), mesh, tolerance);
  });
}

int convexact_verdict_holds(const convexact_verdict* result) { return result->verdict.holds(); }
size_t convexact_verdict_claim_count(const convexact_verdict* result) {
  return result->verdict.claims.size();
}
const char* convexact_verdict_claim_name(const convexact_verdict* result, size_t i) {
  return convexact::name_of(result->verdict.claims[i].code);
}
const char* convexact_verdict_claim_status(const convexact_verdict* result, size_t i) {
  return convexact::name_of(result->verdict.claims[i].status);
}
const char* convexact_verdict_claim_sentence(const convexact_verdict* result, size_t i) {
  return result->verdict.claims[i].sentence.c_str();
}
void convexact_verdict_free(convexact_verdict* result) { delete result; }
