// SPDX-License-Identifier: MIT
// inner_report.hpp - the result of an inner run as JSON (docs/schema/inner.schema.json), as text
// for people, and as files that are proven from their bytes.
#pragma once
#include <span>
#include <string>

#include "convexact/simplify.hpp"
#include "io/json_document.hpp"

namespace convexact {

/// One result without its stages.
[[nodiscard]] Json inner_json(const InnerResult& result);
/// A few lines: what was found, how much of the volume is kept, what was verified.
[[nodiscard]] std::string summary(const InnerResult& result);

/// The result of an object under its name in a file of several.
struct NamedInner {
  std::string name;
  const InnerResult* result;  ///< With a mesh, if the file is one.
};

/// The bytes of a mesh in binary64 or of a file of exact halfspaces, by the extension of `path`:
/// read back from them, every corner of a mesh is a vertex of the result and lies in every
/// halfspace of the hull of the input, and the halfspaces are those of the result. Only an OBJ
/// holds several results, a part for each.
/// @throws Error Unrepresentable for a format that holds no binary64; Internal if the proof fails.
[[nodiscard]] std::string proven_inner_bytes(std::span<const NamedInner> results,
                                             const std::string& path);

}  // namespace convexact
