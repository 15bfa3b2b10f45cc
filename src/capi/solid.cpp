// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numeric>

#include "capi/arrays.hpp"
#include "capi/guarded.hpp"
#include "convexact/scene.hpp"
#include "convexact/simplify.hpp"
#include "wire/simplify_options.hpp"

struct convexact_solid {
  std::vector<std::array<double, 4>> planes;
  std::vector<std::string> texts;  // before rounding
  convexact::TieTally ties;
  std::size_t moves = 0;
};

namespace convexact::capi {
namespace {

convexact_solid simplify_points(PointSet points, const char* options) {
  GivenFields given;
  read_options(options, given.bound(simplify_call_fields()));
  SimplifyRequest request = simplify_request(given);
  request.store.planes = Precision::Binary64;
  const SimplifyOutcome outcome = simplify(std::move(points), request);
  const auto* result = std::get_if<SimplifyResult>(&outcome);
  if (result == nullptr) {
    throw Error(ErrorCode::NoInterior, describe(std::get<NotSolid>(outcome)));
  }
  const std::size_t moves = result->search ? result->search->moves.size() : 0;
  convexact_solid solid{result->solid.planes->planes, {}, result->ties, moves};
  for (const Halfspace& plane : result->solid.exact.planes) solid.texts.push_back(to_text(plane));
  return solid;
}

}  // namespace
}  // namespace convexact::capi

using namespace convexact::capi;

convexact_status convexact_simplify(const double* points, size_t point_count, const char* options,
                                    convexact_solid** result) {
  return guarded(result, [&] { return simplify_points(to_points(points, point_count), options); });
}

size_t convexact_solid_move_count(const convexact_solid* result) { return result->moves; }
size_t convexact_solid_tie_count(const convexact_solid* result) {
  return std::accumulate(result->ties.steps.begin(), result->ties.steps.end(), std::size_t{0});
}
size_t convexact_solid_undecided_count(const convexact_solid* result) {
  return result->ties.steps[static_cast<std::size_t>(convexact::TieProof::Undecided)];
}
long convexact_solid_undecided_bits(const convexact_solid* result) { return result->ties.bits; }
size_t convexact_solid_plane_count(const convexact_solid* result) { return result->planes.size(); }
void convexact_solid_plane(const convexact_solid* result, size_t i, double plane[4]) {
  std::copy_n(result->planes[i].begin(), 4, plane);
}
const char* convexact_solid_plane_text(const convexact_solid* result, size_t i) {
  return result->texts[i].c_str();
}
void convexact_solid_free(convexact_solid* result) { delete result; }
