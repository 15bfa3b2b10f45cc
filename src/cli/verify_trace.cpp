// SPDX-License-Identifier: MIT
#include "cli/verify_trace.hpp"

#include "cli/command_run.hpp"
#include "cli/keep_option.hpp"
#include "convexact/io.hpp"
#include "convexact/scene.hpp"
#include "convexact/verify_run.hpp"
#include "simplify/run_names.hpp"
#include "solid/solid.hpp"
#include "wire/removal_order_file.hpp"
#include "wire/trace_verdict.hpp"

namespace convexact::cli {
namespace {

// The files of an order, read but not yet understood.
struct OrderFiles {
  std::string trace;
  std::optional<std::string> facets;
};

OrderFiles read_files(const TraceOptions& options) {
  OrderFiles files{read_bytes(options.trace), {}};
  remember_input(display_name(options.trace), files.trace);
  if (!options.facets.empty()) {
    files.facets = read_bytes(options.facets);
    remember_input(display_name(options.facets), *files.facets);
  }
  return files;
}

RemovalOrder parse_files(const OrderFiles& files, const TraceOptions& options, const DualHull& dual,
                         Decimal decimal) {
  std::optional<ListedFacets> facets;
  if (files.facets) {
    try {
      facets = read_facet_list(*files.facets, options.facets, decimal);
    } catch (const Error& error) {
      throw error.in_file(display_name(options.facets));
    }
  }
  return read_removal_order(files.trace, facets, dual.halfspaces, decimal, options.cost);
}

TraceVerdict judge(const Solid& solid, const OrderFiles& files, const TraceOptions& options,
                   const JudgeOptions& judge_options, Decimal decimal, StageLog& log) {
  RemovalOrder order;
  try {
    order = log.run("parse the trace", StageKind::Io,
                    [&] { return parse_files(files, options, solid.dual, decimal); });
  } catch (const Error& error) {
    // A fault of its content is a verdict, not a failure.
    if (error.code() == ErrorCode::InvalidArgument) throw;
    return unreadable_trace(solid.dual, error.what(), error.line());
  }
  const RationalPoint center = log.run("center", [&] { return interior_point_of(solid); });
  return log.run("judge every step",
                 [&] { return judge_trace(solid.dual, center, order, judge_options); });
}

}  // namespace

void add_trace_options(Command& command, TraceOptions& options) {
  Option trace =
      command.add_option("--trace", options.trace,
                         "judge a removal order: a trace, rows nx ny nz d, or rows of facet ids");
  add_choice(
      command, "--cost", options.cost, kCostMeasureNames,
      "with --trace: what each removal is to add the least to (default: the measure that the "
      "trace names, else volume)")
      ->needs(trace);
  add_tie_bits(command, options.tie_bits,
               "with --trace: mean widths that neither this many bits nor a proof can order are "
               "undecided; the verdict says so")
      ->needs(trace);
  command.add_option("--facets", options.facets,
                     "with --trace: the facets that its ids refer to, counted from 0: rows nx ny "
                     "nz d, JSON or .ine (default: the input's facets in canonical order)");
  command
      .add_option(
          "--max-regret", options.max_regret,
          "with --trace: the share by which a removal may cost more than the cheapest, e.g. 1%")
      ->capture_default_str();
  add_text(
      command, "--left-out",
      "with --trace: facets that the order leaves out on purpose; it is judged on the solid "
      "without them; positions among the input's facets in canonical order, as a verdict names "
      "them",
      [&options](const std::string& option, const std::string& text) {
        options.left_out = parse_ids(option, text);
      })
      ->type_name("ID,...")
      ->needs(trace);
  add_keep_option(command, options.keep)->needs(trace);
}

int run_verify_trace(const GlobalOptions& global, const std::string& input, Decimal decimal,
                     const TraceOptions& options) {
  JudgeOptions judge_options;
  judge_options.max_regret = parse_share("--max-regret", options.max_regret);
  judge_options.left_out = options.left_out;
  judge_options.compare.bits = options.tie_bits;
  if (decimal == Decimal::Nearest32) judge_options.unit = 0x1p-24;
  judge_options.stop = &interrupted();
  if ((input == "-") + (options.trace == "-") + (options.facets == "-") > 1) {
    throw Error(ErrorCode::InvalidArgument, "standard input, -, can be read only once");
  }
  CommandRun run(global);
  StageLog& log = run.log();
  const OrderFiles files =
      log.run("read the trace", StageKind::Io, [&] { return read_files(options); });
  const std::vector<SceneObject> scene =
      run.read({input}, {.decimal = decimal, .points = options.points, .on_read = remember_input});
  const SolidOutcome outcome = make_solid(scene[0].shape, global.seed, true, log);
  if (const auto* reason = std::get_if<NotSolid>(&outcome)) return run.end_flat(scene[0], *reason);
  const auto* points = std::get_if<PointSet>(&scene[0].shape);
  judge_options.kept = select_facets(std::get<Solid>(outcome).dual.halfspaces,
                                     points != nullptr ? *points : PointSet(),
                                     keep_selectors(options.keep, scene)[0]);
  const std::size_t halfspaces = std::get<Solid>(outcome).dual.halfspaces.size();
  judge_options.progress = [&](std::size_t judged) {
    run.progress()("judging removals", judged, halfspaces - 4);
  };
  const TraceVerdict verdict =
      judge(std::get<Solid>(outcome), files, options, judge_options, decimal, log);
  return run.end({.json = [&] { return trace_verdict_json(verdict); },
                  .text =
                      [&] {
                        return scene[0].name + " against " + display_name(options.trace) + "\n" +
                               trace_verdict_text(verdict) + "\n";
                      },
                  .exit = verdict.holds() ? 0 : 1});
}

}  // namespace convexact::cli
