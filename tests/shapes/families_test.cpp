// SPDX-License-Identifier: MIT
// The registry: every family is usable by name alone, and refuses values outside its ranges.
#include <doctest/doctest.h>

#include <limits>
#include <set>

#include "affine_dimension.hpp"
#include "convexact/error.hpp"
#include "convexact/shapes.hpp"
using namespace convexact;
using namespace convexact::shapes;

TEST_CASE("families: each makes finite points of the stated dimension, the same twice") {
  for (const Family& f : families()) {
    CAPTURE(f.name);
    const std::vector<double> values = usual_values(f);
    const std::vector<Point> points = generate(f, values, 1);
    for (const Point& p : points) CHECK(p.allFinite());
    CHECK(affine_dimension(points) == f.dimension);
    CHECK(generate(f, values, 1) == points);
  }
}

TEST_CASE("families: names are unique, lower-case and found again") {
  std::set<std::string_view> names;
  for (const Family& f : families()) {
    CAPTURE(f.name);
    CHECK(names.insert(f.name).second);
    CHECK(f.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz-") == std::string_view::npos);
    CHECK(!f.description.empty());
    CHECK(&family(f.name) == &f);
  }
  CHECK_THROWS_AS(static_cast<void>(family("sphere-of-cheese")), Error);
}

TEST_CASE("families: a value out of range, not whole, NaN or missing is refused") {
  for (const Family& f : families()) {
    for (std::size_t i = 0; i < f.parameters.size(); ++i) {
      CAPTURE(f.name);
      const Parameter& p = f.parameters[i];
      CAPTURE(p.name);
      CHECK(p.least <= p.usual);
      CHECK(p.usual <= p.most);
      for (const double bad :
           {p.least - 1, 2 * p.most + 1, std::numeric_limits<double>::quiet_NaN()}) {
        std::vector<double> values = usual_values(f);
        values[i] = bad;
        CHECK_THROWS_AS((void)generate(f, values), Error);
      }
      if (!p.whole) continue;
      std::vector<double> values = usual_values(f);
      values[i] = p.least + 0.5;
      CHECK_THROWS_AS((void)generate(f, values), Error);
    }
    std::vector<double> values = usual_values(f);
    values.push_back(1);
    CHECK_THROWS_AS((void)generate(f, values), Error);
  }
}
