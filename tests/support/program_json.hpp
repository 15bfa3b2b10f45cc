// SPDX-License-Identifier: MIT
// program_json.hpp - runs the program with --json and keeps its document, held to its schema.
#pragma once
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "json_schema.hpp"
#include "process.hpp"

namespace support {

/// The document that the program prints with --json; it ends with `exit` and holds to the schema.
/// @param arguments  Shell-quoted; --json is added at their end, or before a " -- ".
inline nlohmann::json program_json(const std::string& arguments, const char* schema, int exit = 0) {
  const std::size_t own = arguments.find(" -- ");
  const Ran ran = run_program(arguments.substr(0, own) + " --json" +
                              (own == arguments.npos ? "" : arguments.substr(own)));
  CAPTURE(arguments);
  CAPTURE(ran.err);
  REQUIRE_MESSAGE(ran.exit == exit, ran.out);
  nlohmann::json document = nlohmann::json::parse(ran.out);
  CHECK(schema_complaint(schema, document) == "");
  return document;
}

}  // namespace support
