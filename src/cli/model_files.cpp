// SPDX-License-Identifier: MIT
#include "cli/model_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "cli/options.hpp"
#include "convexact/io.hpp"
#include "convexact/mass.hpp"
#include "io/file_kind.hpp"
#include "io/mesh_readers.hpp"
#include "number/text.hpp"
#include "wire/mass_report.hpp"
#include "wire/part_models.hpp"

namespace convexact::cli {
namespace {

namespace fs = std::filesystem;

// From the place of the model, which readers take paths to be relative to. Neither has to exist.
std::vector<PartFile> files_in(const std::string& folder, const std::string& model,
                               std::span<const WrittenPart> parts) {
  const fs::path place = fs::weakly_canonical(fs::absolute(model).parent_path());
  const fs::path target = fs::weakly_canonical(fs::absolute(folder));
  std::vector<PartFile> files;
  for (const WrittenPart& part : parts) {
    const fs::path file = target / part_file_name(part.name);
    files.push_back({part.name, file.lexically_relative(place).generic_string()});
  }
  return files;
}

// Readers of URDF show OBJ, STL and COLLADA.
std::string visual_of(const std::string& input, const std::string& model) {
  const std::string extension = lower_case(fs::path(input).extension().string());
  if (extension != ".obj" && extension != ".stl" && extension != ".dae") return "";
  // Readers apply the unit of a COLLADA, and parts have none: the two would differ in size.
  if (extension == ".dae" && collada_unit(read_bytes(input)) != 1) return "";
  const fs::path place = fs::weakly_canonical(fs::absolute(model).parent_path());
  return fs::weakly_canonical(fs::absolute(input)).lexically_relative(place).generic_string();
}

// The mass of all objects together, told in `out`; of an open surface that of the union of its
// parts.
std::optional<MassProperties> mass_of(std::span<const DecomposedObject> objects, const Watch& watch,
                                      ModelOfParts& out) {
  std::vector<MassProperties> bodies;
  for (const DecomposedObject& object : objects) {
    const Decomposition& result = object.result;
    std::optional<MassProperties> mass;
    if (result.surface.is_closed) mass = mass_properties(result.surface, watch);
    if (!mass) {
      std::vector<ConvexPart> parts;
      for (const Part& part : result.parts) parts.push_back(convex_part(part.mesh.points, watch));
      mass = mass_properties(parts, watch);
      out.notes.push_back("the mass is that of the parts, as the faces of " + object.name +
                          " enclose no solid");
    }
    if (mass) bodies.push_back(std::move(*mass));
  }
  return put_together(bodies);
}

// MuJoCo refuses meshes of less.
void note_small_parts(std::span<const WrittenPart> parts, const ModelOptions& model,
                      ModelOfParts& out) {
  const Rational least = parse_rational("1e-15");
  const Rational cubed = model.scale * model.scale * model.scale;
  std::size_t count = 0;
  for (const WrittenPart& part : parts) {
    const ConvexPart convex = convex_part(part.part->mesh.points);
    if (!convex.solid || volume(*convex.solid) * cubed < least) ++count;
  }
  if (count > 0) {
    out.notes.push_back(counted(count, "part has", "parts have") +
                        " a volume below 1e-15, and MuJoCo refuses such meshes: --scale");
  }
}

}  // namespace

bool names_files(PartsOutput kind) {
  return kind == PartsOutput::Mjcf || kind == PartsOutput::Urdf;
}

bool is_model(PartsOutput kind) { return names_files(kind) || kind == PartsOutput::Usd; }

bool is_binary32(PartsOutput kind) { return is_model(kind) || kind == PartsOutput::Glb; }

std::string model_name(const std::string& path, PartsOutput kind) {
  const std::string name = fs::path(path).filename().string();
  const std::size_t extension = kind == PartsOutput::Mjcf ? kMjcfExtension.size() : 5;
  return name.substr(0, name.size() - extension);
}

void require_sensible_models(const std::vector<std::string>& outputs,
                             const DecomposeRequest& request) {
  const auto folders = std::count_if(outputs.begin(), outputs.end(), is_folder);
  for (const std::string& path : outputs) {
    const PartsOutput kind = parts_output_of(path);
    if (!is_binary32(kind)) continue;
    if (request.precision != Precision::Binary32) {
      throw Error(
          ErrorCode::InvalidArgument,
          "-o " + path + ": " +
              (kind == PartsOutput::Glb ? "GLB holds binary32 numbers, and rounding to the "
                                          "nearest one cuts off points "
                                        : "simulators round to the nearest binary32 number, "
                                          "which cuts off points ") +
              "of the input; --precision 32 rounds outward before that");
    }
    if (request.flat == FlatParts::Keep) {
      throw Error(ErrorCode::InvalidArgument,
                  "-o " + path +
                      ": a part that stays flat is no solid there; --flat thicken, the "
                      "default, makes it one");
    }
    if (names_files(kind) && folders != 1) {
      throw Error(ErrorCode::InvalidArgument,
                  "-o " + path +
                      ": it names the files of the parts, so one folder for them is "
                      "needed, such as -o parts/, and there are several");
    }
  }
}

ModelOfParts model_of(std::span<const DecomposedObject> objects, std::span<const WrittenPart> parts,
                      const std::vector<std::string>& outputs, const ModelOptions& options,
                      const Watch& watch) {
  ModelOfParts model;
  model.body = {options.name, options.up, to_double(options.scale, Rounding::Nearest)};
  const bool is_for_mujoco = std::any_of(
      outputs.begin(), outputs.end(),
      [](const std::string& path) { return parts_output_of(path) == PartsOutput::Mjcf; });
  if (is_for_mujoco) note_small_parts(parts, options, model);
  const std::optional<MassProperties> mass = mass_of(objects, watch, model);
  if (mass) model.body.mass = body_mass(*mass, options.density, options.scale);
  if (!model.body.mass) {
    model.notes.push_back("the model has no mass: it is 0 or beyond the doubles");
    return model;
  }
  const double kilograms = model.body.mass->mass;
  model.mass = mass_json(*mass);
  model.mass["density"] = options.density;
  model.mass["scale"] = options.scale;
  model.mass["kilograms"] = kilograms;
  model.summary = summary_line(
      "mass", fmt::format("{:.6g} kg, at {} kg/m3 and {} m a unit", kilograms,
                          to_decimal(options.density, 6), to_decimal(options.scale, 6)));
  return model;
}

std::string model_bytes(const std::string& path, const std::vector<std::string>& outputs,
                        ModelBody body, std::span<const WrittenPart> parts,
                        const std::string& input) {
  const PartsOutput kind = parts_output_of(path);
  if (body.name.empty()) body.name = model_name(path, kind);
  if (kind == PartsOutput::Usd) return proven_parts_usd(body, parts, path);
  const std::string& folder = *std::find_if(outputs.begin(), outputs.end(), is_folder);
  const std::vector<PartFile> names = files_in(folder, path, parts);
  if (kind == PartsOutput::Mjcf) return write_mjcf(body, names);
  body.visual = visual_of(input, path);
  return write_urdf(body, names);
}

namespace {

// A positive decimal, as spelled.
Rational positive(const std::string& option, const std::string& text) {
  try {
    Rational value = parse_rational(text);
    if (value > 0) return value;
  } catch (const Error&) {
  }
  throw Error(ErrorCode::InvalidArgument,
              option + ": expected a number above 0, found " + in_quotes(text));
}

}  // namespace

void add_model_options(Command& command, ModelOptions& model) {
  command.add_option("--name", model.name,
                     "of the body in a model; without it, the name of the model's file");
  add_text(command, "--up", "the axis of INPUT that points upward in a model, y or z",
           [&model](const auto& option, const auto& text) {
             if (text != "y" && text != "z") {
               throw Error(ErrorCode::InvalidArgument,
                           option + ": expected y or z, found " + in_quotes(text));
             }
             model.up = text == "y" ? UpAxis::Y : UpAxis::Z;
           })
      ->type_name("AXIS")
      ->default_str("z");
  add_text(command, "--scale",
           "meters for each unit of INPUT, as an attribute of a model: 0.001 of millimeters",
           [&model](const auto& option, const auto& text) { model.scale = positive(option, text); })
      ->type_name("FACTOR")
      ->default_str("1");
  add_text(
      command, "--density", "kilograms for each cubic meter: mass and inertia of a model",
      [&model](const auto& option, const auto& text) { model.density = positive(option, text); })
      ->default_str("1000");
}

}  // namespace convexact::cli
