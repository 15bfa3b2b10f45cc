// SPDX-License-Identifier: MIT
// report_json.hpp - a report for machines: docs/schema/report.schema.json, and the same as a table.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "report/report_data.hpp"

namespace convexact {

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
[[nodiscard]] nlohmann::ordered_json report_json(const ReportData& report,
                                                 const ReportRequest& request,
                                                 const ReportOrigin& origin);

/// Every number of report_json() in a row of its own: section, subject, parameter, way, quantity,
/// value, unit. With a heading; a value that is not known is empty. RFC 4180.
[[nodiscard]] std::string report_csv(const ReportData& report);

}  // namespace convexact
