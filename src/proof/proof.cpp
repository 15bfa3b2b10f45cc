// SPDX-License-Identifier: MIT
#include "proof/proof.hpp"

#include <algorithm>
#include <map>

#include "convexact/error.hpp"
#include "convexact/linear_program.hpp"
#include "number/arithmetic.hpp"
#include "proof/cost_tree.hpp"
#include "proof/proof_lines.hpp"
#include "simplify/cap.hpp"

namespace convexact {
namespace {

class ProofWriter : private CostTreeObserver, private ProofLines {
 public:
  ProofWriter(const RunStart& start, const Run& run, const PointSet& points)
      : start_(start), run_(run), points_(points) {
    for (const Halfspace& halfspace : run.halfspaces) {
      dual_points_.push_back(polar(halfspace, start.interior));
    }
    directions_ = primitive_directions(dual_points_);
  }
  std::string write(const std::optional<StoredPlanes>& stored);

 private:
  // The data on the removal of a halfspace.
  struct Appraisal {
    RingTriangulation roof;
    std::optional<Cost> cost;
    std::optional<IntegerVector3> ray;  // if it is unbounded: meets no other plane
  };

  void write_hull();
  void write_inside();
  void write_run();
  void write_optimum();
  void evaluated(const Removal& removal) override;
  void branches(const Removal& removal) override;
  void closes() override { line("close"); }
  void write_vertices(const std::vector<DualPlane>& planes);
  void write_evaluation(const Evaluation& evaluation);
  void write_removal(const Step& step);
  bool shows_costs() const { return run_.measure != CostMeasure::MeanWidth; }
  void write_stored(const StoredPlanes& stored);
  Appraisal appraise(const Evaluation& evaluation) const;

