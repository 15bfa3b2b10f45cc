// SPDX-License-Identifier: MIT
// Volume, area and mean width in closed form, and Steiner's formula with them.
#include "convexact/implicit.hpp"
#include "number/precision.hpp"

namespace convexact {
namespace {

// Numbers of one precision.
struct Closed {
  long precision;

  Enclosure number(const Rational& x) const { return Enclosure(x, precision); }
  Enclosure pi() const { return Enclosure::pi(precision); }
  Enclosure length(const Point& from, const Point& to) const {
    return sqrt(number(RationalVector3(to_rational(to) - to_rational(from)).squaredNorm()));
  }

  // All points within t of a convex solid: Steiner's formula, and its derivatives by t.
  ImplicitMeasures grown(const ImplicitMeasures& m, const Enclosure& t) const {
    const Enclosure pi4 = number(4) * pi();
    return {m.volume + m.area * t + number(2) * pi() * m.mean_width * t * t +
                pi4 * t * t * t / number(3),
            m.area + pi4 * m.mean_width * t + pi4 * t * t, m.mean_width + number(2) * t};
  }

  ImplicitMeasures box(const Enclosure& a, const Enclosure& b, const Enclosure& c) const {
    return {a * b * c, number(2) * (a * b + b * c + c * a), (a + b + c) / number(2)};
  }
};

struct ClosedMeasures : Closed {
  using Answer = std::optional<ImplicitMeasures>;

  template <class Other>
  Answer operator()(const Other&) const {
    return {};
  }
  Answer operator()(const implicit::Sphere& s) const {
    const ImplicitMeasures point{number(0), number(0), number(0)};
    return grown(point, number(to_rational(s.radius)));
  }
  Answer operator()(const implicit::Capsule& s) const {
    const ImplicitMeasures segment{number(0), number(0), length(s.from, s.to) / number(2)};
    return grown(segment, number(to_rational(s.radius)));
  }
  Answer operator()(const implicit::Box& s) const {
    const Rational radius = to_rational(s.radius);
    const auto side = [&](int k) {
      return number(to_rational(s.high[k]) - to_rational(s.low[k]) - 2 * radius);
    };
    return grown(box(side(0), side(1), side(2)), number(radius));
  }
  Answer operator()(const implicit::Cylinder& s) const {
    const Enclosure l = length(s.from, s.to), r = number(to_rational(s.radius));
    return ImplicitMeasures{pi() * r * r * l, number(2) * pi() * r * (l + r),
                            (l + pi() * r) / number(2)};
  }
  Answer operator()(const implicit::Translate& s) const {
    return closed_measures(s.of[0], precision);
  }
  Answer operator()(const implicit::Rotate& s) const { return closed_measures(s.of[0], precision); }
  Answer operator()(const implicit::Scale& s) const {
    Answer m = closed_measures(s.of[0], precision);
    if (!m || s.factors.minCoeff() != s.factors.maxCoeff()) return {};
    const Enclosure factor = number(to_rational(s.factors[0]));
    return ImplicitMeasures{m->volume * factor * factor * factor, m->area * factor * factor,
                            m->mean_width * factor};
  }
  Answer operator()(const implicit::Offset& s) const {
    Answer m = closed_measures(s.of[0], precision);
    if (!m || s.by < 0) return {};
    return grown(*m, number(to_rational(s.by)));
  }
};

}  // namespace

std::optional<ImplicitMeasures> closed_measures(const ImplicitShape& shape, long precision) {
  return std::visit(ClosedMeasures{{precision}}, shape.node());
}

double steiner_bound(const ImplicitMeasures& measures, double distance) {
  const Closed closed{measures.volume.precision()};
  return closed.grown(measures, closed.number(to_rational(distance))).volume.high_double();
}

}  // namespace convexact
