// SPDX-License-Identifier: MIT
// convexact query: overlap of two solids, rays against a solid, false positives of one solid around
// another.
#include <memory>
#include <optional>

#include "cli/outputs.hpp"
#include "cli/progress.hpp"
#include "convexact/hull_tree.hpp"
#include "convexact/io.hpp"
#include "convexact/query.hpp"
#include "convexact/scene.hpp"
#include "io/json.hpp"
#include "solid/solid.hpp"
#include "wire/query_report.hpp"
#include "wire/stage_report.hpp"
#include "wire/tree_report.hpp"

namespace convexact::cli {
namespace {

constexpr const char* kQueryFooter =
    "Examples:\n"
    "  convexact query overlap bunny.obj box.json\n"
    "  convexact query rays bunny.obj rays.txt --json\n"
    "  convexact query rays bunny_tree.json rays.txt\n"
    "  convexact query false-positives bunny.obj bunny12.json\n"
    "\n"
    "Every answer is exact; those about overlap and rays are checked by their definition before\n"
    "they are printed. A mesh stands for the convex hull of its points, a list of halfspaces for\n"
    "their intersection. Solids are closed: touching counts. Halfspaces are named by their\n"
    "positions in canonical order, as convexact hull --json lists them.\n"
    "\n"
    "A tree of convexact bvh stands for the union of its parts. Its hulls are tested to hold "
    "their\n"
    "children, then only nodes below a hull that is met are tested; every visit is checked.";

constexpr const char* kOverlapFooter =
    "Example:\n"
    "  convexact query overlap bunny.obj box.json --json\n"
    "\n"
    "Prints a common point; or halfspaces of both that no point satisfies together, with their\n"
    "multipliers, and a plane strictly between the two. Exit code 0 for either answer.";

constexpr const char* kRaysFooter =
    "Example:\n"
    "  convexact query rays bunny.obj rays.txt\n"
    "\n"
    "FILE has a ray origin + t direction, t >= 0, on each line: ox oy oz ux uy uz. Entry and exit\n"
    "are those of the ray's whole line, as fractions, each with all halfspaces that the line\n"
    "crosses there; a ray that begins inside has an entry below 0.";

constexpr const char* kFalsePositivesFooter =
    "Example:\n"
    "  convexact query false-positives bunny.obj bunny12.json --lines 20000 --planes 0 --points 0\n"
    "\n"
    "The rate is the share of the probes that hit B and miss A, among those that hit B. If A is\n"
    "inside B, it is expected to be 1 - M(A)/M(B): M is the area for lines, the mean width for\n"
    "planes, the volume for points; sigma is its standard deviation. If A is not inside B, this\n"
    "is reported instead of a predicted rate.";

struct QueryArguments {
  GlobalOptions global;
  std::string a, b, rays;
  SceneOptions scene;
  FalsePositiveRequest probes;
};

// A query as it runs: its stages, and the solids that it is about.
class RunningQuery {
 public:
  explicit RunningQuery(const QueryArguments& options) : options_(options), run_(options.global) {}

  /// The exit code if one of the inputs is no solid, which is then reported.
  std::optional<int> read_solids(const std::vector<std::string>& paths) {
    for (const SceneObject& object : run_.read(paths, options_.scene)) {
      StageLog log(run_.watch());
      SolidOutcome outcome =
          make_solid(object.shape, {.seed = options_.global.seed, .wants_dual = false}, log);
      run_.log().add(log.stages());
      if (const auto* reason = std::get_if<NotSolid>(&outcome)) {
        return run_.end_flat(object, *reason);
      }
      names_.push_back(object.name);
      solids_.push_back(std::get<Solid>(std::move(outcome)).polytope);
    }
    return {};
  }
  NamedPolytope operator[](std::size_t k) const { return {names_[k], solids_[k]}; }
  StageLog& log() { return run_.log(); }
  int end(const CommandAnswer& answer) { return run_.end(answer); }

