// SPDX-License-Identifier: MIT
// On its own because valijson takes a minute to compile.
#include "json_schema.hpp"

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

std::string schema_complaint(const std::string& name, const nlohmann::json& document) {
  const std::string file =
      std::string(std::getenv("CONVEXACT_SCHEMAS")) + "/" + name + ".schema.json";
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error("cannot open " + file);
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
