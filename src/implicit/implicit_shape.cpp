// SPDX-License-Identifier: MIT
// The conditions on nodes, and how the Lipschitz constant and tightness of a node follow from those
// of its parts.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "convexact/error.hpp"
#include "convexact/implicit.hpp"

namespace convexact {

struct ImplicitShape::Tree {
  implicit::Node node;
  ImplicitBounds bounds;
  std::size_t levels = 1;
  std::optional<ImplicitRotation> rotation_back;
};

namespace {

constexpr std::size_t kMostLevels = 64;

[[noreturn]] void refuse_node(const std::string& expected) {
  throw Error(ErrorCode::InvalidArgument, "expected " + expected);
}

void require_finite(std::initializer_list<double> numbers) {
  for (const double x : numbers) {
    if (!std::isfinite(x)) throw Error(ErrorCode::NotFinite, "expected finite numbers");
  }
}
void require_finite(const Point& p) { require_finite({p[0], p[1], p[2]}); }

void require_positive(const char* what, double x) {
  require_finite({x});
  if (!(x > 0)) refuse_node(fmt::format("a {} above 0, found {}", what, x));
}

void require_parts(const std::vector<ImplicitShape>& of, std::size_t least, std::size_t most) {
  if (of.size() < least || of.size() > most) {
    refuse_node(
        fmt::format("{}{} parts, found {}", least == most ? "" : "at least ", least, of.size()));
  }
}

// The entries of the matrix of a unit quaternion, transposed.
ImplicitRotation rotation_back_of(const std::array<Rational, 4>& quaternion) {
  const auto& [w, i, j, k] = quaternion;
  ImplicitRotation back{{1 - 2 * (j * j + k * k), 2 * (i * j + w * k), 2 * (i * k - w * j),
                         2 * (i * j - w * k), 1 - 2 * (i * i + k * k), 2 * (j * k + w * i),
                         2 * (i * k + w * j), 2 * (j * k - w * i), 1 - 2 * (i * i + j * j)},
                        {}};
  for (std::size_t n = 0; n < 9; ++n) {
    back.rounded[n] = {to_double(back.exact[n], Rounding::Down),
                       to_double(back.exact[n], Rounding::Up)};
  }
  return back;
}

constexpr std::size_t kAny = std::numeric_limits<std::size_t>::max();

// Refuses numbers out of the range of their node.
struct NodeCheck {
  void ends(const Point& from, const Point& to) const {
    require_finite(from);
    require_finite(to);
    if (from == to) refuse_node("two different points, found one twice");
  }
  void direction(const char* what, const Point& v) const {
    require_finite(v);
    if (v == Point::Zero()) refuse_node(fmt::format("a nonzero {}, found 0, 0, 0", what));
  }

