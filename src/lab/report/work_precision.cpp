// SPDX-License-Identifier: MIT
#include "lab/report/work_precision.hpp"

#include <algorithm>

#include "convexact/measure.hpp"
#include "convexact/number.hpp"
#include "convexact/shapes.hpp"
#include "lab/diff/divergence.hpp"
#include "number/arithmetic.hpp"
#include "simplify/exact_engine.hpp"
#include "simplify/replay.hpp"
#include "solid/solid.hpp"

namespace convexact {
namespace {

// Ways of the float loop that a report shows, from few bits to many.
struct LoopWay {
  const char* name;
  Numbers numbers;
};

const std::vector<LoopWay>& loop_ways() {
  static const std::vector<LoopWay> ways = {
      {"mpfr-24", Numbers::MpfrBinary32}, {"mpfr-53", Numbers::MpfrBinary64},
      {"float", Numbers::Engine},         {"mpfr-64", Numbers::Mpfr64},
      {"mpfr-113", Numbers::Mpfr113},     {"mpfr-256", Numbers::Mpfr256},
      {"mpfr-1024", Numbers::Mpfr1024}};
  return ways;
}

// Runs every arithmetic on one solid and collects its errors and times.
class Workbench {
 public:
  Workbench(const Solid& solid, std::size_t faces, const Effort& effort)
      : dual_(solid.dual),
        faces_(faces),
        effort_(effort),
        center_(interior_point_of(solid)),
        fast_(FastDual::of(solid.dual, center_)) {}

  WorkPrecision run(const std::vector<std::string>& ways);

 private:
  SimplifyOptions options(Deadline& deadline) const;
  std::optional<Spread> time_exact();
  std::optional<Spread> time_filtered();
  WayResult engine(const char* way, std::optional<Spread> seconds, const Run& run);
  WayResult loop(const LoopWay& way);
  void judge(WayResult& result, const Run& exact, const std::vector<Rational>& costs,
             const std::optional<Rational>& volume);
  void judge_order(WayResult& result, const std::vector<HalfspaceId>& removed);
  double excess(const std::vector<HalfspaceId>& removed, const Rational& left) const;
  bool agrees_with(Numbers c, const RoundedDual& mpfr, const FastResult& result);

