// SPDX-License-Identifier: MIT
#include "report/report_page.hpp"

#include "report/page_parts.hpp"

namespace convexact {

std::string report_page(std::string_view json) {
  return fill_page(kReportPage, {{"STYLE", kReportStyle},
                                 {"DATA", for_script_element(json)},
                                 {"LIBRARY", kChartLibrary},
                                 {"SCRIPT", kReportScript}});
}

}  // namespace convexact
