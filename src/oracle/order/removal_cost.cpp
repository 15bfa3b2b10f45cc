// SPDX-License-Identifier: MIT
#include "oracle/order/removal_cost.hpp"

#include <algorithm>

#include "convexact/dual.hpp"
#include "convexact/error.hpp"
#include "convexact/linear_program.hpp"
#include "convexact/measure.hpp"
#include "number/arithmetic.hpp"
#include "number/precision.hpp"
#include "simplify/modular_volume.hpp"

namespace convexact {
namespace {

// The pyramid from the center over a facet.
Rational cone(const Polytope& polytope, std::size_t facet, const RationalPoint& center) {
  const std::vector<std::uint32_t>& corners = polytope.facets[facet];
  const RationalVector3 first = polytope.vertices[corners[0]] - center;
  Rational six_times = 0;
  for (std::size_t k = 2; k < corners.size(); ++k) {
    const RationalVector3 second = polytope.vertices[corners[k - 1]] - center;
    const RationalVector3 third = polytope.vertices[corners[k]] - center;
    six_times += first.cross(second).dot(third);
  }
  return six_times / 6;
}

// The part that the plane of a facet cuts off from the solid without it.
struct CutOff {
  CutOff(const Polytope& with, std::size_t facet_of_it, const Polytope& without,
         const RationalPoint& inside)
      : before(with),
        facet(facet_of_it),
        after(without),
        removed(with.planes[facet_of_it]),
        center(inside) {
    for (const RationalPoint& corner : after.vertices) {
      const Rational height = removed(corner);
      beyond.push_back(height > 0);
      touching.push_back(height >= 0);
    }
  }
  /// Whether a facet with these corners of `after` has one that is in the set.
  static bool has_corner_in(const std::vector<char>& set,
                            const std::vector<std::uint32_t>& corners) {
    return std::any_of(corners.begin(), corners.end(),
                       [&](std::uint32_t v) { return set[v] != 0; });
  }

