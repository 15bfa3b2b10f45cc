// SPDX-License-Identifier: MIT
// Questions about solids and trees of hulls, and the points of implicit shapes.
#include "bindings.hpp"
#include "convexact/hull_tree.hpp"
#include "convexact/implicit.hpp"
#include "convexact/query.hpp"
#include "wire/query_report.hpp"
#include "wire/tree_report.hpp"

namespace convexact::python {
namespace {

std::vector<std::size_t> indices_of(const std::vector<HalfspaceId>& ids) {
  std::vector<std::size_t> indices;
  for (const HalfspaceId id : ids) indices.push_back(id.index());
  return indices;
}

// ---- Solids

// A common point, or a plane with `a` strictly inside and `b` strictly outside.
py::tuple overlap(const Polytope& a, const Polytope& b) {
  const Overlap found = find_overlap(a, b);
  if (const auto* common = std::get_if<CommonPoint>(&found)) {
    return py::make_tuple(text_of(common->point), py::none());
  }
  return py::make_tuple(py::none(), text_of(std::get<Separation>(found).plane));
}

Ray ray_of(const py::object& origin, const py::object& direction) {
  const std::vector<Rational> from = rationals_of(origin).front(),
                              along = rationals_of(direction).front();
  return {{from[0], from[1], from[2]}, {along[0], along[1], along[2]}};
}

// first, entry, exit, facets of the entry, facets of the exit, facets that prove a miss.
py::tuple hit_of(const RayAnswer& answer) {
  const auto& line = answer.line;
  const bool is_hit = answer.is_hit();
  return py::make_tuple(
      is_hit ? text_if(answer.first()) : std::nullopt, line ? text_if(line->entry) : std::nullopt,
      line ? text_if(line->exit) : std::nullopt,
      line ? indices_of(line->entry_facets) : std::vector<std::size_t>{},
      line ? indices_of(line->exit_facets) : std::vector<std::size_t>{}, indices_of(answer.missed));
}

std::string false_positives(const Polytope& a, const Polytope& b, std::size_t samples,
                            std::uint64_t seed, const py::object& progress) {
  const FalsePositives found = interruptible(kSmall, progress, [&](const StageWatch& watch) {
    return count_false_positives(a, b, {samples, samples, samples, seed, Watch(watch.stop)});
  });
  return write_json(false_positives_json({"a", a}, {"b", b}, found));
}

// ---- Trees

struct Tree {
  SearchTree search;
  std::string file;
};

Tree read_tree(const std::string& bytes) {
  const CandidateParts read = read_parts_bytes(bytes, "tree.json");
  if (const auto* error = std::get_if<Error>(&read)) throw *error;
  const auto* tree = std::get_if<HullTree>(&read);
  if (tree == nullptr) throw Error(ErrorCode::Malformed, "expected a tree under \"hull_tree\"");
  return {SearchTree(*tree), bytes};
}

Tree tree_over(const std::vector<NamedPart>& parts, const std::vector<Join>& joins,
               const TreeOrigin::Parts& origin, std::optional<std::size_t> faces,
               const py::object& progress) {
  return interruptible(kSmall, progress, [&](const StageWatch& watch) {
    TreeRequest request;
    request.faces = faces;
    request.watch = watch;
    const BuiltTree built = build_tree(parts, joins, request);
    const bool is_binary = std::ranges::all_of(
        parts, [](const NamedPart& part) { return part.mesh.points.is_binary(); });
    return Tree{SearchTree(built.tree),
                proven_tree_file(built, request, {"mesh", origin, is_binary, {}}, "tree.json")};
  });
}

py::tuple tree_ray(const Tree& tree, const py::object& origin, const py::object& direction) {
  const TreeRayAnswer answer = cast_ray(tree.search, ray_of(origin, direction));
  return py::make_tuple(text_if(answer.first), answer.parts, answer.visited.size());
}

// ---- Implicit shapes

// corners, their distance from the solid if that is known, and the cells kept on each level.
py::tuple implicit(const std::string& json, const std::vector<double>& box, std::size_t depth,
                   const py::object& progress) {
  const ImplicitShape shape = read_implicit_bytes(json);
  const ImplicitCells cells = interruptible(kSmall, progress, [&](const StageWatch& watch) {
    return kept_cells(shape, {{box[0], box[1], box[2]}, box[3]}, depth, Watch(watch.stop));
  });
  std::vector<std::size_t> kept;
  for (const ImplicitCells::Level& level : cells.levels) kept.push_back(level.kept);
  return py::make_tuple(array_of(cells.corners), cells.distance, kept);
}

}  // namespace

void add_queries(py::module_& module) {
  py::class_<Polytope>(module, "Solid")
      .def("overlap", &overlap)
      .def("ray", [](const Polytope& solid, const py::object& origin, const py::object& direction) {
        return hit_of(cast_ray(solid, ray_of(origin, direction)));
      });
  module.def("solid", [](const py::object& points, const py::object& planes) {
    const Shape shape = shape_of(points, planes);
    return require_solid(interruptible(size_of(shape), py::none(),
                                       [&](const StageWatch&) { return queried_solid(shape); }));
  });
  module.def("false_positives", &false_positives);

  py::class_<Tree>(module, "Tree")
      .def("ray", &tree_ray)
      .def("overlap",
           [](const Tree& tree, const Polytope& solid) {
             const TreeOverlap answer = find_overlap(tree.search, solid);
             return py::make_tuple(answer.parts, answer.visited.size());
           })
      .def("children",
           [](const Tree& tree) {
             std::vector<std::vector<std::size_t>> children;
             for (const SearchTree::Node& node : tree.search.nodes()) {
               children.push_back(node.children);
             }
             return children;
           })
      .def("parts",
           [](const Tree& tree) {
             std::vector<std::optional<std::size_t>> parts;
             for (const SearchTree::Node& node : tree.search.nodes()) parts.push_back(node.part);
             return parts;
           })
      .def("json", [](const Tree& tree) { return tree.file; });
  module.def("read_tree", &read_tree);
  module.def("tree_of_parts", [](const std::vector<std::pair<py::object, Faces>>& parts,
                                 std::optional<std::size_t> faces, const py::object& progress) {
    std::vector<NamedPart> named;
    for (const auto& [vertices, own] : parts) {
      named.push_back({"part_" + std::to_string(named.size()), mesh_of(vertices, own)});
    }
    return tree_over(named, {}, std::string("parts"), faces, progress);
  });
  module.def("tree_of", [](const Decomposed& made, std::optional<std::size_t> faces,
                           const py::object& progress) {
    std::vector<NamedPart> named;
    for (const Part& part : made.result.parts) {
      named.push_back({"part_" + std::to_string(named.size()), part.mesh});
    }
    return tree_over(named, joins_of(made.result), made.request.method, faces, progress);
  });

  module.def("implicit", &implicit);
}

}  // namespace convexact::python
