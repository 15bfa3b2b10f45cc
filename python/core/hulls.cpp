// SPDX-License-Identifier: MIT
// Hulls, and solids of few halfspaces around them or of few vertices inside.
#include "bindings.hpp"
#include "convexact/json.hpp"
#include "convexact/simplify.hpp"
#include "pages/picture.hpp"
#include "proof/proof.hpp"
#include "simplify/run_names.hpp"
#include "wire/simplify_options.hpp"
#include "wire/simplify_report.hpp"
#include "wire/trace_json.hpp"

namespace convexact::python {
namespace {

// The points, and the solid around them, as a page.
std::string picture_of(const Stored& solid, const std::string& title) {
  PictureLayer points{.name = "points", .color = "#e69f00"};
  points.add(solid.points.doubles(), {});
  PictureLayer faces{.name = "solid", .color = "#56b4e9", .opacity = 0.25, .edges = true};
  faces.add_to_pick(solid.exact, "solid");
  return picture_html({title,
                       std::to_string(solid.exact.planes.size()) + " halfspaces",
                       {std::move(points), std::move(faces)}});
}

struct Hull {
  HullResult result;
};

Hull hull(const Shape& shape, const std::vector<std::string>& measures, int digits,
          std::optional<std::size_t> jobs, const py::object& progress) {
  const auto is_wanted = [&](const char* name) { return std::ranges::count(measures, name) > 0; };
  HullRequest request;
  request.volume = request.exact_volume = is_wanted("volume");
  request.area = is_wanted("area");
  request.mean_width = is_wanted("mean_width");
  request.inertia = is_wanted("inertia");
  request.digits = digits;
  request.jobs = jobs;
  return {require_solid(interruptible(size_of(shape), progress, [&](const StageWatch& watch) {
    request.watch = watch;
    return measure_hull(shape, request);
  }))};
}

struct Simplified {
  SimplifyResult result;
};

// What the command line says by its outputs, and for all of its commands.
Fields<SimplifyRequest> python_fields() {
  using R = SimplifyRequest;
  const auto read_precision = [](const std::string&, const std::string& text) {
    const Precision precision = text == "32" ? Precision::Binary32 : Precision::Binary64;
    return StoreRequest{precision, precision};
  };
  return {flag_field<R>("trace", &R::trace, "keep every step"),
          flag_field<R>("record", &R::record, "keep what a proof needs"),
          text_field<R>(
              "precision", &R::store, read_precision, [](const StoreRequest&) { return "64"; },
              "the numbers of the mesh and of the planes")};
}

SimplifyRequest simplify_request(Options options) {
  static const Fields<SimplifyRequest> fields = python_fields();
  const Options own = taken(options, fields);
  GivenFields given;
  const BoundFields known = given.bound(simplify_call_fields());
  for (const auto& [name, text] : options) field_of(name, known).read(name, text);
  SimplifyRequest request = convexact::simplify_request(given);
  apply(own, fields, request);
  return request;
}

// What is to stay: ids, planes, normals with or without degrees, and faces of the input.
std::vector<KeepSelector> selectors_of(const py::dict& keep) {
  std::vector<KeepSelector> selectors;
  if (keep.contains("ids")) {
    KeepIds wanted;
    for (const std::size_t id : keep["ids"].cast<std::vector<std::size_t>>()) {
      wanted.ids.emplace_back(id);
    }
    selectors.push_back({std::move(wanted), "keep['ids']"});
  }
  if (keep.contains("planes")) {
    for (const std::vector<Rational>& row : rationals_of(keep["planes"])) {
      selectors.push_back({KeepPlane{{row[0], row[1], row[2]}, row[3]}, "keep['planes']"});
    }
  }
  if (keep.contains("normals")) {
    std::optional<double> degrees;
    if (keep.contains("degrees")) degrees = keep["degrees"].cast<double>();
    for (const std::vector<Rational>& row : rationals_of(keep["normals"])) {
      selectors.push_back({KeepNormal{{row[0], row[1], row[2]}, degrees}, "keep['normals']"});
    }
  }
  if (keep.contains("faces")) {
    selectors.push_back({KeepFaces{keep["faces"].cast<Faces>()}, "keep['faces']"});
  }
  return selectors;
}

Simplified simplified(const Shape& shape, SimplifyRequest request, const py::object& progress) {
  return {require_solid(interruptible(size_of(shape), progress, [&](const StageWatch& watch) {
    request.watch = watch;
    return simplify(shape, request);
  }))};
}

// Several objects, with one number of halfspaces for all.
struct Scene {
  SceneTotals totals;
  std::vector<Simplified> objects;
};

Scene scene(const std::vector<Shape>& shapes, SceneRequest& request, const py::object& progress) {
  SceneOutcome outcome = interruptible(kSmall, progress, [&](const StageWatch& watch) {
    request.each.watch = watch;
    return simplify_scene(shapes, request);
  });
  if (const auto* flat = std::get_if<NotSolidPart>(&outcome)) {
    throw Error(ErrorCode::NoInterior,
                "objects[" + std::to_string(flat->part) + "]: " + describe(flat->reason));
  }
  SceneResult& result = std::get<SceneResult>(outcome);
  Scene made{std::move(static_cast<SceneTotals&>(result)), {}};
  for (SimplifyResult& part : result.parts) made.objects.push_back({std::move(part)});
  return made;
}

struct Inner {
  InnerResult result;
};

Inner inner(const PointSet& points, const Options& options, const py::object& progress) {
  InnerRequest request;
  apply(options, inner_fields(), request);
  request.mesh = true;
  return {require_solid(interruptible(points.size(), progress, [&](const StageWatch& watch) {
    request.watch = watch;
    return simplify_inner(points, request);
  }))};
}

std::string proof_of(const SimplifyResult& result) {
  if (!result.start || !result.run) {
    throw Error(ErrorCode::InvalidArgument, "the run kept no record: simplify(..., record=True)");
  }
  return write_proof(*result.start, *result.run, result.solid.points, result.solid.planes);
}

std::string trace_of(const SimplifyResult& result) {
  if (!result.run) {
    throw Error(ErrorCode::InvalidArgument, "the run kept no trace: simplify(..., trace=True)");
  }
  return write_trace_json(*result.run);
}

}  // namespace

void add_hulls(py::module_& module) {
  py::class_<Hull>(module, "Hull")
      .def("vertices", [](const Hull& h) { return texts_of(h.result.solid.exact.vertices); })
      .def("faces", [](const Hull& h) { return h.result.solid.exact.facets; })
      .def("exact_planes", [](const Hull& h) { return texts_of(h.result.solid.exact.planes); })
      .def("planes", [](const Hull& h) { return array_of(h.result.solid.planes_in_doubles()); })
      .def("volume",
           [](const Hull& h) {
             return h.result.volume ? text_if(h.result.volume->exact) : std::nullopt;
           })
      .def("area", [](const Hull& h) { return pair_of(h.result.area); })
      .def("mean_width", [](const Hull& h) { return pair_of(h.result.mean_width); })
      .def("mass",
           [](const Hull& h) -> py::object {
             if (!h.result.mass) return py::none();
             return py::make_tuple(text_of(h.result.mass->center),
                                   texts_of(h.result.mass->inertia()));
           })
      .def("picture", [](const Hull& h) { return picture_of(h.result.solid, "Hull"); })
      .def("json", [](const Hull& h) { return to_json(h.result, 10, -1); });
  module.def("hull", [](const py::object& points, const py::object& planes,
                        const std::vector<std::string>& measures, int digits,
                        std::optional<std::size_t> jobs, const py::object& progress) {
    return hull(shape_of(points, planes), measures, digits, jobs, progress);
  });

  py::class_<Simplified>(module, "Simplified")
      .def("vertices", [](const Simplified& s) { return texts_of(s.result.solid.exact.vertices); })
      .def("faces", [](const Simplified& s) { return s.result.solid.exact.facets; })
      .def("exact_planes",
           [](const Simplified& s) { return texts_of(s.result.solid.exact.planes); })
      .def("planes", [](const Simplified& s) { return array_of(s.result.planes()); })
      .def("stored_mesh",
           [](const Simplified& s) -> py::object {
             if (!s.result.solid.mesh) return py::none();
             const Mesh& mesh = s.result.solid.mesh->mesh;
             return py::make_tuple(array_of(mesh.points.doubles()), mesh.polygons);
           })
      .def("steps", [](const Simplified& s) { return s.result.steps; })
      .def("stop", [](const Simplified& s) { return name_in(kStopReasonNames, s.result.stop); })
      .def("volumes",
           [](const Simplified& s) {
             return std::pair{pair_of(s.result.input_volume), pair_of(s.result.output_volume)};
           })
      .def("trace", [](const Simplified& s) { return trace_of(s.result); })
      .def("proof", [](const Simplified& s) { return proof_of(s.result); })
      .def("kept",
           [](const Simplified& s) {
             std::vector<std::pair<std::size_t, std::size_t>> kept;
             for (const KeptFacet& facet : s.result.kept) {
               kept.emplace_back(facet.id.index(), facet.plane);
             }
             return kept;
           })
      .def("picture", [](const Simplified& s) { return picture_of(s.result.solid, "Enclosure"); })
      .def("json", [](const Simplified& s) { return to_json(s.result, -1); });
  module.def("simplify",
             [](const py::object& points, const py::object& planes, const Options& options,
                const py::dict& keep, const py::object& progress) {
               SimplifyRequest request = simplify_request(options);
               request.keep = selectors_of(keep);
               return simplified(shape_of(points, planes), std::move(request), progress);
             });

  py::class_<Scene>(module, "Scene")
      .def("objects", [](const Scene& s) { return s.objects; })
      .def("steps", [](const Scene& s) { return s.totals.steps; })
      .def("stop", [](const Scene& s) { return name_in(kStopReasonNames, s.totals.stop); })
      .def("volumes",
           [](const Scene& s) {
             return std::pair{pair_of(s.totals.input_volume), pair_of(s.totals.output_volume)};
           })
      .def("json", [](const Scene& s) { return write_json(totals_json(s.totals, {})); });
  module.def("simplify_scene", [](const std::vector<std::pair<py::object, py::object>>& objects,
                                  std::size_t faces, const Options& options,
                                  const std::vector<py::dict>& keep, const py::object& progress) {
    SceneRequest request{simplify_request(options), faces, {}};
    for (const py::dict& each : keep) request.keep.push_back(selectors_of(each));
    std::vector<Shape> shapes;
    for (const auto& [points, planes] : objects) {
      shapes.push_back(shape_of(points, planes));
    }
    return scene(shapes, request, progress);
  });

  py::class_<Inner>(module, "Inner")
      .def("kept",
           [](const Inner& i) {
             std::vector<std::size_t> ids;
             for (const PointId id : i.result.kept) ids.push_back(id.index());
             return ids;
           })
      .def("faces",
           [](const Inner& i) { return i.result.mesh ? i.result.mesh->polygons : Faces{}; })
      .def("vertices",
           [](const Inner& i) {
             return array_of(i.result.mesh ? i.result.mesh->points.doubles()
                                           : std::span<const Point>{});
           })
      .def("json", [](const Inner& i) { return to_json(i.result, -1); });
  module.def("inner",
             [](const py::object& points, const Options& options, const py::object& progress) {
               return inner(points_of(points), options, progress);
             });
}

}  // namespace convexact::python
