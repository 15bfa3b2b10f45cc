// SPDX-License-Identifier: MIT
// Mutation tests of the verifier: every way of corrupting a true step is caught, by the check for
// it.
#include "simplify/step_verification.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <map>

#include "convexact/dual.hpp"
#include "convexact/error.hpp"
#include "shapes/makers.hpp"
#include "simplify/modular_volume.hpp"
#include "simplify_points.hpp"

using namespace convexact;

namespace {

// Points near a sphere: triangular facets, five or six at each vertex.
const DualHull& round_solid() {
  static const DualHull solid = dual_of_doubles(shapes::fibonacci_sphere(24));
  return solid;
}

// Its true steps down to 20 halfspaces.
const std::vector<Step>& true_steps() {
  static const std::vector<Step> steps =
      simplify_exact(round_solid(), center_of(round_solid()), {.faces = 20}).steps;
  return steps;
}

// The message of the verifier on a run whose first step with a ring of at least `valence` is
// corrupted; "" if it found nothing.
std::string verdict(VerifyLevel level, std::size_t valence,
                    const std::function<void(Step&)>& corrupt) {
  StepVerification verification(round_solid(), level);
  for (Step step : true_steps()) {
    const bool here = step.ring.size() >= valence;
    if (here) corrupt(step);
    try {
      verification.check(step);
    } catch (const Error& error) {
      CHECK(error.code() == ErrorCode::Internal);
      CHECK(here);
      return error.what();
    }
    if (here) break;
  }
  return "";
}

void check_caught(const std::string& check, const std::function<void(Step&)>& corrupt) {
  CAPTURE(check);
  for (const VerifyLevel level : {VerifyLevel::Local, VerifyLevel::Full}) {
    const std::string message = verdict(level, 5, corrupt);
    CAPTURE(message);
    CHECK(message.find("verification of step") == 0);
    CHECK(message.find(check) != std::string::npos);
  }
}

const std::string kRing = "the ring is the one-ring of the removed dual point";
const std::string kDisk = "the new triangles form a disk with the ring as its rim";

}  // namespace

TEST_CASE("StepVerification: true steps pass at every level") {
  for (const VerifyLevel level : {VerifyLevel::None, VerifyLevel::Local, VerifyLevel::Full}) {
    CHECK(verdict(level, 5, [](Step&) {}).empty());
  }
}

TEST_CASE("StepVerification: a wrong ring") {
  check_caught(kRing, [](Step& s) { std::swap(s.ring[0], s.ring[1]); });
  check_caught(kRing, [](Step& s) { std::reverse(s.ring.begin(), s.ring.end()); });
  check_caught(kRing, [](Step& s) { s.ring.pop_back(); });
  check_caught(kRing, [](Step& s) { s.ring.clear(); });
  check_caught(kRing, [](Step& s) { s.ring[2] = HalfspaceId(99999); });
  check_caught(kRing, [](Step& s) { s.removed = s.ring[0]; });
}

TEST_CASE("StepVerification: triangles that are no disk") {
  check_caught(kDisk, [](Step& s) { s.triangles.pop_back(); });
  check_caught(kDisk, [](Step& s) { s.triangles.back() = s.triangles.front(); });
  check_caught(kDisk, [](Step& s) { s.triangles.push_back(s.triangles.front()); });
  check_caught(kDisk, [](Step& s) { std::swap(s.triangles[0][0], s.triangles[0][1]); });
  check_caught(kDisk, [](Step& s) { s.triangles[0][0] = s.removed; });
}

TEST_CASE("StepVerification: a disk that is not the hull") {
  // A fan from any one corner is a disk with the right rim; the ring of five has a single right
  // triangulation, and at most one of the five fans is it.
  const auto fan_from = [](std::size_t apex) {
    return [apex](Step& s) {
      const std::size_t k = s.ring.size();
      for (std::size_t t = 0; t < k - 2; ++t) {
        s.triangles[t] = {s.ring[apex % k], s.ring[(apex + t + 1) % k], s.ring[(apex + t + 2) % k]};
      }
    };
  };
  std::size_t caught = 0, convex = 0;
  for (std::size_t apex = 0; apex < 5; ++apex) {
    const std::string message = verdict(VerifyLevel::Local, 5, fan_from(apex));
    caught += !message.empty();
    convex += message.find("inside the other planes of the ring") != std::string::npos;
  }
  CHECK(caught >= 4);
  CHECK(convex >= 1);
}

