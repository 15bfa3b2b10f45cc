// SPDX-License-Identifier: MIT
// A separate file because valijson takes a minute to compile.
#include "json_schema.hpp"

#include <pthread.h>

#include <cstdlib>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

namespace {

using Json = nlohmann::json;

std::string complaint(const Json& text, const Json& document) {
  valijson::Schema schema;
  const valijson::adapters::NlohmannJsonAdapter schema_adapter(text);
  valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(schema_adapter, schema);
  valijson::ValidationResults results;
  const valijson::adapters::NlohmannJsonAdapter adapter(document);
  if (valijson::Validator().validate(schema, adapter, &results)) return "";
  valijson::ValidationResults::Error error;
  return results.popError(error) ? error.description : "does not conform";
}

// Runs `work` on a stack of 512 MB, of which only the touched part becomes memory. valijson's
// patterns are std::regex, which recurses for each character: a fraction of some thousand digits
// overflows the usual 8 MB where a sanitizer makes the frames larger. `work` must not throw.
void on_large_stack(std::function<void()> work) {
  pthread_attr_t attributes;
  pthread_t thread;
  pthread_attr_init(&attributes);
  const bool started = pthread_attr_setstacksize(&attributes, std::size_t{512} << 20) == 0 &&
                       pthread_create(
                           &thread, &attributes,
                           [](void* run) -> void* {
                             (*static_cast<std::function<void()>*>(run))();
                             return nullptr;
                           },
                           &work) == 0;
  pthread_attr_destroy(&attributes);
  if (!started) throw std::runtime_error("cannot start a thread with a stack of 512 MB");
  pthread_join(thread, nullptr);
}

}  // namespace

std::string schema_complaint(const std::string& name, const Json& document) {
  const std::string file =
      std::string(std::getenv("CONVEXACT_SCHEMAS")) + "/" + name + ".schema.json";
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error("cannot open " + file);
  const Json text = Json::parse(stream);
  std::string answer;
  on_large_stack([&] {
    try {
      answer = complaint(text, document);
    } catch (const std::exception& error) {
      answer = error.what();
    }
  });
  return answer;
}