  const Polytope& before;
  std::size_t facet;  // of `before`: its base
  const Polytope& after;
  const Halfspace& removed;
  const RationalPoint& center;
  std::vector<char> beyond;    // for each corner of `after` whether it is on the cap only
  std::vector<char> touching;  // or on its base
};

// The largest |P|.|x| over the planes and the box of a cap. The box, with the center as origin,
// holds the corners beyond the plane; the points of the cap on the plane itself lie, seen from the
// center, behind these or are corners of the facet.
// @param corners  Only planes with one of these corners count.
Rational spread(const CutOff& cap, const std::vector<char>& corners) {
  const Polytope& after = cap.after;
  RationalVector3 box = RationalVector3::Zero();
  const auto include = [&box, &cap](const RationalPoint& corner) {
    for (int k = 0; k < 3; ++k) {
      const Rational reach = abs(Rational(corner[k] - cap.center[k]));
      if (reach > box[k]) box[k] = reach;
    }
  };
  for (std::size_t v = 0; v < after.vertices.size(); ++v) {
    if (cap.beyond[v]) include(after.vertices[v]);
  }
  for (const std::uint32_t v : cap.before.facets[cap.facet]) include(cap.before.vertices[v]);

  Rational largest = 0;
  const auto consider = [&box, &largest, &cap](const Halfspace& plane) {
    Rational product = 0;
    for (int k = 0; k < 3; ++k) product += abs(Rational(plane.normal()[k])) * box[k];
    product /= -plane(cap.center);
    if (product > largest) largest = product;
  };
  consider(cap.removed);
  for (std::size_t f = 0; f < after.facets.size(); ++f) {
    if (CutOff::has_corner_in(corners, after.facets[f])) consider(after.planes[f]);
  }
  return largest;
}

Enclosure root_of(const Rational& squared) { return sqrt(Enclosure(squared, kMeasureBits)); }

// tan(theta / 2) of the angle between two normals, times the sum of the planes' distances from the
// center.
Enclosure motion_at(const Halfspace& a, const Halfspace& b, const RationalPoint& center) {
  const IntegerVector3 &m = a.normal(), &n = b.normal();
  const IntegerVector3 cross = m.cross(n);
  const Rational squared_sine(dot(cross, cross)), cosine(dot(m, n));
  const Rational squared_m(dot(m, m)), squared_n(dot(n, n));
  const Enclosure sine = root_of(squared_sine), one = root_of(squared_m * squared_n),
                  projection(cosine, kMeasureBits);
  const Enclosure tangent = cosine < 0 ? (one - projection) / sine : sine / (one + projection);
  const auto distance = [&](const Halfspace& plane, const Rational& squared) {
    return Enclosure(Rational(-plane(center)), kMeasureBits) / root_of(squared);
  };
  return tangent * (distance(a, squared_m) + distance(b, squared_n));
}

// The sum over the edges of a cap of length times motion_at(); of an edge that ends on this side of
// the plane the part beyond.
Rational edge_motion(const CutOff& cap) {
  Enclosure sum(kMeasureBits);
  const auto add = [&](const Polytope& polytope, const Edge& edge, const Rational& part) {
    const RationalVector3 along = polytope.vertices[edge.head] - polytope.vertices[edge.tail];
    sum += Enclosure(part, kMeasureBits) * root_of(along.squaredNorm()) *
           motion_at(polytope.planes[edge.left], polytope.planes[edge.right], cap.center);
  };
  for (const Edge& edge : edges(cap.after)) {
    if (!cap.beyond[edge.head] && !cap.beyond[edge.tail]) continue;
    Rational high = cap.removed(cap.after.vertices[edge.head]);
    Rational low = cap.removed(cap.after.vertices[edge.tail]);
    if (high < low) std::swap(high, low);
    add(cap.after, edge, low >= 0 ? Rational(1) : Rational(high / (high - low)));
  }
  for (const Edge& edge : edges(cap.before)) {
    if (edge.left == cap.facet || edge.right == cap.facet) add(cap.before, edge, 1);
  }
  return sum.high();
}

// 2 R (1 - cos rho), see RemovalCost.
Rational support_motion(const CutOff& cap) {
  Rational farthest = 0;  // squared
  const auto include = [&](const RationalPoint& corner) {
    const Rational squared = RationalVector3(corner - cap.center).squaredNorm();
    if (squared > farthest) farthest = squared;
  };
  for (std::size_t v = 0; v < cap.after.vertices.size(); ++v) {
    if (cap.beyond[v]) include(cap.after.vertices[v]);
  }
  for (const std::uint32_t v : cap.before.facets[cap.facet]) include(cap.before.vertices[v]);
  const IntegerVector3& n = cap.removed.normal();
  Rational turn = 0;
  for (std::size_t f = 0; f < cap.after.facets.size(); ++f) {
    if (!CutOff::has_corner_in(cap.touching, cap.after.facets[f])) continue;
    const IntegerVector3& m = cap.after.planes[f].normal();
    const Enclosure cosine =
        Enclosure(dot(m, n), kMeasureBits) / root_of(Rational(Integer(dot(m, m) * dot(n, n))));
    const Rational least = cosine.low();
    turn = std::max(turn, least < 0 ? Rational(2) : Rational(1 - least));
  }
  return 2 * root_of(farthest).high() * turn;
}

// Costs that are proven to be the same number, or, for mean widths, agree in all bits that are
// compared.
bool is_same(const std::optional<Cost>& a, const std::optional<Cost>& b, const Watch& watch) {
  if (!a || !b) return a.has_value() == b.has_value();
  const Order order = compare(*a, *b, {}, watch).order;
  return order == Order::Equal || order == Order::Undecided;
}

void require(bool confirmed) {
  if (!confirmed) {
    throw Error(ErrorCode::Internal, "the cost of a removal is not what its definition says");
  }
}

Cost measure_of(std::span<const Halfspace> halfspaces, const RationalPoint& center,
                CostMeasure measure, const Watch& watch) {
  const std::optional<Polytope> polytope = intersect(halfspaces, center);
  require(polytope.has_value());
  return exact_measure(*polytope, measure, watch);
}

}  // namespace

std::optional<Polytope> intersect(std::span<const Halfspace> halfspaces,
                                  const RationalPoint& center) {
  if (std::holds_alternative<RecessionRay>(find_recession(halfspaces))) return std::nullopt;
  const DualHull dual = dual_of(halfspaces, center).dual;
  return to_polytope(dual.halfspaces, dual.triangles);
}

RemovalOracle::RemovalOracle(std::vector<Halfspace> halfspaces, const RationalPoint& center,
                             CostMeasure measure, const Watch& watch)
    : halfspaces_(std::move(halfspaces)), center_(center), measure_(measure), watch_(watch) {
  std::optional<Polytope> polytope = intersect(halfspaces_, center_);
  if (!polytope) throw Error(ErrorCode::InvalidArgument, "the solid is unbounded");
  polytope_ = std::move(*polytope);
  whole_ = exact_measure(polytope_, measure_, watch_);
}

RemovalCost RemovalOracle::without(const Halfspace& removed) const {
  const auto& planes = polytope_.planes;
  const auto found = std::find(planes.begin(), planes.end(), removed);
  if (found == planes.end()) {
    throw Error(ErrorCode::InvalidArgument, "the halfspace to remove bounds no facet");
  }
  const auto facet = static_cast<std::size_t>(found - planes.begin());
  std::vector<Halfspace> rest;
  std::copy_if(halfspaces_.begin(), halfspaces_.end(), std::back_inserter(rest),
               [&](const Halfspace& h) { return h != removed; });
  const std::optional<Polytope> after = intersect(rest, center_);
  if (!after) return {std::nullopt, 0};
  const Cost cost = difference(exact_measure(*after, measure_, watch_), whole_);
  const CutOff cap(polytope_, facet, *after, center_);
  const bool is_width = measure_ == CostMeasure::MeanWidth;
  const Rational share =
      to_rational(kPlaneRounding) * spread(cap, is_width ? cap.touching : cap.beyond);
  if (share >= 1) return {cost, std::nullopt};
  switch (measure_) {
    case CostMeasure::Volume:
      break;
    case CostMeasure::Area:
      return {cost, Rational(share * edge_motion(cap))};
    case CostMeasure::MeanWidth:
      return {cost, Rational(share * support_motion(cap))};
  }
  const Rational reach = 2 * cone(polytope_, facet, center_) + cost.rational();
  return {cost, Rational(3 * share * reach)};
}

std::vector<Halfspace> left_before(const TraceVerdict& verdict, std::size_t step) {
  std::vector<HalfspaceId> gone = verdict.left_out;
  for (std::size_t s = 0; s < step; ++s) gone.push_back(verdict.steps[s].removed);
  return left_after(verdict.halfspaces, gone);
}

void confirm_step(const TraceVerdict& verdict, const RationalPoint& center, std::size_t step,
                  const Watch& watch) {
  const std::vector<Halfspace>& halfspaces = verdict.halfspaces;
  const JudgedStep& judged = verdict.steps[step];
  const RemovalOracle oracle(left_before(verdict, step), center, verdict.measure, watch);
  const auto cost_of = [&](HalfspaceId i) { return oracle.without(halfspaces[i.index()]).cost; };
  require(is_same(cost_of(judged.removed), judged.cost, watch));
  if (judged.tie.empty()) return;
  require(is_same(cost_of(judged.tie.front()), judged.minimum, watch));
}

namespace {

// The sum of the costs is the difference, as far as 256 bits show.
bool is_sum(std::span<const JudgedStep> steps, const Cost& difference, const Watch& watch) {
  constexpr long kBits = 256;
  Enclosure sum(kBits);
  for (const JudgedStep& step : steps) sum += step.cost->enclose(kBits, watch);
  const Enclosure all = difference.enclose(kBits, watch);
  return all.low() <= sum.high() && sum.low() <= all.high();
}

}  // namespace

void confirm_sum(const TraceVerdict& verdict, const RationalPoint& center, const Watch& watch) {
  const std::vector<JudgedStep>& steps = verdict.steps;
  std::size_t bounded = 0;
  while (bounded < steps.size() && steps[bounded].cost) ++bounded;
  if (bounded == 0) return;
  const Cost before = measure_of(left_before(verdict, 0), center, verdict.measure, watch);
  const Cost after = measure_of(left_before(verdict, bounded), center, verdict.measure, watch);
  if (verdict.measure != CostMeasure::Volume) {
    require(is_sum(std::span(steps).first(bounded), difference(after, before), watch));
    return;
  }
  Random random(1);
  for (int repeat = 0; repeat < 2; ++repeat) {
    const ModularVolume modulo({}, random);
    std::uint64_t sum = modulo.residue(before.rational());
    for (std::size_t s = 0; s < bounded; ++s) {
      sum = modulo.sum(sum, modulo.residue(steps[s].cost->rational()));
    }
    require(sum == modulo.residue(after.rational()));
  }
}

// ---- Regret: by which share one cost exceeds another

const Rational& Regret::rational() const {
  if (exact() == nullptr) throw Error(ErrorCode::InvalidArgument, "a regret within an interval");
  return *exact();
}

Enclosure Regret::bounds() const {
  if (exact() != nullptr) return {*exact(), kMeasureBits};
  return std::get<Enclosure>(value_);
}

double Regret::near_double() const {
  return to_double(exact() != nullptr ? *exact() : bounds().low(), Rounding::Nearest);
}

double Regret::high_double() const {
  return exact() != nullptr ? to_double(*exact(), Rounding::Up) : bounds().high_double();
}

bool Regret::is_above(const Regret& other) const {
  if (exact() != nullptr && other.exact() != nullptr) return *exact() > *other.exact();
  return bounds().low() > other.bounds().high();
}

std::optional<Regret> relative_regret(const Cost& cost, const Cost& minimum,
                                      const CompareLimits& limits, const Watch& watch) {
  if (cost.measure() == CostMeasure::Volume && minimum.measure() == CostMeasure::Volume) {
    const Rational &paid = cost.rational(), &least = minimum.rational();
    if (paid == least) return Rational(0);
    if (least == 0) return std::nullopt;
    return Rational((paid - least) / least);
  }
  const Order order = compare(cost, minimum, limits, watch).order;
  if (order == Order::Equal) return Rational(0);
  const bool is_open = order == Order::Undecided;
  const long bits = is_open ? std::max(limits.bits, kMeasureBits) : kMeasureBits;
  const Enclosure least = minimum.enclose(bits, watch);
  if (least.sign() != Sign::Positive) return std::nullopt;
  if (is_open) return Regret((cost.enclose(bits, watch) - least) / least);
  return Regret(difference(cost, minimum).enclose(bits, watch) / least);
}

}  // namespace convexact
