// SPDX-License-Identifier: MIT
// write_json.hpp - the one place where JSON becomes text.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace convexact {

/// The text of a document, without a newline at its end. File names, option values and names of
/// objects are bytes: what is no UTF-8 in them becomes U+FFFD, since JSON knows nothing else.
/// @param indent  Spaces for each level; -1 for all on one line.
[[nodiscard]] std::string write_json(const nlohmann::ordered_json& document, int indent = -1);

/// `text` as write_json() would spell it, for pages and tables.
[[nodiscard]] std::string as_utf8(const std::string& text);

}  // namespace convexact
