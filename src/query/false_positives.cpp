// SPDX-License-Identifier: MIT
// Random probes at two solids, and the shares of hits that their measures predict.
#include <algorithm>
#include <cmath>

#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "convexact/query.hpp"
#include "number/precision.hpp"
#include "number/random.hpp"
#include "query/probed_solid.hpp"

namespace convexact {
namespace {

// Uniform among the multiples of 2^-52 in [-1, 1).
double uniform_symmetric(Random& random) { return 2 * uniform_unit(random) - 1; }

// A uniform point of the unit sphere, up to rounding. Of the points (x, y) of the unit disk the
// squared distance s from the center is uniform, so 1 - 2s may be the height. [Marsaglia1972]
Point on_unit_sphere(Random& random) {
  while (true) {
    const double x = uniform_symmetric(random), y = uniform_symmetric(random);
    const double s = x * x + y * y;
    if (s >= 1) continue;
    const double scale = 2 * std::sqrt(1 - s);
    return {scale * x, scale * y, 1 - 2 * s};
  }
}

Point in_unit_ball(Random& random) {
  while (true) {
    const double x = uniform_symmetric(random), y = uniform_symmetric(random),
                 z = uniform_symmetric(random);
    if (x * x + y * y + z * z <= 1) return {x, y, z};
  }
}

ProbeLine draw_line(Random& random, double radius) {
  ProbeLine line;
  do {
    line.first = radius * on_unit_sphere(random);
    line.second = radius * on_unit_sphere(random);
  } while (line.first == line.second);
  return line;
}

ProbePlane draw_plane(Random& random, double radius) {
  const Point normal = on_unit_sphere(random);
  return {normal, radius * uniform_symmetric(random)};
}

Point draw_point(Random& random, double radius) { return radius * in_unit_ball(random); }

// Of a ball: area 4 pi r^2, mean width 2 r, volume 4/3 pi r^3.
Enclosure measure_of_ball(CostMeasure measure, const Rational& r) {
  const Enclosure radius(r, kMeasureBits);
  const auto times = [](const Rational& factor, Enclosure x) {
    return x *= Enclosure(factor, kMeasureBits);
  };
  if (measure == CostMeasure::MeanWidth) return times(2, radius);
  const Enclosure disk = Enclosure::pi(kMeasureBits) * radius * radius;
  return measure == CostMeasure::Area ? times(4, disk) : times(Rational(4, 3), disk * radius);
}

struct ProbedPair {
  const Polytope& a;
  const Polytope& b;
  ProbedSolid near_a, near_b;
  ProbeFrame frame;
  Rational radius;
  bool is_inside;
  const Watch& watch;
};

// One kind of probe, whose hits are in proportion to a measure.
template <class Draw>
std::optional<ProbeTally> tally(const ProbedPair& pair, std::size_t samples, std::uint64_t seed,
                                CostMeasure measure, Draw&& draw) {
  if (samples == 0) return {};
  const Enclosure of_b = enclose_measure(pair.b, measure, kMeasureBits, pair.watch);
  ProbeTally tally{.samples = samples,
                   .expected_b = Enclosure(Rational(samples), kMeasureBits) * of_b /
                                 measure_of_ball(measure, pair.radius),
                   .prediction = {}};
  if (pair.is_inside) {
    const Enclosure of_a = enclose_measure(pair.a, measure, kMeasureBits, pair.watch);
    tally.prediction = Enclosure(Rational(1), kMeasureBits) - of_a / of_b;
  }
  const std::size_t exact_before = pair.near_a.exact_decisions() + pair.near_b.exact_decisions();
  Random random(seed);
  for (std::size_t i = 0; i < samples; ++i) {
    pair.watch.at(i, samples);
    const auto probe = draw(random, pair.frame.radius);
    const bool hits_a = pair.near_a.is_hit(probe), hits_b = pair.near_b.is_hit(probe);
    tally.hits_a += hits_a;
    tally.hits_b += hits_b;
    tally.only_a += hits_a && !hits_b;
    tally.only_b += hits_b && !hits_a;
  }
  tally.exact = pair.near_a.exact_decisions() + pair.near_b.exact_decisions() - exact_before;
  if (pair.is_inside && tally.only_a > 0) {
    throw Error(ErrorCode::Internal, "a probe hits a solid and misses one that encloses it");
  }
  return tally;
}

}  // namespace

std::optional<double> ProbeTally::rate() const {
  if (hits_b == 0) return {};
  return static_cast<double>(only_b) / static_cast<double>(hits_b);
}

std::optional<double> ProbeTally::sigma() const {
  if (hits_b == 0 || !prediction) return {};
  const double share = std::max(0.0, middle_double(*prediction));
  return std::sqrt(share * (1 - share) / static_cast<double>(hits_b));
}

FalsePositives count_false_positives(const Polytope& a, const Polytope& b,
                                     const FalsePositiveRequest& request) {
  const ProbeFrame frame = probe_frame(a, b);
  ProbedPair pair{.a = a,
                  .b = b,
                  .near_a = ProbedSolid(a, frame),
                  .near_b = ProbedSolid(b, frame),
                  .frame = frame,
                  .radius = scale_by_power_of_two(to_rational(frame.radius), frame.exponent),
                  .is_inside = false,
                  .watch = request.watch};
  FalsePositives result;
  result.outside = pair.near_b.first_outside(pair.near_a);
  result.center = frame.center;
  result.radius = pair.radius;
  pair.is_inside = !result.outside;
  // Each kind has a separate seed, so that the number of probes of one kind does not change another
  // kind.
  Random seeds(request.seed);
  const std::uint64_t of_lines = seeds(), of_planes = seeds(), of_points = seeds();
  result.lines = tally(pair, request.lines, of_lines, CostMeasure::Area, draw_line);
  result.planes = tally(pair, request.planes, of_planes, CostMeasure::MeanWidth, draw_plane);
  result.points = tally(pair, request.points, of_points, CostMeasure::Volume, draw_point);
  return result;
}

}  // namespace convexact
