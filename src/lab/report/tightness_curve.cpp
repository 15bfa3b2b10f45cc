// SPDX-License-Identifier: MIT
#include "lab/report/tightness_curve.hpp"

#include <algorithm>
#include <cmath>

#include "convexact/measure.hpp"
#include "convexact/number.hpp"
#include "convexact/scene.hpp"
#include "fast/engines.hpp"
#include "lab/report/errors.hpp"
#include "number/precision.hpp"
#include "solid/solid.hpp"

namespace convexact {
namespace {

constexpr std::size_t kPoints = 28;

// Seconds from the start at which each number of halfspaces was left, for each repetition.
class Arrivals {
 public:
  explicit Arrivals(const std::vector<std::size_t>& faces) : faces_(faces), times_(faces.size()) {}

  void start() { watch_ = Stopwatch(); }
  void reach(std::size_t left) {
    const auto at = std::lower_bound(faces_.begin(), faces_.end(), left);
    if (at == faces_.end() || *at != left) return;
    times_[static_cast<std::size_t>(at - faces_.begin())].push_back(watch_.seconds());
  }
  /// The spread for a number that some run reached.
  std::optional<Spread> of(std::size_t index) const {
    if (times_[index].empty()) return std::nullopt;
    return spread_of(times_[index]);
  }

 private:
  const std::vector<std::size_t>& faces_;
  std::vector<std::vector<double>> times_;
  Stopwatch watch_;
};

void time_progressive_runs(const FastDual& dual, std::size_t least, CostMeasure measure,
                           Arrivals& arrivals, const Effort& effort) {
  (void)time_repeatedly(effort, [&](Deadline& deadline) {
    SimplifyOptions options;
    options.faces = least;
    options.cost = measure;
    options.seed = effort.seed;
    options.watch = deadline.engine_watch(
        [&](std::size_t done, std::size_t) { arrivals.reach(dual.size() - done); });
    arrivals.start();
    arrivals.reach(dual.size());
    (void)simplify_filtered(dual, options);
  });
}

double growth_of(const Enclosure& after, const Enclosure& before) {
  const Enclosure growth = (after - before) / before;
  return to_double(Rational((growth.low() + growth.high()) / 2), Rounding::Nearest);
}

}  // namespace

std::vector<std::size_t> spaced_by_ratio(std::size_t least, std::size_t most, std::size_t count) {
  std::vector<std::size_t> list{least, most};
  const double ratio = static_cast<double>(most) / static_cast<double>(least);
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    const auto value =
        static_cast<std::size_t>(std::lround(static_cast<double>(least) * std::pow(ratio, share)));
    list.push_back(std::clamp(value, least, most));
  }
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

TightnessCurve measure_tightness_curve(const Solid& solid, std::size_t least, const Effort& effort,
                                       CostMeasure measure) {
  const DualHull& dual_hull = solid.dual;
  const FastDual dual = FastDual::of(dual_hull, interior_point_of(solid));
  const std::vector<std::size_t> faces =
      spaced_by_ratio(std::min(least, dual.size()), dual.size(), kPoints);
  if (effort.progress) effort.progress("tightness: progressive runs");
  Arrivals arrivals(faces);
  time_progressive_runs(dual, least, measure, arrivals, effort);

  TightnessCurve curve{dual.size(), measure, {}};
  const Rational squared_diameter = bounding_box(dual_hull.vertices).squared_diameter();
  const Enclosure whole = enclose_measure(solid.polytope, measure, kMeasureBits);
  const Deadline deadline(effort);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const std::optional<Spread> seconds = arrivals.of(i);
    if (!seconds) continue;  // every removal from a larger number is unbounded
    if (effort.progress)
      effort.progress("tightness at " + std::to_string(faces[i]) + " halfspaces");
    SimplifyOptions options;
    options.faces = faces[i];
    options.cost = measure;
    options.verify = VerifyLevel::None;
    options.watch = effort.stop;
    const FastResult result = simplify_filtered(dual, options);
    const Polytope left = to_polytope(dual_hull.halfspaces, result.triangles);
    TightnessPoint point{.faces = faces[i],
                         .growth = growth_of(enclose_measure(left, measure, kMeasureBits), whole),
                         .hausdorff = {},
                         .seconds = *seconds};
    if (!deadline.has_passed()) {
      point.hausdorff =
          root_size(hausdorff_distance(left, solid.polytope).squared / squared_diameter).value;
    }
    curve.points.push_back(point);
  }
  return curve;
}

}  // namespace convexact
