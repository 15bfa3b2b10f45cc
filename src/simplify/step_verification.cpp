// SPDX-License-Identifier: MIT
// The checks of a single step, in the order of docs/verification.md.
#include "simplify/step_verification.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "simplify/plain_surface.hpp"
#include "simplify/plain_vertex.hpp"
#include "simplify/whole_dual.hpp"

namespace convexact {

struct StepVerification::State {
  State(const DualHull& input, VerifyLevel wanted, std::uint64_t seed, CostMeasure measured,
        CheckObserver* watching);

  void check_ring(const Step& step) const;
  PlainSurface checked_disk(const Step& step) const;
  void check_cap(const Step& step) const;
  void check_rim(const Step& step, const PlainSurface& disk) const;
  void replace(const Step& step);
  void check_growth(const Step& step);

  const Halfspace& plane(HalfspaceId i) const { return dual.halfspaces[i.index()]; }
  PlainVertex vertex_of(const DualTriangle& t) const {
    return plain_vertex(plane(t[0]), plane(t[1]), plane(t[2]));
  }
  void require(bool holds, const TestedCondition& check) const {
    if (observer != nullptr) observer->checked(check, holds);
    if (holds) return;
    throw Error(ErrorCode::Internal,
                "verification of step " + std::to_string(number) + " failed: " + check.name);
  }
  void require(bool holds, const char* name) const { require(holds, TestedCondition{name}); }