 private:
  const QueryArguments& options_;
  CommandRun run_;
  std::vector<std::string> names_;
  std::vector<Polytope> solids_;
};

void require(bool is_true) {
  if (!is_true) throw Error(ErrorCode::Internal, "the answer to a query fails its check");
}

// The tree in a file of convexact bvh; nothing if it holds none.
std::optional<HullTree> tree_in(const std::string& path, Decimal decimal) {
  if (halfspace_format_of_path(path) != HalfspaceFormat::Json) return {};
  const auto bytes = std::make_shared<const std::string>(read_bytes(path));
  if (bytes->find("\"hull_tree\"") == bytes->npos) return {};
  CandidateParts read = read_parts_bytes(*bytes, path, decimal);
  if (auto* error = std::get_if<Error>(&read)) throw std::move(*error);
  auto* tree = std::get_if<HullTree>(&read);
  if (tree == nullptr) return {};
  remember_input(path, bytes);
  return std::move(*tree);
}

// A tree that is queried, and the names of its parts.
class AskedTree {
 public:
  AskedTree(const std::string& path, const HullTree& tree, StageLog& log)
      : path_(path), tree_(log.run("nesting", [&] { return searched(path, tree, log); })) {
    for (const NamedPart& part : tree.parts) names_.push_back(part.name);
  }
  const SearchTree& operator*() const { return tree_; }
  NamedTree named() const { return {path_, tree_, names_}; }

 private:
  static SearchTree searched(const std::string& path, const HullTree& tree, const StageLog& log) {
    try {
      return SearchTree(tree, log.watch("nesting"));
    } catch (const Error& error) {
      if (error.code() == ErrorCode::Stopped) throw;
      throw error.in_file(path);
    }
  }

