// SPDX-License-Identifier: MIT
// convexact generate: the families of shapes as files, and files that no reader may accept.
#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>

#include "cli/command.hpp"
#include "cli/outputs.hpp"
#include "cli/shipped_vectors.hpp"
#include "convexact/hull.hpp"
#include "convexact/io.hpp"
#include "convexact/shapes.hpp"
#include "io/json.hpp"

namespace convexact::cli {
namespace {

namespace fs = std::filesystem;

using shapes::Family;
using shapes::MalformedFile;
using shapes::Parameter;

constexpr const char* kGenerateFooter =
    "Examples:\n"
    "  convexact generate --list\n"
    "  convexact generate needle --points 100 --aspect 1e300 --seed 7 -o needle.obj\n"
    "  convexact generate cospherical --squared-radius 89 --facets -o sphere.ply\n"
    "  convexact generate malformed-off-count-too-large -o broken.off\n"
    "  convexact generate --any --seed 12345 -o any.obj\n"
    "  convexact generate --vector prism-five-hull -o prism.obj\n"
    "\n"
    "The same family, seed and values give the same bytes on every machine. Coordinates are\n"
    "written so that the same doubles are read back. convexact generate FAMILY --help shows the\n"
    "parameters of a family.";

struct GenerateArguments {
  GlobalOptions global;
  std::string output;
  bool list = false;
  bool facets = false;
  bool any = false;
  std::string vector, vectors;
  std::function<int()> work;  ///< Of the family that was named.
};

Json parameter_json(const Parameter& p) {
  return {{"name", p.name}, {"meaning", p.meaning}, {"least", p.least},
          {"most", p.most}, {"default", p.usual},   {"integer", p.whole}};
}

void print_list_json() {
  Json families = Json::array();
  for (const Family& f : shapes::families()) {
    Json parameters = Json::array();
    for (const Parameter& p : f.parameters) parameters.push_back(parameter_json(p));
    families.push_back({{"name", f.name},
                        {"description", f.description},
                        {"dimension", f.dimension},
                        {"parameters", parameters}});
  }
  Json malformed = Json::array();
  for (const MalformedFile& file : shapes::malformed_files()) {
    malformed.push_back({{"name", file.name},
                         {"description", file.description},
                         {"extension", file.extension()},
                         {"error", file.not_finite ? "not-finite" : "malformed"}});
  }
  print(Json{{"families", families}, {"malformed", malformed}});
}

void print_list() {
  std::string text = "Families of points (dimension, and --parameter with its default):\n";
  for (const Family& f : shapes::families()) {
    text += fmt::format("  {:<22}{}D  {}\n", f.name, f.dimension, f.description);
    for (const Parameter& p : f.parameters) {
      text +=
          fmt::format("      --{} {}: {}, {} to {}\n", p.name, p.usual, p.meaning, p.least, p.most);
    }
  }
  text += "\nFiles that no reader may accept (no parameters):\n";
  for (const MalformedFile& file : shapes::malformed_files()) {
    text += fmt::format("  {:<34}{}\n", file.name, file.description);
  }
  print(text);
}

// STL has triangles only, and for a hull any triangles serve: the points three by three, with the
// last one repeated at the end.
void add_triangles_over_points(Mesh& mesh) {
  const auto size = static_cast<std::uint32_t>(mesh.points.size());
  for (std::uint32_t k = 0; k < size; k += 3) {
    mesh.polygons.push_back({k, std::min(k + 1, size - 1), std::min(k + 2, size - 1)});
  }
}

void add_hull_facets(Mesh& mesh, const std::string& family) {
  const HullOutcome outcome = convex_hull(mesh.points);
  const auto* hull = std::get_if<Hull>(&outcome);
  if (hull == nullptr) {
    throw Error(ErrorCode::NoInterior, family + " with these values spans no volume: no facets");
  }
  mesh.polygons = polygons_of(hull->facets);
}

// The bytes go to the file, and messages to standard output; without a file and messages, the bytes
// go to standard output.
void write(const GenerateArguments& options, const std::string& bytes, const std::string& told) {
  if (options.output.empty()) return print(told.empty() ? bytes : told);
  write_together({{options.output, bytes}}, told);
}

MeshFormat format_of(const GenerateArguments& options) {
  if (options.output.empty()) return MeshFormat::Obj;
  const std::optional<MeshFormat> format = mesh_format_of_path(options.output);
  if (!format) {
    throw Error(
        ErrorCode::InvalidArgument,
        "-o: expected a file with the extension .obj, .off, .ply, .stl, .glb or .xyz, found '" +
            options.output + "'");
  }
  return *format;
}

Json document_of(const Family& family, const std::vector<double>& values, std::uint64_t seed,
                 const Mesh& mesh) {
  Json parameters = Json::object();
  for (std::size_t i = 0; i < values.size(); ++i) {
    Json& value = parameters[std::string(family.parameters[i].name)];
    value = values[i];
    if (family.parameters[i].whole) value = static_cast<std::int64_t>(values[i]);
  }
  Json points = Json::array();
  for (const Point& p : mesh.points.doubles()) points.push_back({p.x(), p.y(), p.z()});
  Json document = {
      {"family", family.name}, {"parameters", parameters}, {"seed", seed}, {"points", points}};
  if (!mesh.polygons.empty()) document["facets"] = mesh.polygons;
  return document;
}

int run_family(const GenerateArguments& options, const Family& family,
               const std::vector<double>& values) {
  const MeshFormat format = format_of(options);
  Mesh mesh;
  mesh.points = PointSet(shapes::generate(family, values, options.global.seed));
  if (options.facets) add_hull_facets(mesh, std::string(family.name));
  std::string document;
  if (options.global.json) {
    document = write_json(document_of(family, values, options.global.seed, mesh), 2) + "\n";
  }
  if (holds_binary32_only(format) && mesh.polygons.empty()) add_triangles_over_points(mesh);
  write(options, write_mesh(mesh, format), document);
  return 0;
}

// The command that makes the same again.
std::string command_of(const Family& family, const std::vector<double>& values,
                       std::uint64_t seed) {
  std::string text = fmt::format("convexact generate {}", family.name);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Parameter& p = family.parameters[i];
    text += p.whole ? fmt::format(" --{} {:.0f}", p.name, values[i])
                    : fmt::format(" --{} {}", p.name, values[i]);
  }
  return text + fmt::format(" --seed {}\n", seed);
}

int run_any(const GenerateArguments& options) {
  const auto [family, values] = shapes::any_family(options.global.seed);
  const int exit_code = run_family(options, *family, values);
  // Standard output has the points, or the document with the parameters.
  if (!options.global.json) std::cerr << command_of(*family, values, options.global.seed);
  return exit_code;
}

// The input of a conformance vector, as conform gives it to a program.
int run_vector(const GenerateArguments& options) {
  const std::vector<TestVector> vectors = read_vectors(options.vectors);
  const TestVector& vector = vector_of_id(vectors, options.vector);
  std::string format = fs::path(options.output).extension().string();
  if (!format.empty()) format.erase(0, 1);
  if (options.output.empty()) {
    const auto* file = std::get_if<RawFile>(&vector.input);
    const bool is_mesh = std::holds_alternative<PointSet>(vector.input);
    format = is_mesh ? "obj" : file != nullptr ? file->extension : "json";
  }
  std::optional<std::string> bytes;
  if (mesh_format_of_path("." + format) || halfspace_format_of_path("." + format)) {
    bytes = input_bytes(vector, format);
  }
  if (!bytes) {
    throw Error(ErrorCode::InvalidArgument, "-o " + options.output +
                                                ": no format that holds the vector " + vector.id +
                                                ", " + vector.title);
  }
  write(options, *bytes, "");
  return 0;
}

int run_malformed(const GenerateArguments& options, const MalformedFile& file) {
  const std::string extension = fs::path(options.output).extension().string();
  if (!options.output.empty() && extension != "." + std::string(file.extension())) {
    throw Error(ErrorCode::InvalidArgument, file.name + ": -o takes a file with the extension ." +
                                                std::string(file.extension()) + ", found '" +
                                                options.output + "'");
  }
  if (options.facets || options.global.json) {
    throw Error(ErrorCode::InvalidArgument, file.name + ": takes neither --facets nor --json");
  }
  write(options, file.bytes, "");
  return 0;
}

// @param names  Of families and files, or of the options of the family that was named.
int run_generate(const GenerateArguments& options, const std::vector<std::string>& unknown,
                 const std::vector<std::string>& names) {
  if (!unknown.empty()) {
    const bool is_option = unknown.front().starts_with("-");
    const std::string meant = did_you_mean(unknown.front(), names);
    throw Error(ErrorCode::InvalidArgument,
                fmt::format("there is no {} called '{}'{} convexact generate --list names them",
                            is_option ? "parameter or option" : "family", unknown.front(),
                            meant.empty() ? ";" : meant));
  }
  require_outputs({options.output}, {});
  const int asked = (options.work ? 1 : 0) + (options.any ? 1 : 0) +
                    (options.vector.empty() ? 0 : 1) + (options.list ? 1 : 0);
  if (asked != 1) {
    throw Error(ErrorCode::InvalidArgument,
                "expected a family, or one of --any, --vector ID and --list");
  }
  if (options.work) return options.work();
  if (options.any) return run_any(options);
  if (!options.vector.empty()) return run_vector(options);
  if (options.global.json) {
    print_list_json();
  } else {
    print_list();
  }
  return 0;
}

// Whole numbers from 0 on are counts; one family takes a negative exponent.
void add_parameter(Command& entry, const Parameter& p, double& value) {
  const std::string name = "--" + std::string(p.name);
  if (p.whole && p.least >= 0) {
    const CountRange range{static_cast<std::uint64_t>(p.least), static_cast<std::uint64_t>(p.most)};
    add_count(entry, name, value, range, std::string(p.meaning));
    return;
  }
  add_text(entry, name, fmt::format("{}, {} to {}", p.meaning, p.least, p.most),
           [&value](const auto& option, const auto& text) { value = parse_decimal(option, text); })
      ->type_name(p.whole ? "INTEGER" : "NUMBER")
      ->default_str(fmt::format("{}", value));
}

void add_family(Command& command, const Family& family, GenerateArguments& options) {
  auto values = std::make_shared<std::vector<double>>(shapes::usual_values(family));
  Command& entry =
      *command.add_subcommand(std::string(family.name), std::string(family.description))
           ->fallthrough()
           ->group("Families of points");
  for (std::size_t i = 0; i < family.parameters.size(); ++i) {
    const Parameter& p = family.parameters[i];
    add_parameter(entry, p, (*values)[i]);
  }
  entry.callback([&family, values, &options] {
    options.work = [&family, values, &options] { return run_family(options, family, *values); };
  });
}

void add_malformed(Command& command, const MalformedFile& file, GenerateArguments& options) {
  Command& entry = *command.add_subcommand(file.name, file.description)
                        ->fallthrough()
                        ->group("Files that no reader may accept");
  entry.callback([&file, &options] {
    options.work = [&file, &options] { return run_malformed(options, file); };
  });
}

// What a word that nothing takes may have been meant to be.
std::vector<std::string> names_in(const Command& command) {
  std::vector<std::string> names;
  const auto add_options = [&](const Command& of) {
    for (const Option& option : of.options()) names.push_back(option.name());
  };
  add_options(command);
  if (const Command* family = command.parsed_subcommand()) {
    add_options(*family);
  } else {
    for (const auto& family : command.subcommands()) names.push_back(family->name());
  }
  return names;
}

}  // namespace