  const DualHull& dual;
  VerifyLevel level;
  std::size_t number = 0;  // of the step at hand, from 1
  PlainSurface surface;
  std::vector<bool> present;
  std::vector<PlainVertex> vertices;  // of the solid
  std::optional<WholeDual> whole;     // level full only
  CostMeasure measure;
  std::optional<Cost> measured;  // level full, unless the measure is the volume: of the solid
  CheckObserver* observer;
};

StepVerification::State::State(const DualHull& input, VerifyLevel wanted, std::uint64_t seed,
                               CostMeasure of_costs, CheckObserver* watching)
    : dual(input),
      level(wanted),
      surface(input.halfspaces.size(), input.triangles),
      present(input.halfspaces.size(), true),
      measure(of_costs),
      observer(watching) {
  for (const RationalPoint& v : input.vertices) vertices.push_back(plain_vertex(v));
  if (level != VerifyLevel::Full) return;
  whole.emplace(input.halfspaces, vertices, surface, seed);
  if (measure != CostMeasure::Volume) {
    measured = exact_measure(to_polytope(input.halfspaces, input.triangles), measure);
  }
}

// The cost is the measure of the solid after the step less that before, both from scratch. Areas
// are compared exactly. Mean widths only need to agree in 256 bits if no proof of equality is
// found.
void StepVerification::State::check_growth(const Step& step) {
  if (measure == CostMeasure::Volume) {
    require(whole->volume_grew_by(step.cost.value().rational(), surface),
            "the volume grew by the cost, modulo two primes");
    return;
  }
  constexpr CompareLimits kLimits{.bits = 256, .angle_basis = false};
  const Cost after = exact_measure(to_polytope(dual.halfspaces, surface.triangles()), measure);
  const std::array<Cost, 2> parts{*measured, step.cost.value()};
  const Order order = compare(after, sum_of(parts), kLimits).order;
  require(order == Order::Equal || order == Order::Undecided, "the measure grew by the cost");
  measured = after;
}

// The ring in the step is the ring of the removed dual point, turning the right way. A halfspace
// that is gone has no edge, so neither it nor a ring that names it passes. (A ring that goes around
// twice does, but then no new triangle has each corner on it once.)
void StepVerification::State::check_ring(const Step& step) const {
  const char* const name = "the ring is the one-ring of the removed dual point";
  const std::size_t k = step.ring.size();
  require(k >= 3, name);
  for (std::size_t t = 0; t < k; ++t) {
    require(surface.third(step.removed, step.ring[t]) == step.ring[(t + 1) % k], name);
  }
}

// T_i is a disk: around each ring vertex its triangles form one fan, from the ring edge that leaves
// to the one that enters, and no new edge exists elsewhere. The fans are a surface of k corners
// with the ring as its only rim, so they have k - 2 triangles or more (Euler), and there are no
// others. (A fan that closes instead comes back to the edge that leaves, which exists already.)
PlainSurface StepVerification::State::checked_disk(const Step& step) const {
  const char* const name = "the new triangles form a disk with the ring as its rim";
  const std::size_t k = step.ring.size();
  require(step.triangles.size() == k - 2, name);
  PlainSurface disk(surface.size(), {});
  for (const DualTriangle& t : step.triangles) {
    for (const HalfspaceId i : t) require(std::ranges::count(step.ring, i) == 1, name);
    (void)disk.add(t);  // one that is refused leaves a gap
  }
  for (std::size_t t = 0; t < k; ++t) {
    const HalfspaceId i = step.ring[t], enter = step.ring[(t + k - 1) % k];
    for (std::optional<HalfspaceId> next = step.ring[(t + 1) % k]; next != enter;) {
      next = disk.third(i, *next);
      require(next.has_value() && (next == enter || !surface.third(i, *next)), name);
    }
  }
  return disk;
}

// Each new vertex exists, and it is one of the cap: on or beyond the removed plane, and inside the
// other planes of the ring. So every inner edge is convex, as the plane across it is one of these.
void StepVerification::State::check_cap(const Step& step) const {
  std::vector<PlainVertex> cap;
  for (const DualTriangle& t : step.triangles) {
    cap.push_back(vertex_of(t));
    const Integer& d = cap.back().d;
    require(d > 0, {.name = "every new triangle is bounded (D > 0)",
                    .triangle = t,
                    .value = &d,
                    .wants = ">0"});
  }
  for (std::size_t n = 0; n < cap.size(); ++n) {
    const DualTriangle& t = step.triangles[n];
    const Integer beyond = value_at(cap[n], plane(step.removed));
    require(beyond >= 0, {.name = "every new cap vertex lies on or beyond the removed plane",
                          .triangle = t,
                          .plane = step.removed,
                          .value = &beyond,
                          .wants = ">=0"});
    for (const HalfspaceId j : step.ring) {
      const Integer value = value_at(cap[n], plane(j));
      require(value <= 0, {.name = "every new cap vertex lies inside the other planes of the ring",
                           .triangle = t,
                           .plane = j,
                           .value = &value,
                           .wants = "<=0"});
    }
  }
}

// Across every edge of the ring lies a dual point on or below the new triangle.
void StepVerification::State::check_rim(const Step& step, const PlainSurface& disk) const {
  for (std::size_t t = 0, k = step.ring.size(); t < k; ++t) {
    const HalfspaceId from = step.ring[t], to = step.ring[(t + 1) % k];
    const auto apex = surface.third(to, from);
    require(apex.has_value(), "every ring edge has an outside");
    const DualTriangle inner{from, to, *disk.third(from, to)};
    const Integer value = value_at(vertex_of(inner), plane(*apex));
    require(value <= 0, {.name = "every ring edge is convex",
                         .triangle = inner,
                         .plane = *apex,
                         .value = &value,
                         .wants = "<=0"});
  }
}

void StepVerification::State::replace(const Step& step) {
  const std::size_t k = step.ring.size();
  for (std::size_t t = 0; t < k; ++t) {
    surface.remove({step.removed, step.ring[t], step.ring[(t + 1) % k]});
  }
  for (const DualTriangle& t : step.triangles) {
    const bool is_new = surface.add(t);  // checked_disk() found no new edge elsewhere
    CONVEXACT_ASSERT(is_new);
  }
  present[step.removed.index()] = false;
}

StepVerification::StepVerification(const DualHull& dual, VerifyLevel level, std::uint64_t seed,
                                   CostMeasure measure, CheckObserver* observer)
    : state_(level == VerifyLevel::None
                 ? nullptr
                 : std::make_unique<State>(dual, level, seed, measure, observer)) {}
StepVerification::~StepVerification() = default;

void StepVerification::check(const Step& step) {
  if (!state_) return;
  ++state_->number;
  state_->check_ring(step);
  const PlainSurface disk = state_->checked_disk(step);
  state_->check_cap(step);
  state_->check_rim(step, disk);
  state_->replace(step);
  if (!state_->whole) return;
  state_->require(state_->whole->is_certified(state_->surface, state_->present),
                  "the whole dual is a convex hull around the origin");
  state_->check_growth(step);
}

// No step moves a plane or a vertex, so what holds of the survivors at the end held all along.
void StepVerification::finish() {
  if (!state_) return;
  for (std::size_t i = 0; i < state_->present.size(); ++i) {
    if (!state_->present[i]) continue;
    const PlainVertex& witness = state_->vertices[state_->dual.witness[i]];
    state_->require(value_at(witness, state_->dual.halfspaces[i]) == 0,
                    "every survivor touches its support witness at the end");
  }
  if (!state_->whole) return;
  state_->require(state_->whole->holds_vertices(state_->present),
                  "every survivor holds every hull vertex at the end");
  if (state_->measure != CostMeasure::Volume) return;
  state_->require(state_->whole->volume_is_sum_of_costs(state_->surface),
                  "the final volume is the first one and all costs, as rationals");
}

}  // namespace convexact
