// SPDX-License-Identifier: MIT
#include "convexact/json.hpp"

#include <fmt/format.h>

#include <span>

#include "wire/decompose_options.hpp"
#include "wire/decompose_report.hpp"
#include "wire/inner_report.hpp"
#include "wire/parts_verdict.hpp"
#include "wire/simplify_report.hpp"
#include "wire/stage_report.hpp"
#include "wire/trace_verdict.hpp"
#include "wire/verdict_report.hpp"

namespace convexact {
namespace {

std::string with_stages(Json document, const std::vector<Stage>& stages, int indent) {
  document["stages"] = stages_json(stages);
  return write_json(document, indent);
}

}  // namespace

std::string to_json(const SimplifyResult& result, int indent) {
  return with_stages(result_json(result), result.stages, indent);
}

std::string to_json(const InnerResult& result, int indent) {
  return with_stages(inner_json(result), result.stages, indent);
}

std::string to_json(const HullResult& result, int digits, int indent) {
  return with_stages(hull_json(result, digits), result.stages, indent);
}

std::string to_json(const Decomposition& decomposition, const DecomposeRequest& request,
                    int indent) {
  DecomposedObject object{"", decomposition, {}, request};
  if (request.method == DecomposeMethod::Auto) {
    const bool is_cut = std::holds_alternative<Partition>(decomposition.origin);
    object.request.method = is_cut ? DecomposeMethod::Cut : DecomposeMethod::Hacd;
    if (!is_cut && decomposition.reach) {
      object.request.guard = object.request.merge = ReachUse::Reach;
    }
  }
  for (std::size_t k = 0; k < decomposition.parts.size(); ++k) {
    object.part_names.push_back(fmt::format("part_{:03}", k));
  }
  return with_stages(decomposition_json(std::span(&object, 1), DecompositionDetail::All),
                     decomposition.stages, indent);
}

std::string to_json(const Verdict& verdict, int indent) {
  return with_stages(verdict_json(verdict), verdict.stages, indent);
}

std::string to_json(const PartsVerdict& verdict, int indent) {
  return with_stages(parts_verdict_json(verdict), verdict.stages, indent);
}

std::string to_json(const TraceVerdict& verdict, int indent) {
  return with_stages(trace_verdict_json(verdict), verdict.stages, indent);
}

const char* name_of(DecomposeMethod method) { return name_in(kDecomposeMethodNames, method); }

}  // namespace convexact
