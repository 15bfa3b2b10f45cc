// SPDX-License-Identifier: MIT
// decompose --method cut on stiff inputs: walls down to 1e-12 of the diameter, needles, offsets far
// beyond the size, scales near the ends of the doubles, crossing shells, keyholes. What is promised
// is the same for all, and the oracle judges it.
#include <doctest/doctest.h>

#include <cmath>

#include "cells.hpp"
#include "convexact/decompose.hpp"
#include "convexact/verify_parts.hpp"
#include "sweep.hpp"

using namespace convexact;
using namespace support;

namespace {

struct Builder {
  std::vector<Point> points;
  Mesh mesh;

  void add(const std::vector<Point>& corners, bool is_turned = false) {
    const auto first = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), corners.begin(), corners.end());
    for (std::vector<std::uint32_t> face : box_faces()) {
      for (std::uint32_t& c : face) c += first;
      if (is_turned) std::reverse(face.begin(), face.end());
      mesh.polygons.push_back({face[0], face[1], face[2]});
      mesh.polygons.push_back({face[0], face[2], face[3]});
    }
  }
  Mesh made() {
    mesh.points = PointSet(points);
    return mesh;
  }
};

std::vector<Point> turned(std::vector<Point> corners, double angle) {
  for (Point& p : corners) {
    p = Point(p[0] * std::cos(angle) - p[1] * std::sin(angle),
              p[0] * std::sin(angle) + p[1] * std::cos(angle), p[2]);
  }
  return corners;
}

// An open box of five walls, which overlap at the edges.
Mesh bin(double wall, double scale = 1, double offset = 0) {
  Builder builder;
  for (const Box& box : {Box{{0, 0, 0}, {2, 2, wall}}, Box{{0, 0, 0}, {wall, 2, 2}},
                         Box{{2 - wall, 0, 0}, {2, 2, 2}}, Box{{0, 0, 0}, {2, wall, 2}},
                         Box{{0, 2 - wall, 0}, {2, 2, 2}}}) {
    std::vector<Point> corners = box_corners(box);
    for (Point& p : corners) p = p * scale + Point::Constant(offset);
    builder.add(corners);
  }
  return builder.made();
}

// A box with a hole right through it, the loop of whose side goes to the hole and back.
Mesh keyhole() {
  Mesh mesh;
  std::vector<Point> points;
  for (const double z : {0.0, 1.0}) {
    for (const auto& [x, y] : {std::pair(0, 0), {4, 0}, {4, 4}, {0, 4}})
      points.emplace_back(x, y, z);
    for (const auto& [x, y] : {std::pair(1, 1), {3, 1}, {3, 3}, {1, 3}})
      points.emplace_back(x, y, z);
  }
  mesh.points = PointSet(points);
  mesh.polygons = {{8, 9, 10, 11, 8, 12, 15, 14, 13, 12}, {0, 3, 2, 1, 0, 4, 5, 6, 7, 4}};
  for (std::uint32_t k = 0; k < 4; ++k) {
    const std::uint32_t next = (k + 1) % 4;
    mesh.polygons.push_back({k, next, 8 + next, 8 + k});
    mesh.polygons.push_back({4 + next, 4 + k, 12 + k, 12 + next});
  }
  return mesh;
}

void check_promises(const Mesh& mesh, const char* share = "3/100") {
  DecomposeRequest request;
  request.method = DecomposeMethod::Cut;
  request.distance = ConcavityLimit{parse_rational(share), true};
  request.measures = PartMeasures::None;
  const auto made = std::get<Decomposition>(decompose(mesh, request));
  CHECK(made.limit_holds);
  std::vector<NamedPart> parts;
  for (const Part& part : made.parts) parts.push_back({"part", part.mesh});
  PartsRequest asked;
  asked.claims = {ClaimCode::CoversSurface, ClaimCode::CoversSolid};
  asked.distance = Tolerance{request.distance->value, true};
  asked.measures = PartMeasures::None;
  const PartsVerdict verdict = verify_parts(mesh, parts, asked);
  CHECK(verdict[ClaimCode::CoversSurface].status == Status::Holds);
  CHECK(verdict[ClaimCode::CoversSolid].status == Status::Holds);
  CHECK(verdict[ClaimCode::WithinSolid].status == Status::Holds);
}

}  // namespace

TEST_CASE("cut parts: thin walls" * sweep) {
  for (const double wall : {1e-1, 1e-3, 1e-6, 1e-9, 1e-12}) {
    CAPTURE(wall);
    check_promises(bin(wall));
  }
}

TEST_CASE("cut parts: needles, and slabs that are turned" * sweep) {
  for (const double width : {1e-3, 1e-6, 1e-12}) {
    CAPTURE(width);
    Builder builder;
    for (int k = 0; k < 3; ++k) {
      builder.add(turned(box_corners({{-1, 0, 0}, {1, width, width}}), 0.7 * k));
      builder.add(turned(box_corners({{-1, -1, -1}, {1, 1, width - 1}}), 0.3 * k));
    }
    check_promises(builder.made());
  }
}

TEST_CASE("cut parts: far from the origin, huge and tiny" * sweep) {
  // A corner that is rounded moves by 0.002 there, well below the distance.
  check_promises(bin(0.125, 1, 1e13));
  check_promises(bin(0.125, 1024, 0x1p50));
  check_promises(bin(0.1, 0x1p300));
  check_promises(bin(0.1, 0x1p-300));
}

TEST_CASE("cut parts: crossing shells, and keyholes") {
  Builder builder;
  for (const double shift : {0.0, 1.5}) {
    const auto at = [&](double low, double high) {
      return box_corners({{low + shift, low + shift, low}, {high + shift, high + shift, high}});
    };
    builder.add(at(0, 4));
    builder.add(at(1, 3), true);
  }
  check_promises(builder.made());
  check_promises(keyhole());
  check_promises(keyhole(), "1/100");
}