namespace {

// Every triangulation of the polygon that the ring positions first, ..., last make.
std::vector<std::vector<DualTriangle>> triangulations(const std::vector<HalfspaceId>& ring,
                                                      std::size_t first, std::size_t last) {
  if (last - first < 2) return {{}};
  std::vector<std::vector<DualTriangle>> all;
  for (std::size_t apex = first + 1; apex < last; ++apex) {
    for (const auto& low : triangulations(ring, first, apex)) {
      for (const auto& high : triangulations(ring, apex, last)) {
        all.push_back(low);
        all.back().insert(all.back().end(), high.begin(), high.end());
        all.back().push_back({ring[first], ring[apex], ring[last]});
      }
    }
  }
  return all;
}

}  // namespace

namespace {

// Planes that touch a sphere in random points: no four of them meet.
DualHull simple_solid() {
  std::vector<Halfspace> planes;
  for (const Point& p : shapes::on_sphere(18, 6)) planes.emplace_back(to_rational(p), Rational(-1));
  return dual_of(planes, RationalPoint::Zero()).dual;
}

// How often each check was the first to refuse a triangulation of a ring; "" accepted it.
using Refusals = std::map<std::string, std::size_t>;

Refusals refusals(const DualHull& solid, std::span<const Step> before, Step step) {
  Refusals found;
  for (const auto& triangles : triangulations(step.ring, 0, step.ring.size() - 1)) {
    StepVerification verification(solid, VerifyLevel::Local);
    for (const Step& earlier : before) verification.check(earlier);
    step.triangles = triangles;
    try {
      verification.check(step);
      ++found[""];
    } catch (const Error& error) {
      const std::string message = error.what();
      ++found[message.substr(message.find("failed: ") + 8)];
    }
  }
  return found;
}

}  // namespace

TEST_CASE("StepVerification: of all triangulations of a ring the right one is accepted") {
  const DualHull solid = simple_solid();
  const auto steps = simplify_exact(solid, center_of(solid)).steps;
  Refusals all;
  for (std::size_t at = 0; at < steps.size(); ++at) {
    if (steps[at].ring.size() > 7) continue;
    Refusals found = refusals(solid, std::span(steps).first(at), steps[at]);
    CHECK(found[""] == 1);
    for (const auto& [check, count] : found) all[check] += count;
  }
  CHECK(all["every new triangle is bounded (D > 0)"] > 0);
  CHECK(all["every new cap vertex lies inside the other planes of the ring"] > 0);
}

// On a convex surface these two hold by themselves: seen from a vertex, its ring turns one way.
TEST_CASE(
    "StepVerification: on a surface with a dent, checks refuse that convexity makes needless") {
  const DualHull solid = simple_solid();
  Refusals all;
  AdjacencyMatrix dual(solid.halfspaces.size());
  for (const DualTriangle& t : solid.triangles) dual.add(t);
  for (const auto& [a, b, c] : solid.triangles) {
    const HalfspaceId d = *dual.at(b, a);
    if (dual.at(c, d)) continue;
    AdjacencyMatrix turned = dual;
    turned.remove({a, b, c});
    turned.remove({b, a, d});
    turned.add({a, d, c});
    turned.add({d, b, c});
    DualHull dented = solid;
    dented.triangles = turned.triangles();
    for (const HalfspaceId i : {a, b, c, d}) {
      Step step{i, Rational(0), {}, turned.one_ring(i), {}, 0};
      if (step.ring.size() < 3 || step.ring.size() > 7) continue;
      for (const auto& [check, count] : refusals(dented, {}, step)) all[check] += count;
    }
  }
  CHECK(all["every new cap vertex lies on or beyond the removed plane"] > 0);
  CHECK(all["every ring edge is convex"] > 0);
}

TEST_CASE("StepVerification: a removal that opens a gap (D <= 0)") {
  // The top of a prism: its sides never meet. Its fan is a disk below the top.
  const DualHull prism = dual_of_doubles(shapes::prism(5));
  StepVerification verification(prism, VerifyLevel::Local);
  const auto top =
      std::find_if(prism.halfspaces.begin(), prism.halfspaces.end(), [](const Halfspace& h) {
        return h.normal()[0] == 0 && h.normal()[1] == 0 && h.normal()[2] > 0;
      });
  REQUIRE(top != prism.halfspaces.end());
  AdjacencyMatrix dual(prism.halfspaces.size());
  for (const DualTriangle& t : prism.triangles) dual.add(t);
  Step step;
  step.removed = HalfspaceId(top - prism.halfspaces.begin());
  step.ring = dual.one_ring(step.removed);
  for (std::size_t t = 2; t < step.ring.size(); ++t) {
    step.triangles.push_back({step.ring[0], step.ring[t - 1], step.ring[t]});
  }
  CHECK_THROWS_WITH_AS(verification.check(step), doctest::Contains("bounded (D > 0)"), Error);
}