  const RunStart& start_;
  const Run& run_;
  const PointSet& points_;
  std::vector<DualPoint> dual_points_;
  std::vector<IntegerVector3> directions_;            // of their normals
  std::vector<std::optional<Appraisal>> appraisals_;  // by halfspace: the last one
};

std::string ProofWriter::write(const std::optional<StoredPlanes>& stored) {
  const char* version = run_.is_least ? "5" : run_.kept.empty() ? "2" : "3";
  line("convexact-proof", version, name_in(kProofClaimNames, proof_claim(run_)));
  write_hull();
  write_inside();
  for (const HalfspaceId i : run_.kept) line("keep", i);
  if (run_.moves.empty() && !run_.is_least) {
    write_run();
  } else {
    write_optimum();
  }
  if (stored) write_stored(*stored);
  return finish();
}

void ProofWriter::write_hull() {
  for (const Halfspace& halfspace : start_.input_halfspaces) line("row", halfspace);
  points("point", points_);
  line("interior", start_.interior);
  for (const Halfspace& halfspace : run_.halfspaces) line("plane", halfspace);
  std::map<RationalPoint, PointId, decltype(&precedes<RationalPoint>)> vertices(precedes);
  for (const PointId p : start_.extreme) vertices.emplace(points_[p], p);
  for (const DualTriangle& t : start_.dual.triangles) {
    const auto& h = run_.halfspaces;
    const auto vertex = vertices.find(meet(h[t[0].index()], h[t[1].index()], h[t[2].index()]));
    if (vertex == vertices.end()) throw Error(ErrorCode::Internal, "a vertex is no input point");
    line("triangle", t, vertex->second);
  }
}

// The certificate discards points in turn, each inside a tetrahedron of later ones and extreme
// ones; a proof lists them in the opposite order.
void ProofWriter::write_inside() {
  for (auto proof = start_.inside.rbegin(); proof != start_.inside.rend(); ++proof) {
    const auto& [p, corners] = *proof;
    if (corners[0] == corners[1] && corners[1] == corners[2]) {
      line("inside", p, corners[0]);
    } else {
      line("inside", p, corners);
    }
  }
}

// The effect of removing a halfspace, from its ring and triangulation at that time.
ProofWriter::Appraisal ProofWriter::appraise(const Evaluation& evaluation) const {
  Appraisal appraisal;
  RingTriangulation& roof = appraisal.roof;
  roof.triangles = evaluation.triangles;
  const auto point = [this](HalfspaceId i) { return dual_points_[i.index()]; };
  for (const auto& [a, b, c] : roof.triangles) {
    roof.planes.push_back(plane_through(point(a), point(b), point(c)));
    // All dual points except the removed one have x.n <= d w, so x.n <= 0.
    if (roof.planes.back().d <= 0) appraisal.ray = roof.planes.back().x;
  }
  if (!appraisal.ray && shows_costs()) {
    const HalfspaceId i = evaluation.halfspace;
    appraisal.cost = cost_of(make_cap(dual_points_, i, evaluation.ring, roof), directions_, i,
                             evaluation.ring, run_.measure);
  }
  return appraisal;
}

void ProofWriter::write_evaluation(const Evaluation& evaluation) {
  const HalfspaceId i = evaluation.halfspace;
  std::optional<Appraisal>& known = appraisals_[i.index()];
  // An unbounded removal stays unbounded, though an eager engine evaluates it again.
  if (known && known->ray) return;
  known = appraise(evaluation);
  const auto& [step, halfspace, ring, triangles] = evaluation;
  if (known->ray) {
    line("evaluate", i, "unbounded", *known->ray);
  } else if (!shows_costs()) {
    line("evaluate", i, "ring", ring, "triangles", triangles);
  } else if (run_.measure == CostMeasure::Area) {
    line("evaluate", i, "area", known->cost->area(), "ring", ring, "triangles", triangles);
  } else {
    line("evaluate", i, "cost", known->cost->rational(), "ring", ring, "triangles", triangles);
  }
}

void ProofWriter::write_removal(const Step& step) {
  const std::optional<Appraisal>& appraisal = appraisals_[step.removed.index()];
  if (!appraisal || (shows_costs() && appraisal->cost != step.cost)) {
    throw Error(ErrorCode::Internal, "a removal does not cost what its evaluation says");
  }
  if (run_.is_greedy && shows_costs()) {
    line("remove", step.removed, "tie", step.tie);
  } else {
    line("remove", step.removed);
  }
  write_vertices(appraisal->roof.planes);
}

void ProofWriter::write_vertices(const std::vector<DualPlane>& planes) {
  for (const DualPlane& plane : planes) line("vertex", polar(plane, start_.interior));
}

void ProofWriter::write_run() {
  appraisals_.resize(dual_points_.size());
  auto evaluation = run_.evaluations.begin();
  for (std::size_t s = 0; s <= run_.steps.size(); ++s) {
    for (; evaluation != run_.evaluations.end() && evaluation->step == s; ++evaluation) {
      if (shows_costs()) write_evaluation(*evaluation);
    }
    if (s == run_.steps.size()) break;
    const Step& step = run_.steps[s];
    if (!shows_costs()) write_evaluation({s, step.removed, step.ring, step.triangles});
    write_removal(step);
  }
  line("survive", survivors(run_));
}

// The removals that lead to where a search ended, in the order of their ids, which is as good as
// any other; before them the tree which shows that this is the least volume, if it does.
void ProofWriter::write_optimum() {
  const std::vector<HalfspaceId> left = after_moves(survivors(run_), run_.moves);
  DualSurface surface(run_.halfspaces, start_.dual.triangles, start_.interior);
  std::vector<Removal> removals;
  Rational added = 0;
  for (std::size_t i = 0; i < run_.halfspaces.size(); ++i) {
    if (std::binary_search(left.begin(), left.end(), HalfspaceId(i))) continue;
    removals.push_back(surface.removal_of(HalfspaceId(i)));
    added += removals.back().cost.value().rational();
    surface.apply(removals.back());
  }
  if (run_.is_least) {
    line("least", left.size(), added);
    std::vector<HalfspaceId> free;
    for (std::size_t i = 0; i < run_.halfspaces.size(); ++i) {
      const HalfspaceId id(i);
      if (!std::binary_search(run_.kept.begin(), run_.kept.end(), id)) free.push_back(id);
    }
    for (auto removal = removals.rbegin(); removal != removals.rend(); ++removal) {
      surface.undo(*removal);
    }
    walk_cost_tree(surface, free, removals.size(), added, *this);
  }
  for (const Removal& removal : removals) {
    evaluated(removal);
    line("remove", removal.removed);
    write_vertices(removal.roof.planes);
  }
  line("survive", left);
}

void ProofWriter::evaluated(const Removal& removal) {
  if (removal.cost) {
    return line("evaluate", removal.removed, "cost", removal.cost->rational(), "ring", removal.ring,
                "triangles", removal.roof.triangles);
  }
  const auto open = std::find_if(removal.roof.planes.begin(), removal.roof.planes.end(),
                                 [](const DualPlane& plane) { return plane.d <= 0; });
  line("evaluate", removal.removed, "unbounded", open->x);
}

void ProofWriter::branches(const Removal& removal) {
  line("branch", removal.removed);
  write_vertices(removal.roof.planes);
}

// Each plane with a weight; the weighted normals add up to zero.
void ProofWriter::write_stored(const StoredPlanes& stored) {
  const BoundedOutcome outcome = find_recession(stored.halfspaces);
  const auto* proof = std::get_if<BoundedProof>(&outcome);
  if (proof == nullptr) throw Error(ErrorCode::Internal, "the stored planes are unbounded");
  line("stored");
  for (std::size_t i = 0; i < stored.planes.size(); ++i) {
    const std::array<double, 4>& plane = stored.planes[i];
    const IntegerVector3& normal = stored.halfspaces[i].normal();
    const int k = normal[0] != 0 ? 0 : normal[1] != 0 ? 1 : 2;
    // The multiplier is that of the primitive integers.
    const Rational scale = to_rational(plane[static_cast<std::size_t>(k)]) / Rational(normal[k]);
    line("halfspace", plane, Rational(proof->multipliers[i] / scale));
  }
}

}  // namespace

ProofClaim proof_claim(const Run& run) {
  if (run.is_least) return ProofClaim::Optimal;
  if (!run.moves.empty()) return ProofClaim::Costs;
  switch (run.measure) {
    case CostMeasure::Volume:
      return run.is_greedy ? ProofClaim::Greedy : ProofClaim::Costs;
    case CostMeasure::Area:
      if (run.is_greedy) return ProofClaim::GreedyArea;
      break;
    case CostMeasure::MeanWidth:
      return ProofClaim::CostsNotShown;
  }
  throw Error(ErrorCode::Internal, "no claim is about areas of removals that are not greedy");
}

std::string write_proof(const RunStart& start, const Run& run, const PointSet& points,
                        const std::optional<StoredPlanes>& stored) {
  return ProofWriter(start, run, points).write(stored);
}

}  // namespace convexact
