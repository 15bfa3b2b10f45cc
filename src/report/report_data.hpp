// SPDX-License-Identifier: MIT
// report_data.hpp - everything that a report measures.
#pragma once
#include <string>
#include <variant>
#include <vector>

#include "report/breakdown.hpp"
#include "report/machine.hpp"
#include "report/scaling.hpp"
#include "report/stage_times.hpp"
#include "report/tightness_curve.hpp"
#include "report/work_precision.hpp"

namespace convexact {

/// Which sections to measure.
struct ReportSections {
  bool precision = true;  ///< Error against time, for every way of computing.
  bool tightness = true;  ///< Against the number of halfspaces, and against time.
  bool stages = true;     ///< Time by stage, and the time that skipping stages saves.
  bool scaling = true;    ///< Time by size.
  bool stability = true;  ///< Error against stiffness.
};

struct ReportRequest {
  std::size_t faces = 4;  ///< Halfspaces at which runs end, >= 4.
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
};

struct ReportData {
  std::vector<InputReport> inputs;
  std::vector<ScalingSeries> spheres;
  std::vector<Breakdown> stability;
};

struct NamedShape {
  std::string name;
  const Shape* shape;
};

/// Measures one input. @throws Error InvalidArgument for an invalid request; Stopped.
[[nodiscard]] std::variant<InputReport, NotSolid> measure_input(const NamedShape& input,
                                                                const ReportRequest& request);
/// The measurements that do not depend on the inputs: spheres and stability.
void measure_families(ReportData& report, const ReportRequest& request);

}  // namespace convexact
