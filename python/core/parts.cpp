// SPDX-License-Identifier: MIT
// Decompositions, and the files that meshes come from.
#include "bindings.hpp"
#include "convexact/json.hpp"
#include "convexact/overlay.hpp"
#include "pages/parts_picture.hpp"
#include "proof/decomposition_proof.hpp"
#include "wire/decompose_options.hpp"
#include "wire/decompose_report.hpp"

namespace convexact::python {
namespace {

Decomposed decomposed(const Mesh& mesh, const Options& options, const std::string& measures,
                      const py::object& progress) {
  DecomposeRequest request = default_decompose_request();
  apply(options, decompose_fields(), request);
  request.measures = measures == "all"         ? PartMeasures::All
                     : measures == "uncovered" ? PartMeasures::Uncovered
                                               : PartMeasures::None;
  request.exact_volumes = false;
  return interruptible(mesh.points.size() + kSmall, progress, [&](const StageWatch& watch) {
    DecomposeRequest own = request;
    own.watch = watch;
    own = with_method(mesh, std::move(own));
    Decomposition result = require_solid(decompose(mesh, own));
    own.watch = {};
    return Decomposed{std::move(result), std::move(own)};
  });
}

// vertices, faces, exact planes, triangles owned.
py::tuple part_of(const Part& part) {
  return py::make_tuple(array_of(part.mesh.points.doubles()), part.mesh.polygons,
                        texts_of(part.halfspaces), [&] {
                          std::vector<std::size_t> owned;
                          for (const TriangleId t : part.owns) owned.push_back(t.index());
                          return owned;
                        }());
}

py::tuple read(const std::string& path, bool exact) {
  const Mesh mesh = [&] {
    const py::gil_scoped_release unlocked;
    return read_mesh(path, {.decimal = exact ? Decimal::Exact : Decimal::Nearest});
  }();
  py::object points = array_of(mesh.points.doubles());
  if (!mesh.points.is_binary()) {
    std::vector<RationalPoint> all;
    for (std::size_t k = 0; k < mesh.points.size(); ++k) all.push_back(mesh.points[PointId(k)]);
    points = py::cast(texts_of(all));
  }
  return py::make_tuple(points, mesh.polygons, mesh.notes);
}

}  // namespace

void add_parts(py::module_& module) {
  py::class_<Decomposed>(module, "Decomposition")
      .def("parts",
           [](const Decomposed& d) {
             py::list parts;
             for (const Part& part : d.result.parts) parts.append(part_of(part));
             return parts;
           })
      .def("limit_holds", [](const Decomposed& d) { return d.result.limit_holds; })
      .def("method", [](const Decomposed& d) { return name_of(d.request.method); })
      .def("covers", [](const Decomposed& d) { return covered_name(d.result); })
      .def("measures",
           [](const Decomposed& d) {
             const auto& measures = d.result.measures;
             return measures ? std::tuple{pair_of(measures->solid_volume),
                                          pair_of(measures->uncovered_volume),
                                          pair_of(measures->excess_volume)}
                             : decltype(std::tuple{pair_of({}), pair_of({}), pair_of({})}){};
           })
      .def("summary",
           [](const Decomposed& d) {
             std::vector<std::string> names;
             for (std::size_t k = 0; k < d.result.parts.size(); ++k) {
               names.push_back("part_" + std::to_string(k));
             }
             return summary(d.result, d.request, names);
           })
      .def("picture",
           [](const Decomposed& d, const std::string& title) {
             return picture_html(decomposition_picture(d.result, title));
           })
      .def("trace", [](const Decomposed& d) { return write_decompose_trace(d.result, d.request); })
      .def("proof",
           [](const Decomposed& d) { return write_decomposition_proof(d.result, d.request); })
      .def("json", [](const Decomposed& d) { return to_json(d.result, d.request, -1); });
  module.def("decompose", [](const py::object& points, const Faces& faces, const Options& options,
                             const std::string& measures, const py::object& progress) {
    return decomposed(mesh_of(points, faces), options, measures, progress);
  });

  module.def("read_mesh", &read);
}

}  // namespace convexact::python
