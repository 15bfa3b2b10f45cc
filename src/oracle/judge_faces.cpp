// SPDX-License-Identifier: MIT
// Whether the faces of a mesh are the surface of a convex solid.
#include "convexact/measure.hpp"
#include "convexact/number.hpp"
#include "number/text.hpp"
#include "oracle/judge.hpp"

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
  } else if (open->faces.size() == 2) {
    docket.violated(MeshClosed,
                    "face " + std::to_string(open->faces[0]) + " runs along " + edge_text(*open) +
                        " twice, and no other face does",
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

Witness witness_of(const CrossedFace& crossed) {
  Witness witness;
  witness.faces = {crossed.face};
  witness.vertices.assign(crossed.corners.begin(), crossed.corners.end());
  return witness;
}

std::string crossing_text(const CrossedFace& crossed) {
  const std::string face = "face " + std::to_string(crossed.face);
  const auto& c = crossed.corners;
  if (c.empty()) return face + " is no polygon: it runs along a line more than once to and fro";
  const auto edge = [&](std::size_t k) {
    return "from " + std::to_string(c[k]) + " to " + std::to_string(c[k + 1]);
  };
  return face + " is no simple polygon: its edges " + edge(0) + " and " + edge(2) + " meet";
}

void judge_planar(const Mesh& mesh, const MeshSurface& surface,
                  const std::optional<CrossedFace>& crossed, Docket& docket) {
  if (crossed) {
    docket.violated(MeshPlanar, crossing_text(*crossed), witness_of(*crossed));
    return;
  }
  const auto bent = surface.most_bent();
  if (!bent) {
    docket.holds(MeshPlanar, "each face is a simple polygon in one plane, exactly");
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

void judge_off_hull(const Mesh& mesh, const MeshSurface::OffHull& off, bool covers_once,
                    const CandidateSet& set, Docket& docket) {
  const Rational& squared = off.worst->squared_distance;
  Witness witness;
  witness.faces = {off.worst->face};
  witness.vertices = {off.worst->point.index()};
  witness.plane = off.worst->plane;
  witness.point = mesh.points[off.worst->point];
  std::string sentence = counted(off.faces, "face is", "faces are") +
                         " not in the surface of the hull; point " +
                         std::to_string(off.worst->point.index()) + " is off the plane of face " +
                         std::to_string(off.worst->face) + " by " + docket.distance_text(squared);
  if (covers_once) {
    docket.violated_by(squared, MeshConvex, sentence + hull_text(set), std::move(witness));
  } else {
    witness.squared_distance = squared;
    sentence += ", and together they do not cover it once";
    docket.violated(MeshConvex, sentence + hull_text(set), std::move(witness));
  }
}

// Simple polygons in facet planes of the hull that look outward cover each point of its surface
// equally often if they close up: as a cycle on a sphere they are a multiple of it. Once if they
// enclose what the hull encloses. Faces off by distances within a tolerance enclose nearly a
// multiple.
bool covers_once(const Rational& enclosed, const Rational& hull, bool is_exact) {
  return is_exact ? enclosed == hull : abs(Rational(2 * (enclosed - hull))) < hull;
}

void judge_convex(const Mesh& mesh, const MeshSurface& surface, bool is_closed,
                  const std::optional<CrossedFace>& crossed, const CandidateSet& set,
                  Docket& docket) {
  if (crossed) {
    docket.violated(MeshConvex, crossing_text(*crossed) + hull_text(set), witness_of(*crossed));
    return;
  }
  const MeshSurface::OffHull off = surface.faces_off(set.planes, set.hull->vertices);
  const bool closes = is_closed && !surface.twisted_edge();
  const bool covers =
      !closes || covers_once(surface.enclosed(), 6 * volume(*set.hull, mesh.points), !off.worst);
  if (off.worst && (!covers || !docket.allows(off.worst->squared_distance))) {
    judge_off_hull(mesh, off, covers, set, docket);
  } else if (!closes) {
    docket.not_applicable(MeshConvex,
                          "each face is in the surface of the hull, but together they do not "
                          "close it" +
                              hull_text(set));
  } else if (!covers) {
    docket.violated(MeshConvex,
                    "each face is in the surface of the hull, but together they do not cover it "
                    "once" +
                        hull_text(set),
                    {});
  } else if (off.worst) {
    judge_off_hull(mesh, off, covers, set, docket);
  } else {
    docket.holds(MeshConvex, "the faces are the surface of the hull of the points");
  }
}

std::string list_text(const std::vector<std::size_t>& faces) {
  constexpr std::size_t kShown = 5;
  std::string text = faces.size() == 1 ? "face " : "faces ";
  for (std::size_t k = 0; k < std::min(faces.size(), kShown); ++k) {
    text += (k > 0 ? ", " : "") + std::to_string(faces[k]);
  }
  return faces.size() <= kShown ? text
                                : text + " and " + with_separators(faces.size() - kShown) + " more";
}

void note_surplus(const Surplus& surplus, Docket& docket) {
  std::vector<std::string>& notes = docket.verdict.notes;
  if (!surplus.degenerate_faces.empty()) {
    notes.push_back(list_text(surplus.degenerate_faces) +
                    (surplus.degenerate_faces.size() == 1 ? " does" : " do") +
                    " not count: fewer than three corners at different places");
  }
  if (surplus.zero_edges > 0) {
    notes.push_back(counted(surplus.zero_edges, "edge does", "edges do") +
                    " not count: between points at the same place");
  }
  if (!surplus.slivers.empty()) {
    notes.push_back(list_text(surplus.slivers) + (surplus.slivers.size() == 1 ? " has" : " have") +
                    " no area: all corners on a line");
  }
}

}  // namespace

void judge_faces(const Mesh& mesh, const CandidateSet& set, Docket& docket, const Watch& watch) {
  constexpr ClaimCode kClaims[] = {MeshClosed, MeshOriented, MeshPlanar, MeshConvex};
  if (std::none_of(std::begin(kClaims), std::end(kClaims),
                   [&](ClaimCode code) { return docket.asks(code); })) {
    return;
  }
  const MeshSurface surface(mesh);
  note_surplus(surface.surplus(), docket);
  if (surface.is_empty()) {
    for (const ClaimCode code : kClaims) {
      docket.not_applicable(code, "it has no faces, and stands for the hull of its points");
    }
    if (mesh.polygons.empty()) return;
    Witness witness;
    witness.faces = {0};
    docket.violated(MeshClosed, "no face has three corners at different places", witness);
    return;
  }
  watch.ask();
  const std::optional<MeshEdge> open = surface.open_edge();
  judge_closed(open, docket);
  if (docket.asks(MeshOriented)) judge_oriented(surface, !open, docket);
  watch.ask();
  const bool needs_polygons = docket.asks(MeshPlanar) || docket.asks(MeshConvex);
  const auto crossed = needs_polygons ? surface.crossed_face() : std::nullopt;
  if (docket.asks(MeshPlanar)) judge_planar(mesh, surface, crossed, docket);
  watch.ask();
  if (!set.hull) {
    docket.not_applicable(MeshConvex, "there is no solid");
  } else if (docket.asks(MeshConvex)) {
    judge_convex(mesh, surface, !open, crossed, set, docket);
  }
}

}  // namespace convexact::oracle
