// SPDX-License-Identifier: MIT
// The oracle's verdicts, and the hard inputs that functions are tried on.
#include "bindings.hpp"
#include "convexact/conform.hpp"
#include "convexact/json.hpp"
#include "convexact/shapes.hpp"
#include "convexact/shrink.hpp"
#include "convexact/verify.hpp"
#include "convexact/verify_parts.hpp"
#include "io/used_points.hpp"
#include "wire/judge_fields.hpp"

namespace convexact::python {
namespace {

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

// name, status, sentence, and of the witness: squared distance, point of the input, place, nearest
// place of the candidate, plane, parts.
py::list claims_of(const std::vector<Claim>& claims) {
  py::list tuples;
  const auto text_at = [](const auto& value) {
    return value ? std::optional(text_of(*value)) : std::nullopt;
  };
  for (const Claim& claim : claims) {
    if (claim.status == Status::NotAsked) continue;
    const Witness& witness = claim.witness;
    tuples.append(py::make_tuple(name_of(claim.code), name_of(claim.status), claim.sentence,
                                 text_if(witness.squared_distance), witness.input_point,
                                 text_at(witness.point), text_at(witness.nearest),
                                 text_at(witness.plane), witness.parts));
  }
  return tuples;
}

}  // namespace

void add_verdicts(py::module_& module) {
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

}  // namespace convexact::python
