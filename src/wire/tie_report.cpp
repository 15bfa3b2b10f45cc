// SPDX-License-Identifier: MIT
#include "wire/tie_report.hpp"

#include <fmt/format.h>

#include <numeric>

#include "number/text.hpp"
#include "simplify/run_names.hpp"

namespace convexact {

Json tie_json(const TieEvidence& evidence, const char* key) {
  Json json = Json::object();
  if (evidence.proof) json[key] = name_of(*evidence.proof);
  if (evidence.proof == TieProof::Undecided) json["bits"] = evidence.bits;
  return json;
}

Json ties_json(const TieTally& ties) {
  Json json = Json::object();
  for (const auto& [proof, name] : kTieProofNames) {
    const std::size_t steps = ties.steps[static_cast<std::size_t>(proof)];
    if (steps > 0) json[name] = steps;
  }
  if (ties.bits > 0) json["bits"] = ties.bits;
  return json;
}

std::size_t tie_count(const TieTally& ties) {
  return std::accumulate(ties.steps.begin(), ties.steps.end(), std::size_t{0});
}

std::string tie_proofs_text(const TieTally& ties) {
  std::string text;
  for (const auto& [proof, name] : kTieProofNames) {
    const std::size_t steps = ties.steps[static_cast<std::size_t>(proof)];
    if (steps == 0) continue;
    text += (text.empty() ? "" : ", ") + with_separators(steps) + " " + name;
  }
  if (ties.bits > 0) text += fmt::format("; not told apart by {} bits", ties.bits);
  return text;
}

}  // namespace convexact