  const DualHull& dual_;
  std::size_t faces_;
  const Effort& effort_;
  RationalPoint center_;
  FastDual fast_;
  Run filtered_, reference_;
};

SimplifyOptions Workbench::options(Deadline& deadline) const {
  SimplifyOptions options;
  options.faces = faces_;
  options.seed = effort_.seed;
  options.watch = deadline.engine_watch();
  return options;
}

// The reference becomes the exact engine's run, if there is time for one.
std::optional<Spread> Workbench::time_exact() {
  return time_repeatedly(effort_, [&](Deadline& deadline) {
    reference_ = simplify_exact(dual_, center_, options(deadline));
  });
}

std::optional<Spread> Workbench::time_filtered() {
  return time_repeatedly(
      effort_, [&](Deadline& deadline) { (void)simplify_filtered(fast_, options(deadline)); });
}

// The run of an engine that decides exactly is judged like all others.
WayResult Workbench::engine(const char* way, std::optional<Spread> seconds, const Run& run) {
  WayResult result;
  result.way = way;
  result.seconds = seconds;
  if (!seconds) return result;
  std::vector<Rational> costs;
  for (const Step& step : run.steps) costs.push_back(step.cost->rational());
  result.stop = run.stop;
  const Rational left = volume(to_polytope(dual_.halfspaces, run.triangles));
  judge(result,
        removed_in(run) == removed_in(reference_) ? reference_
                                                  : replay(dual_, center_, removed_in(run)),
        costs, left);
  return result;
}

WayResult Workbench::loop(const LoopWay& way) {
  WayResult result;
  result.way = way.name;
  result.bits = bits_of(way.numbers);
  const auto rounded = RoundedDual::of(fast_, way.numbers);
  FastResult run;
  result.seconds =
      time_repeatedly(effort_, [&](Deadline& deadline) { run = rounded->run(options(deadline)); });
  if (!result.seconds) return result;
  result.stop = run.stop;
  std::vector<HalfspaceId> removed;
  for (const FastStep& step : run.steps) removed.push_back(step.removed);
  result.planes = worst_coordinate(*rounded, fast_.size());
  result.outside = worst_outside(*rounded, dual_, center_);
  judge(result, removed == removed_in(reference_) ? reference_ : replay(dual_, center_, removed),
        rounded->costs(), rounded->volume());
  if (way.numbers == Numbers::MpfrBinary32) {
    result.agrees_with_c = agrees_with(Numbers::CFloat, *rounded, run);
  } else if (way.numbers == Numbers::MpfrBinary64) {
    result.agrees_with_c = agrees_with(Numbers::CDouble, *rounded, run);
  }
  return result;
}

bool Workbench::agrees_with(Numbers c, const RoundedDual& mpfr, const FastResult& result) {
  Deadline deadline(effort_);
  const auto native = RoundedDual::of(fast_, c);
  const FastResult other = native->run(options(deadline));
  const auto same_removal = [](const FastStep& a, const FastStep& b) {
    return a.removed == b.removed;
  };
  return other.stop == result.stop && native->costs() == mpfr.costs() &&
         native->volume() == mpfr.volume() &&
         std::equal(other.steps.begin(), other.steps.end(), result.steps.begin(),
                    result.steps.end(), same_removal);
}

// `exact` is the run's removals with their exact costs.
void Workbench::judge(WayResult& result, const Run& exact, const std::vector<Rational>& costs,
                      const std::optional<Rational>& computed) {
  std::vector<ErrorSize> errors;
  for (std::size_t s = 0; s < costs.size(); ++s) {
    errors.push_back(relative_error(costs[s], exact.steps[s].cost->rational()));
  }
  std::sort(errors.begin(), errors.end());
  if (!errors.empty()) {
    result.cost_worst = errors.back();
    result.cost_median = errors[errors.size() / 2];
  }
  result.left = dual_.halfspaces.size() - costs.size();
  const Rational left = volume(to_polytope(dual_.halfspaces, exact.triangles));
  if (computed) result.volume = relative_error(*computed, left);
  const std::vector<HalfspaceId> removed = removed_in(exact);
  judge_order(result, removed);
  result.excess = excess(removed, left);
}

void Workbench::judge_order(WayResult& result, const std::vector<HalfspaceId>& removed) {
  const std::vector<Step>& steps = reference_.steps;
  std::size_t s = 0;
  while (s < removed.size() && s < steps.size() && removed[s] == steps[s].removed) ++s;
  if (s == removed.size() && s == steps.size()) return;
  result.first_other = s;
  if (s < removed.size() && s < steps.size()) {
    const std::vector<HalfspaceId>& tie = steps[s].tie;
    result.is_tied = std::find(tie.begin(), tie.end(), removed[s]) != tie.end();
  }
  Run run;
  run.halfspaces = dual_.halfspaces;
  run.stop = result.stop;
  for (const HalfspaceId id : removed) run.steps.push_back({id});
  const auto wrong = first_wrong_step(dual_, center_, run, {.watch = effort_.stop});
  if (!wrong) return;
  result.first_wrong = WrongStep{wrong->step, std::nullopt};
  if (wrong->regret) result.first_wrong->regret = wrong->regret->near_double();
}

// `left` is the exact volume of the remaining solid.
double Workbench::excess(const std::vector<HalfspaceId>& removed, const Rational& left) const {
  const std::vector<Step>& steps = reference_.steps;
  const std::size_t count = std::min(removed.size(), steps.size());
  std::vector<Rational> later{-volume(to_polytope(dual_.halfspaces, reference_.triangles))};
  for (std::size_t s = count; s < steps.size(); ++s) later.push_back(steps[s].cost->rational());
  const Rational wanted = -balanced_sum(std::move(later));
  return to_double(Rational(left / wanted - 1), Rounding::Nearest);
}

WorkPrecision Workbench::run(const std::vector<std::string>& ways) {
  const auto is_wanted = [&](const std::string& way) {
    return ways.empty() || std::find(ways.begin(), ways.end(), way) != ways.end();
  };
  const auto tell = [&](const std::string& way) {
    if (effort_.progress) effort_.progress("error and time of " + way);
  };
  WorkPrecision result;
  result.halfspaces = dual_.halfspaces.size();
  tell("filtered");
  SimplifyOptions with_record;
  with_record.faces = faces_;
  with_record.seed = effort_.seed;
  with_record.watch = effort_.stop;
  filtered_ = simplify_filtered(dual_, center_, with_record);
  reference_ = filtered_;
  tell("exact");
  const std::optional<Spread> exact = is_wanted("exact") ? time_exact() : std::nullopt;
  result.reference = exact ? "exact" : "filtered";
  for (const LoopWay& way : loop_ways()) {
    if (!is_wanted(way.name)) continue;
    tell(way.name);
    result.ways.push_back(loop(way));
  }
  if (is_wanted("filtered")) result.ways.push_back(engine("filtered", time_filtered(), filtered_));
  if (is_wanted("exact")) result.ways.push_back(engine("exact", exact, reference_));
  return result;
}

// --- where each arithmetic breaks down: families of shapes, swept -------------------------------

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

WorkPrecision measure_work_precision(const Solid& solid, std::size_t faces,
                                     const std::vector<std::string>& ways, const Effort& effort) {
  return Workbench(solid, faces, effort).run(ways);
}

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
        make_solid(points_of(sweep, value, effort.seed), {.seed = effort.seed}, log);
    if (const auto* reason = std::get_if<NotSolid>(&outcome)) {
      point.why_not = describe(*reason);
      continue;
    }
    point.precision = measure_work_precision(std::get<Solid>(outcome), 4, {}, quiet);
  }
  return result;
}

}  // namespace convexact
