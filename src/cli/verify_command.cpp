// SPDX-License-Identifier: MIT
// convexact verify: the oracle.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "cli/outputs.hpp"
#include "cli/promise_options.hpp"
#include "cli/stdio_loop.hpp"
#include "cli/verify_trace.hpp"
#include "cli/verify_union.hpp"
#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "convexact/scene.hpp"
#include "convexact/verify.hpp"
#include "oracle/parts/scene_verdict.hpp"
#include "pages/answers.hpp"
#include "pages/verdict_picture.hpp"
#include "scene/objects.hpp"
#include "wire/scene_report.hpp"
#include "wire/verdict_report.hpp"

namespace convexact::cli {
namespace {

constexpr const char* kVerifyFooter =
    "Examples:\n"
    "  convexact verify bunny.obj my_hull.obj --asks hull\n"
    "  convexact verify bunny.obj my_enclosure.obj --picture where.html\n"
    "  convexact verify bunny.obj my_planes.json --max-facets 18 --json\n"
    "  convexact verify bunny.obj my_hull.stl --claims contains-input --tolerance 1e-9d\n"
    "  convexact verify room.obj proxies.obj --parts\n"
    "  convexact verify cow.obj cow_parts.obj --union --picture parts.html\n"
    "  convexact verify cow.obj cow_parts.obj --distance 3%\n"
    "  convexact verify cow.obj parts/ --claims covers-surface,parts-disjoint --max-parts 24\n"
    "  convexact verify --inner bunny.obj my_inner_hull.obj\n"
    "  convexact verify bunny.obj --trace steps.json --max-regret 1%\n"
    "  convexact verify bunny.obj --trace my_planes.txt --cost area\n"
    "  convexact verify --stdio <requests.jsonl\n"
    "\n"
    "A mesh stands for the convex hull of its points, a list of halfspaces for their\n"
    "intersection. With --union, a mesh stands for the union of the hulls of its objects.\n"
    "Every claim is decided exactly, on the numbers as they are stored; each violation comes\n"
    "with a witness. docs/verdicts.md#CODE describes the claim CODE.\n"
    "Exit code 0: every claim holds. 1: one is violated, or the CANDIDATE is malformed. 3: a\n"
    "file is missing, or INPUT is malformed. 4: INPUT has no volume (with --union: no point).";

struct VerifyArguments {
  GlobalOptions global;
  std::string input, candidate;
  std::vector<ClaimCode> claims;
  Decimal decimal = Decimal::Nearest;
  MeshPoints points = MeshPoints::All;
  PromiseOptions promise;
  VerifyRequest request;  // what of it has options of its own
  bool skip_bad = false, no_tightness = false, parts = false, inner = false;
  TraceOptions trace;
  UnionOptions of_union;
  StdioOptions stdio;
};

bool names(const VerifyArguments& options, ClaimCode code) {
  return std::find(options.claims.begin(), options.claims.end(), code) != options.claims.end();
}

// The meaning of the numbers of both files, from --numbers, or the profile, and --decimal.
Decimal meaning_of_numbers(const Promise& promise, Decimal decimal) {
  if (promise.numbers == Precision::Binary64) return decimal;
  if (decimal == Decimal::Exact) {
    throw Error(ErrorCode::InvalidArgument,
                "--numbers binary32 rounds and --decimal exact does not: name one of them");
  }
  return Decimal::Nearest32;
}

// How INPUT is read.
SceneOptions reading_of(const VerifyArguments& options, Decimal decimal) {
  return {.decimal = decimal, .skip_bad = options.skip_bad, .on_read = remember_input};
}

// The promise of the profile; an enclosure without one.
Promise promise_of(const VerifyArguments& options) {
  Promise promise = options.promise.promise(Asks::Enclosure);
  if (options.inner) promise.asks = Asks::Inner;
  if (options.promise.asks() == Asks::Simplify && !promise.max_facets) {
    throw Error(ErrorCode::InvalidArgument, "--asks simplify needs --max-facets");
  }
  if (promise.asks != Asks::Inner || options.inner || options.promise.asks()) return promise;
  throw Error(ErrorCode::InvalidArgument,
              "--profile " + options.promise.profile +
                  ": this program writes inner solids, which do not contain their input: add "
                  "--inner, or judge them by conform");
}

VerifyRequest verify_request(const VerifyArguments& options, const Promise& promise) {
  VerifyRequest request = request_of(promise);
  request.claims = options.claims;
  request.exact_facets = options.request.exact_facets;
  if (request.exact_facets && !request.max_facets) {
    throw Error(ErrorCode::InvalidArgument, "--exact-facets needs --max-facets");
  }
  request.tightness = !options.no_tightness;
  request.seed = options.global.seed;
  request.points = options.points;
  return request;
}

const char* relation_of(Asks asks) {
  switch (asks) {
    case Asks::Inner:
      return " inside of ";
    case Asks::Hull:
      return " as the hull of ";
    case Asks::Enclosure:
    case Asks::Simplify:
      break;
  }
  return " as an enclosure of ";
}

// The parts of the candidate together.
int run_union(const VerifyArguments& options) {
  if (options.parts && names(options, ClaimCode::NoGaps)) {
    throw Error(ErrorCode::InvalidArgument,
                "--claims: no-gaps compares parts of INPUT with those of CANDIDATE one by one, and "
                "INPUT has one");
  }
  // Several parts together may hold what no single one holds.
  const Promise promise = options.promise.promise(Asks::Enclosure);
  return run_verify_union(options.global, options.input, options.candidate,
                          reading_of(options, meaning_of_numbers(promise, options.decimal)),
                          parts_request(verify_request(options, promise)), options.of_union);
}

bool names_a_claim_of_parts(const VerifyArguments& options) {
  return std::any_of(options.claims.begin(), options.claims.end(), is_of_parts);
}

Candidate read_candidate_as(const VerifyArguments& options, Decimal decimal, CommandRun& run) {
  Candidate candidate = run.log().run("read candidate", StageKind::Io,
                                      [&] { return read_candidate(options.candidate, decimal); });
  if (const auto* mesh = std::get_if<Mesh>(&candidate)) {
    for (const std::string& note : mesh->notes) run.note(display_name(options.candidate), note);
  }
  return candidate;
}

// A verdict, and what it is about.
Json about(const std::string& input, const VerifyArguments& options, const Json& verdict) {
  Json document = {{"input", input}, {"file", options.candidate}};
  document.update(verdict);
  return document;
}

// Each part of the input with the part of the candidate, and the gaps between these.
int run_verify_parts(const VerifyArguments& options) {
  const Promise promise = promise_of(options);
  VerifyRequest request = verify_request(options, promise);
  const Decimal decimal = meaning_of_numbers(promise, options.decimal);
  CommandRun run(options.global);
  SceneOptions in_parts = reading_of(options, decimal);
  in_parts.parts = true;
  const std::vector<SceneObject> input = run.read({options.input}, in_parts, "read input");
  const Candidate candidate = read_candidate_as(options, decimal, run);
  // Parts of one object can only be judged together.
  if (const auto* mesh = std::get_if<Mesh>(&candidate);
      input.size() == 1 && mesh != nullptr && objects_in(*mesh) > 1) {
    run.abandon();
    return run_union(options);
  }
  request.watch = run.watch();
  const auto outcome = verify_scene(input, candidate, request);
  if (const auto* flat = std::get_if<NotSolidPart>(&outcome)) {
    return run.end_flat(input[flat->part], flat->reason);
  }
  const auto& verdict = std::get<SceneVerdict>(outcome);
  for (const PartVerdict& part : verdict.parts) run.log().add(part.verdict.stages);
  const std::string name = display_name(options.input);
  return run.end({.json = [&] { return about(name, options, scene_verdict_json(verdict)); },
                  .text =
                      [&] {
                        return options.candidate + " as enclosures of the parts of " + name + "\n" +
                               scene_verdict_text(verdict) + "\n";
                      },
                  .exit = verdict.holds() ? 0 : 1});
}

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

// In one line, for a picture: the first claim that does not hold.
std::string answer_of(const VerifyArguments& options, Asks asks, const Verdict& verdict) {
  return file_name(options.candidate) + relation_of(asks) + file_name(options.input) + ": " +
         first_sentence(verdict);
}

int run_verify_candidate(const VerifyArguments& options) {
  const Promise promise = promise_of(options);
  VerifyRequest request = verify_request(options, promise);
  const Decimal decimal = meaning_of_numbers(promise, options.decimal);
  const std::string& picture = options.of_union.picture;
  if (!picture.empty()) require_outputs({picture}, {options.input, options.candidate});
  CommandRun run(options.global);
  const SceneObject input = run.read_one(options.input, reading_of(options, decimal), "read input");
  const Candidate candidate = read_candidate_as(options, decimal, run);
  request.watch = run.watch();
  request.used = used_flags(input);
  const VerifyOutcome outcome = verify(input.shape, candidate, request);
  if (const auto* reason = std::get_if<NotSolid>(&outcome)) return run.end_flat(input, *reason);
  const auto& verdict = std::get<Verdict>(outcome);
  run.log().add(verdict.stages);
  OutputFiles files;
  if (!picture.empty()) {
    files.emplace_back(
        picture, picture_html(verdict_picture(input, candidate, verdict, file_name(input.name),
                                              answer_of(options, request.asks, verdict))));
  }
  return run.end({.json = [&] { return about(input.name, options, verdict_json(verdict)); },
                  .text =
                      [&] {
                        return options.candidate + relation_of(request.asks) + input.name + "\n" +
                               verdict_table(verdict, options.inner || options.promise.is_asked()) +
                               (picture.empty() ? "" : "  written             " + picture + "\n") +
                               "\n";
                      },
                  .files = std::move(files),
                  .exit = verdict.holds() ? 0 : 1});
}

// What a command line asks about.
enum class Mode {
  Candidate,  // one solid
  EachPart,   // each part of INPUT by its own solid
  Union,      // the union of the parts of CANDIDATE
  Order,      // a removal order
};

Mode mode_of(const VerifyArguments& options) {
  if (!options.trace.trace.empty()) return Mode::Order;
  if (options.of_union.is_asked || options.of_union.given.has("distance") ||
      names_a_claim_of_parts(options) || is_decomposition(options.candidate)) {
    return Mode::Union;
  }
  return options.parts ? Mode::EachPart : Mode::Candidate;
}

// Options that say nothing in some mode are refused there. Of several, the first sentence is told.
void require_meaning(const VerifyArguments& options, Mode mode) {
  using enum Mode;
  const bool asks_inner = options.inner || options.promise.asks() == Asks::Inner;
  const std::string of_union = options.of_union.foreign_to_one_solid();
  const struct {
    bool is_given;
    std::vector<Mode> not_in;
    std::string sentence;
  } rules[] = {
      {options.parts, {Order}, "--parts: a trace describes one object"},
      {options.inner && options.promise.asks().value_or(Asks::Inner) != Asks::Inner,
       {Candidate, EachPart, Union, Order},
       "--inner is --asks inner: name one question"},
      {options.promise.given.has("asks"), {Order}, "--asks: a trace is judged step by step"},
      {asks_inner, {Order}, "--inner judges one CANDIDATE: no --trace, no --parts"},
      {asks_inner && options.parts,
       {EachPart, Union},
       "--inner judges one CANDIDATE: no --trace, no --parts"},
      {options.parts && (options.of_union.is_asked || options.of_union.given.has("distance")),
       {Union},
       "--parts judges parts one by one and --union all together: name one of them"},
      {options.inner, {Union}, "--inner judges one CANDIDATE, not a union of parts"},
      {options.promise.given.has("asks"),
       {Union},
       "--asks judges one CANDIDATE, not a union of parts"},
      {options.of_union.is_asked || !of_union.empty(),
       {Order},
       "--trace judges a removal order, not parts"},
      {!of_union.empty(), {Candidate, EachPart}, of_union + " needs --union"},
      {!options.of_union.picture.empty(),
       {EachPart, Order},
       "--picture shows one CANDIDATE, or a union of parts"},
      {names(options, ClaimCode::NoGaps), {Candidate, Order}, "--claims: no-gaps needs --parts"},
  };
  for (const auto& [is_given, not_in, sentence] : rules) {
    if (is_given && std::count(not_in.begin(), not_in.end(), mode) > 0) {
      throw Error(ErrorCode::InvalidArgument, sentence);
    }
  }
}

int run_verify(const VerifyArguments& options) {
  options.stdio.require_sensible();
  if (options.stdio.is_asked) return answer_lines(options.stdio, "verify");
  const bool has_candidate = !options.candidate.empty(), has_trace = !options.trace.trace.empty();
  if (options.input.empty() || has_candidate == has_trace) {
    throw Error(ErrorCode::InvalidArgument,
                "name an INPUT, and a CANDIDATE or a --trace, but not both; or --stdio");
  }
  if (options.input == "-" && options.candidate == "-") {
    throw Error(ErrorCode::InvalidArgument, "standard input, -, can be read only once");
  }
  const Mode mode = mode_of(options);
  require_meaning(options, mode);
  switch (mode) {
    case Mode::Union:
      return run_union(options);
    case Mode::EachPart:
      return run_verify_parts(options);
    case Mode::Candidate:
      return run_verify_candidate(options);
    case Mode::Order:
      break;
  }
  SceneOptions reading =
      reading_of(options, meaning_of_numbers(promise_of(options), options.decimal));
  reading.points = options.points;
  return run_verify_trace(options.global, options.input, reading, options.trace);
}

}  // namespace

void add_verify_command(Command& program, int& exit_code) {
  auto options = std::make_shared<VerifyArguments>();
  Command& command = *program.add_subcommand(
      "verify",
      "decide exactly whether an output is a convex solid that contains its input, or parts "
      "whose union does");
  command.footer(kVerifyFooter);
  command.add_option("INPUT", options->input,
                     "the shape to be enclosed: a mesh or points (OBJ, OFF, PLY, STL, glTF, "
                     "COLLADA, XYZ), or halfspaces");
  command.add_option(
      "CANDIDATE", options->candidate,
      "the output to be judged: a mesh, or halfspaces (JSON, .ine, rows n1 n2 n3 d); with --union "
      "a mesh with an object per part, a folder of meshes, or JSON with \"parts\"");
  add_claims_option(command, options->claims, "decide these claims only, separated by commas");
  command.add_flag("--parts", options->parts,
                   "judge each object of INPUT by the object of CANDIDATE with its name, and "
                   "whether the faces of INPUT lie in the solids of their parts: claim no-gaps");
  add_promise_options(command, options->promise, "as the profile says, else enclosure");
  add_fields(command, bound_fields(verify_fields(), options->request, {"exact_facets"}));
  command.add_flag("--inner", options->inner,
                   "judge an inner solid: whether it lies in the hull of INPUT, not around it (as "
                   "--asks inner)");
  command.add_flag("--no-tightness", options->no_tightness,
                   "do not measure volume, area, mean width and distance");
  add_union_options(command, options->of_union);
  add_points_option(command, options->points);
  add_decimal_option(command, options->decimal);
  add_skip_bad_option(command, options->skip_bad);
  add_trace_options(command, options->trace);
  add_stdio_options(command, options->stdio, "one verdict");
  finish_command(command, options, exit_code, run_verify);
  add_stages_option(command, options->global);
  command.show_first({"--asks", "--claims", "--profile", "--tolerance", "--max-facets",
                      "--max-vertices", "--parts", "--union", "--distance", "--measures", "--trace",
                      "--picture", "--inner", "--json"});
}

}  // namespace convexact::cli
