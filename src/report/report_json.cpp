// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "report/report.hpp"
#include "simplify/trace_json.hpp"

namespace convexact {
namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(const std::optional<double>& x) {
  return x && std::isfinite(*x) ? Json(*x) : Json(nullptr);
}

Json spread_json(const std::optional<Spread>& spread) {
  if (!spread) return nullptr;
  return {{"least", spread->least},
          {"median", spread->median},
          {"most", spread->most},
          {"repetitions", spread->repetitions}};
}

Json error_json(const std::optional<ErrorSize>& error) {
  if (!error) return nullptr;
  return {{"value", number_or_null(error->value)}, {"bits", number_or_null(error->bits)}};
}

Json wrong_json(const std::optional<WrongStep>& wrong) {
  if (!wrong) return nullptr;
  return {{"step", wrong->step}, {"regret", number_or_null(wrong->regret)}};
}

Json way_json(const WayResult& way, std::size_t at_start) {
  Json json = {{"way", way.way},
               {"bits", way.bits ? Json(*way.bits) : Json(nullptr)},
               {"seconds", spread_json(way.seconds)}};
  if (!way.seconds) return json;
  json["left"] = way.left;
  json["stop"] = name_of(way.stop);
  json["planes"] = error_json(way.planes);
  // Where no removal was made, no cost is right, either.
  const bool has_costs = way.left < at_start;
  json["cost_worst"] = has_costs ? error_json(way.cost_worst) : nullptr;
  json["cost_median"] = has_costs ? error_json(way.cost_median) : nullptr;
  json["volume"] = error_json(way.volume);
  json["outside"] = error_json(way.outside);
  json["first_other"] = way.first_other ? Json(*way.first_other) : Json(nullptr);
  json["is_tied"] = way.is_tied;
  json["first_wrong"] = wrong_json(way.first_wrong);
  json["excess"] = number_or_null(way.excess);
  if (way.agrees_with_c) json["agrees_with_c"] = *way.agrees_with_c;
  return json;
}

Json precision_json(const WorkPrecision& precision) {
  Json ways = Json::array();
  for (const WayResult& way : precision.ways) ways.push_back(way_json(way, precision.halfspaces));
  return {{"halfspaces", precision.halfspaces}, {"reference", precision.reference}, {"ways", ways}};
}

Json tightness_json(const TightnessCurve& curve) {
  Json points = Json::array();
  for (const TightnessPoint& point : curve.points) {
    points.push_back({{"faces", point.faces},
                      {"growth", number_or_null(point.growth)},
                      {"hausdorff", number_or_null(point.hausdorff)},
                      {"seconds", spread_json(point.seconds)}});
  }
  return {{"halfspaces", curve.halfspaces}, {"points", points}};
}

Json runs_json(const std::vector<RunTimes>& runs) {
  Json list = Json::array();
  for (const RunTimes& run : runs) {
    Json stages = Json::array();
    for (const StageTime& stage : run.stages) {
      Json entry = {{"name", stage.name}, {"seconds", spread_json(stage.seconds)}};
      if (!stage.seconds) entry["skipped"] = stage.skipped;
      stages.push_back(entry);
    }
    list.push_back({{"run", run.run}, {"seconds", spread_json(run.seconds)}, {"stages", stages}});
  }
  return list;
}

Json scaling_json(const std::vector<ScalingSeries>& list) {
  Json all = Json::array();
  for (const ScalingSeries& series : list) {
    Json points = Json::array(), law;
    for (const ScalingPoint& point : series.points) {
      points.push_back({{"size", point.size}, {"seconds", spread_json(point.seconds)}});
    }
    if (series.law) {
      law = {{"exponent", series.law->exponent},
             {"standard_error", series.law->standard_error},
             {"factor", series.law->factor}};
    }
    all.push_back({{"stage", series.stage},
                   {"run", series.run},
                   {"counts", series.counts},
                   {"points", points},
                   {"law", law}});
  }
  return all;
}

// Commands, with the options that a figure depends on.
class Commands {
 public:
  explicit Commands(const ReportRequest& request)
      : faces_(request.faces),
        options_(fmt::format("--faces {} --repetitions {} --budget {} --seed {}", request.faces,
                             request.effort.repetitions, request.effort.budget,
                             request.effort.seed)) {}

