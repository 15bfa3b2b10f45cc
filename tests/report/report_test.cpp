// SPDX-License-Identifier: MIT
// What a report measures on small inputs: errors by their definitions, and the files' formats.
#include "lab/report/report.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "cells.hpp"
#include "convexact/measure.hpp"
#include "convexact/number.hpp"
#include "convexact/shapes.hpp"
#include "json_schema.hpp"
#include "shapes/makers.hpp"
#include "solid/solid.hpp"
#include "sweep.hpp"

using namespace convexact;

namespace {

Solid solid_of(const PointSet& points) {
  StageLog log;
  return std::get<Solid>(make_solid(points, {}, log));
}

const WayResult& way_of(const WorkPrecision& precision, const std::string& name) {
  const auto found = std::find_if(precision.ways.begin(), precision.ways.end(),
                                  [&](const WayResult& way) { return way.way == name; });
  REQUIRE(found != precision.ways.end());
  return *found;
}

Effort little() {
  Effort effort;
  effort.repetitions = 2;
  effort.budget = 20;
  return effort;
}

}  // namespace

TEST_CASE("work-precision: exact and filtered make no error, longer numbers smaller ones") {
  const Solid solid = solid_of(PointSet(shapes::in_ball(60, 3)));
  const WorkPrecision precision = measure_work_precision(solid, 4, {}, little());
  CHECK(precision.reference == "exact");
  CHECK(precision.halfspaces == solid.dual.halfspaces.size());
  REQUIRE(precision.ways.size() == 9);
  for (const char* name : {"exact", "filtered"}) {
    const WayResult& way = way_of(precision, name);
    CHECK(way.cost_worst.is_exact());
    CHECK(way.volume.value().is_exact());
    CHECK(way.outside.is_exact());
    CHECK_FALSE(way.first_other.has_value());
    CHECK(way.excess == 0);
    CHECK(way.left == 4);
  }
  double bits = 8;
  for (const char* name : {"mpfr-24", "mpfr-53", "mpfr-64", "mpfr-113", "mpfr-256", "mpfr-1024"}) {
    CAPTURE(name);
    const WayResult& way = way_of(precision, name);
    CHECK(way.cost_worst.bits > bits);
    CHECK(way.cost_worst.bits < static_cast<double>(way.bits.value()) + 4);
    CHECK_FALSE(way.cost_worst < way.cost_median);
    CHECK(way.planes.bits >= static_cast<double>(way.bits.value()));
    CHECK_FALSE(way.outside.is_exact());
    CHECK(way.seconds.value().repetitions == 2);
    bits = way.cost_worst.bits;
  }
  CHECK(way_of(precision, "mpfr-24").agrees_with_c.value());
  CHECK(way_of(precision, "mpfr-53").agrees_with_c.value());
}

TEST_CASE("work-precision: equal costs end in the choice of exact numbers (#13)") {
  const Solid solid = solid_of(
      PointSet(shapes::generate(shapes::family("cube-symmetric"),
                                shapes::usual_values(shapes::family("cube-symmetric")), 1)));
  const WorkPrecision precision = measure_work_precision(solid, 4, {"mpfr-256", "exact"}, little());
  REQUIRE(precision.ways.size() == 2);
  const WayResult& way = way_of(precision, "mpfr-256");
  CHECK_FALSE(way.first_other.has_value());
  CHECK_FALSE(way.first_wrong.has_value());
}

TEST_CASE("work-precision: the first wrong step of short numbers has a regret") {
  const Solid solid = solid_of(PointSet(shapes::fibonacci_sphere(150)));  // nearly equal costs
  const WorkPrecision precision = measure_work_precision(solid, 4, {"mpfr-24"}, little());
  const WayResult& way = way_of(precision, "mpfr-24");
  CHECK(precision.reference == "filtered");  // exact was not asked for
  REQUIRE(way.first_wrong.has_value());
  CHECK(way.first_wrong->step >= way.first_other.value());
  CHECK(way.first_wrong->regret.value() > 0);
}

TEST_CASE("work-precision: what takes longer than the budget is left out, and said") {
  Effort effort = little();
  effort.budget = 1e-9;
  const Solid solid = solid_of(PointSet(shapes::in_ball(200, 3)));
  const WorkPrecision precision = measure_work_precision(solid, 4, {"exact", "filtered"}, effort);
  CHECK(precision.reference == "filtered");
  CHECK_FALSE(way_of(precision, "exact").seconds.has_value());
}

