// SPDX-License-Identifier: MIT
// Where each arithmetic breaks down: families of shapes, swept.
#include <algorithm>

#include "convexact/shapes.hpp"
#include "report/work_precision.hpp"
#include "scene/solid.hpp"

namespace convexact {
namespace {

// The parameter of a family that makes it stiff, and the values to measure.
struct SweptFamily {
  const char* family;
  const char* parameter;
  std::vector<double> values;  // from tame to extreme
};

const std::vector<SweptFamily>& sweeps() {
  static const std::vector<SweptFamily> list = {
      {"needle", "aspect", {1, 1e2, 1e4, 1e6, 1e8, 1e10, 1e12, 1e14, 1e16, 1e20, 1e40, 1e300}},
      {"slab", "aspect", {1, 1e2, 1e4, 1e6, 1e8, 1e10, 1e12, 1e14, 1e16, 1e20, 1e40, 1e300}},
      {"tilted-lid",
       "tilt",
       {1, 0x1p-4, 0x1p-8, 0x1p-12, 0x1p-16, 0x1p-20, 0x1p-24, 0x1p-28, 0x1p-32, 0x1p-40, 0x1p-46,
        0x1p-52}},
      {"nearly-flat",
       "ulps",
       {0x1p48, 0x1p40, 0x1p32, 0x1p28, 0x1p24, 0x1p20, 0x1p16, 0x1p12, 0x1p8, 0x1p4, 1}},
      {"offset-ball", "distance", {1, 1e1, 1e2, 1e4, 1e6, 1e8, 1e10, 1e12, 1e13, 1e14, 1e15}},
      {"cone", "k", {8, 16, 32, 64, 128, 256, 512}},
      {"scaled-ball", "exponent", {-1000, -750, -500, -250, -100, 0, 100, 250, 500, 750, 1000}},
      {"wide-exponents", "exponent", {0, 2, 5, 10, 20, 50, 100, 200, 500, 1000}},
      {"mixed-scales", "exponent", {0, 5, 10, 15, 20, 25, 30, 50, 100, 200, 500}}};
  return list;
}

const SweptFamily& sweep_of(const std::string& family) {
  for (const SweptFamily& sweep : sweeps()) {
    if (family == sweep.family) return sweep;
  }
  throw Error(ErrorCode::InvalidArgument, "no sweep of a family named '" + family + "'");
}

PointSet points_of(const SweptFamily& sweep, double value, std::uint64_t seed) {
  const shapes::Family& family = shapes::family(sweep.family);
  std::vector<double> values = shapes::usual_values(family);
  for (std::size_t i = 0; i < family.parameters.size(); ++i) {
    if (family.parameters[i].name == sweep.parameter) values[i] = value;
  }
  return PointSet(shapes::generate(family, values, seed));
}

}  // namespace

std::vector<std::string> breakdown_families() {
  std::vector<std::string> names;
  for (const SweptFamily& sweep : sweeps()) names.emplace_back(sweep.family);
  return names;
}

Breakdown measure_breakdown(const std::string& family, const Effort& effort) {
  const SweptFamily& sweep = sweep_of(family);
  Breakdown result;
  result.family = sweep.family;
  result.parameter = sweep.parameter;
  Effort quiet = effort;
  quiet.progress = {};
  for (const double value : sweep.values) {
    if (effort.progress) {
      effort.progress("stability of " + family + " at " + std::to_string(value));
    }
    BreakdownPoint& point = result.points.emplace_back();
    point.value = value;
    StageLog log;
    const SolidOutcome outcome =
        make_solid(points_of(sweep, value, effort.seed), effort.seed, true, log);
    if (const auto* reason = std::get_if<NotSolid>(&outcome)) {
      point.why_not = describe(*reason);
      continue;
    }
    point.precision = measure_work_precision(std::get<Solid>(outcome), 4, {}, quiet);
  }
  return result;
}

}  // namespace convexact
