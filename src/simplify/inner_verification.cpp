// SPDX-License-Identifier: MIT
// Proves the steps of an inner run again, from plain lists and a separate table of edges.
#include <string>

#include "convexact/error.hpp"
#include "convexact/run.hpp"
#include "measure/vertex_determinants.hpp"
#include "simplify/plain_surface.hpp"

namespace convexact {
namespace {

class InnerVerification {
 public:
  InnerVerification(const VertexHull& hull, VerifyLevel level)
      : level_(level),
        determinants_(hull.points),
        surface_(hull.points.size(), hull.triangles),
        place_(hull.points.size(), 0) {
    if (level == VerifyLevel::Full) six_volumes_ = determinants_.six_volumes(hull.triangles);
  }

  void check(const Step& step);
  void check_end(const InnerRun& run) const;

 private:
  void require(bool holds, const char* claim) const {
    if (holds) return;
    throw Error(ErrorCode::Internal,
                "verification of inner step " + std::to_string(number_) + " failed: " + claim);
  }
  bool is_beyond(const VertexTriangle& t, VertexId p) const {
    return determinants_.side(t[0].index(), t[1].index(), t[2].index(), p.index()) ==
           Sign::Positive;
  }
  void check_disk(const Step& step);
  void check_signs(const Step& step) const;
  void replace(const Step& step);
  void check_whole(const Step& step);

  VerifyLevel level_;
  VertexDeterminants determinants_;
  PlainSurface surface_;
  std::vector<std::uint32_t> place_;  // in the ring at hand, from 1; 0 outside of it
  std::size_t number_ = 0;            // of the step, from 1
  Integer six_volumes_;               // of the solid, at level full
};

// The ring is that of the removed vertex; k - 2 triangles with their corners on it, in the turning
// sense of the ring. That they fit together shows when they take the place of the old ones: each
// directed edge is free then, and in the end no edge lacks its opposite. A disk with holes or
// handles would need another number of triangles.
void InnerVerification::check_disk(const Step& step) {
  const std::size_t k = step.ring.size();
  require(k >= 3, "a ring has three vertices or more");
  for (std::size_t m = 0; m < k; ++m) {
    require(surface_.third(step.removed, step.ring[m]) == step.ring[(m + 1) % k],
            "the ring is that of the removed vertex");
    std::uint32_t& place = place_[step.ring[m].index()];
    require(place == 0, "no vertex is twice on the ring");
    place = static_cast<std::uint32_t>(m + 1);
  }
  require(step.triangles.size() == k - 2, "a ring of k is closed by k - 2 triangles");
  for (const VertexTriangle& t : step.triangles) {
    const std::uint32_t a = place_[t[0].index()], b = place_[t[1].index()],
                        c = place_[t[2].index()];
    require(a != 0 && b != 0 && c != 0, "new triangles have their corners on the ring");
    require((a < b) + (b < c) + (c < a) == 2, "new triangles turn as the ring does");
  }
}

// The new triangles are the part of the hull of the rest that v was beyond: v lies on or beyond
// each of them, the ring on or inside of each, and so does what lies across the rim.
void InnerVerification::check_signs(const Step& step) const {
  const std::size_t k = step.ring.size();
  for (const VertexTriangle& t : step.triangles) {
    require(determinants_.side(t[0].index(), t[1].index(), t[2].index(), step.removed.index()) !=
                Sign::Negative,
            "the removed vertex lies on or beyond the new triangles");
    for (const VertexId r : step.ring) {
      if (r == t[0] || r == t[1] || r == t[2]) continue;
      require(!is_beyond(t, r), "no vertex of the ring lies beyond a new triangle");
    }
    for (int e = 0; e < 3; ++e) {
      const VertexId from = t[e], to = t[(e + 1) % 3];
      const std::uint32_t a = place_[from.index()], b = place_[to.index()];
      if (b != (a == k ? 1 : a + 1)) continue;  // an inner edge
      const std::optional<VertexId> across = surface_.third(to, from);
      require(across.has_value() && !is_beyond(t, *across), "every edge of the rim is convex");
    }
  }
}

void InnerVerification::replace(const Step& step) {
  const std::size_t k = step.ring.size();
  for (std::size_t m = 0; m < k; ++m) {
    surface_.remove({step.removed, step.ring[m], step.ring[(m + 1) % k]});
  }
  for (const VertexTriangle& t : step.triangles) {
    require(surface_.add(t), "no directed edge is there twice");
  }
  for (const VertexTriangle& t : step.triangles) {
    for (int e = 0; e < 3; ++e) {
      require(surface_.third(t[(e + 1) % 3], t[e]).has_value(), "every edge has two sides");
    }
  }
  for (std::size_t m = 0; m < k; ++m) {
    require(surface_.third(step.ring[m], step.ring[(m + 1) % k]).has_value(),
            "the ring bounds the new triangles");
    place_[step.ring[m].index()] = 0;
  }
}

// Every edge of the whole surface is convex or flat, and the cost is the volume before less that
// after, both from scratch.
void InnerVerification::check_whole(const Step& step) {
  const std::vector<VertexTriangle> triangles = surface_.triangles();
  require(triangles.size() == 2 * step.left - 4, "the surface is a sphere");
  for (const VertexTriangle& t : triangles) {
    for (int e = 0; e < 3; ++e) {
      const std::optional<VertexId> across = surface_.third(t[(e + 1) % 3], t[e]);
      require(across.has_value() && !is_beyond(t, *across), "the whole surface is convex");
    }
  }
  const Integer after = determinants_.six_volumes(triangles);
  require(
      after > 0 && step.cost &&
          determinants_.volume(six_volumes_) - step.cost->rational() == determinants_.volume(after),
      "the volume after is the volume before less the cost");
  six_volumes_ = after;
}

void InnerVerification::check(const Step& step) {
  ++number_;
  check_disk(step);
  check_signs(step);
  replace(step);
  if (level_ == VerifyLevel::Full) check_whole(step);
}

void InnerVerification::check_end(const InnerRun& run) const {
  require(3 * run.triangles.size() == surface_.directed_edges(), "the result is what is left");
  for (const VertexTriangle& t : run.triangles) {
    require(surface_.third(t[0], t[1]) == t[2], "the result is what is left");
  }
}

}  // namespace

void verify_inner_run(const VertexHull& hull, const InnerRun& run, VerifyLevel level,
                      const Watch& watch) {
  if (level == VerifyLevel::None) return;
  InnerVerification verification(hull, level);
  for (const Step& step : run.steps) {
    watch.ask();
    verification.check(step);
  }
  verification.check_end(run);
}

}  // namespace convexact
