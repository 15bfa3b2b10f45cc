// SPDX-License-Identifier: MIT
// A report as JSON, as rows of numbers and as a page.
#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "io/json.hpp"
#include "lab/report/report.hpp"
#include "lab/report/report_parts.hpp"
#include "pages/page_parts.hpp"
#include "simplify/run_names.hpp"
#include "wire/decompose_options.hpp"

namespace convexact {
namespace {

Json number_or_null(const std::optional<double>& x) {
  return x ? value_or_null(*x) : Json(nullptr);
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
  // Without a removal there is no correct cost, either.
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
  return {
      {"halfspaces", curve.halfspaces}, {"measure", name_of(curve.measure)}, {"points", points}};
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

Json parts_json(const std::vector<PartsPoint>& points) {
  Json list = Json::array();
  for (const PartsPoint& point : points) {
    Json entry = {{"method", name_in(kDecomposeMethodNames, point.method)},
                  {"limit", point.limit},
                  {"seconds", spread_json(point.seconds)}};
    if (point.seconds) {
      entry["parts"] = point.parts;
      entry["distance"] = number_or_null(point.distance);
      entry["excess"] = number_or_null(point.excess);
      entry["uncovered"] = number_or_null(point.uncovered);
    }
    list.push_back(entry);
  }
  return list;
}

// Commands, with the options that a figure depends on.
class Commands {
 public:
  explicit Commands(const ReportRequest& request)
      : faces_(request.faces),
        cost_(request.cost == CostMeasure::Volume
                  ? std::string()
                  : fmt::format(" --cost {}", name_of(request.cost))),
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
  std::vector<std::string> parts(const std::string& input) const {
    return {section(input, "parts"),
            fmt::format("convexact decompose {0} --method METHOD -o parts.obj; convexact verify "
                        "{0} parts.obj --union --json",
                        input)};
  }
  static std::string shape(const Breakdown& family) {
    return fmt::format("convexact generate {} --{} VALUE -o shape.obj", family.family,
                       family.parameter);
  }
  std::vector<std::string> tightness(const std::string& input) const {
    return {section(input, "tightness") + cost_,
            fmt::format("convexact simplify {0} --faces K{1} -o proxy.json; convexact verify {0} "
                        "proxy.json --json",
                        input, cost_)};
  }

 private:
  std::size_t faces_;
  std::string cost_;  // as an option, unless it is the default
  std::string options_;
};

Json figure(Json content, const std::vector<std::string>& commands) {
  content["commands"] = commands;
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
    json["tightness"] = figure(tightness_json(*input.tightness), commands.tightness(name));
  }
  if (!input.stages.empty()) {
    json["stages"] = figure({{"runs", runs_json(input.stages)}},
                            {commands.section(name, "stages"), commands.stages(name)});
  }
  if (!input.scaling.empty()) {
    json["scaling"] =
        figure({{"series", scaling_json(input.scaling)}}, {commands.section(name, "scaling")});
  }
  if (!input.parts.empty()) {
    json["parts"] = figure({{"points", parts_json(input.parts)}}, commands.parts(name));
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

// --- numbers as rows ----------------------------------------------------------------------------

// A number of the JSON as a quantity of a row.
struct Quantity {
  const char* pointer;
  const char* name;
  const char* unit;
};

constexpr Quantity kSeconds[] = {{"/seconds/least", "seconds least", "s"},
                                 {"/seconds/median", "seconds median", "s"},
                                 {"/seconds/most", "seconds most", "s"},
                                 {"/seconds/repetitions", "repetitions", "1"}};
constexpr Quantity kErrors[] = {{"/left", "left", "1"},
                                {"/stop", "stop", ""},
                                {"/planes/value", "error of planes", "relative"},
                                {"/cost_worst/value", "error of costs, worst", "relative"},
                                {"/cost_median/value", "error of costs, median", "relative"},
                                {"/volume/value", "error of volume", "relative"},
                                {"/outside/value", "outside", "diameters"},
                                {"/first_other", "first other step", "1"},
                                {"/first_wrong/step", "first wrong step", "1"},
                                {"/excess", "excess volume", "relative"}};
constexpr Quantity kParts[] = {{"/parts", "parts", "1"},
                               {"/distance", "distance", "diameters"},
                               {"/excess", "excess volume", "of the solid"},
                               {"/uncovered", "uncovered volume", "of the solid"}};
constexpr Quantity kLaw[] = {{"/exponent", "exponent", "1"},
                             {"/standard_error", "standard error of the exponent", "1"}};

// A field in the form of RFC 4180.
std::string field(const std::string& bytes) {
  std::string text = as_utf8(bytes);
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string escaped = "\"";
  for (const char c : text) {
    if (c == '"') escaped += c;
    escaped += c;
  }
  return escaped + "\"";
}

// @param pointer  "/key", or "/key/key" for a member of a member.
std::string value_text(const Json& json, std::string_view pointer) {
  const Json* value = &json;
  while (value != nullptr && !pointer.empty()) {
    const std::size_t end = std::min(pointer.find('/', 1), pointer.size());
    value = value->find(pointer.substr(1, end - 1));
    pointer.remove_prefix(end);
  }
  if (value == nullptr || value->is_null()) return {};
  if (value->is_string()) return value->text();
  return value->is_double() ? fmt::format("{}", value->number()) : write_json(*value);
}

// CsvRows of one section and subject.
class CsvRows {
 public:
  CsvRows(std::string& csv, const std::string& section, const std::string& subject)
      : csv_(csv), start_(field(section) + "," + field(subject) + ",") {}

  // The quantities of one parameter and way.
  void add(const std::string& parameter, const std::string& way, const Json& json,
           std::span<const Quantity> quantities) {
    const std::string key = start_ + field(parameter) + "," + field(way) + ",";
    for (const auto& [pointer, name, unit] : quantities) {
      csv_ += key + name + "," + field(value_text(json, pointer)) + "," + unit + "\r\n";
    }
  }
  void add_ways(const std::string& parameter, const Json& precision) {
    for (const Json& way : precision.at("ways")) {
      add(parameter, way.at("way").text(), way, kSeconds);
      if (!way.at("seconds").is_null()) add(parameter, way.at("way").text(), way, kErrors);
    }
  }
  void add_scaling(const Json& scaling) {
    for (const Json& series : scaling.at("series")) {
      const std::string &run = series.at("run").text(), &counts = series.at("counts").text();
      for (const Json& point : series.at("points")) {
        add(write_json(point.at("size")) + " " + counts, run, point, kSeconds);
      }
      if (!series.at("law").is_null()) add("", run, series.at("law"), kLaw);
    }
  }

 private:
  std::string& csv_;
  std::string start_;
};

void add_input_rows(std::string& csv, const Json& input) {
  const std::string& name = input.at("name").text();
  if (input.contains("precision")) CsvRows(csv, "precision", name).add_ways("", input["precision"]);
  if (input.contains("tightness")) {
    CsvRows rows(csv, "tightness", name);
    std::string growth = "growth of " + input["tightness"].at("measure").text();
    std::replace(growth.begin(), growth.end(), '-', ' ');
    const Quantity tightness[] = {{"/growth", growth.c_str(), "relative"},
                                  {"/hausdorff", "Hausdorff distance", "diameters"}};
    for (const Json& point : input["tightness"].at("points")) {
      const std::string faces = write_json(point.at("faces")) + " faces";
      rows.add(faces, "filtered", point, tightness);
      rows.add(faces, "filtered", point, kSeconds);
    }
  }
  if (input.contains("stages")) {
    CsvRows rows(csv, "stages", name);
    for (const Json& run : input["stages"].at("runs")) {
      rows.add("all", run.at("run").text(), run, kSeconds);
      for (const Json& stage : run.at("stages")) {
        rows.add(stage.at("name").text(), run.at("run").text(), stage, kSeconds);
      }
    }
  }
  if (input.contains("parts")) {
    CsvRows rows(csv, "parts", name);
    for (const Json& point : input["parts"].at("points")) {
      const std::string limit = "limit " + value_text(point, "/limit");
      rows.add(limit, point.at("method").text(), point, kSeconds);
      rows.add(limit, point.at("method").text(), point, kParts);
    }
  }
  if (input.contains("scaling")) CsvRows(csv, "scaling", name).add_scaling(input["scaling"]);
}

}  // namespace

Json report_json(const ReportData& report, const ReportRequest& request,
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
                 {"cost", name_of(request.cost)},
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

std::string report_csv(const Json& report) {
  std::string csv = "section,subject,parameter,way,quantity,value,unit\r\n";
  for (const Json& input : report.at("inputs")) add_input_rows(csv, input);
  if (report.contains("spheres")) CsvRows(csv, "scaling", "sphere").add_scaling(report["spheres"]);
  if (!report.contains("stability")) return csv;
  for (const Json& family : report["stability"]) {
    CsvRows rows(csv, "stability", family.at("family").text());
    for (const Json& point : family.at("points")) {
      if (!point.contains("ways")) continue;
      rows.add_ways(family.at("parameter").text() + " " + value_text(point, "/value"), point);
    }
  }
  return csv;
}

std::string report_page(std::string_view json) {
  return fill_page(kReportPage, {{"STYLE", kReportStyle},
                                 {"DATA", for_script_element(json)},
                                 {"LIBRARY", kChartLibrary},
                                 {"SCRIPT", kReportScript}});
}

}  // namespace convexact
