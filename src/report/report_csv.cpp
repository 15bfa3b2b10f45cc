// SPDX-License-Identifier: MIT
// A report as a table of numbers, one in each row.
#include <fmt/format.h>

#include "io/json.hpp"
#include "report/report.hpp"
#include "simplify/trace_json.hpp"

namespace convexact {
namespace {

// A field as RFC 4180 wants it.
std::string field(const std::string& bytes) {
  const std::string text = as_utf8(bytes);
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string escaped = "\"";
  for (const char c : text) {
    if (c == '"') escaped += c;
    escaped += c;
  }
  return escaped + "\"";
}

// Rows of one section and subject.
class Rows {
 public:
  Rows(std::string& csv, const std::string& section, const std::string& subject)
      : csv_(csv), start_(field(section) + "," + field(subject) + ",") {}

  void at(const std::string& parameter, const std::string& way) {
    key_ = field(parameter) + "," + field(way) + ",";
  }
  void add(const char* quantity, const std::string& value, const char* unit) {
    csv_ += start_ + key_ + quantity + "," + field(value) + "," + unit + "\r\n";
  }
  void add(const char* quantity, double value, const char* unit) {
    add(quantity, fmt::format("{}", value), unit);
  }
  void add(const char* quantity, std::size_t value, const char* unit) {
    add(quantity, std::to_string(value), unit);
  }
  template <class Value>
  void add(const char* quantity, const std::optional<Value>& value, const char* unit) {
    if (value) {
      add(quantity, *value, unit);
    } else {
      add(quantity, std::string(), unit);
    }
  }
  void add(const std::optional<Spread>& seconds) {
    add("seconds least", seconds ? std::optional(seconds->least) : std::nullopt, "s");
    add("seconds median", seconds ? std::optional(seconds->median) : std::nullopt, "s");
    add("seconds most", seconds ? std::optional(seconds->most) : std::nullopt, "s");
    add("repetitions", seconds ? seconds->repetitions : std::size_t{0}, "1");
  }

 private:
  std::string& csv_;
  std::string start_, key_;
};

void add_ways(Rows& rows, const std::string& parameter, const WorkPrecision& precision) {
  for (const WayResult& way : precision.ways) {
    rows.at(parameter, way.way);
    rows.add(way.seconds);
    if (!way.seconds) continue;
    rows.add("left", way.left, "1");
    rows.add("stop", std::string(name_of(way.stop)), "");
    rows.add("error of planes", way.planes.value, "relative");
    const bool has_costs = way.left < precision.halfspaces;  // else no removal was made
    rows.add("error of costs, worst",
             has_costs ? std::optional(way.cost_worst.value) : std::nullopt, "relative");
    rows.add("error of costs, median",
             has_costs ? std::optional(way.cost_median.value) : std::nullopt, "relative");
    rows.add("error of volume", way.volume ? std::optional(way.volume->value) : std::nullopt,
             "relative");
    rows.add("outside", way.outside.value, "diameters");
    rows.add("first other step", way.first_other, "1");
    rows.add("first wrong step",
             way.first_wrong ? std::optional(way.first_wrong->step) : std::nullopt, "1");
    rows.add("excess volume", way.excess, "relative");
  }
}

void add_scaling(std::string& csv, const std::string& subject,
                 const std::vector<ScalingSeries>& list) {
  Rows rows(csv, "scaling", subject);
  for (const ScalingSeries& series : list) {
    for (const ScalingPoint& point : series.points) {
      rows.at(std::to_string(point.size) + " " + series.counts, series.run);
      rows.add(point.seconds);
    }
    rows.at("", series.run);
    if (!series.law) continue;
    rows.add("exponent", series.law->exponent, "1");
    rows.add("standard error of the exponent", series.law->standard_error, "1");
  }
}

void add_input(std::string& csv, const InputReport& input) {
  if (input.precision) {
    Rows rows(csv, "precision", input.name);
    add_ways(rows, "", *input.precision);
  }
  if (input.tightness) {
    Rows rows(csv, "tightness", input.name);
    for (const TightnessPoint& point : input.tightness->points) {
      rows.at(std::to_string(point.faces) + " faces", "filtered");
      rows.add("growth of volume", point.growth, "relative");
      rows.add("Hausdorff distance", point.hausdorff, "diameters");
      rows.add(point.seconds);
    }
  }
  Rows rows(csv, "stages", input.name);
  for (const RunTimes& run : input.stages) {
    rows.at("all", run.run);
    rows.add(run.seconds);
    for (const StageTime& stage : run.stages) {
      rows.at(stage.name, run.run);
      rows.add(stage.seconds);
    }
  }
  add_scaling(csv, input.name, input.scaling);
}

}  // namespace

std::string report_csv(const ReportData& report) {
  std::string csv = "section,subject,parameter,way,quantity,value,unit\r\n";
  for (const InputReport& input : report.inputs) add_input(csv, input);
  add_scaling(csv, "sphere", report.spheres);
  for (const Breakdown& family : report.stability) {
    Rows rows(csv, "stability", family.family);
    for (const BreakdownPoint& point : family.points) {
      const std::string parameter = fmt::format("{} {}", family.parameter, point.value);
      if (point.precision) add_ways(rows, parameter, *point.precision);
    }
  }
  return csv;
}

}  // namespace convexact
