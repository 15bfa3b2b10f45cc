// SPDX-License-Identifier: MIT
// report_page.hpp - the page that draws a report.
#pragma once
#include <string>
#include <string_view>

namespace convexact {

/// A self-contained HTML page: no network, no further file. Its script draws the plots and writes
/// the tables from the data that it carries, so the page shows what the JSON says.
/// @param json  As report_json() prints it, UTF-8.
[[nodiscard]] std::string report_page(std::string_view json);

}  // namespace convexact
