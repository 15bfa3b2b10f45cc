// SPDX-License-Identifier: MIT
#include "convexact/verify_order.hpp"

#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "solid/solid.hpp"
#include "wire/removal_order_file.hpp"

namespace convexact {
namespace {

RemovalOrder parse(const OrderText& text, const DualHull& dual) {
  std::optional<ListedFacets> facets;
  if (text.facets) {
    try {
      facets = read_facet_list(*text.facets, text.facets_path, text.decimal);
    } catch (const Error& error) {
      throw error.in_file(display_name(text.facets_path));
    }
  }
  return read_removal_order(text.bytes, facets, dual.halfspaces, text.decimal, text.cost);
}

TraceVerdict judge(const Solid& solid, const OrderText& text, const JudgeOptions& options,
                   StageLog& log) {
  RemovalOrder order;
  try {
    order = log.run("parse the trace", StageKind::Io, [&] { return parse(text, solid.dual); });
  } catch (const Error& error) {
    // A fault of its content is a verdict, not a failure.
    if (error.code() == ErrorCode::InvalidArgument) throw;
    return unreadable_trace(solid.dual, error.what(), error.line());
  }
  const RationalPoint center = log.run("center", [&] { return interior_point_of(solid); });
  return log.run("judge every step",
                 [&] { return judge_trace(solid.dual, center, order, options); });
}

}  // namespace

std::variant<TraceVerdict, NotSolid> verify_order(const Shape& input, const OrderText& order,
                                                  const VerifyOrderRequest& request) {
  StageLog log(request.watch);
  SolidOutcome outcome = make_solid(input, {.seed = request.seed}, log);
  if (auto* reason = std::get_if<NotSolid>(&outcome)) return std::move(*reason);
  const auto& solid = std::get<Solid>(outcome);
  const auto* points = std::get_if<PointSet>(&input);
  JudgeOptions options = request.judge;
  options.kept =
      select_facets(solid.dual.halfspaces, points != nullptr ? *points : PointSet(), request.keep);
  options.watch = request.watch.of("judging removals");
  TraceVerdict verdict = judge(solid, order, options, log);
  verdict.stages = log.stages();
  return verdict;
}

}  // namespace convexact
