// SPDX-License-Identifier: MIT
// The float loop in other arithmetics: C floats and MPFR of 24 to 1024 bits. Floats and doubles of
// MPFR are C's; enough bits give the filtered engine's removals; few bits still give bounded
// solids.
#include <doctest/doctest.h>

#include <variant>

#include "check_bounded.hpp"
#include "convexact/io.hpp"
#include "convexact/measure.hpp"
#include "convexact/shapes.hpp"
#include "fast/engines.hpp"
#include "fast/float_loop_steps.hpp"
#include "lab/report/rounded_dual.hpp"
#include "number/mpfr_scalar.hpp"
#include "shapes/makers.hpp"
#include "shipped_meshes.hpp"
#include "simplify/replay.hpp"
#include "sweep.hpp"

using namespace convexact;

namespace {

template <class Scalar>
struct Rounded {
  std::vector<Triple<Scalar>> points;
  double roundoff;

  const Triple<Scalar>& point(HalfspaceId i) const { return points[i.index()]; }
  double unit() const { return roundoff; }
};

// What simplify_float() turns to where doubles cannot tell.
struct LongerPoints {
  using Scalar = DoubleDouble;
  const FastDual& dual;
  DualSigns exact{dual};

  Triple<DoubleDouble> point(HalfspaceId i) const { return dual.long_point(i); }
  static double unit() { return Roundoff<DoubleDouble>::kUnit; }
  const DualSigns& signs() const { return exact; }
};

// MPFR in the place of doubles.
struct DoublesOfMpfr : Rounded<MpfrScalar<53>> {
  using Scalar = MpfrScalar<53>;
  using Longer = LongerPoints;
  LongerPoints long_points;

  const LongerPoints& longer() const { return long_points; }
  const DualSigns& signs() const { return long_points.exact; }
};

FastResult run(const FastDual& dual, Numbers numbers, const SimplifyOptions& options = {}) {
  return RoundedDual::of(dual, numbers)->run(options);
}

// A hull and its dual; none if the points span no volume.
struct Subject {
  PointSet points;
  HullOutcome outcome;

  explicit Subject(PointSet set) : points(std::move(set)), outcome(convex_hull(points)) {}
  const Hull* hull() const { return std::get_if<Hull>(&outcome); }
  FastDual dual() const { return FastDual::of(*hull(), points); }
};

bool is_near(const Rational& x, const Rational& exact, const Rational& relative) {
  return abs(x - exact) <= relative * abs(exact);
}

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
    DoublesOfMpfr arithmetic{{{}, Roundoff<double>::kUnit}, {dual}};
    for (std::size_t i = 0; i < dual.size(); ++i) {
      const Triple<double>& p = dual.near(HalfspaceId(i));
      using Scalar = DoublesOfMpfr::Scalar;
      arithmetic.points.push_back({Scalar(p.x), Scalar(p.y), Scalar(p.z)});
    }
    const SimplifyOptions options{.faces = dual.size() > 400 ? dual.size() - 300 : 4};
    const FastResult doubles = simplify_float(dual, options);
    const FastResult mpfr = FloatLoop<DoublesOfMpfr>(dual, arithmetic, options).run();
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
    const FastResult quick = run(dual, Numbers::Mpfr256, options);
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
    const FastResult sure = simplify_filtered(dual), quick = run(dual, Numbers::Mpfr113);
    CHECK(check_same_up_to_ties(sure, quick) == sure.steps.size());
  }
}

TEST_CASE("float loop: C floats end with bounded solids on every family of shapes") {
  std::size_t removed = 0, possible = 0;
  for (const shapes::Family& family : shapes::families()) {
    CAPTURE(family.name);
    const Subject subject(PointSet(shapes::generate(family, shapes::usual_values(family), 1)));
    if (subject.hull() == nullptr || subject.hull()->facets.size() > 600) continue;
    const FastDual dual = subject.dual();
    const FastResult floats = run(dual, Numbers::CFloat);
    check_bounded(dual, floats);
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
    CHECK(run(dual, Numbers::Mpfr256, options).steps.size() == sure);
    CHECK(run(dual, Numbers::MpfrBinary64, options).steps.size() == sure);
    CHECK(run(dual, Numbers::CFloat, options).steps.size() <= sure + 1);
  }
}

