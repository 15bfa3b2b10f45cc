// SPDX-License-Identifier: MIT
#include "convexact/simplify.hpp"

#include <array>

#include "fast/engines.hpp"
#include "scene/run_stages.hpp"
#include "scene/search_stage.hpp"
#include "simplify/exact_engine.hpp"

namespace convexact {
namespace {

RunEnd make_run(const RunInput& input, const SimplifyRequest& request, StageLog& log) {
  const SimplifyOptions options = options_of(request, input);
  if (!input.dual) {
    Run run = log.run(stage::kSimplify, [&] {
      const DualHull& dual = input.solid->dual;
      return request.engine == Engine::Exact ? simplify_exact(dual, input.center, options)
                                             : simplify_filtered(dual, input.center, options);
    });
    return end_of(std::move(run), log);
  }
  const FastResult result = log.run(stage::kSimplify, [&] {
    return request.engine == Engine::Float ? simplify_float(*input.dual, options)
                                           : simplify_filtered(*input.dual, options);
  });
  return end_of(result, *input.dual, request.engine, log);
}

}  // namespace

SimplifyOutcome simplify(const Shape& shape, const SimplifyRequest& request) {
  require_sensible(request);
  StageLog log(request.watch);
  const auto prepared = prepare_run(shape, request, log);
  if (const auto* reason = std::get_if<NotSolid>(&prepared)) return *reason;
  RunInput& input = *std::get<std::unique_ptr<RunInput>>(prepared);
  RunEnd end = make_run(input, request, log);
  if (request.search.kind != SearchKind::None) {
    end = search_further(std::move(end), input, request, log);
  }
  InputMeasures before = measure_input(input, request, log);
  SimplifyResult result = finish_run(input, std::move(before), std::move(end), request, log);
  if (result.float_bound && request.max_growth) {
    const auto measure = result.measure.value_or(
        std::array{result.input_volume.bounds, result.output_volume.bounds});
    result.float_bound->is_end_proven &= is_growth_proven(
        result.steps, result.stop, least_next(*result.float_bound, input, request.cost), measure,
        *request.max_growth);
  }
  return result;
}

}  // namespace convexact
