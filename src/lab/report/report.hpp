// SPDX-License-Identifier: MIT
// report.hpp - all measurements of a report, and the machine, as data.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "io/json_document.hpp"
#include "lab/report/parts_curve.hpp"
#include "lab/report/run_times.hpp"
#include "lab/report/tightness_curve.hpp"
#include "lab/report/work_precision.hpp"

namespace convexact {

/// Which sections to measure.
struct ReportSections {
  bool precision = true;  ///< Error against time, for every way of computing.
  bool tightness = true;  ///< Against the number of halfspaces, and against time.
  bool stages = true;     ///< Time by stage, and the time that skipping stages saves.
  bool scaling = true;    ///< Time by size.
  bool stability = true;  ///< Error against stiffness.
  bool parts = false;     ///< Of decompositions: distance, excess and number against time.
};

struct ReportRequest {
  std::size_t faces = 4;  ///< Halfspaces at which runs end, >= 4.
  /// Of the tightness: the measure that its runs keep small, and whose growth it shows.
  CostMeasure cost = CostMeasure::Volume;
  ReportSections sections;
  std::vector<std::string> families;  ///< Of the stability; empty: all breakdown_families().
  Effort effort;
};

/// The measurements on one input; none if its section was not requested.
struct InputReport {
  std::string name;
  std::size_t points = 0;  ///< 0 where the input is halfspaces.
  std::size_t hull_vertices = 0, halfspaces = 0;
  std::optional<WorkPrecision> precision;
  std::optional<TightnessCurve> tightness;
  std::vector<RunTimes> stages;
  std::vector<ScalingSeries> scaling;  ///< Over subsets of the points; empty for halfspaces.
  std::vector<PartsPoint> parts;       ///< Empty for points and halfspaces.
};

struct ReportData {
  std::vector<InputReport> inputs;
  std::vector<ScalingSeries> spheres;
  std::vector<Breakdown> stability;
};

/// Measures one input. @throws Error InvalidArgument for an invalid request; Stopped.
/// @param polygons  Of points: the faces that the section parts is about.
[[nodiscard]] std::variant<InputReport, NotSolid> measure_input(
    const std::string& name, const Shape& shape, const ReportRequest& request,
    const std::vector<std::vector<std::uint32_t>>& polygons = {});
/// The measurements that do not depend on the inputs: spheres and stability.
void measure_families(ReportData& report, const ReportRequest& request);

/// A machine: enough for comparisons, but no names of hosts or users.
struct Machine {
  std::string processor;     ///< Its name in the system; "unknown" if there is none.
  unsigned cores = 0;        ///< Those that the process may use; 0 if unknown.
  std::uint64_t memory = 0;  ///< Bytes; 0 if unknown.
};

/// Of Linux, from /proc.
[[nodiscard]] Machine this_machine();

/// The build that made a report.
struct ReportOrigin {
  std::string version;   ///< "convexact 0.1.0".
  std::string commit;    ///< Of the source; "unknown" outside of a repository.
  std::string compiler;  ///< With its version.
  std::string flags;     ///< That the program was built with.
  Machine machine;
};

/// The whole report. Each figure has the command that makes it, where inputs are named without
/// their folders.
[[nodiscard]] Json report_json(const ReportData& report, const ReportRequest& request,
                               const ReportOrigin& origin);

/// Every number of a report_json() in a separate row: section, subject, parameter, way, quantity,
/// value, unit. With a heading; a value that is not known is empty. RFC 4180.
[[nodiscard]] std::string report_csv(const Json& report);

/// A self-contained HTML page: no network, no further file. Its script draws the plots and writes
/// the tables from the data that it carries, so the page shows exactly the data of the JSON.
/// @param json  As write_json() prints it, UTF-8.
[[nodiscard]] std::string report_page(std::string_view json);

}  // namespace convexact
