// SPDX-License-Identifier: MIT
// simplify_inner: the proofs of a result, known meshes, and what is refused.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <numeric>

#include "convexact/io.hpp"
#include "convexact/simplify.hpp"
#include "expect_error.hpp"
#include "inner_runs.hpp"
#include "number/random.hpp"
#include "shapes/makers.hpp"
#include "shipped_meshes.hpp"

using namespace convexact;

namespace {

InnerResult inner(const PointSet& points, const InnerRequest& request) {
  return std::get<InnerResult>(simplify_inner(points, request));
}

// In the folders of CONVEXACT_MESHES and in tests/data; empty if there is none.
std::string find_mesh(const std::string& name) {
  std::string folders = std::string(std::getenv("CONVEXACT_TEST_DATA")) + ":";
  if (const char* more = std::getenv("CONVEXACT_MESHES")) folders += std::string(more) + ":";
  for (std::size_t at = 0; at < folders.size(); at = folders.find(':', at) + 1) {
    const std::filesystem::path path =
        std::filesystem::path(folders.substr(at, folders.find(':', at) - at)) / (name + ".obj");
    if (std::filesystem::exists(path)) return path.string();
  }
  return {};
}

constexpr std::array<std::size_t, 7> kCounts{100, 50, 32, 18, 12, 8, 4};

// The shares of the volume that are left with so many vertices; 0 where the hull has fewer.
std::array<double, 7> shares(const VertexHull& start) {
  const Rational whole = inner_runs::volume_of(start.points);
  const InnerRun run = with_costs(start, simplify_inner_filtered(start));
  std::array<double, 7> found{};
  Rational left = whole;
  for (const Step& step : run.steps) {
    left -= step.cost->rational();
    const auto place = std::find(kCounts.begin(), kCounts.end(), step.left);
    if (place == kCounts.end()) continue;
    found[static_cast<std::size_t>(place - kCounts.begin())] =
        to_double(left / whole, Rounding::Nearest);
  }
  return found;
}

// The same hull with its vertices in another order, and so with other choices among ties.
VertexHull reordered(const VertexHull& start, Random& random) {
  std::vector<std::uint32_t> place(start.ids.size());
  std::iota(place.begin(), place.end(), 0u);
  shuffle(std::span(place), random);
  VertexHull other = start;
  std::vector<PointId> order(place.size());
  for (std::uint32_t v = 0; v < place.size(); ++v) {
    other.ids[place[v]] = start.ids[v];
    order[place[v]] = PointId(v);
  }
  other.points = subset(start.points, order);
  for (VertexTriangle& t : other.triangles) {
    for (VertexId& v : t) v = VertexId(place[v.index()]);
  }
  return other;
}

constexpr double kHalfUnit = 0.5e-5 + 1e-9;

}  // namespace

TEST_CASE("simplify_inner: meshes without ties against a prototype in another language") {
  // Shares of the volume to five decimals, by runs in rationals; 0: not compared. Rings, hulls and
  // costs of that program share nothing with ours.
  const std::map<std::string, std::array<double, 7>> expected{
      {"homer", {.99629, .98316, .95937, .90015, .79283, .61226, .23041}},
      {"fandisk", {.99998, .99983, .99897, .98564, .93226, .81822, .26896}},
      {"suzanne", {0, 0, .97975, .92226, .80900, .61217, .24464}},
      {"spot", {.99593, .98070, .95115, .88549, 0, .65015, .20370}}};
  for (const auto& each : expected) {
    const std::string path = find_mesh(each.first);
    if (path.empty()) {
      MESSAGE("skipped, no such mesh: ", each.first);
      continue;
    }
    CAPTURE(path);
    const PointSet points = read_mesh(path).points;
    const std::array<double, 7> found = shares(inner_runs::start_of(points).value());
    for (std::size_t k = 0; k < kCounts.size(); ++k) {
      CAPTURE(kCounts[k]);
      if (each.second[k] != 0) CHECK(std::abs(found[k] - each.second[k]) <= kHalfUnit);
    }
  }
}

TEST_CASE("simplify_inner: where mirror images tie, the prototype's values are of another order") {
  // Which of several equal vertices goes first decides later costs. The prototype took ties by its
  // own index; its values must be among those of some order.
  struct Tied {
    std::string mesh;
    std::size_t vertices;
    double share;
  };
  const std::vector<Tied> expected{{"spot", 12, .79157}, {"cow", 100, .99987}, {"cow", 50, .99559},
                                   {"cow", 32, .98351},  {"cow", 18, .95027},  {"cow", 12, .88055}};
  for (const Tied& tied : expected) {
    CAPTURE(tied.mesh);
    CAPTURE(tied.vertices);
    const std::string path = find_mesh(tied.mesh);
    if (path.empty()) {
      MESSAGE("skipped, no such mesh: ", tied.mesh);
      continue;
    }
    const VertexHull start = inner_runs::start_of(read_mesh(path).points).value();
    const auto place = static_cast<std::size_t>(
        std::find(kCounts.begin(), kCounts.end(), tied.vertices) - kCounts.begin());
    Random random(1);
    bool is_found = false;
    for (int trial = 0; trial < 40 && !is_found; ++trial) {
      is_found = std::abs(shares(reordered(start, random))[place] - tied.share) <= kHalfUnit;
    }
    CHECK(is_found);
  }
  // The teapot has ties in half of its steps, and hundreds of ends: its values only lie among them.
  const std::array<double, 7> teapot{.98171, .95324, .91061, .82269, .71085, .55627, .18330};
  const VertexHull start = inner_runs::start_of(read_mesh(find_mesh("teapot")).points).value();
  std::array<double, 7> least, most{};
  least.fill(1);
  Random random(1);
  for (int trial = 0; trial < 30; ++trial) {
    const std::array<double, 7> found = shares(reordered(start, random));
    for (std::size_t k = 0; k < 7; ++k) {
      least[k] = std::min(least[k], found[k]);
      most[k] = std::max(most[k], found[k]);
    }
  }
  for (std::size_t k = 0; k < 7; ++k) {
    CAPTURE(kCounts[k]);
    CHECK(least[k] - 1e-3 <= teapot[k]);
    CHECK(teapot[k] <= most[k] + 1e-3);
  }
}

