// SPDX-License-Identifier: MIT
// Whether the faces of a mesh are the surface of a convex solid.
#include "convexact/measure/hull_volume.hpp"
#include "judge.hpp"

namespace convexact::oracle {
namespace {

using enum ClaimCode;

Witness witness_of(const MeshEdge& edge) {
  Witness witness;
  witness.vertices = {edge.tail, edge.head};
  witness.faces = edge.faces;
  return witness;
}

std::string edge_text(const MeshEdge& edge) {
  return "the edge between points " + std::to_string(edge.tail) + " and " +
         std::to_string(edge.head);
}

void judge_closed(const std::optional<MeshEdge>& open, Docket& docket) {
  if (!open) {
    docket.holds(MeshClosed, "each edge has two faces");
  } else if (open->tail == open->head) {
    docket.violated(
        MeshClosed,
        "face " + std::to_string(open->faces[0]) + " has the same corner twice in a row",
        witness_of(*open));
  } else {
    docket.violated(MeshClosed,
                    edge_text(*open) + " has " + counted(open->faces.size(), "face", "faces") +
                        " where a closed surface has 2",
                    witness_of(*open));
  }
}

void judge_oriented(const MeshSurface& surface, bool is_closed, Docket& docket) {
  if (const auto twisted = surface.twisted_edge()) {
    docket.violated(MeshOriented,
                    "along " + edge_text(*twisted) + " two faces run in the same direction",
                    witness_of(*twisted));
  } else if (!is_closed) {
    docket.not_applicable(MeshOriented, "a surface that is not closed has no outside");
  } else if (const Rational enclosed = surface.enclosed(); enclosed <= 0) {
    docket.violated(MeshOriented,
                    enclosed == 0 ? "the faces enclose no volume" : "all faces look inward", {});
  } else {
    docket.holds(MeshOriented, "the faces look outward");
  }
}

void judge_planar(const Mesh& mesh, const MeshSurface& surface, Docket& docket) {
  if (const auto face = surface.face_without_area()) {
    Witness witness;
    witness.faces = {*face};
    for (const std::uint32_t corner : mesh.polygons[*face]) witness.vertices.push_back(corner);
    docket.violated(MeshPlanar, "face " + std::to_string(*face) + " has no area",
                    std::move(witness));
    return;
  }
  const auto bent = surface.most_bent();
  if (!bent) {
    docket.holds(MeshPlanar, "the corners of each face lie in one plane, exactly");
    return;
  }
  Witness witness;
  witness.faces = {bent->face};
  witness.vertices = {bent->corner};
  witness.plane = bent->plane;
  witness.point = mesh.points[PointId(bent->corner)];
  docket.violated_by(bent->squared_distance, MeshPlanar,
                     "corner " + std::to_string(bent->corner) + " of face " +
                         std::to_string(bent->face) + " is off its plane by " +
                         docket.distance_text(bent->squared_distance),
                     std::move(witness));
}

// What the mesh stands for all the same.
std::string hull_text(const CandidateSet& set) {
  return "; the hull of its points has " + counted(set.hull->facets.size(), "facet", "facets") +
         " and " + counted(set.hull->vertices.size(), "vertex", "vertices");
}

void judge_convex(const Mesh& mesh, const MeshSurface& surface, bool is_closed,
                  const CandidateSet& set, Docket& docket) {
  const MeshSurface::OffHull off = surface.faces_off(set.planes, set.hull->vertices);
  if (off.worst) {
    Witness witness;
    witness.faces = {off.worst->face};
    witness.vertices = {off.worst->point.index()};
    witness.plane = off.worst->plane;
    witness.point = mesh.points[off.worst->point];
    docket.violated_by(off.worst->squared_distance, MeshConvex,
                       counted(off.faces, "face is", "faces are") +
                           " not in the surface of the hull; point " +
                           std::to_string(off.worst->point.index()) + " is beyond face " +
                           std::to_string(off.worst->face) + " by " +
                           docket.distance_text(off.worst->squared_distance) + hull_text(set),
                       std::move(witness));
    return;
  }
  // Faces in facet planes of the hull that look outward cover each facet equally often, and close
  // up once: then they enclose what the hull encloses.
  if (!is_closed || surface.twisted_edge()) {
    docket.not_applicable(MeshConvex,
                          "each face is in the surface of the hull, but together they do not "
                          "close it" +
                              hull_text(set));
  } else if (surface.enclosed() != 6 * volume(*set.hull, mesh.points)) {
    docket.violated(MeshConvex,
                    "each face is in the surface of the hull, but together they do not cover it "
                    "once" +
                        hull_text(set),
                    {});
  } else {
    docket.holds(MeshConvex, "the faces are the surface of the hull of the points");
  }
}

}  // namespace

void judge_faces(const Mesh& mesh, const CandidateSet& set, Docket& docket) {
  constexpr ClaimCode kClaims[] = {MeshClosed, MeshOriented, MeshPlanar, MeshConvex};
  if (std::none_of(std::begin(kClaims), std::end(kClaims),
                   [&](ClaimCode code) { return docket.asks(code); })) {
    return;
  }
  if (mesh.polygons.empty()) {
    for (const ClaimCode code : kClaims) {
      docket.not_applicable(code, "it has no faces, and stands for the hull of its points");
    }
    return;
  }
  const MeshSurface surface(mesh);
  const std::optional<MeshEdge> open = surface.open_edge();
  judge_closed(open, docket);
  if (docket.asks(MeshOriented)) judge_oriented(surface, !open, docket);
  if (docket.asks(MeshPlanar)) judge_planar(mesh, surface, docket);
  if (!set.hull) {
    docket.not_applicable(MeshConvex, "there is no solid");
  } else if (docket.asks(MeshConvex)) {
    judge_convex(mesh, surface, !open, set, docket);
  }
}

}  // namespace convexact::oracle
