// SPDX-License-Identifier: MIT
#include "capi/decomposition.hpp"

#include <algorithm>
#include <variant>

#include "capi/guarded.hpp"
#include "convexact/overlay.hpp"
#include "convexact/scene.hpp"
#include "convexact/stored.hpp"
#include "number/precision.hpp"
#include "wire/decompose_options.hpp"

namespace convexact::capi {
namespace {

DecomposeRequest to_request(const char* options) {
  DecomposeRequest request = default_decompose_request();
  read_options(options, bound_fields(decompose_call_fields(), request));
  if (request.exact_volumes && request.measures == PartMeasures::None) {
    reject_argument("exact_volumes or no_measures, not both");
  }
  return request;
}

PartArrays arrays_of(const Part& part) {
  PartArrays arrays{MeshArrays(part.mesh), {}, 0, ""};
  for (const Halfspace& h : part.halfspaces) arrays.planes.push_back(to_text(h));
  const Rational& squared = part.concavity.squared;
  arrays.squared_concavity = to_string(squared);
  arrays.concavity = to_double(sqrt(Enclosure(squared, kMeasureBits)).high(), Rounding::Up);
  return arrays;
}

// The owners of the triangles as the caller numbers them; each of these is a triangle of the
// surface.
std::vector<std::uint32_t> owners_of(const Decomposition& made, std::size_t triangles) {
  std::vector<std::uint32_t> owners(triangles);
  std::size_t found = 0;
  for (std::size_t t = 0; t < made.owner.size(); ++t) {
    if (made.surface.face[t] >= triangles) continue;  // a cap over a border, none of the caller's
    owners[made.surface.face[t]] = made.owner[t];
    ++found;
  }
  if (found != triangles) {
    throw Error(ErrorCode::Internal, "a triangle became several, or none");
  }
  return owners;
}

VolumeNumbers numbers_of(const Measured& x) {
  if (!x.exact) return {{x.bounds.low_double(), x.bounds.high_double()}, ""};
  return {{to_double(*x.exact, Rounding::Down), to_double(*x.exact, Rounding::Up)},
          to_string(*x.exact)};
}

// In the order of convexact_volume.
std::array<VolumeNumbers, 5> volumes_of(const DecompositionMeasures& measures) {
  const auto if_any = [](const std::optional<Measured>& x) {
    return x ? numbers_of(*x) : VolumeNumbers();
  };
  return {if_any(measures.solid_volume), if_any(measures.union_volume),
          if_any(measures.uncovered_volume), if_any(measures.excess_volume),
          if_any(measures.overlap_volume)};
}

convexact_decomposition decompose_mesh(const Mesh& mesh, const DecomposeRequest& request) {
  DecomposeOutcome outcome = decompose(mesh, request);
  auto* made = std::get_if<Decomposition>(&outcome);
  if (made == nullptr) {
    throw Error(ErrorCode::NoInterior, describe(std::get<NotSolid>(outcome)));
  }
  convexact_decomposition result{std::move(*made), request.precision, {}, {}, {}};
  for (const Part& part : result.made.parts) result.parts.push_back(arrays_of(part));
  result.owners = owners_of(result.made, mesh.polygons.size());
  if (result.made.measures) result.volumes = volumes_of(*result.made.measures);
  return result;
}

const VolumeNumbers& numbers_at(const convexact_decomposition& result, int volume) {
  static const VolumeNumbers none;
  const bool is_known = volume >= 0 && static_cast<std::size_t>(volume) < result.volumes.size();
  return is_known ? result.volumes[static_cast<std::size_t>(volume)] : none;
}

void write_planes(const Part& part, Precision precision, double* planes) {
  if (planes == nullptr) reject_argument("the array of planes is missing");
  const PointSet& corners = part.mesh.points;
  const ConvexPart stored = convex_part(corners);
  if (!stored.solid) throw Error(ErrorCode::NoInterior, "the part is flat");
  std::vector<PointId> all;
  for (std::size_t i = 0; i < corners.size(); ++i) all.emplace_back(i);
  for (const auto& plane : store_planes(*stored.solid, corners, all, precision).planes) {
    planes = std::copy(plane.begin(), plane.end(), planes);
  }
}

}  // namespace
}  // namespace convexact::capi

