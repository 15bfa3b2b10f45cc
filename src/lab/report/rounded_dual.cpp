// SPDX-License-Identifier: MIT
#include "lab/report/rounded_dual.hpp"

#include <array>
#include <cmath>

#include "fast/float_cap.hpp"
#include "fast/float_loop_steps.hpp"
#include "number/arithmetic.hpp"
#include "number/mpfr_scalar.hpp"

namespace convexact {

using Binary32 = MpfrScalar<24, ExponentsOf::Binary>;
using Binary64 = MpfrScalar<53, ExponentsOf::Binary>;

template <>
struct ExponentRange<Binary32> : ExponentRange<float> {};

namespace {

Rational exactly(double x) { return to_rational(x); }

template <class Scalar>
Scalar nearest(const Rational& x) {
  return Scalar(x);
}
template <>
float nearest(const Rational& x) {
  return to_float(x, Rounding::Nearest);
}
template <>
double nearest(const Rational& x) {
  return to_double(x, Rounding::Nearest);
}

// The s for which rounded / exact is about 2^s.
long scale_between(const Rational& rounded, const Rational& exact) {
  const Rational ratio = rounded / exact;
  const long s = exponent_of(ratio) - 1;
  const Rational rest = scale_by_power_of_two(ratio, -s);  // between 1/2 and 2
  return rest > Rational(3, 2) ? s + 1 : rest < Rational(3, 4) ? s - 1 : s;
}

// The scale of each axis of a FastDual, read off its largest coordinate.
std::array<long, 3> scales_of(const FastDual& dual, const std::vector<RationalVector3>& exact) {
  std::array<long, 3> scale{};
  for (int k = 0; k < 3; ++k) {
    const auto coordinate = [&](std::size_t i) { return dual.near(HalfspaceId(i))[k]; };
    std::size_t largest = 0;
    for (std::size_t i = 1; i < dual.size(); ++i) {
      if (std::abs(coordinate(i)) > std::abs(coordinate(largest))) largest = i;
    }
    scale[k] = scale_between(to_rational(coordinate(largest)), exact[largest][k]);
  }
  return scale;
}

// The loop's points of one kind of numbers.
template <class Number>
struct Points {
  using Scalar = Number;
  std::vector<Triple<Number>> points;
  double roundoff;

  const Triple<Number>& point(HalfspaceId i) const { return points[i.index()]; }
  double unit() const { return roundoff; }
};

template <class Number>
Points<Number> rounded_points(const std::vector<RationalVector3>& exact,
                              const std::array<long, 3>& scale, long bits) {
  Points<Number> rounded{{}, std::ldexp(1.0, -static_cast<int>(bits))};
  for (const RationalVector3& p : exact) {
    rounded.points.push_back({nearest<Number>(scale_by_power_of_two(p[0], scale[0])),
                              nearest<Number>(scale_by_power_of_two(p[1], scale[1])),
                              nearest<Number>(scale_by_power_of_two(p[2], scale[2]))});
  }
  return rounded;
}

std::vector<RationalVector3> exact_points(const FastDual& dual) {
  std::vector<RationalVector3> points;
  for (std::size_t i = 0; i < dual.size(); ++i) {
    const Halfspace& plane = dual.exact(HalfspaceId(i));
    const Rational w = -plane(dual.center());
    points.push_back({Rational(plane.normal()[0]) / w, Rational(plane.normal()[1]) / w,
                      Rational(plane.normal()[2]) / w});
  }
  return points;
}

template <class Arithmetic>
class LoopOn : public RoundedDual {
 public:
  using Scalar = typename Arithmetic::Scalar;

  LoopOn(const FastDual& dual, std::vector<RationalVector3> exact, const std::array<long, 3>& scale,
         Arithmetic arithmetic)
      : dual_(dual), exact_(std::move(exact)), scale_(scale), arithmetic_(std::move(arithmetic)) {}

  FastResult run(const SimplifyOptions& options) override {
    FloatLoop<Arithmetic> loop(dual_, arithmetic_, options);
    FastResult result = loop.run();
    costs_.clear();
    for (const FastStep& step : result.steps) costs_.push_back(loop.scaled_cost(step.removed));
    left_ = result.triangles;
    return result;
  }