  void operator()(const implicit::Sphere& s) const {
    require_finite(s.center);
    require_positive("radius", s.radius);
  }
  void operator()(const implicit::Capsule& s) const {
    ends(s.from, s.to);
    require_positive("radius", s.radius);
  }
  void operator()(const implicit::Cylinder& s) const {
    ends(s.from, s.to);
    require_positive("radius", s.radius);
  }
  void operator()(const implicit::Box& s) const {
    require_finite(s.low);
    require_finite(s.high);
    require_finite({s.radius});
    if (!(s.low.array() < s.high.array()).all()) refuse_node("low < high in each coordinate");
    const RationalVector3 sides = to_rational(s.high) - to_rational(s.low);
    if (s.radius < 0 || 2 * to_rational(s.radius) > sides.minCoeff()) {
      refuse_node(fmt::format("a radius from 0 to half of the shortest side, found {}", s.radius));
    }
  }
  void operator()(const implicit::Torus& s) const {
    require_finite(s.center);
    direction("axis", s.axis);
    require_positive("major radius", s.major);
    require_positive("minor radius", s.minor);
  }
  void operator()(const implicit::Plane& s) const {
    direction("normal", s.normal);
    require_finite({s.offset});
  }
  void operator()(const implicit::Union& s) const { require_parts(s.of, 1, kAny); }
  void operator()(const implicit::Intersection& s) const { require_parts(s.of, 1, kAny); }
  void operator()(const implicit::Difference& s) const { require_parts(s.of, 1, kAny); }
  void operator()(const implicit::SmoothUnion& s) const {
    require_parts(s.of, 2, 2);
    require_positive("radius", s.radius);
  }
  void operator()(const implicit::Translate& s) const {
    require_parts(s.of, 1, 1);
    require_finite(s.by);
  }
  void operator()(const implicit::Rotate& s) const {
    require_parts(s.of, 1, 1);
    Rational sum = 0;
    for (const Rational& q : s.quaternion) sum += q * q;
    if (sum != 1) {
      refuse_node("a unit quaternion, whose squares add up to 1, found the sum " +
                  to_decimal(sum, 6));
    }
  }
  void operator()(const implicit::Scale& s) const {
    require_parts(s.of, 1, 1);
    for (const double factor : s.factors) require_positive("factor", factor);
  }
  void operator()(const implicit::Offset& s) const {
    require_parts(s.of, 1, 1);
    require_finite({s.by});
  }
};

Rational greatest_lipschitz(const std::vector<ImplicitShape>& of) {
  Rational most = 0;
  for (const ImplicitShape& part : of) most = std::max(most, part.bounds().lipschitz);
  return most;
}

// The bounds of a node of valid parts; docs/implicit.md derives them.
struct NodeBounds {
  // Primitives have the distance itself, with a sign.
  template <class Primitive>
  ImplicitBounds operator()(const Primitive&) const {
    return {1, Rational(1)};
  }
  // A point outside of the union is outside of each part, and as far from the union as from the
  // nearest part.
  ImplicitBounds operator()(const implicit::Union& s) const {
    ImplicitBounds bounds{greatest_lipschitz(s.of), s.of[0].bounds().tightness};
    for (const ImplicitShape& part : s.of) {
      const std::optional<Rational>& tightness = part.bounds().tightness;
      if (!tightness) return {bounds.lipschitz, {}};
      bounds.tightness = std::min(*bounds.tightness, *tightness);
    }
    return bounds;
  }
  ImplicitBounds operator()(const implicit::Intersection& s) const {
    return {greatest_lipschitz(s.of), {}};
  }
  ImplicitBounds operator()(const implicit::Difference& s) const {
    return {greatest_lipschitz(s.of), {}};
  }
  ImplicitBounds operator()(const implicit::SmoothUnion& s) const {
    return {greatest_lipschitz(s.of), {}};
  }
  ImplicitBounds operator()(const implicit::Translate& s) const { return s.of[0].bounds(); }
  ImplicitBounds operator()(const implicit::Rotate& s) const { return s.of[0].bounds(); }
  ImplicitBounds operator()(const implicit::Scale& s) const {
    ImplicitBounds bounds = s.of[0].bounds();
    if (bounds.tightness) {
      *bounds.tightness *= to_rational(s.factors.minCoeff()) / to_rational(s.factors.maxCoeff());
    }
    return bounds;
  }
  // With L = kappa = 1, f is the distance outside, and the distance less r is the distance to the
  // set of all points within r.
  ImplicitBounds operator()(const implicit::Offset& s) const {
    ImplicitBounds bounds = s.of[0].bounds();
    const bool is_distance = bounds.lipschitz == 1 && bounds.tightness == Rational(1);
    if (s.by < 0 || !is_distance) bounds.tightness.reset();
    return bounds;
  }
};

std::size_t levels_of(const implicit::Node& node) {
  return std::visit(
      [](const auto& n) {
        std::size_t levels = 1;
        if constexpr (requires { n.of; }) {
          for (const ImplicitShape& part : n.of) levels = std::max(levels, part.levels() + 1);
        }
        return levels;
      },
      node);
}

}  // namespace

ImplicitShape::ImplicitShape(implicit::Node node) {
  std::visit(NodeCheck{}, node);
  auto tree = std::make_shared<Tree>();
  tree->levels = levels_of(node);
  if (tree->levels > kMostLevels) {
    refuse_node(fmt::format("at most {} nodes within each other", kMostLevels));
  }
  tree->bounds = std::visit(NodeBounds{}, node);
  if (const auto* rotate = std::get_if<implicit::Rotate>(&node)) {
    tree->rotation_back = rotation_back_of(rotate->quaternion);
  }
  tree->node = std::move(node);
  tree_ = std::move(tree);
}

const implicit::Node& ImplicitShape::node() const { return tree_->node; }
const ImplicitBounds& ImplicitShape::bounds() const { return tree_->bounds; }
std::size_t ImplicitShape::levels() const { return tree_->levels; }
const ImplicitRotation* ImplicitShape::rotation_back() const {
  return tree_->rotation_back ? &*tree_->rotation_back : nullptr;
}

}  // namespace convexact
