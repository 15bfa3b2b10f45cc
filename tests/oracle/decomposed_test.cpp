// SPDX-License-Identifier: MIT
// The oracle, which shares nothing with the clustering, on what decompose() stores.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "assembled_meshes.hpp"
#include "convexact/decompose.hpp"
#include "convexact/io.hpp"
#include "convexact/verify_parts.hpp"
#include "shipped_meshes.hpp"
#include "sweep.hpp"

using namespace convexact;
using namespace support;
using enum ClaimCode;

namespace {

std::vector<NamedPart> parts_of(const Decomposition& d) {
  std::vector<NamedPart> parts;
  for (const Part& part : d.parts) parts.push_back({"part", part.mesh});
  return parts;
}

Decomposition decomposed(const Mesh& mesh, DecomposeRequest request) {
  request.measures = PartMeasures::None;
  return std::get<Decomposition>(decompose(mesh, request));
}

void check_accepted(const Mesh& mesh, const Decomposition& d, PartsRequest request) {
  request.claims = {PartsReadable, PartsFinite,   PartsSolid,  PartsConvex,
                    CoversPoints,  CoversSurface, PartsNeeded, MaxParts};
  if (request.max_facets) request.claims.push_back(MaxPartFacets);
  request.max_parts = d.parts.size();
  request.measures = PartMeasures::None;
  const PartsVerdict verdict = verify_parts(mesh, parts_of(d), request);
  for (const Claim& claim : verdict.claims) {
    const std::string sentence = claim.sentence;
    CAPTURE(sentence);
    CHECK((claim.status == Status::Holds || claim.status == Status::NotAsked));
  }
  CHECK(verdict.holds());
}

}  // namespace

TEST_CASE("verify_parts: accepts the parts of a scan, as hulls and with few faces" * sweep) {
  const auto paths = shipped_meshes();
  const auto teapot = std::find_if(paths.begin(), paths.end(), [](const std::string& path) {
    return path.find("teapot") != std::string::npos;
  });
  REQUIRE(teapot != paths.end());
  const Mesh mesh = read_mesh(*teapot);
  DecomposeRequest request;
  request.limit.value = Rational(1, 10);
  check_accepted(mesh, decomposed(mesh, request), {});
  request.faces = 12;
  PartsRequest asked;
  asked.max_facets = 12;
  check_accepted(mesh, decomposed(mesh, request), asked);
  request.precision = Precision::Binary32;
  check_accepted(mesh, decomposed(mesh, request), asked);
}

TEST_CASE("verify_parts: a corner of a part moved inward by units in the last place is missed") {
  const std::vector<Point> centers{{0, 0, 0}, {3, 0, 0}};
  const Mesh mesh = joined({ball(centers[0], 12), ball(centers[1], 12)});
  const Decomposition d = decomposed(mesh, {});
  REQUIRE(d.parts.size() == 2);
  check_accepted(mesh, d, {});
  PartsRequest request;
  request.claims = {CoversPoints, CoversSurface};
  request.measures = PartMeasures::None;
  for (std::size_t k = 0; k < d.parts.size(); ++k) {
    const auto corners = d.parts[k].mesh.points.doubles();
    for (std::size_t v = 0; v < corners.size(); ++v) {
      // As all corners are on a sphere, no point of the rest is beyond the one that moves.
      const Point center = centers[corners[v][0] > 1.5 ? 1 : 0];
      std::vector<Point> moved(corners.begin(), corners.end());
      for (int axis = 0; axis < 3; ++axis) {
        moved[v][axis] = std::nextafter(moved[v][axis], center[axis]);
      }
      auto parts = parts_of(d);
      parts[k].mesh = {PointSet(moved), {}, {}};
      const PartsVerdict verdict = verify_parts(mesh, parts, request);
      CHECK(verdict[CoversPoints].status == Status::Violated);
      CHECK(verdict[CoversSurface].status == Status::Violated);
    }
  }
}
