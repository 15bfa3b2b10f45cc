// SPDX-License-Identifier: MIT
#include <algorithm>

#include "convexact/measure.hpp"
#include "io/json.hpp"
#include "simplify/cap.hpp"
#include "simplify/run_names.hpp"
#include "teach/chapters.hpp"
#include "wire/trace_json.hpp"

namespace convexact {
Json dual_point_json(const DualPoint& point) {
  return {to_string(point.n[0]), to_string(point.n[1]), to_string(point.n[2]), to_string(point.w)};
}

Json cost_or_null(const std::optional<Cost>& cost) {
  return cost ? cost_json(*cost) : Json(nullptr);
}

RemovalRecorder::RemovalRecorder(const DualHull& dual, const LessonFrame& frame,
                                 const LessonRequest& request)
    : dual_(dual),
      frame_(frame),
      request_(request),
      surface_(dual.halfspaces.size()),
      is_present_(dual.halfspaces.size(), true),
      skipped_(dual.halfspaces.size() - std::min(dual.halfspaces.size(), kMostLessonHalfspaces)),
      latest_(dual.halfspaces.size()) {
  for (const Halfspace& halfspace : dual.halfspaces) {
    points_.push_back(polar(halfspace, frame.center()));
  }
  if (!request.measures.empty()) directions_ = primitive_directions(points_);
  for (const DualTriangle& t : dual.triangles) surface_.add(t);
  if (skipped_ == 0) first_costs_.resize(points_.size());
}

// An evaluation begins, so the step before it has passed its verification.
void RemovalRecorder::started(const DualTriangle& first) {
  make_chosen_step();
  current_.first = first;
  current_.insertions = Json::array();
}

void RemovalRecorder::inserted(HalfspaceId corner, std::span<const DualTriangle> lost,
                               std::span<const DualTriangle> gained) {
  current_.insertions.push_back({{"corner", corner}, {"lost", lost}, {"gained", gained}});
}

void RemovalRecorder::evaluated(std::size_t step, const Removal& removal) {
  current_.step = step;
  current_.removal = removal;
  const std::size_t i = removal.removed.index();
  if (step == 0 && !first_costs_.empty()) first_costs_[i] = removal.cost;
  latest_[i] = std::move(current_);
  if (has_begun_) evaluations.push_back(evaluation_json(latest_[i]));
}

void RemovalRecorder::chosen(const Step& step) {
  if (steps_ >= skipped_ && !has_begun_) begin();
  chosen_ = step;
  if (has_begun_) removals.push_back(removal_json(step));
}

// Conditions with several parts but no number, such as those of a ring, are recorded once.
void RemovalRecorder::checked(const TestedCondition& check, bool holds) {
  if (!holds) {
    failed_ = {{"step", chosen_ ? Json(steps_ + 1) : Json(nullptr)}, {"check", check.name}};
  }
  if (!chosen_ || !has_begun_) return;
  Json& checks = removals.back()["checks"];
  const auto is_told = [&](const Json& told) { return told["check"] == check.name; };
  if (holds && check.value == nullptr && std::any_of(checks.begin(), checks.end(), is_told)) {
    return;
  }
  checks.push_back({{"check", check.name},
                    {"holds", holds},
                    {"triangle", or_null(check.triangle)},
                    {"plane", or_null(check.plane)},
                    {"value", check.value ? Json(to_string(*check.value)) : Json(nullptr)},
                    {"wants", check.wants ? Json(check.wants) : Json(nullptr)}});
}

void RemovalRecorder::finish(const std::optional<std::string>& why) {
  if (why && failed_.is_null()) failed_ = {{"step", nullptr}, {"check", *why}};
  if (failed_.is_null()) make_chosen_step();
  if (steps_ >= skipped_ && !has_begun_) begin();
}

void RemovalRecorder::make_chosen_step() {
  if (!chosen_) return;
  const std::size_t k = chosen_->ring.size();
  for (std::size_t t = 0; t < k; ++t) {
    surface_.remove({chosen_->removed, chosen_->ring[t], chosen_->ring[(t + 1) % k]});
  }
  for (const DualTriangle& t : chosen_->triangles) surface_.add(t);
  is_present_[chosen_->removed.index()] = false;
  ++steps_;
  chosen_.reset();
}

std::vector<HalfspaceId> RemovalRecorder::present() const {
  std::vector<HalfspaceId> ids;
  for (std::size_t i = 0; i < is_present_.size(); ++i) {
    if (is_present_[i]) ids.emplace_back(i);
  }
  return ids;
}

// The present solid, and the data on its halfspaces.
void RemovalRecorder::begin() {
  has_begun_ = true;
  const std::vector<DualTriangle> triangles = surface_.triangles();
  const Polytope solid = to_polytope(dual_.halfspaces, triangles);
  volume_ = volume(solid);
  Json vertices = Json::array(), vertex_of = Json::array();
  for (const RationalPoint& v : solid.vertices) vertices.push_back(frame_.both(v));
  for (const auto& [a, b, c] : triangles) {
    const RationalPoint corner =
        meet(dual_.halfspaces[a.index()], dual_.halfspaces[b.index()], dual_.halfspaces[c.index()]);
    vertex_of.push_back(std::find(solid.vertices.begin(), solid.vertices.end(), corner) -
                        solid.vertices.begin());
  }
  topology = {{"step", steps_},
              {"present", present()},
              {"triangles", triangles},
              {"vertices", std::move(vertices)},
              {"vertex_of", std::move(vertex_of)},
              {"volume", volume_}};
  for (const HalfspaceId i : present()) {
    // Nothing is evaluated if there is nothing to remove.
    if (!latest_[i.index()].removal.ring.empty()) {
      evaluations.push_back(evaluation_json(latest_[i.index()]));
    }
  }
}

Json RemovalRecorder::evaluation_json(const Seen& seen) const {
  return {{"step", seen.step},
          {"halfspace", seen.removal.removed},
          {"ring", seen.removal.ring},
          {"triangles", seen.removal.roof.triangles},
          {"cost", cost_or_null(seen.removal.cost)},
          {"others", others_of(seen.removal)}};
}

// The amounts that the same cap adds to the other measures.
Json RemovalRecorder::others_of(const Removal& removal) const {
  Json others = Json::object();
  for (const CostMeasure measure : request_.measures) {
    std::optional<Cost> cost;
    if (removal.cost) {
      const Cap cap = make_cap(points_, removal.removed, removal.ring, removal.roof);
      cost = cost_of(cap, directions_, removal.removed, removal.ring, measure);
    }
    others[name_of(measure)] = cost_or_null(cost);
  }
  return others;
}

Json RemovalRecorder::removal_json(const Step& step) {
  const Seen& seen = latest_[step.removed.index()];
  const RingTriangulation& roof = seen.removal.roof;
  const std::size_t k = step.ring.size();
  const Cap cap = make_cap(points_, step.removed, step.ring, roof);
  Json entry = {{"step", steps_ + 1},
                {"removed", step.removed},
                {"cost", cost_or_null(step.cost)},
                {"others", others_of(seen.removal)},
                {"tie", step.tie}};
  if (step.tie_evidence.proof) entry["tie_proof"] = name_of(*step.tie_evidence.proof);
  entry["left"] = step.left;
  entry["ring"] = step.ring;
  entry["first"] = seen.first;
  entry["insertions"] = seen.insertions;

  Json triangles = Json::array(), base = Json::array();
  for (std::size_t t = 0; t < roof.triangles.size(); ++t) {
    const DualPlane& plane = roof.planes[t];
    triangles.push_back(
        {{"corners", roof.triangles[t]},
         {"x", {to_string(plane.x[0]), to_string(plane.x[1]), to_string(plane.x[2])}},
         {"d", to_string(plane.d)},
         {"height", to_string(height(plane, points_[step.removed.index()]))},
         {"vertex", frame_.both(polar(plane, frame_.center()))}});
  }
  for (std::size_t t = 0; t < k; ++t) {
    base.push_back(frame_.both(polar(cap.vertices[t], frame_.center())));
  }
  entry["triangles"] = std::move(triangles);
  entry["base"] = std::move(base);
  entry["sides"] = cap.sides;

  Json pieces = Json::array();
  const Integer& e = cap.vertices[0].d;
  Rational six_volume = 0;
  for (const CapTetrahedron& t : tetrahedra(cap)) {
    const Rational six(t.n, Integer(t.d * e * e * e));
    six_volume += six;
    pieces.push_back({{"corners", t.corners}, {"six", six}});
  }
  entry["tetrahedra"] = std::move(pieces);
  entry["cap_volume"] = Rational(six_volume / 6);
  volume_ += six_volume / 6;
  entry["volume_after"] = volume_;
  entry["checks"] = Json::array();
  return entry;
}

}  // namespace convexact
