// SPDX-License-Identifier: MIT
#include "io/json.hpp"
#include "teach/chapters.hpp"

namespace convexact {
namespace {

// Points, each with a triangle: [p, a, b, c].
template <class PointAtTriangle>
Json points_json(std::span<const PointAtTriangle> points) {
  Json list = Json::array();
  for (const auto& [point, t] : points) {
    list.push_back({point, t[0], t[1], t[2]});
  }
  return list;
}

}  // namespace

void HullRecorder::start(const HullStart& start) {
  chapter_ = {{"triangles", start.triangles},
              {"conflicts", points_json(start.filed)},
              {"inside", points_json(start.inside)},
              {"insertions", Json::array()}};
}

void HullRecorder::inserted(const HullInsertion& insertion) {
  if (++count_ > kMostLessonInsertions) {
    chapter_ = {};
    return;
  }
  chapter_["insertions"].push_back({{"point", insertion.point},
                                    {"visible", insertion.visible},
                                    {"horizon", insertion.horizon},
                                    {"added", insertion.added},
                                    {"conflicts", points_json(insertion.filed)},
                                    {"inside", points_json(insertion.inside)}});
}

void HullRecorder::finished(const Hull& hull) {
  Json facets = Json::array();
  for (std::size_t f = 0; f < hull.facets.size(); ++f) facets.push_back(hull.facets[f]);
  chapter_["facets"] = std::move(facets);
}

}  // namespace convexact
