// SPDX-License-Identifier: MIT
// json_schema.hpp - validates JSON against the schemas of docs/schema/, by valijson.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

/// "" if `document` conforms to NAME.schema.json in the folder $CONVEXACT_SCHEMAS, else the first
/// complaint.
[[nodiscard]] std::string schema_complaint(const std::string& name, const nlohmann::json& document);
