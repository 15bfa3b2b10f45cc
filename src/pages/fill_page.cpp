// SPDX-License-Identifier: MIT
#include "pages/page_parts.hpp"

namespace convexact {

std::string fill_page(std::string_view page,
                      const std::map<std::string_view, std::string_view>& texts) {
  std::string filled;
  for (std::size_t at = page.find('@'); at != page.npos; at = page.find('@')) {
    const std::size_t end = page.find('@', at + 1);
    filled += page.substr(0, at);
    filled += texts.at(page.substr(at + 1, end - at - 1));
    page.remove_prefix(end + 1);
  }
  return filled += page;
}

std::string for_script_element(std::string_view json) {
  std::string text;
  for (const char c : json) c == '<' ? text += "\\u003c" : text += c;
  return text;
}

}  // namespace convexact
