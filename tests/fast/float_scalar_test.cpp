// SPDX-License-Identifier: MIT
// The float loop in other arithmetics: C floats and MPFR of 24 to 256 bits. Doubles of MPFR are
// doubles; enough bits give the filtered engine's removals; few bits still give bounded solids.
#include <doctest/doctest.h>

#include <cmath>
#include <variant>

#include "check_bounded.hpp"
#include "convexact/fast/float_engine.hpp"
#include "convexact/fast/float_loop.hpp"
#include "convexact/io/read_mesh.hpp"
#include "convexact/shapes/boxes.hpp"
#include "convexact/shapes/extreme.hpp"
#include "convexact/shapes/families.hpp"
#include "convexact/shapes/random_points.hpp"
#include "mpfr_scalar.hpp"
#include "shipped_meshes.hpp"

using namespace convexact;

namespace {

template <class Scalar>
struct Rounded {
  std::vector<Triple<Scalar>> points;
  double roundoff;

  const Triple<Scalar>& point(HalfspaceId i) const { return points[i.index()]; }
  double unit() const { return roundoff; }
};

template <class Number>
struct Arithmetic : Rounded<Number> {
  using Scalar = Number;
};

// What simplify_float() turns to where doubles cannot tell.
struct LongerPoints {
  using Scalar = DoubleDouble;
  const FastDual& dual;

  Triple<DoubleDouble> point(HalfspaceId i) const { return dual.long_point(i); }
  static double unit() { return Roundoff<DoubleDouble>::kUnit; }
};

// MPFR in the place of doubles.
struct DoublesOfMpfr : Rounded<MpfrScalar<53>> {
  using Scalar = MpfrScalar<53>;
  using Longer = LongerPoints;
  LongerPoints long_points;

  const LongerPoints& longer() const { return long_points; }
};

template <long kBits>
double unit_of_bits() {
  return std::ldexp(1.0, -static_cast<int>(kBits));
}

// The dual points as doubles hold them, in numbers of the same length or shorter.
template <class Scalar>
Arithmetic<Scalar> from_doubles(const FastDual& dual, double unit) {
  Arithmetic<Scalar> arithmetic;
  arithmetic.roundoff = unit;
  for (std::size_t i = 0; i < dual.size(); ++i) {
    const Triple<double>& p = dual.near(HalfspaceId(i));
    arithmetic.points.push_back({Scalar(p.x), Scalar(p.y), Scalar(p.z)});
  }
  return arithmetic;
}

// The dual points to kBits, by the definition: n / w, each axis scaled to at most one by a power
// of two.
template <long kBits>
Arithmetic<MpfrScalar<kBits>> from_planes(const FastDual& dual) {
  using Scalar = MpfrScalar<kBits>;
  std::vector<RationalVector3> exact;
  RationalVector3 largest = RationalVector3::Zero();
  for (std::size_t i = 0; i < dual.size(); ++i) {
    const Halfspace& plane = dual.exact(HalfspaceId(i));
    const Rational w = -plane(dual.center());
    RationalVector3 p;
    for (int k = 0; k < 3; ++k) {
      p[k] = Rational(plane.normal()[k]) / w;
      largest[k] = std::max(largest[k], abs(p[k]));
    }
    exact.push_back(p);
  }
  std::array<long, 3> down;
  for (int k = 0; k < 3; ++k) {
    down[k] = static_cast<long>(bit_length(denominator(largest[k]))) -
              static_cast<long>(bit_length(numerator(largest[k]))) - 1;
  }
  Arithmetic<Scalar> arithmetic;
  arithmetic.roundoff = unit_of_bits<kBits>();
  for (const RationalVector3& p : exact) {
    arithmetic.points.push_back({Scalar(scale_by_power_of_two(p[0], down[0])),
                                 Scalar(scale_by_power_of_two(p[1], down[1])),
                                 Scalar(scale_by_power_of_two(p[2], down[2]))});
  }
  return arithmetic;
}

template <class Numbers>
FastResult run(const FastDual& dual, const Numbers& arithmetic,
               const SimplifyOptions& options = {}) {
  return FloatLoop<Numbers>(dual, arithmetic, options).run();
}

// A hull and its dual; none if the points span no volume.
struct Subject {
  PointSet points;
  HullOutcome outcome;

  explicit Subject(PointSet set) : points(std::move(set)), outcome(convex_hull(points)) {}
  const Hull* hull() const { return std::get_if<Hull>(&outcome); }
  FastDual dual() const { return FastDual::of(*hull(), points); }
};

// Removals up to the first exact tie that the two break differently; how many were compared.
std::size_t check_same_up_to_ties(const FastResult& sure, const FastResult& quick) {
  for (std::size_t s = 0; s < sure.steps.size(); ++s) {
    CAPTURE(s);
    REQUIRE(s < quick.steps.size());
    if (sure.steps[s].removed != quick.steps[s].removed) {
      CHECK(sure.steps[s].tied > 1);
      return s;
    }
    CHECK(quick.steps[s].cost_lower >= 0);
  }
  CHECK(sure.stop == quick.stop);
  CHECK(sure.steps.size() == quick.steps.size());
  return sure.steps.size();
}

}  // namespace

