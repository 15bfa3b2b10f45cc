// SPDX-License-Identifier: MIT
#include "teach/lesson.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "convexact/error.hpp"
#include "io/json.hpp"
#include "simplify/run_names.hpp"
#include "solid/stage_log.hpp"
#include "teach/chapters.hpp"

namespace convexact {
namespace {

constexpr int kLessonVersion = 1;

// The subject of the chapters.
struct Subject {
  const SceneObject& object;
  const LessonRequest& request;
  StageLog& log;
  LeftOutParts& left_out;

  const PointSet* points() const { return std::get_if<PointSet>(&object.shape); }
  std::size_t count() const {
    return points() ? points()->size() : std::get<std::vector<Halfspace>>(object.shape).size();
  }
};

// ---- The hull

// The dual points that the hull was made of; the interior point of that hull is their center.
Json hull_rows(const Solid& solid, const Subject& subject, const LessonFrame& frame) {
  const auto& halfspaces = std::get<std::vector<Halfspace>>(subject.object.shape);
  Json rows = Json::array();
  for (const std::size_t row : solid.hull_rows) {
    const DualPoint dual = polar(halfspaces[row], *solid.interior);
    rows.push_back({{"dual", dual_point_json(dual)}, {"at", frame.dual(dual)}});
  }
  return rows;
}

Json hull_chapter(HullRecorder& recorder, const Solid& solid, const Subject& subject,
                  const LessonFrame& frame) {
  if (subject.count() > kMostLessonPoints) {
    subject.left_out.add(
        "hull", fmt::format("the input has {} {}; a hull is shown being built from at most {}",
                            subject.count(), subject.points() ? "points" : "halfspaces",
                            kMostLessonPoints));
    return nullptr;
  }
  if (recorder.insertions() > kMostLessonInsertions) {
    subject.left_out.add("hull", fmt::format("the hull took {} insertions; at most {} are shown",
                                             recorder.insertions(), kMostLessonInsertions));
    return nullptr;
  }
  Json chapter = {{"of", subject.points() ? "points" : "dual-points"}};
  if (!subject.points()) {
    chapter["center"] = vector_json(*solid.interior);
    chapter["rows"] = hull_rows(solid, subject, frame);
  }
  chapter.update(recorder.take());
  if (subject.points()) {
    // In canonical order, so that facet k is halfspace k.
    Json facets = Json::array();
    for (const std::vector<std::uint32_t>& facet : solid.polytope.facets) {
      Json cycle = Json::array();
      for (const std::uint32_t corner : facet) cycle.push_back(solid.extreme[corner].index());
      facets.push_back(std::move(cycle));
    }
    chapter["facets"] = std::move(facets);
  }
  return chapter;
}

Json input_json(const Solid& solid, const Subject& subject, const LessonFrame& frame,
                bool has_hull) {
  Json input = {{"kind", subject.points() ? "points" : "halfspaces"}, {"count", subject.count()}};
  if (subject.points() && has_hull) {
    Json points = Json::array();
    for (std::size_t i = 0; i < subject.count(); ++i) {
      points.push_back(frame.both((*subject.points())[PointId(i)]));
    }
    input["points"] = std::move(points);
  }
  if (!subject.points()) {
    input["redundant"] = to_typed_rows(solid.redundant, subject.object.rows);
  }
  return input;
}

// ---- The center, and the polar map from it

// As simplify() finds it; the chapter is null if the caller gave a center.
RationalPoint find_center(const DualHull& dual, const Subject& subject, Json& chapter) {
  const LessonRequest& request = subject.request;
  if (request.center) {
    subject.left_out.add("center", "the center was given, so none was computed");
    return given_center(*request.center, dual.halfspaces, subject.log);
  }
  CenterRecorder recorder(dual.halfspaces);
  const ChebyshevCenter center =
      certified_center(dual.halfspaces, {.seed = request.seed, .observer = &recorder}, subject.log);
  chapter = recorder.take(center);
  return center.center;
}

Json halfspaces_json(const DualHull& dual, const LessonFrame& frame) {
  Json list = Json::array();
  for (const Halfspace& h : dual.halfspaces) {
    list.push_back({{"plane", plane_json(h)},
                    {"drawn", frame.plane(h)},
                    {"dual", dual_point_json(polar(h, frame.center()))}});
  }
  return list;
}

Json costs_json(const std::vector<std::optional<Cost>>& costs) {
  Json list = Json::array();
  for (const std::optional<Cost>& cost : costs) list.push_back(cost_or_null(cost));
  return list;
}

// No cost depends on the center: all of them again, from halfway to a vertex.
Json polar_chapter(const DualHull& dual, const LessonFrame& frame, const RemovalRecorder& recorder,
                   const Subject& subject) {
  if (recorder.first_costs().empty()) {
    subject.left_out.add("polar", fmt::format("costs from a second center are shown for at most {} "
                                              "halfspaces; this input has {}",
                                              kMostLessonHalfspaces, dual.halfspaces.size()));
    return nullptr;
  }
  const RationalPoint other = (frame.center() + dual.vertices.front()) / Rational(2);
  DualSurface surface(dual.halfspaces, dual.triangles, other, subject.request.seed,
                      subject.request.cost);
  Json points = Json::array();
  std::vector<std::optional<Cost>> costs;
  for (std::size_t i = 0; i < dual.halfspaces.size(); ++i) {
    points.push_back(dual_point_json(polar(dual.halfspaces[i], other)));
    costs.push_back(surface.removal_of(HalfspaceId(i)).cost);
  }
  return {
      {"other",
       {{"center", vector_json(other)}, {"dual", std::move(points)}, {"costs", costs_json(costs)}}},
      {"costs", costs_json(recorder.first_costs())}};
}

// ---- The removals

// The result of a run of the exact engine; nothing if it gave up, as it does when its verification
// refuses a step.
std::optional<Run> watched_run(const DualHull& dual, RemovalRecorder& recorder,
                               const LessonFrame& frame, const Subject& subject,
                               std::optional<std::string>& failure) {
  const LessonRequest& request = subject.request;
  const std::size_t count = dual.halfspaces.size();
  SimplifyOptions options;
  options.faces = request.faces;
  options.cost = request.cost;
  options.seed = request.seed;
  options.watch = request.watch.of(stage::kSimplify);
  options.verify = count <= kMostFullyVerified ? VerifyLevel::Full : VerifyLevel::Local;
  if (options.verify == VerifyLevel::Local) {
    subject.left_out.add("verification",
                         fmt::format("with {} halfspaces each step is verified separately; the "
                                     "whole dual is verified up to {}",
                                     count, kMostFullyVerified));
  }
  std::optional<Run> run;
  try {
    run = subject.log.run(stage::kSimplify,
                          [&] { return simplify_exact(dual, frame.center(), options, &recorder); });
  } catch (const Error& error) {
    if (error.code() != ErrorCode::Internal) throw;
    failure = error.what();
  }
  recorder.finish(failure);
  if (!recorder.has_begun()) {
    const std::string why =
        fmt::format("the run ends with {} halfspaces; removals are shown once {} are left",
                    recorder.present().size(), kMostLessonHalfspaces);
    for (const char* chapter : {"topology", "removal"}) subject.left_out.add(chapter, why);
  } else if (recorder.skipped() > 0) {
    subject.left_out.add("removal",
                         fmt::format("the first {} of {} removals are not shown: the lesson "
                                     "begins where {} halfspaces are left",
                                     recorder.skipped(), recorder.steps(), kMostLessonHalfspaces));
  }
  return run;
}

Json end_json(const DualHull& dual, const RemovalRecorder& recorder) {
  Json witnesses = Json::array();
  for (const HalfspaceId i : recorder.present()) {
    witnesses.push_back({i.index(), vector_json(dual.vertices[dual.witness[i.index()]])});
  }
  return {{"present", recorder.present()}, {"witness", std::move(witnesses)}};
}

Json stored_chapter(const Solid& solid, const std::optional<Run>& run,
                    const RemovalRecorder& recorder, const Subject& subject) {
  const std::vector<HalfspaceId> present = recorder.present();
  if (!run || present.size() > kMostLessonHalfspaces) {
    subject.left_out.add("storing",
                         !run ? "the run failed, so there is no result to store"
                              : fmt::format("the result has {} halfspaces; at most {} are shown",
                                            present.size(), kMostLessonHalfspaces));
    return nullptr;
  }
  return subject.log.run("store", [&] {
    return storing_chapter(to_polytope(run->halfspaces, run->triangles), present, solid,
                           subject.request.precision, subject.left_out);
  });
}

// The name without folders, as text.
std::string title_of(const SceneObject& object) {
  return as_utf8(std::filesystem::path(object.name).filename().string());
}

// The measures that are not the cost, each once.
std::vector<CostMeasure> other_measures(const LessonRequest& request) {
  std::vector<CostMeasure> others;
  for (const CostMeasure m : request.measures) {
    if (m != request.cost && std::find(others.begin(), others.end(), m) == others.end()) {
      others.push_back(m);
    }
  }
  return others;
}

void add_unless_null(Json& document, const char* key, Json value) {
  if (!value.is_null()) document[key] = std::move(value);
}

}  // namespace

std::variant<Lesson, NotSolid> make_lesson(const SceneObject& object, const LessonRequest& asked) {
  LessonRequest request = asked;
  request.measures = other_measures(asked);
  StageLog log(request.watch);
  LeftOutParts left_out;
  const Subject subject{object, request, log, left_out};

  // (1) The hull, of points or of dual points.
  HullRecorder hull;
  const bool is_small = subject.count() <= kMostLessonPoints;
  SolidOutcome outcome =
      make_solid(object.shape, {.seed = request.seed, .observer = is_small ? &hull : nullptr}, log);
  if (const auto* reason = std::get_if<NotSolid>(&outcome)) {
    return of_typed_rows(*reason, object.rows);
  }
  const auto& solid = std::get<Solid>(outcome);

  // (2) The center of the dual.
  Json center;
  const RationalPoint found = find_center(solid.dual, subject, center);
  const LessonFrame frame(solid.dual.vertices, found);
  Json hull_part = hull_chapter(hull, solid, subject, frame);

  // (3) The removals.
  RemovalRecorder recorder(solid.dual, frame, request);
  Lesson lesson;
  const std::optional<Run> run = watched_run(solid.dual, recorder, frame, subject, lesson.failure);

  // (4) The parts that show more than a run needs.
  Json polar_part =
      log.run("second center", [&] { return polar_chapter(solid.dual, frame, recorder, subject); });
  Json storing = stored_chapter(solid, run, recorder, subject);

  Json measures = Json::array();
  for (const CostMeasure m : request.measures) measures.push_back(name_of(m));
  Json& document = lesson.document;
  document = {{"lesson", kLessonVersion},
              {"name", title_of(object)},
              {"cost", name_of(request.cost)},
              {"measures", std::move(measures)},
              {"faces", request.faces},
              {"stop", run ? name_of(run->stop) : "failed"},
              {"input", input_json(solid, subject, frame, !hull_part.is_null())},
              {"frame", frame.json()},
              {"halfspaces", halfspaces_json(solid.dual, frame)},
              {"left_out", left_out.list()}};
  add_unless_null(document, "hull", std::move(hull_part));
  add_unless_null(document, "center", std::move(center));
  add_unless_null(document, "polar", std::move(polar_part));
  if (recorder.has_begun()) {
    document["topology"] = std::move(recorder.topology);
    document["evaluations"] = std::move(recorder.evaluations);
    document["removals"] = std::move(recorder.removals);
  }
  document["end"] = end_json(solid.dual, recorder);
  add_unless_null(document, "storing", std::move(storing));
  add_unless_null(document, "failed", recorder.failed());
  lesson.stages = log.stages();
  return lesson;
}

}  // namespace convexact
