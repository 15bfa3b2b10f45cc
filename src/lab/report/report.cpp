// SPDX-License-Identifier: MIT
#include "lab/report/report.hpp"

#include <fstream>
#include <sstream>
#include <thread>

#include "solid/solid.hpp"

namespace convexact {
namespace {

constexpr std::size_t kLeastPoints = 200, kMostPoints = 12800;  // of spheres and subsets

void require_sensible(const ReportRequest& request) {
  if (request.faces < 4) {
    throw Error(ErrorCode::InvalidArgument, "no bounded solid has fewer than 4 faces");
  }
  if (request.effort.repetitions < 1 || !(request.effort.budget > 0)) {
    throw Error(ErrorCode::InvalidArgument, "at least one repetition, and some time for it");
  }
}

// The text after "NAME :" in a file of such lines; empty if there is none.
std::string entry_of(const char* file, const std::string& name) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind(name, 0) != 0) continue;
    const std::size_t start = line.find_first_not_of(" \t", line.find(':') + 1);
    if (start != std::string::npos) return line.substr(start);
  }
  return {};
}

}  // namespace

std::variant<InputReport, NotSolid> measure_input(
    const std::string& name, const Shape& shape, const ReportRequest& request,
    const std::vector<std::vector<std::uint32_t>>& polygons) {
  require_sensible(request);
  Effort effort = request.effort;
  if (effort.progress) {
    effort.progress = [&](const std::string& what) { request.effort.progress(name + ": " + what); };
  }
  StageLog log;
  const SolidOutcome outcome = make_solid(shape, {.seed = effort.seed}, log);
  if (const auto* reason = std::get_if<NotSolid>(&outcome)) return *reason;
  const auto& solid = std::get<Solid>(outcome);
  InputReport report;
  report.name = name;
  report.points = solid.input_points;
  report.hull_vertices = solid.extreme.size();
  report.halfspaces = solid.dual.halfspaces.size();
  if (request.sections.precision) {
    report.precision = measure_work_precision(solid, request.faces, {}, effort);
  }
  if (request.sections.tightness) {
    report.tightness = measure_tightness_curve(solid, request.faces, effort, request.cost);
  }
  if (request.sections.stages) {
    report.stages = measure_stage_times(shape, request.faces, effort);
  }
  const auto* points = std::get_if<PointSet>(&shape);
  if (request.sections.scaling && points != nullptr) {
    report.scaling = measure_scaling(nested_subsets(*points, kLeastPoints, effort.seed), effort);
  }
  if (request.sections.parts && points != nullptr && !polygons.empty()) {
    Mesh mesh;
    mesh.points = *points;
    mesh.polygons = polygons;
    report.parts = measure_parts_curve(mesh, effort);
  }
  return report;
}

void measure_families(ReportData& report, const ReportRequest& request) {
  require_sensible(request);
  const Effort& effort = request.effort;
  if (request.sections.scaling) {
    report.spheres =
        measure_scaling(growing_spheres(kLeastPoints, kMostPoints, effort.seed), effort);
  }
  if (!request.sections.stability) return;
  for (const std::string& family :
       request.families.empty() ? breakdown_families() : request.families) {
    report.stability.push_back(measure_breakdown(family, effort));
  }
}

Machine this_machine() {
  Machine machine;
  machine.processor = entry_of("/proc/cpuinfo", "model name");
  if (machine.processor.empty()) machine.processor = "unknown";
  machine.cores = std::thread::hardware_concurrency();
  std::uint64_t kibibytes = 0;
  std::istringstream(entry_of("/proc/meminfo", "MemTotal")) >> kibibytes;
  machine.memory = 1024 * kibibytes;
  return machine;
}

}  // namespace convexact