  std::string path_;
  SearchTree tree_;
  std::vector<std::string> names_;
};

int run_tree_overlap(const QueryArguments& options, const HullTree& read) {
  RunningQuery query(options);
  if (const auto exit = query.read_solids({options.b})) return *exit;
  const AskedTree tree(options.a, read, query.log());
  const NamedPolytope b = query[0];
  const TreeOverlap answer =
      query.log().run("overlap", [&] { return find_overlap(*tree, b.solid, options.global.seed); });
  query.log().run("check", [&] { require(check(*tree, b.solid, answer)); });
  return query.end({[&] { return overlap_json(tree.named(), b, answer); },
                    [&] { return overlap_text(tree.named(), b, answer); }});
}

int run_overlap(const QueryArguments& options) {
  if (const auto tree = tree_in(options.a, options.scene.decimal)) {
    return run_tree_overlap(options, *tree);
  }
  RunningQuery query(options);
  if (const auto exit = query.read_solids({options.a, options.b})) return *exit;
  const NamedPolytope a = query[0], b = query[1];
  const Overlap answer = query.log().run(
      "overlap", [&] { return find_overlap(a.solid, b.solid, options.global.seed); });
  query.log().run("check", [&] { require(check(a.solid, b.solid, answer)); });
  return query.end(
      {[&] { return overlap_json(a, b, answer); }, [&] { return overlap_text(a, b, answer); }});
}

std::vector<Ray> rays_of(const QueryArguments& options) {
  if (options.a == "-" && options.rays == "-") {
    throw Error(ErrorCode::InvalidArgument, "standard input, -, can be read only once");
  }
  const std::string file = display_name(options.rays);
  const auto bytes = std::make_shared<const std::string>(read_bytes(options.rays));
  remember_input(file, bytes);
  try {
    return read_rays_bytes(*bytes, options.scene.decimal);
  } catch (const Error& error) {
    throw error.in_file(file);
  }
}

// The answers to all rays; each is then checked by its definition.
template <class Asked>
auto cast_all(const Asked& asked, const std::vector<Ray>& rays, StageLog& log) {
  std::vector<decltype(cast_ray(asked, rays.front()))> answers;
  log.run("rays", [&] {
    const Watch watch = log.watch("rays");
    for (const Ray& ray : rays) {
      watch.at(answers.size(), rays.size());
      answers.push_back(cast_ray(asked, ray));
    }
  });
  log.run("check", [&] {
    const Watch watch = log.watch("check");
    for (std::size_t i = 0; i < rays.size(); ++i) {
      watch.at(i, rays.size());
      require(check(asked, rays[i], answers[i]));
    }
  });
  return answers;
}

int run_tree_rays(const QueryArguments& options, const HullTree& read) {
  RunningQuery query(options);
  const std::vector<Ray> rays =
      query.log().run("read", StageKind::Io, [&] { return rays_of(options); });
  const AskedTree tree(options.a, read, query.log());
  const auto answers = cast_all(*tree, rays, query.log());
  return query.end({[&] { return rays_json(tree.named(), answers); },
                    [&] { return rays_text(tree.named(), answers); }});
}

int run_rays(const QueryArguments& options) {
  if (const auto tree = tree_in(options.a, options.scene.decimal)) {
    return run_tree_rays(options, *tree);
  }
  RunningQuery query(options);
  const std::vector<Ray> rays =
      query.log().run("read", StageKind::Io, [&] { return rays_of(options); });
  if (const auto exit = query.read_solids({options.a})) return *exit;
  const NamedPolytope a = query[0];
  const auto answers = cast_all(a.solid, rays, query.log());
  return query.end({[&] { return rays_json(a, answers); }, [&] { return rays_text(a, answers); }});
}

int run_false_positives(const QueryArguments& options) {
  RunningQuery query(options);
  if (const auto exit = query.read_solids({options.a, options.b})) return *exit;
  const NamedPolytope a = query[0], b = query[1];
  FalsePositiveRequest request = options.probes;
  request.seed = options.global.seed;
  request.watch = query.log().watch("probes");
  const FalsePositives found =
      query.log().run("probes", [&] { return count_false_positives(a.solid, b.solid, request); });
  return query.end({[&] { return false_positives_json(a, b, found); },
                    [&] { return false_positives_text(a, b, found); }});
}

void add_solid(Command& command, const std::string& name, std::string& path,
               const std::string& meaning) {
  command
      .add_option(name, path,
                  meaning +
                      ": mesh or points (OBJ, OFF, PLY, STL, glTF, COLLADA, XYZ) or halfspaces "
                      "(JSON, .ine, "
                      "rows); - is standard input")
      ->required();
}

void finish_query(Command& command, const std::shared_ptr<QueryArguments>& options, int& exit_code,
                  int (*run)(const QueryArguments&)) {
  options->scene.on_read = remember_input;
  add_decimal_option(command, options->scene.decimal);
  finish_command(command, options, exit_code, run);
  add_stages_option(command, options->global);
}

void add_probes(Command& command, const std::string& name, std::size_t& samples,
                const std::string& meaning) {
  add_count(command, name, samples, {0, 1'000'000'000}, meaning);
}

}  // namespace

void add_query_command(Command& program, int& exit_code) {
  Command& command =
      *program.add_subcommand("query", "overlap, rays and false positives, answered exactly");
  command.footer(kQueryFooter);
  command.require_subcommand(1);

  Command& overlap =
      *command.add_subcommand("overlap", "whether two solids have a point in common");
  overlap.footer(kOverlapFooter);
  auto options = std::make_shared<QueryArguments>();
  add_solid(overlap, "A", options->a, "a solid, or a tree of convexact bvh");
  add_solid(overlap, "B", options->b, "another one");
  finish_query(overlap, options, exit_code, run_overlap);

  Command& rays = *command.add_subcommand("rays", "where rays enter and leave a solid");
  rays.footer(kRaysFooter);
  options = std::make_shared<QueryArguments>();
  add_solid(rays, "A", options->a, "a solid, or a tree of convexact bvh");
  rays.add_option("FILE", options->rays,
                  "the rays, a line of six numbers each; - is standard input")
      ->required();
  finish_query(rays, options, exit_code, run_rays);

  Command& probes = *command.add_subcommand(
      "false-positives", "how often random probes hit a solid and not one inside it");
  probes.footer(kFalsePositivesFooter);
  options = std::make_shared<QueryArguments>();
  add_solid(probes, "A", options->a, "a solid");
  add_solid(probes, "B", options->b, "the solid around it");
  add_probes(probes, "--lines", options->probes.lines, "lines through a ball around both");
  add_probes(probes, "--planes", options->probes.planes, "planes through it");
  add_probes(probes, "--points", options->probes.points, "points of it");
  finish_query(probes, options, exit_code, run_false_positives);
  probes.get_option("--seed")->description("seed of the probes");
}

}  // namespace convexact::cli