  std::string section(const std::string& inputs, const char* section) const {
    return fmt::format("convexact report {}{}--sections {} {}", inputs, inputs.empty() ? "" : " ",
                       section, options_);
  }
  std::string family(const std::string& name) const {
    return section("", "stability") + " --family " + name;
  }
  std::string stages(const std::string& input) const {
    return fmt::format("convexact simplify {} --faces {} --engine ENGINE --json", input, faces_);
  }
  static std::string shape(const Breakdown& family) {
    return fmt::format("convexact generate {} --{} VALUE -o shape.obj", family.family,
                       family.parameter);
  }
  static std::string tightness(const std::string& input) {
    return fmt::format(
        "convexact simplify {0} --faces K -o proxy.json; convexact verify {0} proxy.json --json",
        input);
  }

 private:
  std::size_t faces_;
  std::string options_;
};

Json figure(Json content, std::vector<std::string> commands) {
  content["commands"] = std::move(commands);
  return content;
}

std::string quoted(const std::string& name) {
  return name.find(' ') == std::string::npos ? name : "'" + name + "'";
}

Json input_json(const InputReport& input, const Commands& commands) {
  const std::string name = quoted(input.name);
  Json json = {{"name", input.name},
               {"points", input.points},
               {"hull_vertices", input.hull_vertices},
               {"halfspaces", input.halfspaces}};
  if (input.precision) {
    json["precision"] =
        figure(precision_json(*input.precision), {commands.section(name, "precision")});
  }
  if (input.tightness) {
    json["tightness"] = figure(tightness_json(*input.tightness),
                               {commands.section(name, "tightness"), Commands::tightness(name)});
  }
  if (!input.stages.empty()) {
    json["stages"] = figure({{"runs", runs_json(input.stages)}},
                            {commands.section(name, "stages"), commands.stages(name)});
  }
  if (!input.scaling.empty()) {
    json["scaling"] =
        figure({{"series", scaling_json(input.scaling)}}, {commands.section(name, "scaling")});
  }
  return json;
}

Json breakdown_json(const Breakdown& family, const Commands& commands) {
  Json points = Json::array();
  for (const BreakdownPoint& point : family.points) {
    Json entry = {{"value", point.value}};
    if (point.precision) {
      entry.update(precision_json(*point.precision));
    } else {
      entry["why_not"] = point.why_not;
    }
    points.push_back(entry);
  }
  return figure({{"family", family.family}, {"parameter", family.parameter}, {"points", points}},
                {commands.family(family.family), Commands::shape(family)});
}

}  // namespace

nlohmann::ordered_json report_json(const ReportData& report, const ReportRequest& request,
                                   const ReportOrigin& origin) {
  const Commands commands(request);
  Json inputs = Json::array(), families = Json::array();
  for (const InputReport& input : report.inputs) inputs.push_back(input_json(input, commands));
  for (const Breakdown& family : report.stability) {
    families.push_back(breakdown_json(family, commands));
  }
  Json json = {{"origin",
                {{"version", origin.version},
                 {"commit", origin.commit},
                 {"compiler", origin.compiler},
                 {"flags", origin.flags},
                 {"processor", origin.machine.processor},
                 {"cores", origin.machine.cores},
                 {"memory", origin.machine.memory}}},
               {"request",
                {{"faces", request.faces},
                 {"repetitions", request.effort.repetitions},
                 {"budget", request.effort.budget},
                 {"seed", request.effort.seed}}},
               {"inputs", inputs}};
  if (!report.spheres.empty()) {
    json["spheres"] =
        figure({{"series", scaling_json(report.spheres)}}, {commands.section("", "scaling")});
  }
  if (!report.stability.empty()) json["stability"] = families;
  return json;
}

}  // namespace convexact