TEST_CASE("StepVerification: a wrong cost shows in the volume, at level full") {
  const auto wrong = [](Step& s) {
    s.cost = s.cost->rational() + scale_by_power_of_two(Rational(1), -300);
  };
  CHECK(verdict(VerifyLevel::Full, 5, wrong).find("the volume grew by the cost") !=
        std::string::npos);
  CHECK(verdict(VerifyLevel::Local, 5, wrong).empty());  // local proves the step, not its price
}

TEST_CASE("StepVerification: a wrong cost shows in the area and in the mean width, at level full") {
  const Rational little = scale_by_power_of_two(Rational(1), -200);
  for (const CostMeasure measure : {CostMeasure::Area, CostMeasure::MeanWidth}) {
    CAPTURE(static_cast<int>(measure));
    const Run run = simplify_exact(round_solid(), center_of(round_solid()),
                                   {.faces = 40, .cost = measure, .verify = VerifyLevel::None});
    REQUIRE(run.steps.size() >= 2);
    StepVerification right(round_solid(), VerifyLevel::Full, 1, measure);
    for (const Step& step : run.steps) CHECK_NOTHROW(right.check(step));
    for (const Rational& error : {little, Rational(-little)}) {
      StepVerification verification(round_solid(), VerifyLevel::Full, 1, measure);
      verification.check(run.steps[0]);
      Step step = run.steps[1];
      step.cost = measure == CostMeasure::Area
                      ? Cost(step.cost->area() + RootSum(error))
                      : Cost(AngleSum(step.cost->angles()) += AngleSum::pi(error));
      CHECK_THROWS_WITH_AS(verification.check(step), doctest::Contains("grew by the cost"), Error);
    }
  }
}

// Both residues are blind to a multiple of both primes; the rationals at the end are not.
TEST_CASE(
    "StepVerification: a cost that two primes cannot tell from the true one is found at the end") {
  constexpr std::uint64_t seed = 5;
  Random random(seed);
  Integer both = 1;
  for (int prime = 0; prime < 2; ++prime) {
    both *= Integer(ModularVolume({}, random).residue(Rational(-1))) + 1;
  }
  for (const bool is_wrong : {false, true}) {
    StepVerification verification(round_solid(), VerifyLevel::Full, seed);
    for (Step step : true_steps()) {
      if (is_wrong && step.left == true_steps()[0].left) step.cost = step.cost->rational() + both;
      verification.check(step);
    }
    if (is_wrong) {
      CHECK_THROWS_WITH_AS(verification.finish(), doctest::Contains("the final volume is"), Error);
    } else {
      CHECK_NOTHROW(verification.finish());
    }
  }
}

TEST_CASE("StepVerification: a witness that does not touch its plane is found at the end") {
  DualHull solid = round_solid();
  const std::vector<Step>& steps = true_steps();
  const auto misplace = [&](HalfspaceId i) {
    const Halfspace& plane = solid.halfspaces[i.index()];
    for (std::uint32_t v = 0; v < solid.vertices.size(); ++v) {
      if (plane(solid.vertices[v]) != 0) solid.witness[i.index()] = v;
    }
  };
  misplace(steps.front().removed);  // which is gone then
  for (const bool survives : {false, true}) {
    if (survives) misplace(steps.front().ring.front());
    StepVerification verification(solid, VerifyLevel::Local);
    verification.check(steps.front());
    if (survives) {
      CHECK_THROWS_WITH_AS(verification.finish(), doctest::Contains("its support witness"), Error);
    } else {
      CHECK_NOTHROW(verification.finish());
    }
  }
}

