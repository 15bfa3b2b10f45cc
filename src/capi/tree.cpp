// SPDX-License-Identifier: MIT
#include "capi/decomposition.hpp"
#include "capi/guarded.hpp"
#include "convexact/hull_tree.hpp"
#include "wire/decompose_options.hpp"

struct convexact_tree {
  std::vector<convexact::HullTreeNode> nodes;
  std::vector<convexact::capi::MeshArrays> meshes;  // by node
};

namespace convexact::capi {
namespace {

convexact_tree tree_of(const Decomposition& made, const char* options) {
  TreeRequest request;
  read_options(options, bound_fields(tree_fields(), request));
  BuiltTree built = build_tree(made, std::vector<std::string>(made.parts.size()), request);
  convexact_tree result;
  for (std::size_t i = 0; i < built.tree.nodes.size(); ++i) {
    result.meshes.emplace_back(built.tree.mesh_of(i));
  }
  result.nodes = std::move(built.tree.nodes);
  return result;
}

}  // namespace
}  // namespace convexact::capi

using namespace convexact::capi;

convexact_status convexact_decomposition_tree(const convexact_decomposition* parts,
                                              const char* options, convexact_tree** result) {
  return guarded(result, [&] {
    if (parts == nullptr) convexact::reject_argument("the parts are missing");
    return tree_of(parts->made, options);
  });
}

size_t convexact_tree_node_count(const convexact_tree* result) { return result->nodes.size(); }
size_t convexact_tree_parent(const convexact_tree* result, size_t i) {
  return result->nodes[i].parent.value_or(CONVEXACT_NONE);
}
size_t convexact_tree_child_count(const convexact_tree* result, size_t i) {
  return result->nodes[i].children.size();
}
const size_t* convexact_tree_children(const convexact_tree* result, size_t i) {
  return result->nodes[i].children.data();
}
size_t convexact_tree_part(const convexact_tree* result, size_t i) {
  return result->nodes[i].part.value_or(CONVEXACT_NONE);
}
size_t convexact_tree_vertex_count(const convexact_tree* result, size_t i) {
  return result->meshes[i].vertices.size() / 3;
}
const double* convexact_tree_vertices(const convexact_tree* result, size_t i) {
  return result->meshes[i].vertices.data();
}
size_t convexact_tree_face_count(const convexact_tree* result, size_t i) {
  return result->meshes[i].face_sizes.size();
}
const size_t* convexact_tree_face_sizes(const convexact_tree* result, size_t i) {
  return result->meshes[i].face_sizes.data();
}
const uint32_t* convexact_tree_corners(const convexact_tree* result, size_t i) {
  return result->meshes[i].corners.data();
}
void convexact_tree_free(convexact_tree* result) { delete result; }