TEST_CASE("rounded dual: the formats binary32 and binary64 of MPFR are C's, bit for bit" * sweep) {
  std::vector<PointSet> sets;
  for (const shapes::Family& family : shapes::families()) {
    sets.emplace_back(shapes::generate(family, shapes::usual_values(family), 1));
  }
  // Stiff ones, far apart in the exponents of their numbers.
  for (const double aspect : {1e6, 1e12, 1e20}) {
    sets.emplace_back(shapes::needle(40, aspect, 1));
    sets.emplace_back(shapes::slab(40, aspect, 1));
  }
  for (const std::string& path : shipped_meshes()) sets.push_back(read_mesh(path).points);
  std::size_t steps = 0;
  for (const PointSet& set : sets) {
    const Subject subject(set);
    if (subject.hull() == nullptr) continue;
    const FastDual dual = subject.dual();
    const SimplifyOptions options{.faces = dual.size() > 300 ? dual.size() - 200 : 4};
    const std::pair<Numbers, Numbers> pairs[] = {{Numbers::CFloat, Numbers::MpfrBinary32},
                                                 {Numbers::CDouble, Numbers::MpfrBinary64}};
    for (const auto& [c, mpfr] : pairs) {
      const auto by_c = RoundedDual::of(dual, c), by_mpfr = RoundedDual::of(dual, mpfr);
      const FastResult a = by_c->run(options), b = by_mpfr->run(options);
      CHECK(a.stop == b.stop);
      CHECK(a.counts.evaluations == b.counts.evaluations);
      CHECK(by_c->costs() == by_mpfr->costs());
      CHECK(by_c->volume() == by_mpfr->volume());
      REQUIRE(a.steps.size() == b.steps.size());
      for (std::size_t s = 0; s < a.steps.size(); ++s) {
        REQUIRE(a.steps[s].removed == b.steps[s].removed);
      }
      for (std::size_t i = 0; i < dual.size(); ++i) {
        REQUIRE(by_c->point(HalfspaceId(i)) == by_mpfr->point(HalfspaceId(i)));
      }
      steps += a.steps.size();
    }
  }
  CHECK(steps > 2000);
}

// The expected values are rationals: replay() computes the cost of each removal that was made.
TEST_CASE(
    "rounded dual: costs, volume and points come near the exact ones, the nearer the longer") {
  const PointSet points(shapes::in_ball(60, 5));
  const auto hull = std::get<Hull>(convex_hull(points));
  const DualHull solid = dual_of(hull, points);
  const RationalPoint center(Rational(1, 16), Rational(0), Rational(-1, 32));
  const FastDual dual = FastDual::of(solid, center);
  for (const Numbers numbers : {Numbers::CFloat, Numbers::CDouble, Numbers::Engine, Numbers::Mpfr64,
                                Numbers::Mpfr113, Numbers::Mpfr256, Numbers::Mpfr1024}) {
    CAPTURE(bits_of(numbers));
    const auto rounded = RoundedDual::of(dual, numbers);
    const FastResult result = rounded->run({.faces = 20});
    std::vector<HalfspaceId> removed;
    for (const FastStep& step : result.steps) removed.push_back(step.removed);
    REQUIRE(removed.size() == solid.halfspaces.size() - 20);
    const Run exact = replay(solid, center, removed);
    // Far wider than the error of these tame caps, far narrower than the next shorter numbers'.
    const Rational wide = scale_by_power_of_two(Rational(1), 12 - bits_of(numbers));
    const std::vector<Rational> costs = rounded->costs();
    REQUIRE(costs.size() == removed.size());
    bool all_exact = true;
    for (std::size_t s = 0; s < costs.size(); ++s) {
      const Rational& cost = exact.steps[s].cost->rational();
      CHECK(is_near(costs[s], cost, wide));
      all_exact = all_exact && costs[s] == cost;
    }
    CHECK_FALSE(all_exact);
    const Rational left = volume(to_polytope(solid.halfspaces, exact.triangles));
    CAPTURE(to_double(rounded->volume().value(), Rounding::Nearest));
    CAPTURE(to_double(left, Rounding::Nearest));
    CHECK(is_near(rounded->volume().value(), left, wide));
    for (std::size_t i = 0; i < dual.size(); ++i) {
      const RationalVector3 p = rounded->point(HalfspaceId(i)),
                            q = rounded->exact_point(HalfspaceId(i));
      const Rational unit = scale_by_power_of_two(Rational(1), 1 - bits_of(numbers));
      for (int k = 0; k < 3; ++k) CHECK(is_near(p[k], q[k], unit));
    }
  }
}
