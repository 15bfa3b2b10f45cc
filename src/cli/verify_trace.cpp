// SPDX-License-Identifier: MIT
#include "cli/verify_trace.hpp"

#include "cli/command_run.hpp"
#include "convexact/io.hpp"
#include "convexact/scene.hpp"
#include "convexact/verify_order.hpp"
#include "simplify/run_names.hpp"
#include "wire/keep_selectors.hpp"
#include "wire/simplify_options.hpp"
#include "wire/trace_verdict.hpp"

namespace convexact::cli {
namespace {

// Read but not yet understood.
OrderText read_order(const TraceOptions& options, Decimal decimal) {
  OrderText text{.bytes = read_bytes(options.trace),
                 .facets_path = options.facets,
                 .decimal = decimal,
                 .cost = options.cost};
  const auto remember = [](const std::string& path, const std::string& bytes) {
    remember_input(display_name(path), std::make_shared<const std::string>(bytes));
  };
  remember(options.trace, text.bytes);
  if (!options.facets.empty()) {
    text.facets = read_bytes(options.facets);
    remember(options.facets, *text.facets);
  }
  return text;
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

int run_verify_trace(const GlobalOptions& global, const std::string& input,
                     const SceneOptions& reading, const TraceOptions& options) {
  VerifyOrderRequest request;
  request.judge.max_regret = parse_share("--max-regret", options.max_regret);
  request.judge.left_out = options.left_out;
  request.judge.compare.bits = options.tie_bits;
  if (reading.decimal == Decimal::Nearest32) request.judge.unit = 0x1p-24;
  request.seed = global.seed;
  if ((input == "-") + (options.trace == "-") + (options.facets == "-") > 1) {
    throw Error(ErrorCode::InvalidArgument, "standard input, -, can be read only once");
  }
  CommandRun run(global);
  const OrderText order = run.log().run("read the trace", StageKind::Io,
                                        [&] { return read_order(options, reading.decimal); });
  const std::vector<SceneObject> scene = run.read({input}, reading);
  request.keep = keep_selectors("--keep", options.keep, scene)[0];
  request.watch = run.watch();
  const auto outcome = verify_order(scene[0].shape, order, request);
  if (const auto* reason = std::get_if<NotSolid>(&outcome)) return run.end_flat(scene[0], *reason);
  const auto& verdict = std::get<TraceVerdict>(outcome);
  run.log().add(verdict.stages);
  return run.end({.json = [&] { return trace_verdict_json(verdict); },
                  .text =
                      [&] {
                        return scene[0].name + " against " + display_name(options.trace) + "\n" +
                               trace_verdict_text(verdict) + "\n";
                      },
                  .exit = verdict.holds() ? 0 : 1});
}

}  // namespace convexact::cli
