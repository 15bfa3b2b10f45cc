// SPDX-License-Identifier: MIT
// json_schema.hpp - validates JSON text against a schema of docs/schema/, by valijson.
#pragma once
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

/// "" if `document` conforms to the schema file, else the first complaint.
inline std::string schema_complaint(const std::string& schema_file,
                                    const nlohmann::json& document) {
  std::ifstream stream(schema_file);
  if (!stream) throw std::runtime_error("cannot open " + schema_file);
  const nlohmann::json text = nlohmann::json::parse(stream);
  valijson::Schema schema;
  const valijson::adapters::NlohmannJsonAdapter schema_adapter(text);
  valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(schema_adapter, schema);
  valijson::ValidationResults results;
  const valijson::adapters::NlohmannJsonAdapter adapter(document);
  if (valijson::Validator().validate(schema, adapter, &results)) return "";
  valijson::ValidationResults::Error error;
  return results.popError(error) ? error.description : "does not conform";
}
