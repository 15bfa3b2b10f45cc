// SPDX-License-Identifier: MIT
// conformance_junit(): the report in the XML of JUnit.
#include <fmt/format.h>

#include "io/json_document.hpp"
#include "wire/conformance_report.hpp"

namespace convexact {

namespace {

// Text in XML, without the characters that XML 1.0 does not have.
std::string xml_text(const std::string& text) {
  std::string result;
  for (const char c : as_utf8(text)) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '"') {
      result += "&quot;";
    } else if (code >= 0x20 || c == '\n' || c == '\t') {
      result += c;
    }
  }
  return result;
}

std::string junit_case(const ConformanceReport& report, const ConformanceEntry& entry) {
  std::string text =
      fmt::format("  <testcase classname=\"convexact.level{}\" name=\"{}\" time=\"{:.3f}\"",
                  entry.vector->level, xml_text(entry.vector->id), entry.seconds);
  if (entry.result.failures.empty()) return text + "/>\n";
  const std::string kind = name_of(entry.result.outcome());
  const std::string sentence = xml_text(entry.result.sentence);
  if (report.is_known_failure(*entry.vector)) {
    return text + fmt::format(">\n    <skipped message=\"known failure: {}\"/>\n  </testcase>\n",
                              sentence);
  }
  text += fmt::format(">\n    <failure type=\"{}\" message=\"{}\"/>\n", kind, sentence);
  if (!entry.printed.empty()) {
    text += fmt::format("    <system-out>{}</system-out>\n", xml_text(entry.printed));
  }
  return text + "  </testcase>\n";
}

}  // namespace

std::string conformance_junit(const ConformanceReport& report) {
  std::size_t failed = 0, skipped = 0;
  double seconds = 0;
  std::string cases;
  for (const ConformanceEntry& entry : report.entries) {
    if (!entry.result.failures.empty())
      ++(report.is_known_failure(*entry.vector) ? skipped : failed);
    seconds += entry.seconds;
    cases += junit_case(report, entry);
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuite name=\"convexact conform: {}\" tests=\"{}\" failures=\"{}\" errors=\"0\" "
      "skipped=\"{}\" time=\"{:.3f}\">\n{}</testsuite>\n",
      xml_text(report.program), report.entries.size(), failed, skipped, seconds, cases);
}

}  // namespace convexact