// By the definition: every rounded plane against every vertex, in rationals.
TEST_CASE("rounded planes: how far a vertex lies outside is the worst of all pairs") {
  for (const PointSet& points :
       {PointSet(shapes::in_ball(40, 3)), PointSet(shapes::needle(30, 1e12, 1)),
        PointSet(shapes::scaled_ball(30, -900, 1)), PointSet(shapes::offset_ball(30, 1e6, 1))}) {
    const Solid solid = solid_of(points);
    const RationalPoint center = interior_point_of(solid);
    const FastDual dual = FastDual::of(solid.dual, center);
    const auto rounded = RoundedDual::of(dual, Numbers::MpfrBinary32);
    Rational worst = 0;
    for (std::size_t i = 0; i < dual.size(); ++i) {
      const RationalVector3 p = rounded->point(HalfspaceId(i));
      for (const RationalPoint& v : solid.dual.vertices) {
        const Rational beyond = p.dot(RationalVector3(v - center)) - 1;
        if (beyond > 0) worst = std::max<Rational>(worst, beyond * beyond / p.squaredNorm());
      }
    }
    const Rational squared = worst / bounding_box(solid.dual.vertices).squared_diameter();
    REQUIRE(squared > 0);
    CHECK(worst_outside(*rounded, solid.dual, center).bits == root_size(squared).bits);
  }
}

TEST_CASE("tightness curve: from all halfspaces to four, never tighter with fewer") {
  const Solid solid = solid_of(PointSet(shapes::in_ball(50, 4)));
  const TightnessCurve curve = measure_tightness_curve(solid, 4, little());
  REQUIRE(curve.points.size() > 10);
  CHECK(curve.points.front().faces == 4);
  CHECK(curve.points.back().faces == solid.dual.halfspaces.size());
  CHECK(curve.points.back().growth == 0);
  CHECK(curve.points.back().hausdorff.value() == 0);
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    CHECK(curve.points[i].growth < curve.points[i - 1].growth);
    CHECK(curve.points[i].hausdorff.value() <= curve.points[i - 1].hausdorff.value());
    CHECK(curve.points[i].seconds.least <= curve.points[i - 1].seconds.least);
  }
}

// |x| + |y| + |z| <= 1 has the volume 4/3; four of its planes, no two of which share an edge, bound
// a tetrahedron of volume 8/3.
TEST_CASE("tightness curve: the octahedron ends as a tetrahedron of twice its volume") {
  const Solid solid = solid_of(PointSet(shapes::octahedron()));
  const TightnessCurve curve = measure_tightness_curve(solid, 4, little());
  CHECK(curve.points.front().faces == 4);
  CHECK(curve.points.front().growth == doctest::Approx(1));
  // Its corner (1, 1, 1) is 2 / sqrt(3) from the facet; the box has the diameter 2 sqrt(3).
  CHECK(curve.points.front().hausdorff.value() == doctest::Approx(1.0 / 3));
}

// With 8 faces that touch one ball the area is proportional to the volume, so it doubles as well.
// The mean width is that of 12 edges of length sqrt(2) and exterior angle a = acos(1/3), then of 6
// edges of length 2 sqrt(2) and exterior angle pi - a.
TEST_CASE("tightness curve: the octahedron's area doubles, its mean width grows by (pi - a) / a") {
  const Solid solid = solid_of(PointSet(shapes::octahedron()));
  const double angle = std::acos(1.0 / 3);
  for (const CostMeasure measure : {CostMeasure::Area, CostMeasure::MeanWidth}) {
    const TightnessCurve curve = measure_tightness_curve(solid, 4, little(), measure);
    CHECK(curve.measure == measure);
    REQUIRE(curve.points.front().faces == 4);
    CHECK(
        curve.points.front().growth ==
        doctest::Approx(measure == CostMeasure::Area ? 1 : (std::acos(-1.0) - angle) / angle - 1));
    CHECK(curve.points.back().growth == 0);
  }
}

TEST_CASE("stage times: everything runs every stage, the planned run leaves stages out") {
  const Shape shape = PointSet(shapes::in_ball(80, 2));
  const std::vector<RunTimes> runs = measure_stage_times(shape, 6, little());
  REQUIRE(runs.size() == 4);
  const auto ran = [](const RunTimes& run) {
    std::set<std::string> names;
    for (const StageTime& stage : run.stages) {
      if (stage.seconds) names.insert(stage.name);
    }
    return names;
  };
  REQUIRE(runs[3].run == "everything");
  const std::set<std::string> all = ran(runs[3]);
  for (const RunTimes& run : runs) {
    CAPTURE(run.run);
    for (const StageTime& stage : run.stages) {
      if (stage.seconds) continue;
      CHECK_FALSE(stage.skipped.empty());
      // What is no stage of its own, but a part of one that ran.
      if (stage.name != "exact planes" && stage.name != "exact volume")
        CHECK(all.count(stage.name));
    }
  }
  CHECK(ran(runs[1]).size() < all.size());
}

