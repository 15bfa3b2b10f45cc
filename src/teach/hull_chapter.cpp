// SPDX-License-Identifier: MIT
#include "teach/chapters.hpp"

namespace convexact {
namespace {

using nlohmann::ordered_json;

ordered_json triangles_json(std::span<const HullTriangle> triangles) {
  ordered_json list = ordered_json::array();
  for (const HullTriangle& t : triangles) list.push_back(triangle_json(t));
  return list;
}

// Points, each with a triangle: [p, a, b, c].
template <class PointAtTriangle>
ordered_json points_json(std::span<const PointAtTriangle> points) {
  ordered_json list = ordered_json::array();
  for (const auto& [point, t] : points) {
    list.push_back({point.index(), t[0].index(), t[1].index(), t[2].index()});
  }
  return list;
}

ordered_json cycle_json(std::span<const PointId> cycle) {
  ordered_json list = ordered_json::array();
  for (const PointId p : cycle) list.push_back(p.index());
  return list;
}

}  // namespace

void HullRecorder::start(const HullStart& start) {
  chapter_ = {{"triangles", triangles_json(start.triangles)},
              {"conflicts", points_json(start.filed)},
              {"inside", points_json(start.inside)},
              {"insertions", ordered_json::array()}};
}

void HullRecorder::inserted(const HullInsertion& insertion) {
  if (++count_ > kMostLessonInsertions) {
    chapter_ = {};
    return;
  }
  chapter_["insertions"].push_back({{"point", insertion.point.index()},
                                    {"visible", triangles_json(insertion.visible)},
                                    {"horizon", cycle_json(insertion.horizon)},
                                    {"added", triangles_json(insertion.added)},
                                    {"conflicts", points_json(insertion.filed)},
                                    {"inside", points_json(insertion.inside)}});
}

void HullRecorder::finished(const Hull& hull) {
  ordered_json facets = ordered_json::array();
  for (std::size_t f = 0; f < hull.facets.size(); ++f) facets.push_back(cycle_json(hull.facets[f]));
  chapter_["facets"] = std::move(facets);
}

}  // namespace convexact