TEST_CASE("StepVerification: what only one condition on rings and disks refuses") {
  // A ring of two: both triangles of a degenerate dual, with nothing to fill it.
  DualHull solid = round_solid();
  const HalfspaceId i(0), a(1), b(2);
  solid.triangles = {{i, a, b}, {i, b, a}};
  StepVerification two(solid, VerifyLevel::Local);
  CHECK_THROWS_WITH_AS(two.check({i, {}, {}, {a, b}, {}, 0}), doctest::Contains(kRing.c_str()),
                       Error);
  // A corner that is no halfspace at all, or none of the ring.
  check_caught(kDisk, [](Step& s) { s.triangles[0][1] = HalfspaceId(99999); });
  check_caught(kDisk, [](Step& s) { s.triangles[0][1] = HalfspaceId(100000000); });
  // A ring that goes around twice, with as many triangles as it would take.
  check_caught(kDisk, [](Step& s) {
    s.ring.insert(s.ring.end(), s.ring.begin(), s.ring.end());
    while (s.triangles.size() + 2 < s.ring.size()) s.triangles.push_back(s.triangles.front());
  });
  // Three triangles that close around a ring vertex: its fan never comes to the ring's other side.
  check_caught(kDisk, [](Step& s) {
    const auto& r = s.ring;
    s.triangles = {{r[0], r[1], r[2]}, {r[0], r[2], r[3]}, {r[0], r[3], r[1]}};
    for (std::size_t t = 3; t + 2 < r.size(); ++t) s.triangles.push_back({r[t], r[t + 1], r[1]});
  });
  // The right fans, and one of their triangles once more.
  check_caught(kDisk, [](Step& s) { s.triangles.push_back(s.triangles.front()); });
}

TEST_CASE("StepVerification: a dual that ends at the ring") {
  // Without the triangle outside of a ring edge.
  DualHull solid = round_solid();
  const Step& step = true_steps().front();
  const HalfspaceId from = step.ring[0], to = step.ring[1];
  std::erase_if(solid.triangles, [&](const DualTriangle& t) {
    return std::ranges::count(t, from) == 1 && std::ranges::count(t, to) == 1 &&
           std::ranges::count(t, step.removed) == 0;
  });
  REQUIRE(solid.triangles.size() + 1 == round_solid().triangles.size());
  StepVerification verification(solid, VerifyLevel::Local);
  CHECK_THROWS_WITH_AS(verification.check(step), doctest::Contains("has an outside"), Error);
}

TEST_CASE("StepVerification: an input point outside a survivor is found at the end") {
  // A vertex of the first step's cap: only the halfspace that the step removes leaves it out.
  DualHull solid = round_solid();
  const Step& step = true_steps().front();
  const auto& planes = solid.halfspaces;
  for (const auto& [a, b, c] : step.triangles) {
    const RationalPoint vertex = meet(planes[a.index()], planes[b.index()], planes[c.index()]);
    if (planes[step.removed.index()](vertex) > 0) solid.vertices.push_back(vertex);
  }
  REQUIRE(solid.vertices.size() > round_solid().vertices.size());
  StepVerification before(solid, VerifyLevel::Full);
  CHECK_THROWS_WITH_AS(before.finish(), doctest::Contains("holds every hull vertex at the end"),
                       Error);
  StepVerification after(solid, VerifyLevel::Full);
  after.check(step);
  CHECK_NOTHROW(after.finish());
}

TEST_CASE("StepVerification: a witness of an untouched halfspace is asked at the end") {
  DualHull solid = round_solid();
  for (std::uint32_t v = 0; v < solid.vertices.size(); ++v) {
    if (solid.halfspaces[0](solid.vertices[v]) != 0) solid.witness[0] = v;
  }
  StepVerification verification(solid, VerifyLevel::Local);
  CHECK_THROWS_WITH_AS(verification.finish(), doctest::Contains("touches its support witness"),
                       Error);
}

TEST_CASE("StepVerification: a dual that is no hull from the start") {
  // Two neighbouring triangles with the edge between them turned: a surface, but not convex.
  DualHull solid = round_solid();
  const std::vector<Step>& steps = true_steps();
  AdjacencyMatrix dual(solid.halfspaces.size());
  for (const DualTriangle& t : solid.triangles) dual.add(t);
  const auto untouched = [&](HalfspaceId i) {
    const Step& s = steps.front();
    return i != s.removed && std::find(s.ring.begin(), s.ring.end(), i) == s.ring.end();
  };
  for (const DualTriangle& t : solid.triangles) {
    const auto [a, b, c] = t;
    const HalfspaceId d = *dual.at(b, a);
    if (!untouched(a) || !untouched(b) || !untouched(c) || !untouched(d)) continue;
    if (dual.at(c, d)) continue;
    const auto& h = solid.halfspaces;
    if (h[d.index()](meet(h[a.index()], h[b.index()], h[c.index()])) == 0) continue;  // level
    dual.remove(t);
    dual.remove({b, a, d});
    dual.add({a, d, c});
    dual.add({d, b, c});
    break;
  }
  solid.triangles = dual.triangles();
  StepVerification local(solid, VerifyLevel::Local);
  CHECK_NOTHROW(local.check(steps.front()));
  StepVerification full(solid, VerifyLevel::Full);
  CHECK_THROWS_WITH_AS(full.check(steps.front()), doctest::Contains("the whole dual"), Error);
}
