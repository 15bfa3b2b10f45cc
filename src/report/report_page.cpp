// SPDX-License-Identifier: MIT
#include "report/report_page.hpp"

#include "report/page_parts.hpp"

namespace convexact {
namespace {

void append(std::string& page, std::string_view& rest, std::string_view mark,
            std::string_view part) {
  const std::size_t at = rest.find(mark);
  page += rest.substr(0, at);
  page += part;
  rest.remove_prefix(at + mark.size());
}

// No text inside may end the element that holds the data: JSON can spell '<' without it.
std::string for_script_element(std::string_view json) {
  std::string text;
  for (const char c : json) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

}  // namespace

std::string report_page(std::string_view json) {
  std::string page;
  std::string_view rest = kReportPage;
  append(page, rest, "@STYLE@", kReportStyle);
  append(page, rest, "@DATA@", for_script_element(json));
  append(page, rest, "@LIBRARY@", kChartLibrary);
  append(page, rest, "@SCRIPT@", kReportScript);
  page += rest;
  return page;
}

}  // namespace convexact