TEST_CASE("simplify_inner: a result of input points, with its volumes and its mesh") {
  for (const Engine engine : {Engine::Exact, Engine::Filtered}) {
    for (const VerifyLevel level : {VerifyLevel::None, VerifyLevel::Local, VerifyLevel::Full}) {
      const PointSet points(shapes::in_ball(200, 3));
      const InnerResult result =
          inner(points, {.vertices = 20, .engine = engine, .verify = level, .mesh = true});
      CHECK(result.kept.size() == 20);
      CHECK(result.run.triangles.size() == 36);
      CHECK(std::is_sorted(result.kept.begin(), result.kept.end()));
      CHECK(result.input_volume.exact == inner_runs::volume_of(points));
      CHECK(result.output_volume.exact == inner_runs::volume_of(subset(points, result.kept)));
      CHECK(result.mesh->points.size() == 20);
      for (std::size_t k = 0; k < 20; ++k) {
        CHECK(result.mesh->points.doubles()[k] == points.doubles()[result.kept[k].index()]);
      }
    }
  }
}

TEST_CASE("simplify_inner: exact costs only where they are asked for, and then of all steps") {
  const PointSet points(shapes::in_ball(100, 5));
  const auto lost = [](const InnerResult& result) {
    Rational sum = 0;
    for (const Step& step : result.run.steps) sum += step.cost.value().rational();
    return sum;
  };
  for (const InnerRequest& request : {InnerRequest{.vertices = 8, .costs = true},
                                      InnerRequest{.vertices = 8, .engine = Engine::Exact},
                                      InnerRequest{.vertices = 8, .verify = VerifyLevel::Full}}) {
    const InnerResult result = inner(points, request);
    CHECK(lost(result) == *result.input_volume.exact - *result.output_volume.exact);
  }
  const InnerResult lean = inner(points, {.vertices = 8});
  for (const Step& step : lean.run.steps) CHECK_FALSE(step.cost.has_value());
  CHECK(std::any_of(lean.stages.begin(), lean.stages.end(), [](const Stage& stage) {
    return stage.name == "costs" && !stage.skipped.empty();
  }));
}

TEST_CASE("simplify_inner: the loss limit, and both limits together") {
  const PointSet points(shapes::on_sphere(60, 9));
  const InnerResult limited = inner(points, {.max_loss = Rational(1, 10)});
  CHECK(limited.run.stop == InnerStop::LossLimit);
  CHECK(*limited.output_volume.exact * 10 >= *limited.input_volume.exact * 9);
  const InnerResult next = inner(points, {.vertices = limited.kept.size() - 1});
  CHECK(*next.output_volume.exact * 10 < *next.input_volume.exact * 9);
  const InnerResult both =
      inner(points, {.vertices = limited.kept.size() + 3, .max_loss = Rational(1, 10)});
  CHECK(both.run.stop == InnerStop::Reached);
  CHECK(both.kept.size() == limited.kept.size() + 3);
}

TEST_CASE("simplify_inner: what is refused") {
  const PointSet points(shapes::cube());
  for (const InnerRequest& request :
       {InnerRequest{}, InnerRequest{.vertices = 3}, InnerRequest{.max_loss = Rational(-1)},
        InnerRequest{.vertices = 5, .engine = Engine::Float}}) {
    CHECK(error_of([&] { return simplify_inner(points, request); }).code() ==
          ErrorCode::InvalidArgument);
  }
  CHECK(std::holds_alternative<NotSolid>(
      simplify_inner(PointSet(shapes::coplanar(9, 1)), {.vertices = 4})));
  // Thirds are no doubles: the planes are exact, a mesh would not be.
  std::vector<RationalPoint> thirds;
  for (const Point& p : shapes::cube()) thirds.push_back(to_rational(p) / Rational(3));
  const PointSet rational(thirds);
  CHECK(inner(rational, {.vertices = 6}).kept.size() == 6);
  CHECK(error_of([&] { return simplify_inner(rational, {.vertices = 6, .mesh = true}); }).code() ==
        ErrorCode::Unrepresentable);
}
