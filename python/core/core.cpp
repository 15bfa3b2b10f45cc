// SPDX-License-Identifier: MIT
// convexact._core: the library as Python calls it. The package around it gives names, defaults and
// shapes; nothing is decided there.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>

#include "arrays.hpp"
#include "convexact/conform.hpp"
#include "convexact/decompose.hpp"
#include "convexact/json.hpp"
#include "convexact/overlay.hpp"
#include "convexact/shapes.hpp"
#include "convexact/shrink.hpp"
#include "convexact/simplify.hpp"
#include "convexact/verify.hpp"
#include "convexact/verify_parts.hpp"
#include "interruptible.hpp"
#include "io/used_points.hpp"
#include "pages/parts_picture.hpp"
#include "proof/decomposition_proof.hpp"
#include "proof/proof.hpp"
#include "simplify/run_names.hpp"
#include "wire/decompose_options.hpp"
#include "wire/decompose_report.hpp"
#include "wire/judge_fields.hpp"
#include "wire/simplify_report.hpp"
#include "wire/trace_json.hpp"

namespace convexact::python {
namespace {

// By the names of the command line, with values spelled as there.
using Options = std::vector<std::pair<std::string, std::string>>;

template <class Request>
void apply(const Options& options, const Fields<Request>& fields, Request& request) {
  for (const auto& [name, text] : options) {
    const auto field = std::find_if(fields.begin(), fields.end(),
                                    [&, wanted = name](const auto& f) { return f.name == wanted; });
    if (field == fields.end()) {
      throw Error(ErrorCode::InvalidArgument, "there is no option " + name);
    }
    field->read(request, name, text);
  }
}

// Those of one table, which are removed from the list.
template <class Request>
Options taken(Options& options, const Fields<Request>& fields) {
  const auto rest = std::stable_partition(options.begin(), options.end(), [&](const auto& option) {
    return std::none_of(fields.begin(), fields.end(),
                        [&](const auto& field) { return field.name == option.first; });
  });
  const Options of_table(rest, options.end());
  options.erase(rest, options.end());
  return of_table;
}

template <class Value, std::size_t n>
Value chosen(const NameTable<Value, n>& table, const std::string& option, const std::string& text) {
  if (const auto value = value_in(table, text)) return *value;
  throw Error(ErrorCode::InvalidArgument, option + ": there is no '" + text + "'");
}

// ---- Hulls and simplification

struct Hull {
  HullResult result;
};

Hull hull(const Shape& shape, bool volume, bool area, bool mean_width, int digits, std::size_t size,
          const py::object& progress) {
  HullRequest request;
  request.volume = volume;
  request.exact_volume = volume;
  request.area = area;
  request.mean_width = mean_width;
  request.digits = digits;
  return {require_solid(interruptible(size, progress, [&](const StageWatch& watch) {
    request.watch = watch;
    return measure_hull(shape, request);
  }))};
}

struct Simplified {
  SimplifyResult result;
};

SimplifyRequest simplify_request(const Options& options) {
  SimplifyRequest request;
  for (const auto& [name, text] : options) {
    if (name == "faces") {
      request.faces = parse_count(name, text, {4, std::uint64_t(1) << 32});
    } else if (name == "max_growth") {
      request.max_growth = parse_rational(text);
    } else if (name == "growth_of") {
      request.growth_of = chosen(kCostMeasureNames, name, text);
    } else if (name == "cost") {
      request.cost = chosen(kCostMeasureNames, name, text);
    } else if (name == "engine") {
      request.engine = chosen(kEngineNames, name, text);
    } else if (name == "verify") {
      request.verify = chosen(kVerifyLevelNames, name, text);
    } else if (name == "search") {
      request.search.kind = chosen(kSearchKindNames, name, text);
    } else if (name == "seed") {
      request.seed = parse_count(name, text, {});
    } else if (name == "trace") {
      request.trace = text == "true";
    } else if (name == "record") {
      request.record = text == "true";
    } else if (name == "precision") {
      request.store.mesh = request.store.planes =
          text == "32" ? Precision::Binary32 : Precision::Binary64;
    } else {
      throw Error(ErrorCode::InvalidArgument, "there is no option " + name);
    }
  }
  return request;
}

Simplified simplified(const Shape& shape, const Options& options, std::size_t size,
                      const py::object& progress) {
  SimplifyRequest request = simplify_request(options);
  return {require_solid(interruptible(size, progress, [&](const StageWatch& watch) {
    request.watch = watch;
    return simplify(shape, request);
  }))};
}

struct Inner {
  InnerResult result;
};

Inner inner(const PointSet& points, std::optional<std::size_t> vertices,
            const std::optional<std::string>& max_loss, const py::object& progress) {
  InnerRequest request;
  request.vertices = vertices;
  if (max_loss) request.max_loss = parse_rational(*max_loss);
  request.mesh = true;
  return {require_solid(interruptible(points.size(), progress, [&](const StageWatch& watch) {
    request.watch = watch;
    return simplify_inner(points, request);
  }))};
}

std::vector<std::array<std::string, 4>> texts_of(const std::vector<Halfspace>& planes) {
  std::vector<std::array<std::string, 4>> rows;
  for (const Halfspace& h : planes) {
    rows.push_back({to_string(h.normal()[0]), to_string(h.normal()[1]), to_string(h.normal()[2]),
                    to_string(h.offset())});
  }
  return rows;
}

std::vector<std::array<std::string, 3>> texts_of(const std::vector<RationalPoint>& points) {
  std::vector<std::array<std::string, 3>> rows;
  for (const RationalPoint& p : points) {
    rows.push_back({to_string(p[0]), to_string(p[1]), to_string(p[2])});
  }
  return rows;
}

std::optional<std::string> text_of(const std::optional<Rational>& x) {
  return x ? std::optional(to_string(*x)) : std::nullopt;
}

std::optional<std::pair<double, double>> pair_of(const std::optional<Measured>& measured) {
  if (!measured) return {};
  return std::pair{measured->bounds.low_double(), measured->bounds.high_double()};
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

// ---- Verdicts

struct Judged {
  Verdict verdict;
};

Judged judge(const PointSet& points, const Candidate& candidate, const Options& options,
             const std::vector<std::string>& claims, const Faces& faces,
             const py::object& progress) {
  VerifyRequest request;
  request.tightness = false;
  apply(options, verify_fields(), request);
  for (const std::string& name : claims) {
    const auto code = claim_of_name(name);
    if (!code) throw Error(ErrorCode::InvalidArgument, "there is no claim '" + name + "'");
    request.claims.push_back(*code);
  }
  if (!faces.empty()) request.used = used_points(points.size(), faces);
  return {require_solid(interruptible(points.size(), progress, [&](const StageWatch& watch) {
    request.watch = watch;
    return verify(points, candidate, request);
  }))};
}

struct JudgedParts {
  PartsVerdict verdict;
};

JudgedParts judge_parts(const Mesh& input, const std::vector<NamedPart>& parts, Options options,
                        const std::vector<std::string>& claims, const py::object& progress) {
  VerifyRequest common;
  common.tightness = false;
  apply(taken(options, verify_fields()), verify_fields(), common);
  PartsRequest request = parts_request(common);
  request.measures = PartMeasures::None;
  apply(options, parts_fields(), request);
  for (const std::string& name : claims) {
    const auto code = claim_of_name(name);
    if (!code) throw Error(ErrorCode::InvalidArgument, "there is no claim '" + name + "'");
    request.claims.push_back(*code);
  }
  const CandidateParts candidate = parts;
  return {interruptible(input.points.size() + kSmall, progress, [&](const StageWatch& watch) {
    request.watch = watch;
    return verify_parts(input, candidate, request);
  })};
}

// name, status, sentence, squared distance of the witness, its point in the input.
using ClaimTuple = std::tuple<std::string, std::string, std::string, std::optional<std::string>,
                              std::optional<std::size_t>>;

std::vector<ClaimTuple> claims_of(const std::vector<Claim>& claims) {
  std::vector<ClaimTuple> tuples;
  for (const Claim& claim : claims) {
    if (claim.status == Status::NotAsked) continue;
    tuples.emplace_back(name_of(claim.code), name_of(claim.status), claim.sentence,
                        text_of(claim.witness.squared_distance), claim.witness.input_point);
  }
  return tuples;
}

// ---- Decomposition

struct Decomposed {
  Decomposition result;
  DecomposeRequest request;
};

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

// ---- Errors, by kind

struct Kinds {
  py::object base, not_solid, malformed, unrepresentable, invalid, interrupted, unreadable;
};

Kinds make_kinds(py::module_& module) {
  const auto make = [&](const char* name, const py::tuple& bases, const char* meaning) {
    py::object kind = py::reinterpret_steal<py::object>(PyErr_NewExceptionWithDoc(
        (std::string("convexact.") + name).c_str(), meaning, bases.ptr(), nullptr));
    module.attr(name) = kind;
    return kind;
  };
  const auto builtin = [](PyObject* kind) { return py::reinterpret_borrow<py::object>(kind); };
  Kinds kinds;
  kinds.base =
      make("ConvexactError", py::make_tuple(builtin(PyExc_Exception)), "Any error of convexact.");
  kinds.not_solid = make("NotSolid", py::make_tuple(kinds.base),
                         "The input encloses no volume; the message has the proof.");
  kinds.malformed = make("MalformedInput", py::make_tuple(kinds.base, builtin(PyExc_ValueError)),
                         "A file or an array is malformed, or a number is not finite.");
  kinds.unreadable = make("Unreadable", py::make_tuple(kinds.base, builtin(PyExc_OSError)),
                          "A file cannot be read, or is of a kind that is not read.");
  kinds.unrepresentable =
      make("Unrepresentable", py::make_tuple(kinds.base), "Doubles cannot hold the result.");
  kinds.invalid = make("InvalidArgument", py::make_tuple(kinds.base, builtin(PyExc_ValueError)),
                       "An argument that cannot be.");
  kinds.interrupted =
      make("Interrupted", py::make_tuple(kinds.base, builtin(PyExc_KeyboardInterrupt)),
           "The call was ended.");
  return kinds;
}

const py::object& kind_of(const Kinds& kinds, ErrorCode code) {
  switch (code) {
    case ErrorCode::NoInterior:
      return kinds.not_solid;
    case ErrorCode::Malformed:
    case ErrorCode::NotFinite:
      return kinds.malformed;
    case ErrorCode::Unreadable:
      return kinds.unreadable;
    case ErrorCode::Unrepresentable:
      return kinds.unrepresentable;
    case ErrorCode::InvalidArgument:
      return kinds.invalid;
    case ErrorCode::Stopped:
      return kinds.interrupted;
    default:
      return kinds.base;
  }
}

Shape shape_of(const py::object& points, const py::object& planes) {
  if (planes.is_none()) return points_of(points);
  HalfspaceList list = planes_of(planes);
  if (list.impossible_row) {
    throw Error(ErrorCode::NoInterior, "halfspace " + std::to_string(*list.impossible_row) +
                                           " has a zero normal and holds nowhere");
  }
  return std::move(list.halfspaces);
}

std::size_t size_of(const Shape& shape) {
  return std::visit([](const auto& x) { return x.size(); }, shape);
}

}  // namespace
}  // namespace convexact::python

PYBIND11_MODULE(_core, module) {
  using namespace convexact;
  using namespace convexact::python;
  // Classes of errors live as long as the interpreter.
  static Kinds& kinds = *new Kinds(make_kinds(module));
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& error) {
      PyErr_SetString(kind_of(kinds, error.code()).ptr(), error.what());
    }
  });

  py::class_<python::Hull>(module, "Hull")
      .def("vertices",
           [](const python::Hull& h) { return texts_of(h.result.solid.exact.vertices); })
      .def("faces", [](const python::Hull& h) { return h.result.solid.exact.facets; })
      .def("exact_planes",
           [](const python::Hull& h) { return texts_of(h.result.solid.exact.planes); })
      .def("planes",
           [](const python::Hull& h) { return array_of(h.result.solid.planes_in_doubles()); })
      .def("volume",
           [](const python::Hull& h) {
             return h.result.volume ? text_of(h.result.volume->exact) : std::nullopt;
           })
      .def("area", [](const python::Hull& h) { return pair_of(h.result.area); })
      .def("mean_width", [](const python::Hull& h) { return pair_of(h.result.mean_width); })
      .def("json", [](const python::Hull& h) { return to_json(h.result, 10, -1); });
  module.def("hull", [](const py::object& points, const py::object& planes, bool volume, bool area,
                        bool mean_width, int digits, const py::object& progress) {
    const Shape shape = shape_of(points, planes);
    return hull(shape, volume, area, mean_width, digits, size_of(shape), progress);
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
      .def("json", [](const Simplified& s) { return to_json(s.result, -1); });
  module.def("simplify", [](const py::object& points, const py::object& planes,
                            const Options& options, const py::object& progress) {
    const Shape shape = shape_of(points, planes);
    return simplified(shape, options, size_of(shape), progress);
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
  module.def("inner", [](const py::object& points, std::optional<std::size_t> vertices,
                         const std::optional<std::string>& max_loss, const py::object& progress) {
    return inner(points_of(points), vertices, max_loss, progress);
  });

  py::class_<Judged>(module, "Verdict")
      .def("holds", [](const Judged& j) { return j.verdict.holds(); })
      .def("claims", [](const Judged& j) { return claims_of(j.verdict.claims); })
      .def("json", [](const Judged& j) { return to_json(j.verdict, -1); });
  module.def("verify_planes",
             [](const py::object& points, const Faces& faces, const py::object& planes,
                const Options& options, const std::vector<std::string>& claims,
                const py::object& progress) {
               return judge(points_of(points), planes_of(planes), options, claims, faces, progress);
             });
  module.def("verify_mesh",
             [](const py::object& points, const Faces& faces, const py::object& vertices,
                const Faces& candidate_faces, const Options& options,
                const std::vector<std::string>& claims, const py::object& progress) {
               return judge(points_of(points), mesh_of(vertices, candidate_faces), options, claims,
                            faces, progress);
             });

  py::class_<JudgedParts>(module, "PartsVerdict")
      .def("holds", [](const JudgedParts& j) { return j.verdict.holds(); })
      .def("claims", [](const JudgedParts& j) { return claims_of(j.verdict.claims); })
      .def("json", [](const JudgedParts& j) { return to_json(j.verdict, -1); });
  module.def("verify_parts",
             [](const py::object& points, const Faces& faces,
                const std::vector<std::pair<py::object, Faces>>& parts, const Options& options,
                const std::vector<std::string>& claims, const py::object& progress) {
               std::vector<NamedPart> named;
               for (const auto& [vertices, own] : parts) {
                 named.push_back({"part_" + std::to_string(named.size()), mesh_of(vertices, own)});
               }
               return judge_parts(mesh_of(points, faces), named, options, claims, progress);
             });

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

  module.def("read_mesh", &python::read);
  // Under Python's lock throughout: it is the predicate that takes the time.
  module.def("shrink", [](const Doubles& points, const py::object& fails) {
    const Shrunk smallest = shrink(points_of(points), [&](const PointSet& fewer, auto&&) {
      return fails(array_of(fewer.doubles())).template cast<bool>();
    });
    return array_of(smallest.points.doubles());
  });
  module.def("families", [] {
    std::vector<std::string> names;
    for (const shapes::Family& family : shapes::families()) names.emplace_back(family.name);
    return names;
  });
  module.def("generate", [](const std::string& name, std::uint64_t seed) {
    const shapes::Family& family = shapes::family(name);
    return array_of(shapes::generate(family, shapes::usual_values(family), seed));
  });
}
