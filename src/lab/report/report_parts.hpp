// SPDX-License-Identifier: MIT
// report_parts.hpp - the files from which the report's page is made (embed.py turns each into an
// array).
#pragma once
#include <string_view>

namespace convexact {

extern const std::string_view kReportPage, kReportStyle, kReportScript, kChartLibrary;

}  // namespace convexact