void add_generate_command(Command& program, int& exit_code) {
  auto options = std::make_shared<GenerateArguments>();
  Command& command =
      *program.add_subcommand("generate", "write hard inputs: families of points by name");
  command.footer(kGenerateFooter);
  command.require_subcommand(0, 1);
  command.allow_extras();  // so that an unknown family gets a separate message
  command.add_flag("--list", options->list, "name every family with its parameters");
  command.add_option(
      "-o,--output", options->output,
      "the file, by its extension .obj .off .ply .stl .xyz; without it OBJ on standard "
      "output");
  command.add_flag("--facets", options->facets,
                   "write the facets of the exact hull too, for programs that need a closed mesh");
  command.add_flag("--any", options->any,
                   "a random family with random parameters, by --seed; what it is goes to standard "
                   "error");
  command.add_option("--vector", options->vector,
                     "the input of the conformance vector with this id, as conform gives it");
  command.add_option("--vectors", options->vectors,
                     "a folder of vectors (default: the shipped ones)");
  add_global_options(command, options->global);
  command.get_option("--seed")->description("seed of the random families");
  // These are hundreds.
  command.when_named([&command, options] {
    for (const Family& family : shapes::families()) add_family(command, family, *options);
    for (const MalformedFile& file : shapes::malformed_files()) {
      add_malformed(command, file, *options);
    }
  });
  command.callback([&command, options, &exit_code] {
    exit_code = run_guarded(options->global, [&] {
      return run_generate(*options, command.remaining(), names_in(command));
    });
  });
}

}  // namespace convexact::cli