  std::vector<Rational> costs() const override {
    std::vector<Rational> costs;
    for (const Scalar& cost : costs_) costs.push_back(in_units(cost));
    return costs;
  }

  std::optional<Rational> volume() const override {
    const HalfEdgeMesh mesh(dual_.size(), left_);
    typename RoundedDeterminants<Scalar>::Sum six_times;
    OneRing ring;
    RingGeometry<Scalar> geometry;
    for (const HalfspaceId i : mesh.vertices()) {
      mesh.one_ring(i, ring);
      geometry.load(i, ring.vertices, [&](HalfspaceId v) { return arithmetic_.point(v); });
      RoundedDeterminants<Scalar> determinants(geometry);
      add_cone(static_cast<std::uint32_t>(ring.vertices.size()), determinants, six_times);
    }
    if (!std::isfinite(leading(six_times.total))) return std::nullopt;
    return in_units(six_times.total);
  }

  RationalVector3 point(HalfspaceId i) const override {
    const Triple<Scalar>& p = arithmetic_.point(i);
    return {scale_by_power_of_two(exactly(p.x), -scale_[0]),
            scale_by_power_of_two(exactly(p.y), -scale_[1]),
            scale_by_power_of_two(exactly(p.z), -scale_[2])};
  }
  RationalVector3 exact_point(HalfspaceId i) const override { return exact_[i.index()]; }

 private:
  Rational in_units(const Scalar& six_times) const {
    return scale_by_power_of_two(exactly(six_times), dual_.volume_exponent()) / 6;
  }

  const FastDual& dual_;
  std::vector<RationalVector3> exact_;
  std::array<long, 3> scale_;
  Arithmetic arithmetic_;
  std::vector<Scalar> costs_;       // six times, of the latest run
  std::vector<DualTriangle> left_;  // by the latest run
};

template <class Arithmetic>
std::unique_ptr<RoundedDual> loop_on(const FastDual& dual, std::vector<RationalVector3> exact,
                                     const std::array<long, 3>& scale, Arithmetic arithmetic) {
  return std::make_unique<LoopOn<Arithmetic>>(dual, std::move(exact), scale, std::move(arithmetic));
}

}  // namespace

long bits_of(Numbers numbers) {
  switch (numbers) {
    case Numbers::CFloat:
    case Numbers::MpfrBinary32:
      return 24;
    case Numbers::Engine:
    case Numbers::CDouble:
    case Numbers::MpfrBinary64:
      return 53;
    case Numbers::Mpfr64:
      return 64;
    case Numbers::Mpfr113:
      return 113;
    case Numbers::Mpfr256:
      return 256;
    case Numbers::Mpfr1024:
      break;
  }
  return 1024;
}

std::unique_ptr<RoundedDual> RoundedDual::of(const FastDual& dual, Numbers numbers) {
  std::vector<RationalVector3> exact = exact_points(dual);
  const std::array<long, 3> scale = scales_of(dual, exact);
  const auto rounded_to = [&]<class Number>(Number) {
    return loop_on(dual, exact, scale, rounded_points<Number>(exact, scale, bits_of(numbers)));
  };
  switch (numbers) {
    case Numbers::Engine:
      return loop_on(dual, std::move(exact), scale, Doubles{dual, {dual}});
    case Numbers::CFloat:
      return rounded_to(float{});
    case Numbers::CDouble:
      return rounded_to(double{});
    case Numbers::MpfrBinary32:
      return rounded_to(Binary32{});
    case Numbers::MpfrBinary64:
      return rounded_to(Binary64{});
    case Numbers::Mpfr64:
      return rounded_to(MpfrScalar<64>{});
    case Numbers::Mpfr113:
      return rounded_to(MpfrScalar<113>{});
    case Numbers::Mpfr256:
      return rounded_to(MpfrScalar<256>{});
    case Numbers::Mpfr1024:
      break;
  }
  return rounded_to(MpfrScalar<1024>{});
}

}  // namespace convexact
