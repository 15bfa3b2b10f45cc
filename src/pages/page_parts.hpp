// SPDX-License-Identifier: MIT
// page_parts.hpp - the files from which pages are made (embed.py turns each into an array), and the
// functions that assemble a page.
#pragma once
#include <map>
#include <string>
#include <string_view>

namespace convexact {

extern const std::string_view kViewerPage, kViewerStyle, kFacetsScript, kShapesScript,
    kViewerScript, kThreeLibrary;

/// The page with a text in place of each mark such as @TITLE@. Marks inside of these texts stay.
/// @throws std::out_of_range if the page has a mark without a text.
[[nodiscard]] std::string fill_page(std::string_view page,
                                    const std::map<std::string_view, std::string_view>& texts);

/// JSON that does not end the script element that contains it: '<' is spelled \u003c.
[[nodiscard]] std::string for_script_element(std::string_view json);

}  // namespace convexact