TEST_CASE("float loop: MPFR with the 53 bits of doubles does what doubles do, bit for bit") {
  std::vector<PointSet> sets = {
      PointSet(shapes::in_ball(300, 3)), PointSet(shapes::on_sphere(200, 4)),
      PointSet(shapes::rounded_box({1, 1, 2}, 0.25, 3)), PointSet(shapes::nearly_coplanar(16, 1)),
      PointSet(shapes::needle(40, 1e12, 1))};
  for (const std::string& path : shipped_meshes()) sets.push_back(read_mesh(path).points);
  for (const PointSet& set : sets) {
    const Subject subject(set);
    REQUIRE(subject.hull() != nullptr);
    const FastDual dual = subject.dual();
    const DoublesOfMpfr arithmetic{from_doubles<MpfrScalar<53>>(dual, Roundoff<double>::kUnit),
                                   {dual}};
    const SimplifyOptions options{.faces = dual.size() > 400 ? dual.size() - 300 : 4};
    const FastResult doubles = simplify_float(dual, options), mpfr = run(dual, arithmetic, options);
    CHECK(doubles.stop == mpfr.stop);
    CHECK(doubles.counts.evaluations == mpfr.counts.evaluations);
    REQUIRE(doubles.steps.size() == mpfr.steps.size());
    for (std::size_t s = 0; s < doubles.steps.size(); ++s) {
      CAPTURE(s);
      REQUIRE(doubles.steps[s].removed == mpfr.steps[s].removed);
      REQUIRE(doubles.steps[s].cost_lower == mpfr.steps[s].cost_lower);
    }
  }
}

TEST_CASE("float loop: 256 bits remove what the filtered engine removes, but for exact ties") {
  std::size_t compared = 0;
  const auto check = [&](const PointSet& set, std::size_t most) {
    const Subject subject(set);
    REQUIRE(subject.hull() != nullptr);
    const FastDual dual = subject.dual();
    const SimplifyOptions options{.faces = dual.size() > most ? dual.size() - most : 4};
    const FastResult quick = run(dual, from_planes<256>(dual), options);
    if (dual.size() < 200) check_bounded(dual, quick);
    compared += check_same_up_to_ties(simplify_filtered(dual, options), quick);
  };
  for (const std::string& path : shipped_meshes()) {
    CAPTURE(path);
    check(read_mesh(path).points, 100);
  }
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    CAPTURE(seed);
    check(PointSet(shapes::in_ball(100, seed)), 1000);
    check(PointSet(shapes::needle(24, 1e12, seed)), 1000);
    check(PointSet(shapes::slab(24, 1e12, seed)), 1000);
    check(PointSet(shapes::offset_ball(24, 1e8, seed)), 1000);
    check(PointSet(shapes::scaled_ball(24, 300, seed)), 1000);
    check(PointSet(shapes::nearly_flat(16, seed)), 1000);
    check(PointSet(shapes::nearly_coplanar(16, seed)), 1000);
    check(PointSet(shapes::lattice(20, 3, seed)), 1000);
  }
  CHECK(compared > 500);
}

TEST_CASE("float loop: 113 bits agree with the filtered engine on random points") {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    CAPTURE(seed);
    const Subject subject(PointSet(shapes::in_ball(150, seed)));
    const FastDual dual = subject.dual();
    const FastResult sure = simplify_filtered(dual), quick = run(dual, from_planes<113>(dual));
    CHECK(check_same_up_to_ties(sure, quick) == sure.steps.size());
  }
}

TEST_CASE("float loop: 24 bits and C floats end with bounded solids on every family of shapes") {
  std::size_t removed = 0, possible = 0;
  for (const shapes::Family& family : shapes::families()) {
    CAPTURE(family.name);
    const Subject subject(PointSet(shapes::generate(family, shapes::usual_values(family), 1)));
    if (subject.hull() == nullptr || subject.hull()->facets.size() > 600) continue;
    const FastDual dual = subject.dual();
    const FastResult floats = run(dual, from_doubles<float>(dual, 0x1p-24));
    check_bounded(dual, floats);
    const FastResult mpfr = run(dual, from_doubles<MpfrScalar<24>>(dual, 0x1p-24));
    check_bounded(dual, mpfr);
    possible += simplify_filtered(dual).steps.size();
    removed += floats.steps.size();
  }
  // Not by refusing everything.
  CHECK(2 * removed > possible);
}

TEST_CASE("float loop: a growth limit holds in any arithmetic") {
  const Subject subject(PointSet(shapes::in_ball(80, 7)));
  const FastDual dual = subject.dual();
  for (const int percent : {0, 1, 5, 20, 100}) {
    CAPTURE(percent);
    const SimplifyOptions options{.max_growth = Rational(percent, 100)};
    const std::size_t sure = simplify_filtered(dual, options).steps.size();
    CHECK(run(dual, from_planes<256>(dual), options).steps.size() == sure);
    CHECK(run(dual, from_planes<53>(dual), options).steps.size() == sure);
    CHECK(run(dual, from_doubles<float>(dual, 0x1p-24), options).steps.size() <= sure + 1);
  }
}
