// SPDX-License-Identifier: MIT
// Every predicate on thousands of hard inputs, as two numbers: a hash of all answers, and one of
// the stages that they needed. mutate.py compares them between a mutant and the original.
#include <cstdio>
#include <variant>

#include "convexact/dual.hpp"
#include "convexact/geometry.hpp"
#include "convexact/hull.hpp"
#include "convexact/number.hpp"
#include "fast/engines.hpp"
#include "fast/signs.hpp"
#include "geometry/orient3d_stages.hpp"
#include "geometry/plane_determinants.hpp"
#include "hard_inputs.hpp"
#include "number/random.hpp"
#include "simplify/plain_vertex.hpp"

using namespace convexact;

namespace {

// FNV-1a.
class Hash {
 public:
  void add(std::uint64_t x) {
    for (int byte = 0; byte < 8; ++byte) value_ = (value_ ^ (x >> 8 * byte & 255)) * 0x100000001b3;
  }
  void add(Sign sign) { add(static_cast<std::uint64_t>(static_cast<int>(sign) + 2)); }
  unsigned long long value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

struct Answers {
  Hash answers, stages;

  void orientations(const std::vector<Point>& points, Random& random) {
    for (int i = 0; i < 60; ++i) {
      const auto pick = [&] { return points[uniform_below(random, points.size())]; };
      const Point a = pick(), b = pick(), c = pick(), d = pick();
      const StagedSign staged = orient3d_staged(a, b, c, d);
      answers.add(staged.sign);
      stages.add(static_cast<std::uint64_t>(staged.stage));
    }
  }

  void planes(const FastDual& dual, const std::vector<Point>& points, Random& random) {
    const DualSigns signs(dual);
    for (int i = 0; i < 40; ++i) {
      const auto pick = [&] { return HalfspaceId(uniform_below(random, dual.size())); };
      const HalfspaceId a = pick(), b = pick(), c = pick(), p = pick();
      const Halfspace &ha = dual.exact(a), &hb = dual.exact(b), &hc = dual.exact(c),
                      &hp = dual.exact(p);
      answers.add(signs.height(a, b, c, p));
      answers.add(signs.determinant(a, b, c));
      answers.add(sign_of(plane_determinant(ha, hb, hc, hp)));
      answers.add(sign_of(normal_determinant(ha, hb, hc)));
      const DualPlane plane = plane_through(polar(ha, dual.center()), polar(hb, dual.center()),
                                            polar(hc, dual.center()));
      answers.add(sign_of(convexact::height(plane, polar(hp, dual.center()))));
      answers.add(sign_of(plane.d));
      const PlainVertex vertex = plain_vertex(ha, hb, hc);
      answers.add(sign_of(value_at(vertex, hp)));
      answers.add(sign_of(vertex.d));
      const Point& x = points[uniform_below(random, points.size())];
      answers.add(side_of(ha, x));
      for (const Rounding rounding : {Rounding::Down, Rounding::Up, Rounding::Nearest}) {
        answers.add(std::bit_cast<std::uint64_t>(to_double(ha(to_rational(x)), rounding)));
        answers.add(std::bit_cast<std::uint32_t>(to_float(ha(to_rational(x)), rounding)));
      }
    }
    add(signs.counts());
  }

  void removals(const FastDual& dual) {
    const FastResult result = simplify_filtered(dual, {.faces = 4});
    for (const FastStep& step : result.steps) answers.add(step.removed.index());
    for (const FastStep& step : result.steps) answers.add(std::uint64_t{step.tied});
    add(result.counts.signs);
    for (const std::uint64_t count : {result.counts.evaluations, result.counts.doubtful,
                                      result.counts.extended, result.counts.exact}) {
      stages.add(count);
    }
  }

  void add(const SignCounts& counts) {
    for (const std::uint64_t count :
         {counts.filtered, counts.incident, counts.extended, counts.exact}) {
      stages.add(count);
    }
  }
};

}  // namespace

int main() {
  Answers all;
  Random random(1);
  for (const hard::Inputs& kind : hard::inputs()) {
    hard::for_each(kind.name, [&](std::uint32_t, const std::vector<Point>& points) {
      all.orientations(points, random);
      const PointSet set(points);
      const HullOutcome outcome = convex_hull(set);
      const auto* hull = std::get_if<Hull>(&outcome);
      all.answers.add(hull != nullptr ? hull->facets.size() : 0);
      if (hull == nullptr) return;
      const FastDual dual = FastDual::of(*hull, set);
      all.planes(dual, points, random);
      all.removals(dual);
    });
  }
  std::printf("answers %llx\nstages %llx\n", all.answers.value(), all.stages.value());
  return 0;
}