using namespace convexact::capi;

convexact_status convexact_decompose(const double* points, size_t point_count,
                                     const uint32_t* triangles, size_t triangle_count,
                                     const char* options, convexact_decomposition** result) {
  return guarded(result, [&] {
    if (triangle_count == 0) convexact::reject_argument("there is no triangle");
    return decompose_mesh(to_mesh(points, point_count, triangles, triangle_count),
                          to_request(options));
  });
}

size_t convexact_decomposition_part_count(const convexact_decomposition* result) {
  return result->parts.size();
}
int convexact_decomposition_eps_holds(const convexact_decomposition* result) {
  return result->made.limit_holds;
}
int convexact_decomposition_reach_holds(const convexact_decomposition* result) {
  return result->made.reach && result->made.reach->farther.empty();
}
const uint32_t* convexact_decomposition_owners(const convexact_decomposition* result) {
  return result->owners.data();
}
void convexact_decomposition_volume(const convexact_decomposition* result, int volume,
                                    double bounds[2]) {
  const auto& numbers = numbers_at(*result, volume).bounds;
  std::copy(numbers.begin(), numbers.end(), bounds);
}
const char* convexact_decomposition_exact_volume(const convexact_decomposition* result,
                                                 int volume) {
  return numbers_at(*result, volume).exact.c_str();
}
size_t convexact_decomposition_vertex_count(const convexact_decomposition* result, size_t k) {
  return result->parts[k].mesh.vertices.size() / 3;
}
const double* convexact_decomposition_vertices(const convexact_decomposition* result, size_t k) {
  return result->parts[k].mesh.vertices.data();
}
size_t convexact_decomposition_face_count(const convexact_decomposition* result, size_t k) {
  return result->parts[k].mesh.face_sizes.size();
}
const size_t* convexact_decomposition_face_sizes(const convexact_decomposition* result, size_t k) {
  return result->parts[k].mesh.face_sizes.data();
}
const uint32_t* convexact_decomposition_corners(const convexact_decomposition* result, size_t k) {
  return result->parts[k].mesh.corners.data();
}
size_t convexact_decomposition_plane_count(const convexact_decomposition* result, size_t k) {
  return result->parts[k].planes.size();
}
const char* convexact_decomposition_plane_text(const convexact_decomposition* result, size_t k,
                                               size_t i) {
  return result->parts[k].planes[i].c_str();
}
convexact_status convexact_decomposition_planes(const convexact_decomposition* result, size_t k,
                                                double* planes) {
  return status_of_call([&] { write_planes(result->made.parts[k], result->precision, planes); });
}
int convexact_decomposition_form(const convexact_decomposition* result, size_t k) {
  switch (result->made.parts[k].form) {
    case convexact::PartForm::Hull:
      return CONVEXACT_FORM_HULL;
    case convexact::PartForm::Rounded:
      return CONVEXACT_FORM_ROUNDED;
    case convexact::PartForm::Simplified:
      return CONVEXACT_FORM_SIMPLIFIED;
    case convexact::PartForm::Thickened:
      return CONVEXACT_FORM_THICKENED;
    case convexact::PartForm::Flat:
      break;
  }
  return CONVEXACT_FORM_FLAT;
}
double convexact_decomposition_concavity(const convexact_decomposition* result, size_t k) {
  return result->parts[k].concavity;
}
const char* convexact_decomposition_squared_concavity(const convexact_decomposition* result,
                                                      size_t k) {
  return result->parts[k].squared_concavity.c_str();
}
int convexact_decomposition_within_limit(const convexact_decomposition* result, size_t k) {
  return result->made.parts[k].is_within_limit;
}
void convexact_decomposition_free(convexact_decomposition* result) { delete result; }
