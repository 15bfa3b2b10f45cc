// SPDX-License-Identifier: MIT
// implicit_value.hpp - the function of an implicit shape, written once for every kind of interval.
#pragma once
#include <array>
#include <type_traits>
#include <variant>

#include "convexact/implicit.hpp"

namespace convexact {

/// Evaluates shapes in intervals. Numbers offers, for its type Number of intervals:
/// number(double), entry(rotation, k), + - *, quotient(a, b) for b > 0, root(a) for an a that is
/// >= 0, least(a, b), greatest(a, b), magnitude(a) and square(a), all exact or rounded outward.
template <class Numbers>
class ImplicitValue {
 public:
  using Number = typename Numbers::Number;
  using Place = std::array<Number, 3>;

  explicit ImplicitValue(Numbers numbers) : n_(numbers) {}

  Number operator()(const ImplicitShape& shape, const Place& x) const {
    return std::visit(
        [&](const auto& node) {
          using Node = std::decay_t<decltype(node)>;
          if constexpr (std::is_same_v<Node, implicit::Rotate>) {
            return rotated(shape, x);
          } else {
            return value(node, x);
          }
        },
        shape.node());
  }

 private:
  Number zero() const { return n_.number(0.0); }
  Place place(const Point& p) const { return {n_.number(p[0]), n_.number(p[1]), n_.number(p[2])}; }
  static Place minus(const Place& a, const Place& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }
  static Number dot(const Place& a, const Place& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  Number squared_length(const Place& a) const {
    return n_.square(a[0]) + n_.square(a[1]) + n_.square(a[2]);
  }
  Number length(const Place& a) const { return n_.root(squared_length(a)); }
  Number hypotenuse(const Number& a, const Number& b) const {
    return n_.root(n_.square(a) + n_.square(b));
  }
  static Place cross(const Place& a, const Place& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  Number positive_part(const Number& a) const { return n_.greatest(a, zero()); }

  Number value(const implicit::Sphere& s, const Place& x) const {
    return length(minus(x, place(s.center))) - n_.number(s.radius);
  }

  Number value(const implicit::Capsule& s, const Place& x) const {
    const Place along = minus(place(s.to), place(s.from)), from = minus(x, place(s.from));
    const Number share = n_.least(
        positive_part(n_.quotient(dot(from, along), squared_length(along))), n_.number(1.0));
    const Place foot = {along[0] * share, along[1] * share, along[2] * share};
    return length(minus(from, foot)) - n_.number(s.radius);
  }

  // q is the signed distance beyond the sides, by coordinate.
  Number value(const implicit::Box& s, const Place& x) const {
    const Number radius = n_.number(s.radius);
    const Place low = place(s.low), high = place(s.high);
    const auto beyond = [&](std::size_t k) {
      return n_.greatest(low[k] + radius - x[k], x[k] - high[k] + radius);
    };
    const Place q = {beyond(0), beyond(1), beyond(2)};
    const Number outside = length({positive_part(q[0]), positive_part(q[1]), positive_part(q[2])});
    const Number inside = n_.least(n_.greatest(n_.greatest(q[0], q[1]), q[2]), zero());
    return outside + inside - radius;
  }

  Number value(const implicit::Torus& s, const Place& x) const {
    const Place axis = place(s.axis), from = minus(x, place(s.center));
    const Number size = length(axis);
    const Number radial = n_.quotient(length(cross(from, axis)), size);
    const Number axial = n_.quotient(dot(from, axis), size);
    return hypotenuse(radial - n_.number(s.major), axial) - n_.number(s.minor);
  }

  // In the plane through the axis and x: the distance from a rectangle.
  Number value(const implicit::Cylinder& s, const Place& x) const {
    const Place along = minus(place(s.to), place(s.from)), from = minus(x, place(s.from));
    const Number size = length(along);
    const Number axial = n_.quotient(dot(from, along), size);
    const Number beyond_end = n_.greatest(zero() - axial, axial - size);
    const Number beyond_side = n_.quotient(length(cross(from, along)), size) - n_.number(s.radius);
    return hypotenuse(positive_part(beyond_end), positive_part(beyond_side)) +
           n_.least(n_.greatest(beyond_end, beyond_side), zero());
  }

  Number value(const implicit::Plane& s, const Place& x) const {
    const Place normal = place(s.normal);
    return n_.quotient(dot(normal, x) + n_.number(s.offset), length(normal));
  }

  Number value(const implicit::Union& s, const Place& x) const {
    Number least = (*this)(s.of[0], x);
    for (std::size_t k = 1; k < s.of.size(); ++k) least = n_.least(least, (*this)(s.of[k], x));
    return least;
  }
  Number value(const implicit::Intersection& s, const Place& x) const {
    Number most = (*this)(s.of[0], x);
    for (std::size_t k = 1; k < s.of.size(); ++k) most = n_.greatest(most, (*this)(s.of[k], x));
    return most;
  }
  Number value(const implicit::Difference& s, const Place& x) const {
    Number most = (*this)(s.of[0], x);
    for (std::size_t k = 1; k < s.of.size(); ++k) {
      most = n_.greatest(most, zero() - (*this)(s.of[k], x));
    }
    return most;
  }
  Number value(const implicit::SmoothUnion& s, const Place& x) const {
    const Number a = (*this)(s.of[0], x), b = (*this)(s.of[1], x), radius = n_.number(s.radius);
    const Number overlap = positive_part(radius - n_.magnitude(a - b));
    return n_.least(a, b) - n_.quotient(n_.square(overlap), n_.number(4.0) * radius);
  }

  Number value(const implicit::Translate& s, const Place& x) const {
    return (*this)(s.of[0], minus(x, place(s.by)));
  }
  Number rotated(const ImplicitShape& shape, const Place& x) const {
    const ImplicitRotation& back = *shape.rotation_back();
    const auto row = [&](std::size_t k) {
      return dot({n_.entry(back, k), n_.entry(back, k + 1), n_.entry(back, k + 2)}, x);
    };
    return (*this)(std::get<implicit::Rotate>(shape.node()).of[0], {row(0), row(3), row(6)});
  }
  Number value(const implicit::Scale& s, const Place& x) const {
    const Place factors = place(s.factors);
    const Place before = {n_.quotient(x[0], factors[0]), n_.quotient(x[1], factors[1]),
                          n_.quotient(x[2], factors[2])};
    return (*this)(s.of[0], before) * n_.number(s.factors.minCoeff());
  }
  Number value(const implicit::Offset& s, const Place& x) const {
    return (*this)(s.of[0], x) - n_.number(s.by);
  }

  Numbers n_;
};

}  // namespace convexact