TEST_CASE("scaling: nested subsets and spheres grow") {
  const auto subsets = nested_subsets(PointSet(shapes::in_ball(1000, 2)), 200, 1);
  REQUIRE(subsets.size() == 3);
  CHECK(subsets[0].size() == 250);
  CHECK(subsets[2].size() == 1000);
  const auto spheres = growing_spheres(10, 80, 1);
  REQUIRE(spheres.size() == 4);
  const auto series = measure_scaling(spheres, little());
  REQUIRE(series.size() == 4);
  CHECK(series[0].stage == "hull");
  CHECK(series[3].run == "exact");
  CHECK(series[3].points.back().size == 2 * 80 - 4);  // simplicial: 2n - 4 facets
}

TEST_CASE("report: the files conform, and the page carries the JSON" * sweep) {
  ReportRequest request;
  request.effort = little();
  request.families = {"needle"};
  request.sections.scaling = false;
  const Shape shape = PointSet(shapes::in_ball(24, 1));
  ReportData report;
  report.inputs.push_back(
      std::get<InputReport>(measure_input("a </script>, \"b\".obj", shape, request)));
  measure_families(report, request);
  const Json json = report_json(report, request,
                                {.version = "convexact",
                                 .commit = "unknown",
                                 .compiler = "GCC",
                                 .flags = "-O2",
                                 .machine = this_machine()});
  const auto read = nlohmann::json::parse(write_json(json));
  CHECK(schema_complaint("report", read) == "");
  CHECK(read["inputs"][0]["precision"]["commands"][0] ==
        "convexact report 'a </script>, \"b\".obj' --sections precision --faces 4 "
        "--repetitions 2 --budget 20 --seed 1");

  const std::string csv = report_csv(json);
  CHECK(csv.find("precision,\"a </script>, \"\"b\"\".obj\",,mpfr-24,seconds median,") !=
        std::string::npos);
  CHECK(csv.find("stability,needle,aspect 100,") != std::string::npos);

  const std::string page = report_page(write_json(json));
  const std::string start = "id=\"data\">";
  const std::size_t from = page.find(start) + start.size();
  const std::string carried = page.substr(from, page.find("</script>", from) - from);
  CHECK(nlohmann::json::parse(carried) == read);
}

TEST_CASE("report: parts of an L of cells, by every method" * sweep) {
  const Mesh mesh = support::mesh_of_cells({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  Effort effort = little();
  effort.budget = 600;  // no run is to be given up, however slow the machine
  const std::vector<PartsPoint> points = measure_parts_curve(mesh, effort);
  REQUIRE(points.size() == 12);
  for (const PartsPoint& point : points) {
    CAPTURE(point.limit);
    REQUIRE(point.seconds);
    REQUIRE(point.excess);
    REQUIRE(point.uncovered);
    // The middle of the notch is 1/2 from the solid, of a diameter of 3, along its diagonal.
    // Volumes are enclosures, and distances upper bounds to about a thousandth of the diameter.
    const bool is_exact = *point.excess < 1e-9;
    CHECK(is_exact == (point.parts == 2));
    CHECK(*point.distance >= (is_exact ? 0 : std::sqrt(0.5) / 3));
    CHECK(*point.distance <= (is_exact ? 0 : std::sqrt(0.5) / 3) + 0.002);
    if (point.method != DecomposeMethod::Cut) continue;
    CHECK(*point.uncovered == 0);
    CHECK(point.parts == 2);
  }

  ReportRequest request;
  request.effort = effort;
  request.sections = {false, false, false, false, false, true};
  ReportData report;
  report.inputs.push_back(
      std::get<InputReport>(measure_input("l.obj", mesh.points, request, mesh.polygons)));
  CHECK(report.inputs[0].parts.size() == 12);
  const Json json = report_json(report, request,
                                {.version = "convexact",
                                 .commit = "unknown",
                                 .compiler = "GCC",
                                 .flags = "-O2",
                                 .machine = this_machine()});
  CHECK(schema_complaint("report", nlohmann::json::parse(write_json(json))) == "");
  CHECK(report_csv(json).find("parts,l.obj,limit 0.03,cut,parts,2,1\r\n") != std::string::npos);
  // Points have no parts.
  CHECK(std::get<InputReport>(measure_input("p.obj", mesh.points, request)).parts.empty());
}

TEST_CASE("report: every swept family exists, with its parameter") {
  for (const std::string& family : breakdown_families()) {
    CAPTURE(family);
    CHECK(shapes::family(family).name == family);
  }
  CHECK_THROWS_AS((void)measure_breakdown("none", little()), Error);
}
