// SPDX-License-Identifier: MIT
#include "wire/inner_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "convexact/stored.hpp"
#include "io/json.hpp"
#include "number/precision.hpp"
#include "number/text.hpp"
#include "scene/objects.hpp"
#include "simplify/run_names.hpp"
#include "wire/trace_json.hpp"

namespace convexact {
namespace {

std::size_t tied_steps(const InnerRun& run) {
  return static_cast<std::size_t>(std::count_if(
      run.steps.begin(), run.steps.end(), [](const Step& step) { return step.tie.size() > 1; }));
}

std::string mesh_bytes(std::span<const NamedInner> results, MeshFormat format) {
  if (results.size() == 1) return write_mesh(results[0].result->mesh.value(), format);
  std::vector<NamedMesh> objects;
  for (const auto& [name, result] : results) objects.push_back({name, &result->mesh.value()});
  return write_mesh(joined(objects), format);
}

// The file's points are the vertices of the results, one result after another, bit for bit except
// for the sign of zeros; and they lie in the exact hulls of the inputs.
void prove_mesh(const std::string& bytes, const std::string& path, MeshFormat format,
                std::span<const NamedInner> results) {
  const Mesh mesh = read_mesh_bytes(bytes, {.format = format});
  std::size_t first = 0;
  for (const NamedInner& part : results) {
    const auto expected = part.result->mesh->points.doubles();
    if (!mesh.points.is_binary() || first + expected.size() > mesh.points.size()) {
      reject_bytes(path, "lacks vertices");
    }
    const auto found = mesh.points.doubles().subspan(first, expected.size());
    if (!std::equal(expected.begin(), expected.end(), found.begin())) {
      reject_bytes(path, "has a vertex that is no point of the input");
    }
    const PointSet corners(std::vector<Point>(found.begin(), found.end()));
    if (count_outside(part.result->hull, corners) > 0) {
      reject_bytes(path, "has a vertex outside of the input's hull");
    }
    first += expected.size();
  }
  if (first != mesh.points.size()) reject_bytes(path, "has points of no result");
}

}  // namespace

Json inner_json(const InnerResult& result) {
  // A lower bound, so that it never reads as more than was kept.
  const Enclosure ratio = result.output_volume.bounds / result.input_volume.bounds;
  return {{"inner", true},
          {"input",
           {{"points", result.input_points},
            {"hull_vertices", result.start.ids.size()},
            {"halfspaces", result.input_halfspaces}}},
          {"output",
           {{"vertices", result.kept.size()},
            {"triangles", result.run.triangles.size()},
            {"stop", name_of(result.run.stop)},
            {"points", result.kept},
            {"planes", result.solid.planes}}},
          {"volume",
           {{"input", measured_json(result.input_volume, kDigits)},
            {"output", measured_json(result.output_volume, kDigits)},
            {"ratio", ratio.low_double()}}},
          {"ties", tied_steps(result.run)},
          {"engine", name_of(result.engine)},
          {"verified",
           {{"level", name_in(kVerifyLevelNames, result.verified)},
            {"steps", result.run.steps.size()},
            {"violations", 0}}}};
}

std::string summary(const InnerResult& result) {
  const auto decimal = [](const Measured& x) { return to_decimal(x.bounds, 6).value_or("?"); };
  const std::size_t steps = result.run.steps.size(), ties = tied_steps(result.run);
  std::string text =
      summary_line("input", fmt::format("{} points; their hull has {} vertices and {} halfspaces",
                                        with_separators(result.input_points),
                                        with_separators(result.start.ids.size()),
                                        with_separators(result.input_halfspaces)));
  std::string output = fmt::format("{} vertices, {} triangles", with_separators(result.kept.size()),
                                   with_separators(result.run.triangles.size()));
  if (result.run.stop == InnerStop::LossLimit) {
    output += ": removing one more would exceed the loss allowed";
  } else if (steps == 0) {
    output += ": as many as the hull has";
  }
  text += summary_line("output", output);
  std::string volume = decimal(result.input_volume) + " -> " + decimal(result.output_volume);
  if (steps == 0) {
    volume += ", unchanged";
  } else {
    const Enclosure hundred(Integer(100), kMeasureBits);
    const Enclosure kept = hundred * (result.output_volume.bounds / result.input_volume.bounds);
    volume += ", " + to_decimal(kept, 5).value_or("?") + "% kept";
  }
  text += summary_line("volume", volume);
  if (ties > 0) {
    text += summary_line("ties",
                         fmt::format("in {} of {} steps several vertices cost the same, exactly; "
                                     "the first by x, then y, then z goes",
                                     with_separators(ties), with_separators(steps)));
  }
  if (result.verified == VerifyLevel::None)
    return text + summary_line("verified", "nothing, as requested");
  return text +
         summary_line(
             "verified",
             fmt::format("{} steps proven again, exactly ({}); each vertex is an input "
                         "point inside every halfspace of the hull",
                         with_separators(steps), name_in(kVerifyLevelNames, result.verified)));
}

std::string proven_inner_bytes(std::span<const NamedInner> results, const std::string& path) {
  if (const auto format = mesh_format_of_path(path)) {
    if (holds_binary32_only(*format)) {
      throw Error(ErrorCode::Unrepresentable,
                  path + ": STL and GLB hold binary32, which would move vertices of the result");
    }
    std::string bytes = mesh_bytes(results, *format);
    prove_mesh(bytes, path, *format, results);
    return bytes;
  }
  const HalfspaceFormat format = halfspace_format_of_path(path).value();
  const std::vector<Halfspace>& planes = results[0].result->solid.planes;
  std::string bytes = write_halfspaces(planes, format);
  if (read_halfspaces_bytes(bytes, format).halfspaces != planes) {
    reject_bytes(path, "has other halfspaces than the result");
  }
  return bytes;
}

}  // namespace convexact
