// SPDX-License-Identifier: MIT
#include "io/json.hpp"
#include "lp/interior_point.hpp"
#include "teach/chapters.hpp"

namespace convexact {
namespace {

constexpr std::size_t kMostListedRows = 60;  // if there are more, unmoved ones are only counted

Json numbers_json(const RationalVector& v) {
  Json list = Json::array();
  for (const Rational& x : v) list.push_back(x);
  return list;
}

}  // namespace

CenterRecorder::CenterRecorder(std::span<const Halfspace> halfspaces) : halfspaces_(halfspaces) {
  Json norms = Json::array();
  for (const Halfspace& halfspace : halfspaces) {
    norms_.push_back(enclose_norm(halfspace.normal()).upper);
    norms.push_back(norms_.back());
  }
  chapter_["norms"] = std::move(norms);
}

// The last row, t >= 0, keeps the radius from being negative.
Json CenterRecorder::name_of(std::size_t row) const {
  return row == norms_.size() ? Json("t>=0") : Json(row);
}

// By the definition: n.x + d + U r = 0, and so for the part in M.
bool CenterRecorder::is_tight(std::size_t row, const LpPoint& point) const {
  if (row == norms_.size()) return point.x[3] == 0 && point.direction[3] == 0;
  const RationalVector3 normal = halfspaces_[row].normal().cast<Rational>();
  const RationalVector3 x = point.x.head<3>(), direction = point.direction.head<3>();
  return halfspaces_[row](x) + norms_[row] * point.x[3] == 0 &&
         normal.dot(direction) + norms_[row] * point.direction[3] == 0;
}

void CenterRecorder::start(const LpPoint& optimum) {
  chapter_["start"] = {{"x", numbers_json(optimum.x)},
                       {"direction", numbers_json(optimum.direction)}};
  chapter_["insertions"] = Json::array();
}

void CenterRecorder::inserted(const LpInsertion& insertion) {
  rows_.insert(insertion.row);
  Json& list = chapter_["insertions"];
  if (!insertion.moved && norms_.size() >= kMostListedRows) {
    if (list.empty() || !list.back().contains("unmoved")) list.push_back({{"unmoved", 0}});
    Json& count = list.back()["unmoved"];
    count = count.count() + 1;
    return;
  }
  Json entry = {{"row", name_of(insertion.row)}, {"moved", insertion.moved}};
  if (insertion.moved && insertion.optimum) {
    entry["x"] = numbers_json(insertion.optimum->x);
    entry["direction"] = numbers_json(insertion.optimum->direction);
    Json tight = Json::array();
    for (const std::size_t row : rows_) {
      if (is_tight(row, *insertion.optimum)) tight.push_back(name_of(row));
    }
    entry["tight"] = std::move(tight);
  }
  list.push_back(std::move(entry));
}

Json CenterRecorder::take(const ChebyshevCenter& center) {
  Json touching = Json::array();
  for (const Multiplier& m : center.touching) touching.push_back({m.row, to_string(m.value)});
  chapter_["optimum"] = vector_json(center.optimum);
  chapter_["optimum_radius"] = center.optimum_radius;
  chapter_["center"] = vector_json(center.center);
  chapter_["radius_low"] = center.radius_low;
  chapter_["radius_high"] = center.radius_high;
  chapter_["touching"] = std::move(touching);
  return std::move(chapter_);
}

}  // namespace convexact
