// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "convexact/error.hpp"
#include "io/json.hpp"
#include "number/arithmetic.hpp"
#include "teach/chapters.hpp"

namespace convexact {
namespace {

// The gap between a number of the format and the next larger one.
Rational spacing_above(Precision precision, double x) {
  const double next =
      precision == Precision::Binary64
          ? std::nextafter(x, std::numeric_limits<double>::infinity())
          : std::nextafterf(static_cast<float>(x), std::numeric_limits<float>::infinity());
  return to_rational(next) - to_rational(x);
}

// The point of the input that is farthest in a direction.
struct Support {
  PointId point;
  Rational value;
};

Support support_of(const RationalVector3& direction, const Solid& solid) {
  Support support{solid.extreme.front(), direction.dot(solid.points[solid.extreme.front()])};
  for (const PointId p : solid.extreme) {
    Rational value = direction.dot(solid.points[p]);
    if (value > support.value) support = {p, std::move(value)};
  }
  return support;
}

Json planes_chapter(const Polytope& exact, std::span<const HalfspaceId> ids, const Solid& solid,
                    Precision precision) {
  const StoredPlanes stored = store_planes(exact, solid.points, solid.extreme, precision);
  Json planes = Json::array();
  std::vector<Halfspace> naive_planes;
  for (std::size_t i = 0; i < exact.planes.size(); ++i) {
    const Halfspace& plane = exact.planes[i];
    const long bits = static_cast<long>(bit_length(plane.normal()));
    RationalVector3 scaled, nearest, normal;
    for (int k = 0; k < 3; ++k) {
      scaled[k] = scale_by_power_of_two(Rational(plane.normal()[k]), -bits);
      nearest[k] = to_rational(round_to(precision, scaled[k], Rounding::Nearest));
      normal[k] = to_rational(stored.planes[i][static_cast<std::size_t>(k)]);
    }
    const Rational offset = scale_by_power_of_two(Rational(plane.offset()), -bits);
    const double naive = round_to(precision, offset, Rounding::Nearest);
    if (!std::isfinite(naive)) {
      throw Error(ErrorCode::Unrepresentable, "an offset to nearest is beyond the format");
    }
    naive_planes.emplace_back(nearest, to_rational(naive));
    const Support support = support_of(normal, solid);
    const Rational cut = support.value + to_rational(naive);
    const double d = stored.planes[i][3];
    planes.push_back({{"halfspace", ids[i].index()},
                      {"scaled", {scaled[0], scaled[1], scaled[2], offset}},
                      {"normal", vector_json(normal)},
                      {"turned", normal != nearest},
                      {"support", support.value},
                      {"witness", vector_json(solid.points[support.point])},
                      {"naive", to_rational(naive)},
                      {"cut", cut > 0 ? cut : Rational(0)},
                      {"stored", to_rational(d)},
                      {"ulp", spacing_above(precision, d)}});
  }
  return {{"precision", precision == Precision::Binary64 ? "binary64" : "binary32"},
          {"planes", std::move(planes)},
          {"naive_outside", count_outside(naive_planes, solid.points)},
          {"push", value_or_null(stored.growth.push)},
          {"volume_ratio", value_or_null(stored.growth.volume_ratio)}};
}

Json mesh_part(const Polytope& exact, const Solid& solid, Precision precision) {
  const StoredMesh stored = store_mesh(exact, solid.points, solid.extreme, precision);
  std::vector<Point> rounded;
  for (const RationalPoint& v : exact.vertices) {
    Point& p = rounded.emplace_back();
    for (int k = 0; k < 3; ++k) p[k] = round_to(precision, v[k], Rounding::Nearest);
  }
  return {{"naive_outside", count_outside_hull(PointSet(std::move(rounded)), solid.points)},
          {"push", value_or_null(stored.growth.push)},
          {"volume_ratio", value_or_null(stored.growth.volume_ratio)}};
}

}  // namespace

Json storing_chapter(const Polytope& exact, std::span<const HalfspaceId> ids, const Solid& solid,
                     Precision precision, LeftOutParts& left_out) {
  Json chapter;
  const auto unless_refused = [&](auto&& work) {
    try {
      work();
    } catch (const Error& error) {
      if (error.code() != ErrorCode::Unrepresentable) throw;
      left_out.add("storing", error.what());
    }
  };
  unless_refused([&] { chapter = planes_chapter(exact, ids, solid, precision); });
  if (chapter.is_null()) return chapter;
  unless_refused([&] { chapter["mesh"] = mesh_part(exact, solid, precision); });
  return chapter;
}

}  // namespace convexact
