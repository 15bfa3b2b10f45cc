// SPDX-License-Identifier: MIT
// Whether the faces of a mesh are the surface of a convex solid.
#include <fmt/format.h>

#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "convexact/number.hpp"
#include "number/text.hpp"
#include "oracle/solid/judge.hpp"
#include "oracle/solid/mesh_surface.hpp"

namespace convexact::oracle {
namespace {

using enum ClaimCode;

constexpr ClaimCode kFaceClaims[] = {MeshClosed, MeshOriented, MeshPlanar, MeshConvex};

Witness witness_of(const MeshEdge& edge) {
  Witness witness;
  witness.vertices = {edge.tail, edge.head};
  witness.faces = edge.faces;
  return witness;
}

Witness witness_of(const CrossedFace& crossed) {
  Witness witness;
  witness.faces = {crossed.face};
  witness.vertices.assign(crossed.corners.begin(), crossed.corners.end());
  return witness;
}

Witness witness_of(const PointOffFace& off, const Mesh& mesh) {
  Witness witness;
  witness.faces = {off.face};
  witness.vertices = {off.point.index()};
  witness.plane = off.plane;
  witness.point = mesh.points[off.point];
  return witness;
}

std::string edge_text(const MeshEdge& edge) {
  return fmt::format("the edge between points {} and {}", edge.tail, edge.head);
}

std::string crossing_text(const CrossedFace& crossed) {
  const auto& c = crossed.corners;
  if (c.empty()) {
    return fmt::format("face {} is no polygon: it runs along a line more than once to and fro",
                       crossed.face);
  }
  return fmt::format("face {} is no simple polygon: its edges from {} to {} and from {} to {} meet",
                     crossed.face, c[0], c[1], c[2], c[3]);
}

void judge_closed(const std::optional<MeshEdge>& open, Trial& trial) {
  if (!open) return trial.holds(MeshClosed, "each edge has two faces");
  trial.violated(MeshClosed,
                 open->faces.size() == 2
                     ? fmt::format("face {} runs along {} twice, and no other face does",
                                   open->faces[0], edge_text(*open))
                     : fmt::format("{} has {} where a closed surface has 2", edge_text(*open),
                                   counted(open->faces.size(), "face", "faces")),
                 witness_of(*open));
}

void judge_oriented(const MeshSurface& surface, bool is_closed, Trial& trial) {
  if (const auto twisted = surface.twisted_edge()) {
    trial.violated(MeshOriented,
                   "along " + edge_text(*twisted) + " two faces run in the same direction",
                   witness_of(*twisted));
  } else if (!is_closed) {
    trial.not_applicable(MeshOriented, "a surface that is not closed has no outside");
  } else if (const Rational& enclosed = surface.enclosed(); enclosed <= 0) {
    trial.violated(MeshOriented,
                   enclosed == 0 ? "the faces enclose no volume" : "all faces look inward", {});
  } else {
    trial.holds(MeshOriented, "the faces look outward");
  }
}

void judge_planar(const MeshSurface& surface, const std::optional<CrossedFace>& crossed,
                  Trial& trial) {
  if (crossed) {
    return trial.violated(MeshPlanar, crossing_text(*crossed), witness_of(*crossed));
  }
  const auto bent = surface.most_bent();
  if (!bent) {
    return trial.holds(MeshPlanar, "each face is a simple polygon in one plane, exactly");
  }
  trial.violated_by(bent->squared_distance, MeshPlanar,
                    fmt::format("corner {} of face {} is off its plane by {}", bent->point.index(),
                                bent->face, trial.distance_text(bent->squared_distance)),
                    witness_of(*bent, *trial.mesh()));
}

// Simple polygons in facet planes of the hull that look outward cover each point of its surface
// equally often if they close up: as a cycle on a sphere they are a multiple of it. The multiple is
// 1 if they enclose the volume of the hull. Faces that are off by distances within a tolerance
// enclose nearly a multiple.
bool covers_once(const Rational& enclosed, const Rational& hull, bool is_exact) {
  return is_exact ? enclosed == hull : abs(Rational(2 * (enclosed - hull))) < hull;
}

void judge_convex(const MeshSurface& surface, bool is_closed,
                  const std::optional<CrossedFace>& crossed, Trial& trial) {
  const Mesh& mesh = *trial.mesh();
  const Hull& hull = *trial.set.hull;
  // The solid that the mesh stands for in any case.
  const std::string hull_text = fmt::format("; the hull of its points has {} and {}",
                                            counted(hull.facets.size(), "facet", "facets"),
                                            counted(hull.vertices.size(), "vertex", "vertices"));
  if (crossed) {
    return trial.violated(MeshConvex, crossing_text(*crossed) + hull_text, witness_of(*crossed));
  }
  const auto [off_count, worst] = surface.faces_off(hull, trial.set.planes);
  const bool closes = is_closed && !surface.twisted_edge();
  const bool covers =
      !closes || covers_once(surface.enclosed(), 6 * volume(hull, mesh.points), !worst);
  // If the faces do not close, a distance within the tolerance is not what is wrong.
  if (worst && (!covers || closes || !trial.allows(worst->squared_distance))) {
    Witness witness = witness_of(*worst, mesh);
    const std::string sentence =
        fmt::format("{} not in the surface of the hull; point {} is off the plane of face {} by {}",
                    counted(off_count, "face is", "faces are"), worst->point.index(), worst->face,
                    trial.distance_text(worst->squared_distance));
    if (covers) {
      return trial.violated_by(worst->squared_distance, MeshConvex, sentence + hull_text,
                               std::move(witness));
    }
    witness.squared_distance = worst->squared_distance;
    trial.violated(MeshConvex, sentence + ", and together they do not cover it once" + hull_text,
                   std::move(witness));
  } else if (!closes) {
    trial.not_applicable(
        MeshConvex,
        "each face is in the surface of the hull, but together they do not close it" + hull_text);
  } else if (!covers) {
    trial.violated(
        MeshConvex,
        "each face is in the surface of the hull, but together they do not cover it once" +
            hull_text,
        {});
  } else {
    trial.holds(MeshConvex, "the faces are the surface of the hull of the points");
  }
}

std::string list_text(const std::vector<std::size_t>& faces) {
  constexpr std::ptrdiff_t kShown = 5;
  const auto count = static_cast<std::ptrdiff_t>(faces.size());
  const auto last = faces.begin() + std::min(count, kShown);
  std::string text =
      fmt::format("{} {}", count == 1 ? "face" : "faces", fmt::join(faces.begin(), last, ", "));
  if (last == faces.end()) return text;
  return text + " and " + with_separators(faces.size() - kShown) + " more";
}

void note_surplus(const Surplus& surplus, Trial& trial) {
  std::vector<std::string>& notes = trial.verdict.notes;
  if (const auto& faces = surplus.degenerate_faces; !faces.empty()) {
    notes.push_back(fmt::format("{} {} not count: fewer than three corners at different places",
                                list_text(faces), faces.size() == 1 ? "does" : "do"));
  }
  if (surplus.zero_edges > 0) {
    notes.push_back(counted(surplus.zero_edges, "edge does", "edges do") +
                    " not count: between points at the same place");
  }
  if (const auto& faces = surplus.slivers; !faces.empty()) {
    notes.push_back(fmt::format("{} {} no area: all corners on a line", list_text(faces),
                                faces.size() == 1 ? "has" : "have"));
  }
}

Mesh turned_over(Mesh mesh) {
  for (std::vector<std::uint32_t>& polygon : mesh.polygons) std::ranges::reverse(polygon);
  return mesh;
}

void judge_mesh(const Mesh& mesh, Trial& trial) {
  const MeshSurface surface(mesh);
  const Watch watch(trial.stop());
  note_surplus(surface.surplus(), trial);
  if (surface.is_empty()) {
    for (const ClaimCode code : kFaceClaims) {
      trial.not_applicable(code, "it has no faces, and stands for the hull of its points");
    }
    if (mesh.polygons.empty()) return;
    Witness witness;
    witness.faces = {0};
    return trial.violated(MeshClosed, "no face has three corners at different places", witness);
  }
  watch.ask();
  const std::optional<MeshEdge> open = surface.open_edge();
  judge_closed(open, trial);
  if (trial.asks(MeshOriented)) judge_oriented(surface, !open, trial);
  watch.ask();
  const bool needs_polygons = trial.asks(MeshPlanar) || trial.asks(MeshConvex);
  const auto crossed = needs_polygons ? surface.crossed_face(watch) : std::nullopt;
  if (trial.asks(MeshPlanar)) judge_planar(surface, crossed, trial);
  watch.ask();
  if (!trial.set.hull) {
    trial.not_applicable(MeshConvex, "there is no solid");
  } else if (trial.asks(MeshConvex)) {
    // Faces that all look inward are one fault, and mesh-oriented names it.
    const bool looks_inward = !open && !surface.twisted_edge() && surface.enclosed() < 0;
    if (looks_inward) {
      const Mesh turned = turned_over(mesh);
      judge_convex(MeshSurface(turned), true, crossed, trial);
    } else {
      judge_convex(surface, !open, crossed, trial);
    }
  }
}

}  // namespace

void judge_faces(Trial& trial) {
  if (const Mesh* mesh = trial.mesh()) {
    return trial.log.run("faces", [&] {
      const bool is_asked = std::any_of(std::begin(kFaceClaims), std::end(kFaceClaims),
                                        [&](ClaimCode code) { return trial.asks(code); });
      if (is_asked) judge_mesh(*mesh, trial);
    });
  }
  for (const ClaimCode code : kFaceClaims) {
    trial.not_applicable(code, "a list of halfspaces has no faces");
  }
}

}  // namespace convexact::oracle
