// SPDX-License-Identifier: MIT
// The shipped meshes by area and by mean width. Expected ratios of the result to the hull are those
// of a run from the definition with costs of 50 digits, in another language, to five decimals.
#include <doctest/doctest.h>

#include <string>

#include "convexact/io.hpp"
#include "convexact/simplify.hpp"
#include "shipped_meshes.hpp"

using namespace convexact;

namespace {

struct Expected {
  const char* mesh;
  CostMeasure cost;
  std::size_t faces;
  double volume, measure;
};

constexpr Expected kExpected[] = {
    {"spot", CostMeasure::Area, 18, 1.02790, 1.05370},
    {"spot", CostMeasure::Area, 12, 1.06271, 1.10593},
    {"spot", CostMeasure::Area, 6, 1.52433, 1.67626},
    {"spot", CostMeasure::MeanWidth, 18, 1.04007, 1.03271},
    {"spot", CostMeasure::MeanWidth, 12, 1.07126, 1.06086},
    {"spot", CostMeasure::MeanWidth, 6, 1.56923, 1.43274},
    {"teapot", CostMeasure::Area, 18, 1.07973, 1.09103},
    {"teapot", CostMeasure::Area, 6, 1.64480, 1.65257},
    {"teapot", CostMeasure::MeanWidth, 18, 1.11556, 1.05709},
    {"teapot", CostMeasure::MeanWidth, 6, 1.71389, 1.39038},
    {"bunny", CostMeasure::Area, 18, 1.05016, 1.06599},
    {"bunny", CostMeasure::MeanWidth, 6, 1.72207, 1.33401},
};

double ratio(const Enclosure& before, const Enclosure& after) {
  return (after / before).low().convert_to<double>();
}

}  // namespace

TEST_CASE("simplify: the shipped meshes by area and by mean width, as from the definition") {
  for (const std::string& path : shipped_meshes()) {
    const Shape shape = read_mesh(path).points;
    for (const Expected& expected : kExpected) {
      if (path.find(expected.mesh) == std::string::npos) continue;
      CAPTURE(expected.mesh);
      CAPTURE(expected.faces);
      CAPTURE(static_cast<int>(expected.cost));
      SimplifyRequest request;
      request.faces = expected.faces;
      request.cost = expected.cost;
      request.verify = VerifyLevel::None;
      const auto outcome = simplify(shape, request);
      const auto& result = std::get<SimplifyResult>(outcome);
      const auto& [before, after] = result.measure.value();
      CHECK(ratio(before, after) == doctest::Approx(expected.measure).epsilon(6e-6));
      CHECK(ratio(result.input_volume.bounds, result.output_volume.bounds) ==
            doctest::Approx(expected.volume).epsilon(6e-6));
    }
  }
}
