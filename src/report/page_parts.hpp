// SPDX-License-Identifier: MIT
// page_parts.hpp - the files that a report page is made of; embed.py turns them into an array each.
#pragma once
#include <string_view>

namespace convexact {

extern const std::string_view kReportPage, kReportStyle, kReportScript, kChartLibrary;

}  // namespace convexact
